#!/usr/bin/env python3
"""docs/scenes.md: its example can be rendered, and its tables name every key of every section and no other.

    scene_test.py AUREOLE docs/scenes.md

What keys there are is asked of the application: it lists them when it rejects one.
"""
import os
import re
import subprocess
import sys
import tempfile

KEY = re.compile(r'`([a-z][a-z_]*)`')
# Section of the page; a scene whose last line is a key that does not exist; keys that open sections of their own.
SECTIONS = [
    ('The picture', 'x = 1\n', {'atmosphere', 'camera', 'sun', 'terrain'}),
    ('[[sun]]', '[[sun]]\nx = 1\n', set()),
    ('[camera]', '[camera]\nx = 1\n', set()),
    ('[terrain]', '[terrain]\nheightmap = "jacksboro"\nx = 1\n', set()),
]
TERM = '[[atmosphere.term]]\nname = "mie"\n'
KINDS = {'profile': ('exponential', 'tent', 'tabulated'),
         'phase': ('rayleigh', 'henyey_greenstein', 'cornette_shanks', 'henyey_greenstein_draine', 'tabulated')}


def render(program, scene, folder):
    """(exit code, message) for a small picture of a scene."""
    path = os.path.join(folder, 'scene.toml')
    with open(path, 'w', encoding='utf-8') as f:
        f.write(scene)
    command = [program, 'render', path, '-o', os.path.join(folder, 'scene.png'), '--size', '32x18', '--quality', 'low', '--backend', 'cpu']
    done = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    return done.returncode, done.stdout


def keys_of(program, scene, folder):
    message = render(program, scene, folder)[1]
    return set(message.rsplit('allowed: ', 1)[-1].strip().split(', '))


def tables(page, title):
    """The tables of a section: rows of cells, without the line below the header."""
    text = re.search(r'^## ' + re.escape(title) + r'\n(.*?)(?=^## |\Z)', page, re.M | re.S).group(1)
    found = [[line.split('|')[1:-1] for line in table.splitlines()] for table in re.findall(r'(?:^\|.*\n)+', text, re.M)]
    return [table[:1] + table[2:] for table in found]


def first_cells(table):
    return {key for row in table[1:] for key in KEY.findall(row[0])}


def compare(where, real, said):
    return [f'{where}: {key} is not documented' for key in sorted(real - said)] + \
           [f'{where}: {key} does not exist' for key in sorted(said - real)]


def check(program, page, folder):
    code, message = render(program, re.search(r'```toml\n(.*?)```', page, re.S).group(1), folder)
    problems = [] if code == 0 else [f'the example is not rendered: {message.strip()}']
    for title, scene, opens_section in SECTIONS:
        problems += compare(title, keys_of(program, scene, folder) - opens_section, first_cells(tables(page, title)[0]))
    planet, term, *kinds = tables(page, '[atmosphere]')
    problems += compare('[atmosphere]', keys_of(program, '[atmosphere]\nx = 1\n', folder) - {'term'}, first_cells(planet))
    problems += compare('[[atmosphere.term]]', keys_of(program, TERM + 'x = 1\n', folder), first_cells(term))
    for (part, names), table in zip(KINDS.items(), kinds, strict=True):
        for name in names:
            real = keys_of(program, TERM + f'{part} = {{ kind = "{name}", x = 1 }}\n', folder) - {'kind'}
            rows = [row for row in table if f'`"{name}"`' in row[0]]
            problems += compare(f'{part} {name}', real, {key for row in rows for key in KEY.findall(row[1])})
    return problems


if __name__ == '__main__':
    with open(sys.argv[2], encoding='utf-8') as f, tempfile.TemporaryDirectory() as temporary:
        report = check(sys.argv[1], f.read(), temporary)
    print('\n'.join(report) if report else 'the example renders; the page names every key')
    sys.exit(1 if report else 0)
