#!/usr/bin/env python3
"""The tree keeps its rooms: samples -> atmosphere -> rhi <- backends, and nobody knows what is not theirs to know.

Run by ctest with the root of the tree. `--self-test` checks that each rule catches an offender.
"""
import pathlib
import re
import sys
import tempfile

CODE = {'.h', '.c', '.cpp', '.glsl', '.vert', '.frag', '.comp', '.txt', '.cmake', '.in'}
LATER = '|'.join(a + b for a, b in (('TO', 'DO'), ('FIX', 'ME'), ('XX', 'X'), ('not imple', 'mented'), ('place', 'holder')))
SCRIPTS = {'.py'}  # held to their length alone
MAX_LINES = 400
ROOMS = {'rhi', 'atmosphere', 'backends', 'samples', 'tests', 'docs', 'cmake'}
AT_THE_TOP = ROOMS | {'CMakeLists.txt', 'CMakePresets.json', 'README.md', 'CONTRIBUTING.md', 'CHANGELOG.md', 'LICENSE', 'demo.sh',
                      'test.sh', 'vcpkg.json', 'conanfile.py', 'out', '__pycache__', 'compile_commands.json'}

# Rooms that stand above their folder, and of which of its rules: the C API shows the backends, too.
# The tools that measure for the planner, and make its table, know how it is kept, and integrate by the library's rules.
ABOVE = {'atmosphere/c_api': ('the atmosphere names a graphics API or a window', 'the atmosphere knows a backend'),
         'samples/app': ('a sample takes what only tools that measure may',), 'samples/measure': ('a sample takes what only tools that measure may',),
         'samples/report': ('a sample takes what only tools that measure may',)}

# The rooms of the atmosphere that no host sees. The samples have a folder `common`, too.
ATMOSPHERE = sorted(room.name for room in (pathlib.Path(__file__).parent.parent / 'atmosphere').iterdir()
                    if room.is_dir() and room.name not in ('include', 'c_api', 'common'))

# (folder, what its files must not contain, tests are held to it too, why)
RULES = [
    ('rhi', r'\bVk[A-Z]\w*|volk|vulkan/', True, 'the interface names a graphics API'),
    ('rhi', r'#\s*include\s*[<"]aureole/(?!rhi/)', True, 'the interface includes what stands above it'),
    # Not even in comments: `gl_FragCoord` and the like are words of GLSL, which every form of a kernel is made from.
    ('rhi', r'\bGL_[A-Z]|(?i:open_?gl|gles\b|vulkan|direct3d|\bd3d|\bmetal\b|webgpu)', True, 'the interface names a graphics API'),
    ('rhi', r'#\s*include\s*[<"](GL|EGL|GLFW|epoxy|Ogre)', True, 'the interface names a graphics API'),
    ('atmosphere', r'#\s*include\s*[<"](GL|EGL|GLFW|epoxy|Ogre)', True, 'the atmosphere names a graphics API or an engine'),
    ('samples/ogre/gl', r'#\s*include\s*[<"](?!epoxy/|doctest/|aureole/rhi/|aureole/rhi_tests/|passes/)[^>"]*/', True,
     'the OpenGL adapter knows more than the interface'),
    ('atmosphere', r'\bVk[A-Z]\w*|volk|vulkan/|GLFW', False, 'the atmosphere names a graphics API or a window'),
    ('atmosphere', r'#\s*include\s*<(fstream|filesystem|cstdio|OpenEXR/|png\.h|CLI/|toml\+\+)', False, 'the atmosphere knows files'),
    ('atmosphere', r'#\s*include\s*[<"]aureole/(cpu|vulkan)/', False, 'the atmosphere knows a backend'),
    ('backends', r'(?i)rayleigh|ozone|sky_view|transmittance', False, 'a backend knows about skies'),
    ('backends', r'#\s*include\s*[<"]aureole/(?!rhi/|cpu/|vulkan/)', False, 'a backend includes the atmosphere'),
    # A host outside of the tree has what is installed, no more.
    ('samples', r'atmosphere/(?!include/)[\w/]+\.(glsl|h)\b|[}"]/atmosphere/(?!include)\w|"-I[^"]*[/}]atmosphere"|#\s*include\s*[<"](\.\./)*atmosphere/',
     True, 'a sample takes what the atmosphere keeps to itself'),
    ('samples', rf'#\s*include\s*[<"]({"|".join(room for room in ATMOSPHERE if room not in ("plan", "quadrature"))})/', True,
     'a sample takes what the atmosphere keeps to itself'),
    ('samples', r'#\s*include\s*[<"](plan|quadrature)/', True, 'a sample takes what only tools that measure may'),
    ('', r'std::views::|std::ranges::\w+_view\b|#\s*include\s*<ranges>', True, "views of the C++ library, which clang 14 cannot read in g++ 12's"),
    ('samples/viewer/core', r'\bVk[A-Z]\w*|glfw|imgui|vulkan/', True, "the viewer's core knows a window"),
    ('samples/common', r'(?i)glfw|imgui|\bOgre|volk\.h|#\s*include\s*"(viewer|host_vulkan|ogre|app)/', True, 'what the samples share knows one of them'),
    ('', LATER, True, 'work left for later'),
    ('', r'^(?!.*(scale\(|Approx\(0\))).*\)\.epsilon\(', True, "doctest's Approx adds 1 to the value: give it .scale(1e-300)"),
]


