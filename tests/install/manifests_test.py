#!/usr/bin/env python3
"""vcpkg.json and conanfile.py say what CMake says: the version, and a package for all that it looks for.

Run by ctest with the root of the tree.
"""
import ast
import json
import pathlib
import re
import sys

ROOT = pathlib.Path(sys.argv[1])
# What CMake calls it: (vcpkg's name, Conan's name).
PACKAGES = {
    'glm': ('glm', 'glm'), 'spdlog': ('spdlog', 'spdlog'), 'TBB': ('tbb', 'onetbb'), 'Vulkan': ('vulkan-headers', 'vulkan-headers'),
    'volk.h': ('volk', 'volk'), 'CLI11': ('cli11', 'cli11'), 'tomlplusplus': ('tomlplusplus', 'tomlplusplus'),
    'nlohmann_json': ('nlohmann-json', 'nlohmann_json'), 'OpenEXR': ('openexr', 'openexr'), 'PNG': ('libpng', 'libpng'),
    'zip.h': ('libzip', 'libzip'), 'glslangValidator': ('glslang', 'glslang'), 'spirv-val': ('spirv-tools', 'spirv-tools'),
    'doctest': ('doctest', None),  # tests are no part of a Conan package
}
NOT_PACKAGES = {'Python3', 'spirv-opt', 'npm', 'ccache', 'gzip', 'zip'}
# What each project of the tree may look for when it is built as vcpkg or Conan build it.
BUILD_FILES = ['CMakeLists.txt', 'rhi/CMakeLists.txt', 'atmosphere/CMakeLists.txt', 'backends/*/CMakeLists.txt', 'samples/CMakeLists.txt',
               'samples/*/*.cmake', 'cmake/*.cmake']


def looked_for():
    found = set()
    for pattern in BUILD_FILES:
        for path in ROOT.glob(pattern):
            text = re.sub(r'#.*', '', path.read_text(encoding='utf-8'))
            found |= set(re.findall(r'find_package\((\w+)(?![^)]*\bQUIET\b)', text))  # quietly: it can be done without
            found |= set(re.findall(r'find_(?:program|path|library)\(\s*\w+\s+([\w.-]+)', text))
    return found - NOT_PACKAGES


def vcpkg_names(manifest):
    lists = [manifest['dependencies'], *(feature['dependencies'] for feature in manifest['features'].values())]
    return {each if isinstance(each, str) else each['name'] for one in lists for each in one}


def conan_names(text):
    """Packages of self.requires('name/version', ...) and self.tool_requires."""
    calls = [node for node in ast.walk(ast.parse(text)) if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute)]
    wanted = [call.args[0].value for call in calls if call.func.attr in ('requires', 'tool_requires')]
    problems = [f'conanfile.py: {name}: not name/version' for name in wanted if not re.fullmatch(r'[a-z0-9_+.-]+/\S+( <\d+\])?', name)]
    return {name.split('/')[0] for name in wanted}, problems


def check():
    version = re.search(r'project\(aureole VERSION ([\d.]+)', (ROOT / 'CMakeLists.txt').read_text(encoding='utf-8')).group(1)
    manifest = json.loads((ROOT / 'vcpkg.json').read_text(encoding='utf-8'))
    problems = [] if manifest['version-semver'] == version else [f'vcpkg.json: {manifest["version-semver"]}; CMake says {version}']
    changes = (ROOT / 'CHANGELOG.md').read_text(encoding='utf-8')
    if f'\n## {version}\n' not in changes:
        problems.append(f'CHANGELOG.md: says nothing of {version}')
    in_vcpkg = vcpkg_names(manifest)
    in_conan, wrong = conan_names((ROOT / 'conanfile.py').read_text(encoding='utf-8'))
    problems += wrong
    packages = looked_for()
    for package in sorted(packages):
        if package not in PACKAGES:
            problems.append(f'CMake looks for {package}: which package is that in vcpkg and in Conan? (PACKAGES, or NOT_PACKAGES)')
            continue
        vcpkg, conan = PACKAGES[package]
        if vcpkg not in in_vcpkg:
            problems.append(f'vcpkg.json: {vcpkg} is missing')
        if conan and conan not in in_conan:
            problems.append(f'conanfile.py: {conan} is missing')
    known = [PACKAGES[package] for package in packages if package in PACKAGES]
    problems += [f'vcpkg.json: nothing looks for {name}' for name in in_vcpkg - {v for v, _ in known} - {'aureole'}]
    return problems + [f'conanfile.py: nothing looks for {name}' for name in in_conan - {c for _, c in known} - {'cmake'}]


if __name__ == '__main__':
    report = check()
    print('\n'.join(report) if report else 'the manifests say what CMake says')
    sys.exit(1 if report else 0)
