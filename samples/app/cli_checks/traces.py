"""`trace`: results to score against; interrupted and resumed."""
import json
import signal
import subprocess

from cli_checks.runner import AUREOLE, BACKEND, FOLDER, HEADER, QUICK, SCENES, expect, fails, put, works

SCENE = SCENES / 'truth_earth.toml'
GRID = ['--sun-zenith', '60,92', '--altitude', '0.2', '--view-zenith', '30', '--azimuth', '0,90']
TRACE = ['trace', SCENE, *BACKEND, '--max-paths', 4096]


def check_trace():
    """A grid of directions as a truth to score against."""
    out = works(*TRACE, *GRID, '--orders', 2, '-o', FOLDER / 'trace.csv')
    expect('4 directions, 16384 paths' in out and ' %' in out and BACKEND[1] + ' on ' in out, f'trace says what it did: {out}')
    comment, names, *rows = (FOLDER / 'trace.csv').read_text().splitlines()
    for part in ('bottom_radius_km=6360 ', 'seed=0 ', 'target_rel=0.005 ', 'max_paths=4096;', 'spectral=rgb', 'orders=2', '1/sr'):
        expect(part in comment, f'the comment of a trace holds {part}: {comment}')
    names = names.split(',')
    table = [dict(zip(names, map(float, row.split(',')))) for row in rows]
    expect(len(table) == 4 and [row['azimuth_deg'] for row in table] == [0, 90, 0, 90], f'a grid has every combination: {table}')
    for row in table:
        for c in 'rgb':
            all_, error = row[f'L_{c}_per_sr'], row[f'stderr_{c}_per_sr']
            first, second = row[f'order1_{c}_per_sr'], row[f'order2_{c}_per_sr']
            expect(0 < error < 0.1 * all_ and 0 < first + second < all_ and row['paths'] == 4096 and
                   abs(row[f'L1_{c}_per_sr'] + row[f'Lground1_{c}_per_sr'] - first) < 1e-6 * first and
                   0 < row[f'order2_stderr_{c}_per_sr'] < second and row[f'order1_stderr_{c}_per_sr'] == 0, f'trace wrote {row}')
    works('probe', '--scene', SCENE, *BACKEND, '--directions', FOLDER / 'trace.csv', '-o', FOLDER / 'probe.csv')
    works('score', FOLDER / 'probe.csv', FOLDER / 'trace.csv', '--by-ray', '--json', FOLDER / 'traced.json')
    score = json.loads((FOLDER / 'traced.json').read_text())
    expect(sum(s['rows'] for s in score) >= 2 and all(s['max'] < 0.1 for s in score), f'a trace is a truth to score against: {score}')


def check_trace_again():
    """The same directions from a table; a preset in wavelengths."""
    works(*TRACE, '--directions', FOLDER / 'trace.csv', '-o', FOLDER / 'again.csv', '--orders', 2)
    expect((FOLDER / 'again.csv').read_text() == (FOLDER / 'trace.csv').read_text(), 'its own directions give the same trace')
    works('trace', '--preset', 'mars', *BACKEND, *GRID, '-o', FOLDER / 'mars.csv', '--error', 1, '--spectral', 3, '--seed', 9)


def check_interrupted_trace():
    """Interrupted and resumed to the same result."""
    trace = ['trace', SCENE, *BACKEND, *GRID, '--error', '0.01%', '-o']
    paths = 16384 if QUICK else 40960  # long enough that the signal comes before the end
    most = ['--max-paths', paths]
    works(*trace, FOLDER / 'whole.csv', *most)
    run_file = FOLDER / 'run.json'
    again = [*trace, FOLDER / 'pieces.csv', '--checkpoint', run_file]
    program = subprocess.Popen([AUREOLE, *map(str, [*again, *most])], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    program.stderr.readline()  # a tenth is done
    program.send_signal(signal.SIGINT)
    said = program.communicate(timeout=240)[1]
    expect(program.returncode == 2 and 'aureole: interrupted with ' in said and '--resume goes on' in said,
           f'an interrupted trace says so: {program.returncode} {said}')
    expect(run_file.exists() and not (FOLDER / 'pieces.csv').exists(), 'an interrupted trace leaves its checkpoint alone')
    expect(not list(FOLDER.glob('.*.part')), 'an interrupted trace leaves nothing half-written')
    works(*again, '--resume', *most)
    expect((FOLDER / 'pieces.csv').read_text() == (FOLDER / 'whole.csv').read_text(), 'interrupted and resumed is the same')
    works(*again, '--resume', '--max-paths', paths + 4096)
    expect((FOLDER / 'pieces.csv').read_text().splitlines()[2].endswith(f',{paths + 4096}'), 'resumed with more paths goes further')


def check_trace_faults():
    """Among them: to go on from the checkpoint of an interrupted trace with something else."""
    checkpoint = ['--checkpoint', FOLDER / 'run.json', '--resume']
    fails('seed is 0 there and 1 here', *TRACE, *GRID, '-o', FOLDER / 'x.csv', *checkpoint, '--seed', 1)
    fails('bottom_radius_km is 6360 there and 3389.5 here', 'trace', '--preset', 'mars', *BACKEND, *GRID, '-o', FOLDER / 'x.csv', *checkpoint)
    fails('--checkpoint', *TRACE, *GRID, '-o', FOLDER / 'x.csv', *checkpoint[:2])
    fails('not a checkpoint', *TRACE, *GRID, '-o', FOLDER / 'x.csv', '--resume', '--checkpoint', put('bad.json', '{}'))
    fails('there is no such file', *TRACE, *GRID, '-o', FOLDER / 'x.csv', '--resume', '--checkpoint', FOLDER / 'none.json')
    to = ['-o', FOLDER / 'x.csv']
    fails('--resume requires --checkpoint', *TRACE, *GRID, *to, '--resume')
    fails('SCENE', 'trace', *BACKEND, *GRID, *to)
    fails('--preset', 'trace', *BACKEND, *GRID, *to, '--preset', 'venus')
    fails('SCENE', 'trace', SCENE, '--preset', 'mars', *BACKEND, *GRID, *to)
    fails('--azimuth: nothing', *TRACE, *GRID[:-2], *to)
    fails('--directions', *TRACE, *GRID, *to, '--directions', FOLDER / 'trace.csv')
    fails('view_zenith_deg: 200', *TRACE, *to, '--sun-zenith', 60, '--altitude', 0, '--view-zenith', 200, '--azimuth', 0)
    fails('f.csv:2: view_zenith_deg', *TRACE, *to, '--directions', put('f.csv', HEADER + '\n1,2,300,4\n'))
    for text in ('0', '-1%', 'small', '', '%', 'nan'):
        fails('--error', *TRACE, *GRID, *to, '--error=' + text)
    fails('error: 2 is not allowed', *TRACE, *GRID, *to, '--error', '200%')
    fails('max_paths: 100', *TRACE[:-1], 100, *GRID, *to)
    fails('orders: 65', *TRACE, *GRID, *to, '--orders', 65)
    fails('seed: 4096', *TRACE, *GRID, *to, '--seed', 4096)
    fails('--spectral', *TRACE, *GRID, *to, '--spectral', 2)
    fails('there is no folder', *TRACE, *GRID, '-o', FOLDER / 'none/x.csv')
    fails('there is no folder', *TRACE, *GRID, *to, '--checkpoint', FOLDER / 'none/x.json')
