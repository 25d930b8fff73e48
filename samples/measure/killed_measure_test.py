#!/usr/bin/env python3
"""`aureole measure` is killed (SIGKILL) whenever it has kept something more: the runs that follow go on from that, and what they
end with is what an uninterrupted run measures.

Usage: killed_measure_test.py AUREOLE; the working folder is a scratch folder."""
import json
import pathlib
import shutil
import subprocess
import sys
import time

AUREOLE = sys.argv[1]
MEASURE = [AUREOLE, 'measure', '--suite', 'small', '--airs', 'mars', '--models', 'fog,single-lut', '--backend', 'cpu', '--rounds', '2',
           '--cost-size', '64x32', '--no-pictures', '--no-html', '-o']
MINUTES = 5


def kept(folder):
    """What is kept so far, and how much of it."""
    return {path: path.stat().st_size for path in folder.glob('items/**/*.json') if path.is_file()}


def run_until_more_is_kept(folder):
    """True if the run came to its end before it could be killed."""
    before = kept(folder)
    with subprocess.Popen([*MEASURE, folder], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) as process:
        while process.poll() is None and kept(folder) == before:
            time.sleep(0.001)
        process.kill()
        said = process.stderr.read()
        if process.wait() > 0:
            sys.exit(f'measure failed: {said}')
    return process.returncode == 0


def measured(folder):
    """All that does not depend on the clock."""
    found = json.loads((folder / 'measurements.json').read_text(encoding='utf-8'))
    costs = [{key: cost[key] for key in ('air', 'setting', 'per_frame', 'rebuild', 'bytes')} for cost in found['costs']]
    return found['scenes'], found['settings'], found['results'], costs


def main():
    whole, killed = pathlib.Path('whole'), pathlib.Path('killed')
    for folder in (whole, killed):
        shutil.rmtree(folder, ignore_errors=True)
    subprocess.run([*MEASURE, whole], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    kills, end = 0, time.monotonic() + 60 * MINUTES
    while not run_until_more_is_kept(killed):
        kills += 1
        if time.monotonic() > end:
            sys.exit(f'killed {kills} times and still not done after {MINUTES} minutes')
    # A look as it runs, in double and as fine as it gets and two rounds and a count of its costs, of each of two settings.
    if kills < 10:
        sys.exit(f'killed only {kills} times: too little is kept on the way')
    if measured(whole) != measured(killed):
        sys.exit('the interrupted runs measured something else')
    left = [str(path) for path in killed.glob('items/**/part_*')] + [str(path) for path in killed.glob('items/**/cost_rounds*')]
    if left:
        sys.exit(f'left behind: {left}')
    print(f'killed {kills} times; the same in the end')


main()
