#!/usr/bin/env python3
"""Every public type of the headers says what it is: read from Doxygen's XML.

    undocumented.py XML_FOLDER

Types, enumerations and what can be called by a class are asked; fields and values whose name and type say all are not.
"""
import pathlib
import sys
import xml.etree.ElementTree as ElementTree

SKIP = ('aureole::kernels', 'aureole::shaders', 'std')


def says_nothing(element):
    return not any(''.join(each.itertext()).strip() for name in ('briefdescription', 'detaileddescription', 'inbodydescription')
                   for each in element.findall(name))


def where(element):
    place = element.find('location')
    return f'{place.get("file")}:{place.get("line")}' if place is not None else '?'


def check(folder):
    found, count = [], 0
    for path in sorted(folder.glob('*.xml')):
        for compound in ElementTree.parse(path).getroot().findall('compounddef'):
            kind, name = compound.get('kind'), compound.findtext('compoundname')
            if name.startswith(SKIP):
                continue
            if kind in ('class', 'struct') and compound.get('prot') == 'public' and compound.find('location') is not None:
                # A name that is only declared is not ours to describe.
                if compound.find('location').get('bodystart') is None:
                    continue
                count += 1
                if says_nothing(compound):
                    found.append(f'{where(compound)}: {kind} {name} says nothing of itself')
            if kind in ('class', 'struct', 'namespace'):
                for member in compound.iter('memberdef'):
                    if member.get('kind') == 'enum' and member.get('prot') == 'public':
                        count += 1
                        if says_nothing(member):
                            found.append(f'{where(member)}: enum {name}::{member.findtext("name")} says nothing of itself')
    return count, sorted(set(found))


if __name__ == '__main__':
    number, report = check(pathlib.Path(sys.argv[1]))
    if number == 0:
        report = [f'{sys.argv[1]}: there is no type']
    print('\n'.join(report) if report else f'{number} public types: each says what it is')
    sys.exit(1 if report else 0)
