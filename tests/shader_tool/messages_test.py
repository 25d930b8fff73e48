#!/usr/bin/env python3
"""Faulty kernels are refused, with the file and line that the author has to mend, and nothing is written.

  messages_test.py SHADER_TOOL PRELUDE GLSLANG SPIRV_VAL
"""
import pathlib
import subprocess
import sys
import tempfile

TOOL, PRELUDE, GLSLANG, SPIRV_VAL = sys.argv[1:5]
MAIN = 'LOCAL_SIZE(8, 8, 1)\nCOMPUTE_MAIN(id) { imageStore(image, ivec2(id), vec4(real(1))); }\n'
GOOD = 'IMAGE_2D(0, image)\n' + MAIN

# name, kernel, other files, what the message must hold (None: accepted)
CASES = [
    ('good', GOOD, {}, None),
    ('good include', '#include "a.glsl"\n' + GOOD, {'a.glsl': '#ifndef A\n#define A\n#endif\n'}, None),
    ('good include from include dir', '#include "b.glsl"\n' + GOOD, {'inc/b.glsl': '// why\n#ifndef A\n#define A\n#endif\n'}, None),
    ('syntax error', 'IMAGE_2D(0, image)\nCONST(real, X, wrong)\n' + MAIN, {}, 'k.comp.glsl:2: error'),
    ('syntax error in an include', '#include "a.glsl"\n' + GOOD, {'a.glsl': '#ifndef A\n#define A\n\nvec4 f( { }\n#endif\n'}, 'a.glsl:4: error'),
    ('include not found', '\n#include "none.glsl"\n' + GOOD, {}, 'k.comp.glsl:2: error: cannot find "none.glsl"'),
    ('no include guard', '#include "a.glsl"\n' + GOOD, {'a.glsl': 'CONST(real, X, real(1))\n'}, 'a.glsl:1: error: an included file must start'),
    ('slot twice', 'SAMPLER_2D(0, other)\n' + GOOD, {}, 'slot 0 is declared twice'),
    ('slot too high', 'SAMPLER_2D(32, other)\n' + GOOD, {}, 'slot 32 is not allowed; allowed: 0 to 31'),
    ('resource without a macro', 'layout(set = 0, binding = 1) uniform isampler2D other;\n' + GOOD, {}, 'macros of prelude.glsl'),
    ('word of the base class', 'SAMPLER_2D(1, sampled)\n' + GOOD, {}, 'cannot be called sampled'),
    ('no local size', GOOD.replace('LOCAL_SIZE(8, 8, 1)', ''), {}, 'LOCAL_SIZE'),
    ('default that is no literal', 'CONST(int, FOUR, 4)\nSPEC_INT(0, N, FOUR)\n' + GOOD, {}, 'the default of N is FOUR; allowed: a literal'),
    ('two push blocks', 'struct P { vec4 a; };\nPUSH_CONSTANTS(P, p)\nPUSH_CONSTANTS(P, q)\n' + GOOD, {}, 'error'),
]


def attempt(kernel, others):
    """Exit status, message, whether the output exists."""
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        (root / 'inc').mkdir()
        (root / 'k.comp.glsl').write_text(kernel)
        for name, text in others.items():
            (root / name).write_text(text)
        output = root / 'k.shader.cpp'
        done = subprocess.run(
            [sys.executable, TOOL, 'kernel', str(root / 'k.comp.glsl'), '--prelude', PRELUDE, '-I', str(root / 'inc'), '--glslang',
             GLSLANG, '--spirv-val', SPIRV_VAL, '--output', str(output), '--depfile', str(root / 'k.d')],
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        return done.returncode, done.stdout, output.exists()


def main():
    failed = 0
    for name, kernel, others, expected in CASES:
        status, message, written = attempt(kernel, others)
        if expected is None:
            good = status == 0 and written
        else:
            good = status == 1 and expected in message and 'Traceback' not in message and not written
        print(f'{"ok" if good else "FAILED"}: {name}')
        if not good:
            failed += 1
            print(f'  expected {expected!r}, got status {status}, output written: {written}\n{message}')
    sys.exit(1 if failed else 0)


if __name__ == '__main__':
    main()
