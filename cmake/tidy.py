#!/usr/bin/env python3
"""Runs clang-tidy 14 with the tree's .clang-tidy.

    cmake/tidy.py                 everything that build/release compiles, but for generated kernels
    cmake/tidy.py --build FOLDER  what another build folder compiles
    cmake/tidy.py --headers       the public headers alone, in files that include them all, one of C++ and one of C: no build is needed
    cmake/tidy.py PART...         of the build's files those whose path holds one of these words

Exit code 1 if anything is found. Files that the build compiles together are looked at together.
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
ROOMS = ('rhi', 'atmosphere', 'backends', 'samples', 'tests')
# Headers that C includes are looked at from C, for C++ has other ways of writing what they say.
C_HEADERS = (ROOT / 'atmosphere/c_api/include', ROOT / 'tests/c_api')
CLANG_TIDY = shutil.which('clang-tidy-14') or shutil.which('clang-tidy')


def ours(is_c):
    folders = {ROOT / room for room in ROOMS}
    if is_c:
        return f'^({"|".join(map(str, folders))})/.*\\.[ch]$'
    # These regular expressions know no exception: all folders beside that one.
    for outer in {parent for part in C_HEADERS for parent in part.parents if parent.is_relative_to(ROOT) and parent != ROOT}:
        folders.update(inner for inner in outer.iterdir() if inner.is_dir())
    folders -= {parent for part in C_HEADERS for parent in (part, *part.parents)}
    return f'^({"|".join(sorted(map(str, folders)))})/.*\\.(h|cpp)$|^{ROOT}/.*\\.cpp$'


def tidy(file, arguments):
    """Says what it found in a file (nothing: all is well), and the seconds it took."""
    started = time.monotonic()
    # g++ knows warnings that clang does not.
    command = [CLANG_TIDY, '--quiet', f'--header-filter={ours(str(file).endswith(".c"))}', '--extra-arg=-Wno-unknown-warning-option', str(file), *arguments]
    done = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False)
    said = done.stdout.strip()
    if done.returncode != 0 and not said:
        said = done.stderr.strip()
    return said if done.returncode != 0 else '', time.monotonic() - started


def options_for(file):
    # The files that a build makes of several of ours include them by design.
    return ['--checks=-bugprone-suspicious-include'] if '/Unity/' in file else []


def compiled(build, parts):
    """Of the build's files ours, and those that it makes of several of ours."""
    database = build / 'compile_commands.json'
    if not database.exists():
        sys.exit(f'{database}: there is none; configure first: cmake --preset release')
    files = {entry['file'] for entry in json.loads(database.read_text(encoding='utf-8'))}
    made = str(build.resolve()) + os.sep
    mine = [file for file in files if '/Unity/' in file or (not file.startswith(made) and file.startswith(str(ROOT) + os.sep))]
    return sorted(file for file in mine if not parts or any(part in file for part in parts))


def check_build(build, parts):
    files = compiled(build, parts)
    if not files:
        sys.exit(f'{build}: compiles no file of this name')
    bad, started = 0, time.monotonic()
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        runs = {pool.submit(tidy, file, ['-p', str(build), *options_for(file)]): file for file in files}
        for number, run in enumerate(concurrent.futures.as_completed(runs), 1):
            said, seconds = run.result()
            print(f'[{number}/{len(files)}] {os.path.relpath(runs[run], ROOT)}: {seconds:.0f} s', flush=True)
            if said:
                bad += 1
                print(said, flush=True)
    print(f'clang-tidy: {len(files)} files in {time.monotonic() - started:.0f} s, {bad} with findings')
    return bad


def check_together(parts, name, options):
    """The headers of some parts in one file that includes them all. Says how many they are, what was found, and the seconds it took."""
    folders = [ROOT / part / 'include' for part in parts]
    # Kernels' headers are included by kernels alone.
    headers = [header.relative_to(folder) for folder in folders for header in sorted(folder.rglob('*.h')) if 'kernel' not in header.parts]
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / name
        file.write_text(''.join(f'#include <{header.as_posix()}>\n' for header in headers), encoding='utf-8')
        options = ['-Wall', '-Wextra', *options, *(f'-I{path}' for path in folders)]
        return len(headers), *tidy(file, [f'--config-file={ROOT}/.clang-tidy', '--', *options])


def check_headers():
    cpp = check_together(('rhi', 'atmosphere', 'backends/cpu', 'backends/vulkan', 'tests/rhi'), 'headers.cpp',
                         ['-std=c++20', '-DSPDLOG_COMPILED_LIB', '-DSPDLOG_FMT_EXTERNAL'])
    c = check_together(('atmosphere/c_api',), 'headers.c', ['-std=c11'])
    said = cpp[1] + c[1]
    if said:
        print(said)
    print(f'clang-tidy: {cpp[0] + c[0]} public headers in {cpp[2] + c[2]:.0f} s, {"with findings" if said else "nothing found"}')
    return bool(said)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--headers', action='store_true')
    parser.add_argument('--build', type=pathlib.Path, default=ROOT / 'build/release')
    parser.add_argument('parts', nargs='*')
    options = parser.parse_args()
    if CLANG_TIDY is None:
        sys.exit('tidy.py: there is no clang-tidy; install clang-tidy-14')
    return 1 if (check_headers() if options.headers else check_build(options.build, options.parts)) else 0


if __name__ == '__main__':
    sys.exit(main())
