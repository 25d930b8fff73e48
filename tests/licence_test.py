#!/usr/bin/env python3
"""The project has one licence and says so wherever it is asked; what it bundles may be bundled; nobody else's text stands in its files.

Run by ctest with the root of the tree. `--self-test` checks that each kind of fault is found.
"""
import json
import pathlib
import re
import sys
import tempfile

LICENCE = 'MIT'
# Of what npm fetches and the report's page and the site hold: licences that ask for no more than their text to be kept.
MAY_BE_BUNDLED = {'MIT', 'ISC', '0BSD', 'BSD-2-Clause', 'BSD-3-Clause', 'Unlicense', 'Apache-2.0'}
TEXT = {'.h', '.cpp', '.glsl', '.py', '.sh', '.txt', '.cmake', '.js', '.css', '.html', '.md', '.toml', '.c', '.in'}
# A foreign notice in a file of ours; those that tell of licences are looked at by other means.
FOREIGN = re.compile(r'copyright\s+(?:\(c\)|©|\d{4})|SPDX-License-Identifier:|GNU (?:Lesser )?General Public', re.I)
SKIP = {'build', 'out', '.git', 'node_modules'}


def manifest_licences(root):
    """What each manifest says."""
    found = {}
    for path in [*root.glob('vcpkg.json'), *root.rglob('package.json')]:
        if not SKIP.intersection(path.relative_to(root).parts):
            found[path] = json.loads(path.read_text(encoding='utf-8')).get('license')
    recipe = root / 'conanfile.py'
    if recipe.exists():
        said = re.search(r"^\s+license = '([^']*)'", recipe.read_text(encoding='utf-8'), re.M)
        found[recipe] = said and said.group(1)
    return found


def bundled(root):
    """(lock file, package, licence) of all that npm fetches."""
    for path in root.rglob('package-lock.json'):
        if SKIP.intersection(path.relative_to(root).parts):
            continue
        for name, package in json.loads(path.read_text(encoding='utf-8'))['packages'].items():
            if name:
                yield path, name, package.get('license')


def foreign(root):
    for path in sorted(root.rglob('*')):
        parts = path.relative_to(root).parts
        if path.suffix not in TEXT or not path.is_file() or SKIP.intersection(parts) or path.name == 'licence_test.py':
            continue
        for number, line in enumerate(path.read_text(encoding='utf-8', errors='replace').splitlines(), 1):
            if FOREIGN.search(line):
                yield f'{path.relative_to(root)}:{number}: a notice of its own: {line.strip()[:100]}'


def check(root):
    text = (root / 'LICENSE').read_text(encoding='utf-8')
    problems = [] if text.startswith('MIT License\n\nCopyright (c) ') else ['LICENSE: not the text of MIT']
    for path, said in manifest_licences(root).items():
        if said != LICENCE:
            problems.append(f'{path.relative_to(root)}: says {said}, not {LICENCE}')
    for path, name, said in bundled(root):
        if said not in MAY_BE_BUNDLED:
            problems.append(f'{path.relative_to(root)}: {name}: {said} is none of {", ".join(sorted(MAY_BE_BUNDLED))}')
    return problems + list(foreign(root))


TREE = {
    'LICENSE': 'GPL', 'vcpkg.json': '{"license": "GPL-3.0"}', 'conanfile.py': "class A:\n    license = 'BSD'\n",
    'a/package.json': '{}', 'a/package-lock.json': '{"packages": {"": {}, "node_modules/x": {"license": "AGPL-3.0"}, "node_modules/y": '
                                                   '{"license": "MIT"}}}',
    'b.cpp': '// Copyright (c) 2011 Somebody\nint a;\n', 'c.md': 'The licence is told in LICENSE.\n', 'build/d.cpp': '// Copyright 2000\n',
}
FAULTS = ['LICENSE: not', 'vcpkg.json: says GPL-3.0', 'conanfile.py: says BSD', 'a/package.json: says None',
          'a/package-lock.json: node_modules/x: AGPL-3.0', 'b.cpp:1: a notice']


def self_test():
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for name, text in TREE.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text, encoding='utf-8')
        found = check(root)
    good = len(found) == len(FAULTS) and all(any(line.startswith(fault) for line in found) for fault in FAULTS)
    return [] if good else [f'self-test: expected {FAULTS}, found {found}']


if __name__ == '__main__':
    report = self_test() if sys.argv[1] == '--self-test' else check(pathlib.Path(sys.argv[1]).resolve())
    print('\n'.join(report) if report else 'one licence, and nothing that it cannot hold')
    sys.exit(1 if report else 0)