def is_test(path):
    return path.stem.endswith('_test') or 'tests' in path.parts or path.name == 'CMakeLists.txt'


def files(root):
    for room in ('rhi', 'atmosphere', 'backends', 'samples', 'tests', 'cmake'):
        for path in sorted((root / room).rglob('*')):
            if path.is_file() and path.suffix in CODE | SCRIPTS:
                yield path


def check(root):
    # What a test or an app wrote where it was started is not the project's.
    problems = [f'{path.name}: nothing of this name belongs at the top of the tree' for path in sorted(root.iterdir())
                if path.name not in AT_THE_TOP and not path.name.startswith(('.', 'build'))]
    for path in files(root):
        relative = path.relative_to(root)
        lines = path.read_text(encoding='utf-8').splitlines()
        if len(lines) > MAX_LINES:
            problems.append(f'{relative}: {len(lines)} lines; allowed: {MAX_LINES}')
        for folder, pattern, tests_too, why in RULES if path.suffix in CODE else []:
            if (folder and not relative.is_relative_to(folder)) or (is_test(relative) and not tests_too):
                continue
            if any(relative.is_relative_to(room) and why in rules for room, rules in ABOVE.items()):
                continue
            for number, line in enumerate(lines, 1):
                if re.search(pattern, line):
                    problems.append(f'{relative}:{number}: {why}: {line.strip()}')
    return problems


OFFENDERS = [
    ('rhi/a.h', 'VkImage image;'), ('rhi/b.h', '#include <aureole/atmosphere.h>'), ('atmosphere/c_api/b.cpp', '#include <fstream>'), ('atmosphere/a.cpp', '#include <volk.h>'),
    ('atmosphere/b.cpp', '#include <fstream>'), ('atmosphere/c.cpp', '#include <aureole/cpu/cpu_device.h>'),
    ('backends/cpu/a.cpp', 'float ozone;'), ('backends/cpu/b.cpp', '#include <aureole/atmosphere.h>'),
    ('rhi/d.h', '#include <epoxy/gl.h>'), ('rhi/e.h', '// As OpenGL has it.'), ('rhi/f_test.cpp', 'bool vulkan;'), ('atmosphere/d.cpp', '#include <GL/gl.h>'),
    ('samples/ogre/gl/a.cpp', '#include <aureole/atmosphere.h>'), ('samples/ogre/gl/b.cpp', '#include "app/frame.h"'),
    ('samples/viewer/core/a_test.cpp', '#include <imgui.h>'), ('samples/common/a.h', '#include "viewer/core/state.h"'), ('samples/common/b.h', '#include <imgui.h>'), ('result.csv', '1'), ('rhi/h.cpp', '#include <ranges>'), ('samples/i.cpp', 'std::views::reverse(all)'), ('tests/b_test.cpp', 'CHECK(a == doctest::Approx(1e-3).epsilon(0.01));'), ('samples/a.cpp', '// ' + LATER.split('|')[0]), ('samples/long.cpp', '\n' * (MAX_LINES + 1)),
    ('samples/d.cpp', '#include "../../atmosphere/light/harmonics.glsl"'), ('samples/e.cpp', '#include "atmosphere/light/light.h"'),
    ('samples/f.cpp', '#include "composite/display.glsl"'), ('samples/a.frag', '#include "light/harmonics.glsl"'),
    ('samples/terrain/g.cpp', '#include "plan/work.h"'), ('samples/x/CMakeLists.txt', 'FOLDER="${PROJECT_SOURCE_DIR}/atmosphere/composite"'),
    ('samples/y/CMakeLists.txt', '"-I${PROJECT_SOURCE_DIR}/atmosphere"'), ('samples/z/CMakeLists.txt', '${PROJECT_SOURCE_DIR}/atmosphere/light/light.glsl'),
    ('tests/long_test.py', '\n' * (MAX_LINES + 1)),
]
LAWFUL = [('rhi/c.h', '#include <aureole/rhi/types.h>'), ('rhi/g.glsl', 'gl_FragCoord.xy'), ('backends/cpu/c_test.cpp', 'float ozone;'),
          ('samples/b.cpp', '#include <fstream>'), ('samples/h.cpp', '#include <aureole/atmosphere.h>\n#include "common/surface.h"'),
          ('samples/measure/h.cpp', '#include "plan/work.h"'), ('samples/w/CMakeLists.txt', '${PROJECT_BINARY_DIR}/atmosphere/include/aureole'), ('atmosphere/c_api/a.cpp', '#include <aureole/cpu/cpu_device.h>'),
          ('samples/ogre/gl/c.cpp', '#include <epoxy/gl.h>\n#include "formats.h"')]


def self_test():
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for name, text in OFFENDERS + LAWFUL:
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text + '\n', encoding='utf-8')
        found = check(root)
    expected = sorted(name for name, _ in OFFENDERS)
    caught = sorted(problem.split(':')[0] for problem in found)
    return [] if caught == expected else [f'self-test: expected {expected}, caught {caught}']


if __name__ == '__main__':
    report = self_test() if sys.argv[1] == '--self-test' else check(pathlib.Path(sys.argv[1]))
    print('\n'.join(report) if report else 'every file keeps to its room')
    sys.exit(1 if report else 0)
