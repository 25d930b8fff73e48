#!/usr/bin/env python3
"""Every test that a Markdown page names is one that ctest knows, and every `ctest -R` on a page finds one. Behind a program's name, names in
quotation marks (`this_test`, "a case of it", "another") are those of cases.

    test_names_test.py ROOT CTEST BUILD_FOLDER

Run by ctest. What this build leaves out (tests that open a driver, say) counts where a CMake file adds it by name. `--self-test`
checks that each kind of wrong name is found.
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

from links_test import SKIP, pages

NAME = re.compile(r'`(\w+_test)`')
CASES = re.compile(r'`\w+_test`((?:,\s"[^"\n]+")+)')
CASE = re.compile(r'\bTEST_CASE\w*\(\s*"((?:[^"\\]|\\.)*)"')
CHOICE = re.compile(r'\bctest\b[^`\n]*?(?:\n[^`\n]*?)?\s-R\s+(?:\'([^\']+)\'|([\w^$.|-]+))')
ADDED = re.compile(r'\b(?:aureole_add_test\(|add_test\(\s*NAME)\s*([A-Za-z]\w*)\b')


def registered(ctest, build):
    """Of this build, as ctest itself lists them."""
    done = subprocess.run([ctest, '--show-only=json-v1', '--test-dir', build], stdout=subprocess.PIPE, text=True, check=True)
    return {test['name'] for test in json.loads(done.stdout)['tests']}


def written(root):
    """Of any build: what stands by name in CMake files."""
    files = [path for path in root.rglob('CMakeLists.txt') if not SKIP.intersection(path.relative_to(root).parts)]
    return {name for path in files for name in ADDED.findall(path.read_text(encoding='utf-8'))}


def cases(root):
    """Of all programs, whatever is built."""
    files = [path for path in root.rglob('*_test.cpp') if not SKIP.intersection(path.relative_to(root).parts)]
    return {name for path in files for name in CASE.findall(path.read_text(encoding='utf-8'))}


def check(root, tests):
    tests = tests | written(root)
    known_cases = cases(root)
    problems = []
    for page in pages(root):
        text = page.read_text(encoding='utf-8')
        where = lambda m: f'{page.relative_to(root)}:{text.count(chr(10), 0, m.start()) + 1}'
        problems += [f'{where(m)}: {m.group(1)}: no such test' for m in NAME.finditer(text) if m.group(1) not in tests]
        for m in CASES.finditer(text):
            problems += [f'{where(m)}: "{case}": no such case' for case in re.findall(r'"([^"]+)"', m.group(1)) if case not in known_cases]
        for m in CHOICE.finditer(text):
            wanted = m.group(1) or m.group(2)
            if not any(re.search(wanted, test) for test in tests):
                problems.append(f'{where(m)}: ctest -R {wanted}: finds no test')
    return problems


TREE = {
    'CMakeLists.txt': 'aureole_add_test(module_test SOURCES a.cpp)\nadd_test(\n    NAME docs_links COMMAND x)\n'
                      'aureole_add_test(\n    model_${name}_test SOURCES b.cpp)\n',
    'b.cpp': 'TEST_CASE("no test of ours")',
    'b_test.cpp': 'TEST_CASE("one") {}\nTEST_CASE_TEMPLATE("two, and more",\n real, float) {}',
    'cases.md': '`module_test`, "one", "two, and more"; `module_test`, "one", "no test of ours"; "three"\n',
    'build/old.md': '`gone_test`\n',
    'room.md': '# A\n`module_test` [x_test.cpp](x_test.cpp) `x_test.cpp`\n`model_fog_test`, `models_test`, `shadow_test`\n'
               '`ctest --test-dir build\n-R ^model` `ctest -R passes`\n```sh\nctest -L slow -R \'^(fog|sky)$\' -V\nctest -R docs\n```\n',
}
WRONG = ['cases.md:1: "no test of ours": no such case',
         'room.md:3: models_test: no such test', 'room.md:3: shadow_test: no such test',
         'room.md:5: ctest -R passes: finds no test',
         'room.md:7: ctest -R ^(fog|sky)$: finds no test']


def self_test():
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for name, text in TREE.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text, encoding='utf-8')
        found = sorted(check(root, {'model_fog_test'}))
    return [] if found == WRONG else [f'self-test: expected {WRONG}, found {found}']


if __name__ == '__main__':
    if sys.argv[1] == '--self-test':
        report = self_test()
    else:
        report = check(pathlib.Path(sys.argv[1]), registered(sys.argv[2], sys.argv[3]))
    print('\n'.join(report) if report else 'every test that a page names exists')
    sys.exit(1 if report else 0)
