#!/usr/bin/env python3
"""What cpack makes for Debian: its packages by name, what each needs, and what each holds; and that a project which asks for no more
than find_package(aureole 1.0) builds and runs with what libaureole-dev holds.

    debian_test.py CPACK BUILD_FOLDER WORK_FOLDER VERSION CMAKE

Exit code 77: there is no dpkg-deb here.
"""
import pathlib
import shutil
import subprocess
import sys

CPACK, BUILD, WORK, VERSION, CMAKE = sys.argv[1:]
WANTED = {
    'aureole': {
        'needs': ['libc6', 'libstdc++6', 'libtbb12'],  # told by dpkg-shlibdeps
        'holds': ['usr/bin/aureole', 'usr/share/man/man1/aureole.1.gz', 'usr/share/bash-completion/completions/aureole',
                  'usr/share/zsh/vendor-completions/_aureole', 'usr/share/fish/vendor_completions.d/aureole.fish',
                  'usr/share/aureole/scenes/noon.toml', 'usr/share/aureole/suites/small.toml', 'usr/share/doc/aureole/copyright',
                  'usr/share/doc/aureole/changelog.Debian.gz'],
        'never': ['.a', '.h', '.pc', '.cmake'],
    },
    'libaureole-dev': {
        'needs': ['libglm-dev', 'libspdlog-dev', 'libtbb12'],  # the last for the C library
        'holds': ['usr/include/aureole/atmosphere.h', 'usr/include/aureole/rhi/device.h', 'usr/include/aureole/glsl/aureole.glsl',
                  'usr/include/aureole/glsl/aureole_display.glsl',
                  'usr/lib/libaureole_atmosphere.a', 'usr/lib/pkgconfig/aureole.pc', 'usr/lib/pkgconfig/aureole-c.pc',
                  'usr/lib/libaureole_c.so.1', 'usr/lib/cmake/aureole/aureole-config.cmake',
                  'usr/share/doc/aureole/docs/integration.md', 'usr/share/doc/libaureole-dev/copyright'],
        'never': ['_test.h', '/aureole/scenes/noon.toml', 'bin/aureole', 'bin/aureole-viewer'],
    },
}
if (pathlib.Path(BUILD) / 'bin/aureole-viewer').exists():
    WANTED['aureole-viewer'] = {'needs': ['libglfw3', 'libstdc++6'], 'holds': ['usr/bin/aureole-viewer'],
                                'never': ['.a', '.h', 'bin/aureole']}


def output(*command, **options):
    return subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, text=True, check=True, **options).stdout


def check(package, wanted):
    found = list(pathlib.Path(WORK).glob(f'{package}_*.deb'))
    if len(found) != 1 or f'_{VERSION}-1_' not in found[0].name:
        return [f'{package}: {[path.name for path in found]}; wanted: one of version {VERSION}-1']
    depends = output('dpkg-deb', '--field', found[0], 'Depends')
    files = [line.split()[5].removeprefix('./') for line in output('dpkg-deb', '--contents', found[0]).splitlines()]
    files = [name for name in files if not name.endswith('/')]
    problems = [f'{package}: does not depend on {name}: {depends}' for name in wanted['needs'] if name not in depends]
    problems += [f'{package}: lacks {name}' for name in wanted['holds'] if name not in files]
    problems += [f'{package}: holds {name}' for name in files if name.endswith(tuple(wanted['never']))]
    return problems + [f'{package}: {name}: not below usr/' for name in files if not name.startswith('usr/')]


def build_with_package():
    """Problems of an outside project with the files of libaureole-dev alone."""
    root, build = pathlib.Path(WORK) / 'root', pathlib.Path(WORK) / 'plain'
    output('dpkg-deb', '--extract', next(pathlib.Path(WORK).glob('libaureole-dev_*.deb')), root)
    source = pathlib.Path(__file__).parent / 'plain'
    said = output(CMAKE, '-G', 'Ninja', '-S', source, '-B', build, f'-DCMAKE_PREFIX_PATH={root}/usr', '-DCMAKE_BUILD_TYPE=Release',
                  '-DCMAKE_FIND_PACKAGE_NO_PACKAGE_REGISTRY=ON')
    output(CMAKE, '--build', build)
    output(build / 'outside_plain')
    return [] if f'aureole_CONFIG: {root}/usr/' in said else ['find_package(aureole 1.0) found another package: ' + said]


if not (shutil.which('dpkg-deb') and shutil.which('dpkg-shlibdeps')):
    print('skipped: dpkg-deb and dpkg-shlibdeps are not here')
    sys.exit(77)
shutil.rmtree(WORK, ignore_errors=True)
output(CPACK, '-G', 'DEB', '-B', WORK, cwd=BUILD)
report = [problem for package, wanted in WANTED.items() for problem in check(package, wanted)]
report = report or build_with_package()
print('\n'.join(report) if report else f'{len(WANTED)} packages, with all that they should hold')
sys.exit(1 if report else 0)
