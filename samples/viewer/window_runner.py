"""Runs of aureole-viewer and of aureole for window_test.py, and what has failed."""
import pathlib
import subprocess
import sys
import time

from window_checks import read_png, skip

VIEWER, AUREOLE, SCENES = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
COLUMN = 440  # pixels of the panels, left of the picture
WIDTH, HEIGHT = 760, 400
AREA = (WIDTH - COLUMN, HEIGHT)
failures = []


def check(condition, message):
    if not condition:
        failures.append(message)


def values(said, field):
    """What `print FIELD` has said, in order."""
    return [line.split(' = ')[1] for line in said.splitlines() if line.startswith(field + ' = ')]


def view(name, script, *options, ok=True):
    """What a run prints, and its complaints."""
    path = pathlib.Path(f'{name}.txt')
    path.write_text(script, encoding='utf-8')
    started = time.monotonic()
    run = subprocess.run([VIEWER, *options, '--script', str(path), '--size', f'{WIDTH}x{HEIGHT}'], capture_output=True, text=True,
                         timeout=240, stdin=subprocess.DEVNULL)
    print(f'{name}: {time.monotonic() - started:.1f} s')
    if run.returncode == 77 or 'no Vulkan device' in run.stderr:
        skip(run.stderr.strip())
    if (run.returncode == 0) != ok:
        print('\n'.join(failures + [f'{name}: exit {run.returncode}: {run.stdout}{run.stderr}']))
        sys.exit(1)
    return run.stdout + run.stderr


def render(scene, output, *options):
    subprocess.run([AUREOLE, 'render', str(scene), '-o', output, '--size', '{}x{}'.format(*AREA), '--samples', '1', '--backend', 'vulkan',
                    *options], check=True, capture_output=True, timeout=120, stdin=subprocess.DEVNULL)
    return read_png(output)
