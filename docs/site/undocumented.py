#!/usr/bin/env python3
"""Everything public in the headers says what it is: types, functions, fields, aliases and macros, as Doxygen's XML has them.

    undocumented.py ROOT          runs Doxygen over the headers of the tree, some seconds
    undocumented.py --xml FOLDER  reads what it has written
    undocumented.py --self-test   each kind of silence is found

Not asked: what says all by its name (values of enumerations, comparisons, destructors, copies), struct_size and X_defaults of the C API, which
its first page explains for all, and what is declared alone.
"""
import os
import pathlib
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

SKIP = ('aureole::kernels', 'aureole::shaders', 'std')
MEMBERS = {'enum', 'function', 'variable', 'typedef', 'define'}
BY_NAME = {'struct_size', 'impl', 'operator==', 'operator='}


def says_nothing(element):
    return not any(''.join(each.itertext()).strip() for name in ('briefdescription', 'detaileddescription', 'inbodydescription')
                   for each in element.findall(name))


def where(element):
    place = element.find('location')
    return f'{place.get("file")}:{place.get("line")}' if place is not None else '?'


def asked(member, owner):
    name, kind = member.findtext('name'), member.get('kind')
    if kind not in MEMBERS or member.get('prot') != 'public' or member.find('reimplements') is not None:
        return False
    # The enumerations of the C API have no name: the type before each says what it is.
    if kind == 'enum':
        return not name.startswith('@') and name != ''
    deleted_copy = name == owner.rsplit('::', 1)[-1] and '=delete' in member.findtext('argsstring', '').replace(' ', '')
    return not (name in BY_NAME or name.startswith('~') or name.endswith('_defaults') or deleted_copy)


def check(folder):
    found, seen = [], set()
    for path in sorted(folder.glob('*.xml')):
        for compound in ElementTree.parse(path).getroot().findall('compounddef'):
            kind, name = compound.get('kind'), compound.findtext('compoundname')
            if name.startswith(SKIP) or kind not in ('class', 'struct', 'union', 'namespace', 'file'):
                continue
            if kind in ('class', 'struct', 'union'):
                # A name that is only declared is not ours to describe.
                if compound.get('prot') != 'public' or compound.find('location') is None or compound.find('location').get('bodystart') is None:
                    continue
                seen.add(name)
                if says_nothing(compound):
                    found.append(f'{where(compound)}: {kind} {name} says nothing of itself')
            for member in compound.iter('memberdef'):
                if member.get('id') not in seen and asked(member, name):
                    seen.add(member.get('id'))
                    if says_nothing(member):
                        found.append(f'{where(member)}: {member.get("kind")} {member.findtext("name")} of {name} says nothing of itself')
    return len(seen), sorted(found)


def doxygen(settings, folder):
    """Its complaints; nothing but XML is written."""
    settings += f'\nOUTPUT_DIRECTORY = "{folder}"\nGENERATE_HTML = NO\nGENERATE_XML = YES\nXML_OUTPUT = xml\nWARN_AS_ERROR = NO\n'
    done = subprocess.run(['doxygen', '-'], input=settings, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    return done.stdout.splitlines() + ([f'doxygen: exit code {done.returncode}'] if done.returncode != 0 else [])


HEADER = """/// Told.
struct Told {
    Told(const Told&) = delete;
    ~Told();
    int field = 0;  ///< Told.
    int silent_field = 0;
    int a = 0, b = 0;  ///< Both.
    bool operator==(const Told&) const = default;
    void silent_method();
};
struct Silent { enum class Kind { a }; };
struct Declared;
void told();  ///< Told.
void silent();
using Alias = int;
"""
SILENT = ['function silent of', 'function silent_method of Told', 'enum Kind of Silent', 'struct Silent', 'typedef Alias of', 'variable silent_field of Told']


def self_test():
    with tempfile.TemporaryDirectory() as folder:
        header = pathlib.Path(folder) / 'header.h'
        header.write_text(HEADER, encoding='utf-8')
        report = doxygen(f'INPUT = "{header}"\nEXTRACT_ALL = YES\nGENERATE_LATEX = NO\nHAVE_DOT = NO\nQUIET = YES\nWARN_IF_UNDOCUMENTED = NO\n'
                         f'FILTER_PATTERNS = "*.h=python3 -B {os.path.relpath(pathlib.Path(__file__).with_name("share_comments.py"))}"\n', folder)
        report += check(pathlib.Path(folder) / 'xml')[1]
    missed = [each for each in SILENT if sum(f': {each} ' in line for line in report) != 1]
    return [f'self-test: wanted each of {SILENT} once, found {report}'] if missed or len(report) != len(SILENT) else []


def main():
    if sys.argv[1] == '--self-test':
        number, report = 1, self_test()
    elif sys.argv[1] == '--xml':
        number, report = check(pathlib.Path(sys.argv[2]))
    else:
        with tempfile.TemporaryDirectory() as folder:
            settings = (pathlib.Path(sys.argv[1]) / 'docs/site/Doxyfile').read_text(encoding='utf-8')
            report = doxygen(settings, folder)
            number, silent = check(pathlib.Path(folder) / 'xml')
            report += silent
    if number == 0:
        report = [*report, 'there is nothing to read']
    print('\n'.join(report) if report else f'{number} public types and members: each says what it is')
    return 1 if report else 0


if __name__ == '__main__':
    sys.exit(main())
