#!/usr/bin/env python3
"""The page of the C API lists every number of every model by its name, and no other: numbers_page_test.py ATMOSPHERE/C_API"""
import pathlib
import re
import sys

# Who makes the fields of which model: a function for each settings struct, and one for what two of them share.
STRUCTS = {'QualitySettings': 'aureole', 'BrunetonSettings': 'bruneton', 'HillaireSettings': 'hillaire', 'SingleLutSettings': 'single-lut',
           'SingleSettings': 'single', 'FogSettings': 'fog', 'ReferenceSettings': 'reference'}


def main(folder):
    source = (folder / 'src/numbers.cpp').read_text(encoding='utf-8')
    page = (folder / 'c_api.md').read_text(encoding='utf-8').partition('## Numbers of a model')[2]
    problems = []
    for struct, model in STRUCTS.items():
        body = re.search(r'Fields fields_of\(' + struct + r'& s\) {(.*?)\n}', source, re.S)[1]
        names = set(re.findall(r'{"([\w.]+)", &s\.', body))
        if model == 'single':
            names |= set(re.findall(r'{"(dome\.[\w.]+)", ', source))
        row = re.search(r'^\| `' + model + r'` .*?\| (.*) \|$', page, re.M)[1]
        listed = set(re.findall(r'`([\w.]+)`', row))
        problems += [f'{model}: {name} is not on the page' for name in sorted(names - listed)]
        problems += [f'{model}: {name} is on the page alone' for name in sorted(listed - names)]
        if len(names) < 5:
            problems.append(f'{model}: {len(names)} names read from numbers.cpp')
    print('\n'.join(problems) or 'every number is on the page')
    return 1 if problems else 0


if __name__ == '__main__':
    sys.exit(main(pathlib.Path(sys.argv[1])))
