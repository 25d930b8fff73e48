#!/usr/bin/env python3
"""The C API's shared library shows the functions that its headers declare, and nothing else: symbols_test.py HEADERS LIBRARY"""
import pathlib
import re
import subprocess
import sys


def main(headers, library):
    text = ''.join(path.read_text(encoding='utf-8') for path in sorted(pathlib.Path(headers).rglob('*.h')))
    declared = set(re.findall(r'^AUREOLE_API\s[^(]*?(aureole_\w+)\(', text, re.M))
    listing = subprocess.run(['nm', '-D', '--defined-only', library], stdout=subprocess.PIPE, text=True, check=True).stdout
    shown = {line.split()[-1] for line in listing.splitlines()}
    problems = [f'{name} is declared and not there' for name in sorted(declared - shown)]
    problems += [f'{name} is there and not declared' for name in sorted(shown - declared)]
    print('\n'.join(problems) or f'{len(declared)} functions')
    return 1 if problems or len(declared) < 50 else 0


if __name__ == '__main__':
    sys.exit(main(*sys.argv[1:]))
