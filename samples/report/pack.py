#!/usr/bin/env python3
"""Makes one C++ file of the report's page: its parts, and the libraries of its charts with their licences.

    pack.py PAGE_FOLDER OUTPUT.cpp [NODE_MODULES]

report.html names what goes where in comments of its own: <!-- name --> is replaced by the part of that name. The page is cut at
<!-- data -->, where the program puts what was measured. Without NODE_MODULES the file holds no page.
"""
import json
import pathlib
import re
import sys

LIBRARIES = ('vega', 'vega-lite', 'vega-embed')
SLOT = re.compile(r'<!-- ([a-z_]+) -->')
DATA = 'data'


def inline(text, name):
    """Text as it may stand inside of an element: nothing in it ends that element."""
    for forbidden in ('</script', '</style', '<!--', '-->'):
        if forbidden in text.lower():
            sys.exit(f'{name}: holds {forbidden}, which cannot stand inside of a page')
    return text


def read(path):
    return inline(path.read_text(encoding='utf-8'), path)


def without_map(text):
    """The last line of a bundle points a debugger at a file that the page does not have."""
    return re.sub(r'\n?//# sourceMappingURL=.*\s*$', '\n', text)


def library(node_modules, name):
    version = json.loads((node_modules / name / 'package.json').read_text(encoding='utf-8'))['version']
    bundle = without_map(read(node_modules / name / 'build' / f'{name}.min.js'))
    return f'/* {name} {version}; its licence is at the head of this page */\n{bundle}'


def licences(node_modules):
    """Each text once, under the packages it stands for: everything a bundle may hold."""
    texts = {}
    for manifest in sorted([*node_modules.glob('*/package.json'), *node_modules.glob('@*/*/package.json')]):
        package = json.loads(manifest.read_text(encoding='utf-8'))
        files = sorted(path for path in manifest.parent.iterdir() if re.match(r'(?i)licen[cs]e', path.name))
        text = '\n'.join(read(path).strip() for path in files) or package['license']
        texts.setdefault(text, []).append(f'{package["name"]} {package["version"]}')
    return '\n\n'.join(f'== {", ".join(names)}\n\n{text}' for text, names in texts.items())


def page(folder, node_modules):
    parts = {
        'licences': '<!--\nThe charts are drawn by these libraries, under their licences:\n\n' + licences(node_modules) + '\n-->',
        'style': f'<style>\n{read(folder / "report.css")}</style>',
        'libraries': '\n'.join(f'<script>\n{library(node_modules, name)}</script>' for name in LIBRARIES),
        'scripts': '\n'.join(f'<script>\n{read(path)}</script>' for path in sorted(folder.glob('*.js'))),
    }
    template = (folder / 'report.html').read_text(encoding='utf-8')
    used = SLOT.findall(template)
    if sorted(used) != sorted([*parts, DATA]):
        sys.exit(f'report.html: has the slots {used}; wanted: each of {[*parts, DATA]} once')
    before, after = template.split(f'<!-- {DATA} -->')
    return [SLOT.sub(lambda match: parts[match.group(1)], half) for half in (before, after)]


def literal(text):
    """A C++ string, in pieces that compilers are quick with. A number of octal digits that is fixed ends by itself."""
    data = text.encode('utf-8')
    plain = {ord('\n'): '\\n', ord('"'): '\\"', ord('\\'): '\\\\', ord('?'): '\\?'}
    pieces = []
    for start in range(0, len(data), 8192):
        pieces.append(''.join(plain.get(byte) or (chr(byte) if 32 <= byte < 127 else f'\\{byte:03o}')
                              for byte in data[start:start + 8192]))
    return '\n'.join(f'    "{piece}"' for piece in pieces) or '    ""'


def main():
    folder, output = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    halves = page(folder, pathlib.Path(sys.argv[3])) if len(sys.argv) > 3 else ['', '']
    names = ('page_before_data', 'page_after_data')
    lines = ['// Made by pack.py.', '#include "report/page.h"', '', 'namespace aureole::app::report {', '']
    for name, half in zip(names, halves):
        lines += [f'const std::string_view {name}(', literal(half) + f',\n    {len(half.encode("utf-8"))});', '']
    output.write_text('\n'.join(lines + ['}  // namespace aureole::app::report', '']), encoding='utf-8')


if __name__ == '__main__':
    main()
