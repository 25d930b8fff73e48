#!/usr/bin/env python3
"""cmake/install_dependencies.sh reads the package database right, whatever it says: a stand-in for dpkg-query answers here.

Run by ctest with the root of the tree.
"""
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(sys.argv[1])
# What the database prints for a package: a status for each architecture (behind each, whatever the format asks for), and its exit code.
CASES = [
    (['installed'], 0, True), (['installed', 'installed'], 0, True), (['not-installed', 'installed'], 0, True),
    (['installed', 'config-files'], 0, True), (['not-installed'], 0, False), (['config-files', 'half-installed'], 0, False),
    ([], 1, False),
]
STAND_IN = """#!/bin/sh
# dpkg-query -W -f FORMAT PACKAGE
for status in {statuses}; do printf "$(printf '%s' "$3" | sed "s/\\${{db:Status-Status}}/$status/")"; done
exit {code}
"""
failures = []
for statuses, code, complete in CASES:
    with tempfile.TemporaryDirectory() as folder:
        tool = pathlib.Path(folder) / 'dpkg-query'
        tool.write_text(STAND_IN.format(statuses=' '.join(statuses), code=code))
        tool.chmod(0o755)
        result = subprocess.run([ROOT / 'cmake/install_dependencies.sh', '--no-install'], capture_output=True, text=True,
                                env={**os.environ, 'PATH': f'{folder}:{os.environ["PATH"]}'}, timeout=60)
    if (result.returncode == 0) != complete:
        failures.append(f'{statuses}: exit {result.returncode}: {result.stdout}{result.stderr}'.strip())
print('\n'.join(failures) if failures else 'packages are counted right')
sys.exit(1 if failures else 0)
