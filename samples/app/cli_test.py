#!/usr/bin/env python3
"""The application as a user sees it: results, one clear line and exit code 2 for every fault, nothing partial left behind.

Usage: cli_test.py AUREOLE SCENES [BACKEND [quick]]; works in a folder of its own, which goes with it. Exit code 77: there is no device to test on.
"quick" leaves out what takes a slow build minutes: pictures of every model, the bench, a plan that is measured.
"""
import atexit
import json
import os
import pathlib
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time

AUREOLE, SCENES = str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2]).resolve()
BACKEND = ['--backend', sys.argv[3] if len(sys.argv) > 3 else 'cpu']
QUICK = sys.argv[4:] == ['quick']
CALIBRATE = ['--calibrate'] if BACKEND[1] == 'vulkan' else []  # many pixels: minutes on a CPU under sanitizers
FOLDER = pathlib.Path('cli')
failures = []


def run(*arguments, file_bytes=None):
    limit = None if file_bytes is None else lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (file_bytes, file_bytes))
    return subprocess.run([AUREOLE, *map(str, arguments)], capture_output=True, text=True, timeout=240, preexec_fn=limit)


def timed(check, *arguments):
    start = time.monotonic()
    result = check(*arguments)
    print(f'{check.__name__}: {time.monotonic() - start:.1f} s', flush=True)
    return result


def expect(truth, what, result=None):
    if not truth:
        failures.append(what if result is None else f'{what}: exit {result.returncode}\n{result.stdout}{result.stderr}')


def works(*arguments):
    result = run(*arguments)
    expect(result.returncode == 0, f'works {arguments}', result)
    return result.stdout


def fails(part, *arguments, file_bytes=None):
    """Exit code 2, one line on stderr that holds `part`, and no new file."""
    before = sorted(FOLDER.iterdir())
    result = run(*arguments, file_bytes=file_bytes)
    lines = result.stderr.splitlines()
    expect(result.returncode == 2 and len(lines) == 1 and lines[0].startswith('aureole: ') and part in lines[0],
           f'fails with {part!r}: {arguments}', result)
    expect(sorted(FOLDER.iterdir()) == before, f'{arguments} left files behind')


def vulkan_runs():
    """A line "can run" in the part about Vulkan, which comes first."""
    lines = [line.strip() for line in run('devices').stdout.splitlines()]
    return 'can run' in lines[:next(i for i, line in enumerate(lines) if line.startswith('cpu '))]


def models():
    """The names that `aureole devices` lists."""
    lines = run('devices').stdout.splitlines()
    return [line.split()[0] for line in lines[next(i for i, line in enumerate(lines) if line.startswith('models')) + 1:] if line]


def put(name, text):
    path = FOLDER / name
    path.write_text(text)
    return path


def check_render():
    noon, small = SCENES / 'noon.toml', ['--size', '64x36', '--quality', 'low', *BACKEND]
    out = works('render', noon, '-o', FOLDER / 'a.png', *small)
    expect((FOLDER / 'a.png').read_bytes().startswith(b'\x89PNG'), 'a.png is a PNG')
    for part in ('a.png', 'transmittance', 'composite', ' ms', BACKEND[1] + ' on '):
        expect(part in out, f'render prints {part!r}: {out}')
    works('render', noon, '-o', FOLDER / 'a.exr', '--raster', '--projection', 'fisheye', *small)
    expect((FOLDER / 'a.exr').read_bytes().startswith(b'\x76\x2f\x31\x01'), 'a.exr is an EXR')
    works('render', noon, '-o', FOLDER / 'p.png', '--projection', 'panorama', '--samples', 1, *small)
    works('render', noon, '-o', FOLDER / 's.png', '--sun-elevation', '-5:20', '--frames', 3, *small)
    works('render', noon, '-o', FOLDER / 't%02d.png', '--sun-elevation', '-5:20', '--frames', 2, *small)
    pictures = set()
    drawn = [model for model in models() if not QUICK or model in ('fog', 'hillaire')]
    for model in drawn:
        out = works('render', noon, '-o', FOLDER / f'm-{model}.exr', '--model', model, *small)
        expect(f'model {model}, quality low' in out, f'render says which model: {out}')
        pictures.add((FOLDER / f'm-{model}.exr').read_bytes())
    expect(len(pictures) == len(drawn) > 1, 'every model has its own picture')
    result = run('render', noon, '-o', FOLDER / 'r.png', '--model', 'reference', '--size', '16x9', '--quality', 'low', *BACKEND)
    expect('4/4  100%' in result.stderr and 'film' in result.stdout, 'the path tracer tells its progress', result)
    for spectral in ('3', '12'):
        out = works('render', noon, '-o', FOLDER / f's-{spectral}.exr', '--spectral', spectral, *small)
        expect(f'quality low, {spectral} wavelengths' in out, f'render says how many wavelengths: {out}')
        pictures.add((FOLDER / f's-{spectral}.exr').read_bytes())
    expect(len(pictures) == len(drawn) + 2, 'every set of wavelengths has its own picture')
    dusk = SCENES / 'twilight.toml'
    expect('4 wavelengths' in works('render', dusk, '-o', FOLDER / 'd.exr', *small), 'the wavelengths of the scene')
    out = works('render', dusk, '-o', FOLDER / 'd.exr', '--model', 'single', *small)
    expect('model single, quality low, 4 wavelengths' in out, f'another model in the wavelengths of the scene: {out}')
    scene = put('model.toml', 'model = "hillaire"\n' + noon.read_text())
    works('render', scene, '-o', FOLDER / 'scene.exr', *small)
    expect((FOLDER / 'scene.exr').read_bytes() == (FOLDER / 'm-hillaire.exr').read_bytes(), 'the model of the scene')
    for name in ('s-0001.png', 's-0003.png', 't01.png', 't02.png'):
        expect((FOLDER / name).exists(), f'{name} exists')
    expect((FOLDER / 's-0001.png').read_bytes() != (FOLDER / 's-0003.png').read_bytes(), 'the sun moves')


def check_render_faults():
    noon, terrain = SCENES / 'noon.toml', SCENES / 'terrain_near.toml'
    out = ['-o', FOLDER / 'x.png', *BACKEND]
    fails('no_scene.toml: there is no such file', 'render', 'no_scene.toml', *out)
    fails('--output', 'render', noon, *BACKEND)
    fails('a name that ends in .png or .exr', 'render', noon, '-o', FOLDER / 'x.jpg', *BACKEND)
    fails('there is no folder', 'render', noon, '-o', FOLDER / 'none/x.png', *BACKEND)
    fails('--size', 'render', noon, *out, '--size', '100')
    fails('--size', 'render', noon, *out, '--size', '0x100')
    fails('--quality', 'render', noon, *out, '--quality', 'ultra')
    fails('--model', 'render', noon, *out, '--model', 'preetham')
    fails('--spectral', 'render', noon, *out, '--spectral', '2')
    fails('model.toml:1: model: "preetham"', 'render', put('model.toml', 'model = "preetham"\n'), *out)
    fails('--backend', 'render', noon, '-o', FOLDER / 'x.png', '--backend', 'metal')
    fails('--projection', 'render', noon, *out, '--projection', 'mercator')
    fails('perspective, for a scene with terrain', 'render', terrain, *out, '--projection', 'fisheye')
    fails('--samples', 'render', noon, *out, '--samples', '5')
    fails('--sun-elevation', 'render', noon, *out, '--sun-elevation', '5', '--frames', '2')
    fails('--frames', 'render', noon, *out, '--sun-elevation', '5:6')
    fails('--frames', 'render', noon, *out, '--sun-elevation', '5:6', '--frames', '1')
    fails('at most one %d', 'render', noon, '-o', FOLDER / 'x%s.png', *BACKEND, '--sun-elevation', '5:6', '--frames', '2')
    fails('a scene with a [terrain] section', 'render', noon, *out, '--heightmap', 'jacksboro')
    fails('there is no such file', 'render', terrain, *out, '--heightmap', 'none.npz')
    fails('not a readable .npz archive', 'render', terrain, *out, '--heightmap', put('bad.npz', 'no zip'))
    fails('not a readable PNG', 'render', terrain, *out, '--heightmap', put('bad.png', 'no png'))
    fails('not a readable EXR', 'render', terrain, *out, '--heightmap', put('bad.exr', 'no exr'))
    lost = put('lost.toml', '[terrain]\n\nheightmap = "lost.png"\n')
    fails('lost.toml:3: terrain.heightmap: ' + str(FOLDER / 'lost.png') + ': there is no such file', 'render', lost, *out)
    fails('--heightmap: none.npz', 'render', terrain, *out, '--heightmap', 'none.npz')
    fails('typo.toml:3: camera.altitude: this key', 'render', put('typo.toml', '[camera]\n\naltitude = 5\n'), *out)
    fails('size.toml:1: size', 'render', put('size.toml', 'size = [-1, 5]\n'), *out)
    fails('not TOML', 'render', put('broken.toml', '[camera\n'), *out)
    fails('', 'render', noon, '-o', FOLDER / 'x.png', '--backend', 'vulkan', '--device', 'no such device')
    fails('[640.5, 360]', 'render', put('half.toml', 'size = [640.5, 360]\n'), *out)
    fails('--size 16384x20 with --samples 2: a composite of 32768x40', 'render', noon, *out, '--size', '16384x20')
    fails('--size: 16384x9 is not allowed; allowed: one side', 'render', noon, *out, '--size', '16384x9')
    fails('--size 9x8192 with --samples 4: a composite of 36x32768', 'render', noon, *out, '--size', '9x8192', '--samples', '4')


def check_places_that_take_no_files():
    """Folders that are none, that not even root may write to, and files that may not grow (SIGXFSZ)."""
    noon, small = SCENES / 'noon.toml', ['--size', '64x36', '--quality', 'low', '--samples', 1, '--model', 'fog', *BACKEND]
    plain, old = put('plain', 'text'), put('old.png', 'old')
    fails(f'{plain}/x.png: cannot be written: there is no folder {plain}', 'render', noon, *small, '-o', plain / 'x.png')
    fails('/proc/x.png: cannot be written', 'render', noon, *small, '-o', '/proc/x.png')
    fails(f'{plain}/x.toml: there is no such file', 'render', plain / 'x.toml', *small, '-o', FOLDER / 'x.png')
    for name in ('old.png', 'new.exr'):
        fails(f'{name}: cannot be written', 'render', noon, *small, '-o', FOLDER / name, file_bytes=100)
    rows = put('in.csv', 'sun_zenith_deg,altitude_km,view_zenith_deg,azimuth_deg\n' + '30,0.2,10,45\n' * 20)
    fails('new.csv: cannot be written', 'probe', '--scene', noon, '--directions', rows, '--model', 'fog', *BACKEND, '-o',
          FOLDER / 'new.csv', file_bytes=100)
    trace = ['trace', '--preset', 'airless', '--directions', rows, *BACKEND, '--max-paths', 4096, '-o', FOLDER / 'new.csv']
    result = run(*trace, '--checkpoint', FOLDER / 'new.json', file_bytes=100)
    said = [line for line in result.stderr.splitlines() if line.startswith('aureole: ')]
    expect(result.returncode == 2 and said == [f'aureole: {FOLDER}/new.json: cannot be written (is the disk full?)'],
           'a checkpoint that cannot be written is told', result)
    expect(not list(FOLDER.glob('*new.*')), 'and leaves nothing')
    fails('new.md: cannot be written', 'report', SCENES.parent / 'report/example.json', '--markdown', FOLDER / 'new.md', file_bytes=100)
    expect(old.read_bytes() == b'old', 'a file that cannot be replaced stays')


def check_options_of_another_backend():
    noon, out = SCENES / 'noon.toml', ['-o', FOLDER / 'x.png']
    for backend in ('cpu', 'cpu-double'):
        fails(f'--device llvm: --backend {backend} is not allowed', 'render', noon, *out, '--backend', backend, '--device', 'llvm')
        fails(f'--validation: --backend {backend} is not allowed', 'bench', '--backend', backend, '--validation')
    fails('--threads 2: --backend vulkan is not allowed', 'render', noon, *out, '--backend', 'vulkan', '--threads', 2)
    if BACKEND[1] == 'vulkan':
        fails('--threads 2: --backend auto, which is vulkan here', 'render', noon, *out, '--threads', 2)
        fails('--device: no such device is not allowed', 'render', noon, *out, '--device', 'no such device')


def check_interrupted_sequence():
    """A sequence that fails says what it has written; a size beyond the meter's is no trouble."""
    noon, small = SCENES / 'noon.toml', ['--size', '32x18', '--quality', 'low', '--samples', 1, *BACKEND]
    (FOLDER / 'q-0003.png').mkdir()
    result = run('render', noon, '-o', FOLDER / 'q.png', '--sun-elevation', '5:20', '--frames', 5, *small)
    said = f'2 of 5 pictures were written: {FOLDER}/q-0001.png .. {FOLDER}/q-0002.png'
    expect(result.returncode == 2 and said in result.stderr, 'a sequence says what it has written', result)
    expect(sorted(path.name for path in FOLDER.glob('q*')) == ['q-0001.png', 'q-0002.png', 'q-0003.png'], 'nothing partial')
    works('render', noon, '-o', FOLDER / 'tall.png', '--size', '4x2000', '--quality', 'low', *BACKEND)


def check_probe():
    header = 'sun_zenith_deg,altitude_km,view_zenith_deg,azimuth_deg'
    rows = put('in.csv', f'# comment\n{header},L_r_per_sr,note\n30,0.2,10,45,1,x\n85,10,95,0,2,y\n')
    scene = SCENES / 'truth_earth.toml'
    probe = ['probe', '--scene', scene, *BACKEND, '--quality', 'low', '-o']
    works(*probe, FOLDER / 'other.csv', '--directions', rows, '--model', 'hillaire')
    works(*probe, FOLDER / 'out.csv', '--directions', rows)
    expect(', model hillaire, quality low' in (FOLDER / 'other.csv').read_text(), 'a probe says which model')
    lines = [line for line in (FOLDER / 'out.csv').read_text().splitlines() if not line.startswith('#')]
    expect(lines[0] == header + ',r,g,b' and lines[1].startswith('30,0.2,10,45,') and len(lines) == 3, f'probe wrote {lines}')
    expect(all(0 < float(x) < 1 for line in lines[1:] for x in line.split(',')[4:]), f'plausible radiances {lines}')
    for part, text in (('column azimuth_deg is missing', 'sun_zenith_deg,altitude_km,view_zenith_deg\n1,2,3\n'),
                       ('f.csv:2: azimuth_deg: "nan"', header + '\n1,2,3,nan\n'), ('f.csv:2: 3 cells', header + '\n1,2,3\n'),
                       ('holds no row', header + '\n'), ('holds no row', ''), ('f.csv:3: view_zenith_deg: 300', header + '\n1,2,3,4\n1,2,300,4\n')):
        fails(part, *probe, FOLDER / 'x.csv', '--directions', put('f.csv', text))
    fails('there is no such file', *probe, FOLDER / 'x.csv', '--directions', 'none.csv')
    fails('there is no folder', *probe, FOLDER / 'none/x.csv', '--directions', rows)
    return FOLDER / 'out.csv'


def check_score(result):
    lines = [line.split(',') for line in result.read_text().splitlines() if not line.startswith('#')][1:]
    columns = 'sun_zenith_deg,altitude_km,view_zenith_deg,azimuth_deg,L_r_per_sr,L_g_per_sr,L_b_per_sr,' \
              'stderr_r_per_sr,stderr_g_per_sr,stderr_b_per_sr\n'
    truth = put('truth.csv', columns + ''.join(','.join(line) + ',0,0,0\n' for line in lines))
    works('score', result, truth, '--json', FOLDER / 'score.json', '--by-altitude', '--by-ray', '--bottom-radius-km', 6360)
    score = json.loads((FOLDER / 'score.json').read_text())
    expect([(s['sun_zenith_deg'], s['ray'], s['rows'], s['max']) for s in score] == [(30, 'sky', 1, 0), (85, 'ground', 1, 0)],
           f'score of a table against itself: {score}')
    fails('--bottom-radius-km', 'score', result, truth, '--by-ray')
    fails('--bottom-radius-km requires --by-ray', 'score', result, truth, '--bottom-radius-km', 6360)
    fails('column r is missing', 'score', truth, truth)


def check_trace():
    """A trace can be scored against, interrupted, and resumed to the same result."""
    header = 'sun_zenith_deg,altitude_km,view_zenith_deg,azimuth_deg'
    scene, grid = SCENES / 'truth_earth.toml', ['--sun-zenith', '60,92', '--altitude', '0.2', '--view-zenith', '30', '--azimuth', '0,90']
    trace = ['trace', scene, *BACKEND, '--max-paths', 4096]
    out = works(*trace, *grid, '--orders', 2, '-o', FOLDER / 'trace.csv')
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
    works('probe', '--scene', scene, *BACKEND, '--directions', FOLDER / 'trace.csv', '-o', FOLDER / 'probe.csv')
    works('score', FOLDER / 'probe.csv', FOLDER / 'trace.csv', '--by-ray', '--json', FOLDER / 'traced.json')
    score = json.loads((FOLDER / 'traced.json').read_text())
    expect(sum(s['rows'] for s in score) >= 2 and all(s['max'] < 0.1 for s in score), f'a trace is a truth to score against: {score}')
    works(*trace, '--directions', FOLDER / 'trace.csv', '-o', FOLDER / 'again.csv', '--orders', 2)
    expect((FOLDER / 'again.csv').read_text() == (FOLDER / 'trace.csv').read_text(), 'its own directions give the same trace')
    works('trace', '--preset', 'mars', *BACKEND, *grid, '-o', FOLDER / 'mars.csv', '--error', 1, '--spectral', 3, '--seed', 9)

    check_interrupted_trace(grid)
    checkpoint = ['--checkpoint', FOLDER / 'run.json', '--resume']
    fails('seed is 0 there and 1 here', *trace, *grid, '-o', FOLDER / 'x.csv', *checkpoint, '--seed', 1)
    fails('bottom_radius_km is 6360 there and 3389.5 here', 'trace', '--preset', 'mars', *BACKEND, *grid, '-o', FOLDER / 'x.csv', *checkpoint)
    fails('--checkpoint', *trace, *grid, '-o', FOLDER / 'x.csv', *checkpoint[:2])
    fails('not a checkpoint', *trace, *grid, '-o', FOLDER / 'x.csv', '--resume', '--checkpoint', put('bad.json', '{}'))
    fails('there is no such file', *trace, *grid, '-o', FOLDER / 'x.csv', '--resume', '--checkpoint', FOLDER / 'none.json')
    to = ['-o', FOLDER / 'x.csv']
    fails('--resume requires --checkpoint', *trace, *grid, *to, '--resume')
    fails('SCENE', 'trace', *BACKEND, *grid, *to)
    fails('--preset', 'trace', *BACKEND, *grid, *to, '--preset', 'venus')
    fails('SCENE', 'trace', scene, '--preset', 'mars', *BACKEND, *grid, *to)
    fails('--azimuth: nothing', *trace, *grid[:-2], *to)
    fails('--directions', *trace, *grid, *to, '--directions', FOLDER / 'trace.csv')
    fails('view_zenith_deg: 200', *trace, *to, '--sun-zenith', 60, '--altitude', 0, '--view-zenith', 200, '--azimuth', 0)
    fails('f.csv:2: view_zenith_deg', *trace, *to, '--directions', put('f.csv', header + '\n1,2,300,4\n'))
    for text in ('0', '-1%', 'small', '', '%', 'nan'):
        fails('--error', *trace, *grid, *to, '--error=' + text)
    fails('error: 2 is not allowed', *trace, *grid, *to, '--error', '200%')
    fails('max_paths: 100', *trace[:-1], 100, *grid, *to)
    fails('orders: 65', *trace, *grid, *to, '--orders', 65)
    fails('seed: 4096', *trace, *grid, *to, '--seed', 4096)
    fails('--spectral', *trace, *grid, *to, '--spectral', 2)
    fails('there is no folder', *trace, *grid, '-o', FOLDER / 'none/x.csv')
    fails('there is no folder', *trace, *grid, *to, '--checkpoint', FOLDER / 'none/x.json')


def check_interrupted_trace(grid):
    trace = ['trace', SCENES / 'truth_earth.toml', *BACKEND, *grid, '--error', '0.01%', '-o']
    most = ['--max-paths', '40960']
    works(*trace, FOLDER / 'whole.csv', *most)
    run_file = FOLDER / 'run.json'
    again = [*map(str, trace), str(FOLDER / 'pieces.csv'), '--checkpoint', str(run_file)]
    program = subprocess.Popen([AUREOLE, *again, *most], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    program.stderr.readline()  # a tenth is done
    program.send_signal(signal.SIGINT)
    said = program.communicate(timeout=240)[1]
    expect(program.returncode == 2 and 'aureole: interrupted with ' in said and '--resume goes on' in said,
           f'an interrupted trace says so: {program.returncode} {said}')
    expect(run_file.exists() and not (FOLDER / 'pieces.csv').exists(), 'an interrupted trace leaves its checkpoint alone')
    expect(not list(FOLDER.glob('.*.part')), 'an interrupted trace leaves nothing half-written')
    works(*again, '--resume', *most)
    expect((FOLDER / 'pieces.csv').read_text() == (FOLDER / 'whole.csv').read_text(), 'interrupted and resumed is the same')
    works(*again, '--resume', '--max-paths', 45056)
    expect((FOLDER / 'pieces.csv').read_text().splitlines()[2].endswith(',45056'), 'resumed with more paths goes further')


def check_bench():
    out = works('bench', *BACKEND, '--size', '32x16', '--frames', 1, '--json', FOLDER / 'bench.json')
    known = models()
    bench = json.loads((FOLDER / 'bench.json').read_text())
    expect([(m['model'], m['quality']) for m in bench['models']] ==
           [(m, q) for m in ('aureole', 'hillaire') for q in ('low', 'default', 'high')], 'bench: models')
    expect(all(p['median_ms'] > 0 and p['bytes_written'] > 0 for m in bench['models'] for p in m['passes'] if p['invocations']),
           'bench: passes')
    expect(bench['models'][4]['ratio'] == {'to': 'hillaire default', 'per_frame': 1, 'full_rebuild': 1}, 'bench: ratio to itself')
    expect('hillaire default' in out and 'per frame' in out, 'bench prints a table')
    out = works('bench', *BACKEND, '--size', '32x16', '--frames', 1, '--model', 'aureole,aureole', '--quality', 'low')
    expect('aureole low' in out and 'aureole default' not in out and 'relative to aureole low' in out, f'bench of one: {out}')


def check_bench_and_devices():
    if not QUICK:
        check_bench()
    fails('--model', 'bench', *BACKEND, '--model', 'aureole,preetham')
    fails('--quality', 'bench', *BACKEND, '--quality', 'low,ultra')
    fails('--preset: none not in {earth,hazy_earth,mars,airless', 'bench', *BACKEND, '--preset', 'none')
    expect('earth, hazy_earth, mars, airless' in works('bench', '--help'), 'bench says which presets it takes')
    fails('--frames: 0 is not allowed; allowed: 1 to 100000', 'bench', *BACKEND, '--frames', 0)
    for text in ('abc', '3x', '-1', '1.5'):
        fails(f'--frames: "{text}" is not a whole number', 'bench', *BACKEND, f'--frames={text}')
    fails('--frames: 99999999999 is not allowed', 'bench', *BACKEND, '--frames', '99999999999')
    fails('there is no folder', 'bench', *BACKEND, '--json', FOLDER / 'none/x.json')
    out = works('devices')
    expect('cpu-double' in out and 'vulkan' in out, f'devices: {out}')
    known = models()
    for text in (out, works('--help'), works('render', '--help'), works('probe', '--help'), works('bench', '--help')):
        expect(all(any(line.split()[:1] == [name] and len(line.split()) > 3 for line in text.splitlines()) for name in known),
               f'every model has a line: {text}')


def check_measure():
    """A suite's truth is traced and kept; what is measured is kept, too."""
    def suite(elevations, more=''):
        return put('tiny.toml', 'truth_error = 0.1\ntruth_max_paths = 4096\n[[air]]\nname = "earth"\n[[scenes]]\nclass = "Day"\n'
                   f'air = "earth"\nsun_elevation_deg = {elevations}\naltitude_m = [2]\n[[setting]]\nmodel = ["fog", "single-lut"]\n{more}')
    tiny, table = suite('[30]'), FOLDER / 'truth/earth.csv'
    fails('earth.csv lacks scenes of the suite; `aureole truth` adds them', 'measure', '--suite', tiny, *BACKEND, '-o', FOLDER / 'report')
    expect('are missing' in works('truth', tiny) and 'complete' in works('truth', tiny), 'truth says what is missing')
    first = table.read_text().splitlines()
    works('truth', suite('[30, 10]'), '--airs', 'earth')
    fails('--airs: mars is not allowed', 'truth', suite('[30, 10]'), '--airs', 'mars')
    more = table.read_text().splitlines()
    expect(len(more) > 1.8 * len(first) - 4 and set(first) < set(more), 'truth adds what is missing and leaves the rest')
    works('truth', suite('[30]'))
    out = works('measure', '--suite', tiny, *BACKEND, '-o', FOLDER / 'report', '--rounds', 1, '--cost-size', '64x36',
                '--no-html')
    expect('single-lut default' in out and 'median_%' in out and BACKEND[1] + ' on ' in out, f'measure says what it did: {out}')
    measured = json.loads((FOLDER / 'report/measurements.json').read_text())
    errors = {r['setting']: r['regions']['all']['median'] for r in measured['results']}
    expect(errors['fog default'] > errors['single-lut default'] > 0.1, f'measure: errors {errors}')
    expect(all(r['split']['all']['model']['median'] > 0 for r in measured['results']) and measured['library'], 'measure: parts')
    expect([c['setting'] for c in measured['costs']] == ['fog default', 'single-lut default'] and
           measured['costs'][1]['composite_ms']['median'] > 0 and measured['costs'][1]['rebuild']['medium_evaluations'] > 0 and
           measured['pictures'] == [], f'measure: costs {measured["costs"]}')
    expect(measured['cost_size'] == [64, 36], 'measure: size of the pictures with costs')
    fails('--cost-size: "huge"', 'measure', '--suite', tiny, *BACKEND, '--cost-size', 'huge', '-o', FOLDER / 'report')
    expect((FOLDER / 'report/tables.md').exists() and (FOLDER / 'report/results.csv').exists(), 'measure: tables')
    fails('--models', 'measure', '--suite', tiny, *BACKEND, '--models', 'aureole', '-o', FOLDER / 'report')
    fails('none.toml', 'measure', '--suite', FOLDER / 'none.toml', *BACKEND, '-o', FOLDER / 'report')
    fails('--suite: "tiny" is not allowed; allowed: full, small', 'measure', '--suite', 'tiny', *BACKEND, '-o', FOLDER / 'report')
    fails('tiny.toml:13: setting[0].colour', 'measure', '--suite', suite('[30]', '\ncolour = 1\n'), *BACKEND, '-o', FOLDER / 'report')
    suite('[30]')
    put('truth/earth.csv', '\n'.join(more).replace('ground_albedo=0.3,', 'ground_albedo=0.4,'))
    fails('is the truth of another air', 'measure', '--suite', tiny, *BACKEND, '-o', FOLDER / 'report')


def check_report():
    example = SCENES.parent / 'report/example.json'
    works('report', example, '-o', FOLDER / 'report', '--no-html', '--markdown', FOLDER / 'trade.md')
    tables = (FOLDER / 'report/tables.md').read_text()
    expect('## Mars' in tables and (FOLDER / 'trade.md').read_text() == tables, 'report: tables')
    expect(len((FOLDER / 'report/results.csv').read_text().splitlines()) == 12, 'report: lines')
    works('report', example, '--markdown', FOLDER / 'only.md')
    expect((FOLDER / 'only.md').read_text() == tables, 'report: tables alone')
    page = FOLDER / 'page.md'
    page.write_text('before\n<!-- at a glance: written by `aureole report --overview` -->\nold\n<!-- end of it -->\nafter\n')
    works('report', example, '--overview', page)
    expect(page.read_text().startswith('before\n<!-- at') and page.read_text().endswith('<!-- end of it -->\nafter\n') and
           'old' not in page.read_text() and '| aureole default |' in page.read_text(), 'report: tables in a page')
    page.write_text('nothing')
    fails('--overview', 'report', example, '--overview', page)
    fails('--output: is missing', 'report', example)
    fails('no.json', 'report', FOLDER / 'no.json', '-o', FOLDER / 'none')
    fails('bad.json: is no JSON', 'report', put('bad.json', '{"version":'), '-o', FOLDER / 'none')
    fails('old.json: version: 7', 'report', put('old.json', '{"version": 7}'), '-o', FOLDER / 'none')
    fails('is no folder', 'report', example, '-o', FOLDER / 'old.json', '--no-html')


def check_measured_plan():
    out = works('plan', 'earth', '--budget', '1000ms', '4MiB', '--size', '64x36', *CALIBRATE, '--measure', *BACKEND, '--json',
                FOLDER / 'plan.json')
    measured = json.loads((FOLDER / 'plan.json').read_text())['measured']
    expect('measured here: ' in out and measured['frame_ms'] > 0 and measured['rebuild_ms'] > 0, f'plan: measured {out}')


def check_plan():
    out = works('plan', 'earth', '--tolerance', '5%', '--sun-elevation', '30', '--json', FOLDER / 'plan.json', '--list')
    plan = json.loads((FOLDER / 'plan.json').read_text())
    expect(out.startswith('plan: ' + plan['setting']['id']) and plan['tolerable'] and plan['error']['bound'] <= 0.05,
           f'plan: {out}')
    expect('ozone' in out and 'aerial perspective: left out' in out and out.count('meets the requirements') >= 1, f'plan: {out}')
    cheapest = min(c['cost']['charged_ms'] for c in plan['candidates'] if c.get('tolerable'))
    expect(plan['cost']['charged_ms'] <= 1.1 * cheapest, 'plan: the cheapest')
    same = works('plan', 'earth', '--tolerance', '0.05', '--sun-elevation', '30:30')
    expect(same.splitlines()[0] == out.splitlines()[0], 'plan: a share is a percentage')
    for altitude, outside in (('2:9e8', False), ('2:2e9', True)):
        told = run('plan', 'earth', '--tolerance', '0.05', '--altitude', altitude)
        expect(told.returncode == 0 and ('2e+09 is outside the envelope of stability' in told.stderr) == outside,
               'a plan says what is outside the envelope, and nothing else', told)
    for elevation, outside in (('-5:-6', False), ('-14:-15', True)):
        told = run('render', SCENES / 'noon.toml', '-o', FOLDER / 'dusk.png', '--model', 'hillaire', '--size', '16x9',
                   f'--sun-elevation={elevation}', '--frames', 2, *BACKEND)
        expect(told.returncode == 0 and ('suns[0].direction: elevation in degrees: -14 is outside' in told.stderr) == outside,
               'pictures from outside the envelope say so', told)
    scene = works('plan', SCENES / 'terrain_far.toml', '--budget', '100ms', '64MiB')
    expect('aerial perspective: recorded' in scene, f'plan of a scene with terrain: {scene}')
    dusk = works('plan', SCENES / 'golden_hour.toml', '--tolerance', '20%')
    expect('4 wavelengths' in dusk.splitlines()[0] or '4' in dusk.splitlines()[0].split(), f'plan in wavelengths: {dusk}')
    clear, hazy = (works('plan', 'earth', '--visibility', far, '--tolerance', '5%', '--list') for far in ('166.45km', '20000m'))
    expect(clear.splitlines()[0] == works('plan', 'earth', '--tolerance', '5%').splitlines()[0] and clear != hazy,
           f'plan: visibility {clear} {hazy}')
    for wrong in ('10', 'far', '10 miles', 'nankm'):
        fails('a distance with its unit, as 10km', 'plan', 'earth', '--visibility', wrong, '--tolerance', '5%')
    fails('visibility_m: 500 is not allowed; allowed: in [1000, 220000]', 'plan', 'earth', '--visibility', '0.5km', '--tolerance', '5%')
    fails('--visibility: of mars is not allowed', 'plan', 'mars', '--visibility', '10km', '--tolerance', '5%')
    out = works('plan', 'earth', '--budget', '100ms')
    expect('warning: the budget in milliseconds is judged by the speed of' in out and 'not calibrated' in out, f'plan: {out}')
    expect('warning' not in same, f'plan: nothing to warn of: {same}')
    out = works('plan', 'earth', '--tolerance', '5%', '--geometry', 250)
    expect('warning: geometry up to 250 km away is FAR' in out, f'plan: far geometry {out}')
    for wrong in ('nan', 'inf', '-1'):
        fails('kilometres, 0 or more', 'plan', 'earth', '--tolerance', '5%', f'--geometry={wrong}')
    fails('--budget: a second one in ms is not allowed; allowed: one in ms, and one in MiB', 'plan', 'earth', '--budget', '1ms', '2ms')
    for wrong in ('2', '1.01', 'nan', 'inf%'):
        fails('a share up to 1 as 0.02, or a percentage as 2%', 'plan', 'earth', '--tolerance', wrong)
    for wrong in ('nan', 'inf:3', '2:nan'):
        fails('--sun-elevation', 'plan', 'earth', '--tolerance', '5%', '--sun-elevation', wrong)
    works('plan', 'earth', '--tolerance', '200%')
    out = works('plan', 'mars', '--tolerance', '0.01%')
    expect('does NOT meet the requirements' in out, f'plan that cannot be: {out}')
    if not QUICK:
        check_measured_plan()
    fails('tolerance: nothing is not allowed', 'plan', 'earth')
    fails('--tolerance: "2 per cent" is not allowed', 'plan', 'earth', '--tolerance', '2 per cent')
    fails('--budget: "1s" is not allowed; allowed: milliseconds of a frame as 1ms, or memory as 2MiB', 'plan', 'earth', '--budget',
          '1s')
    fails('sun_elevation_deg.most: -6 is not allowed', 'plan', 'earth', '--tolerance', '2%', '--sun-elevation', '6:-6')
    fails('--altitude: "high" is not allowed', 'plan', 'earth', '--tolerance', '2%', '--altitude', 'high')
    fails('--suns', 'plan', 'earth', '--tolerance', '2%', '--suns', 9)
    fails('none.toml', 'plan', 'none.toml', '--tolerance', '2%')


def check_fit(measurements):
    out = works('fit', measurements, '-o', FOLDER)
    expect('rgb: ' in out and 'wavelengths: no scenes' in out, f'fit: {out}')
    expect('fog' in (FOLDER / 'measured_rgb.inc').read_text(), 'fit: writes the table')
    put('broken.json', '{')
    fails('is no JSON', 'fit', FOLDER / 'broken.json')
    fails("key 'settings' not found", 'fit', put('empty.json', '{}'))
    fails('measured without costs', 'fit', put('no_costs.json', '{"settings": [], "scenes": [], "results": []}'))


def check_help():
    for command in ([], ['render'], ['probe'], ['score'], ['trace'], ['truth'], ['measure'], ['fit'], ['plan'], ['bench'], ['report'],
                    ['devices']):
        out = works(*command, '--help')
        expect(len(out.splitlines()) > 3, f'help of {command}')
    fails('ubcommand', )
    fails('COMMAND: "frobnicate" is not allowed; allowed: render, probe, score, trace, truth, measure, '
          'fit, plan, bench, report, devices', '--verbose', 'frobnicate')
    version = works('--version')
    expect(version.startswith('aureole ') and version.split()[1][0].isdigit(), f'version: {version}')


if BACKEND[1] == 'vulkan' and not vulkan_runs():
    print('skipped: no usable Vulkan device')
    sys.exit(77)
scratch = tempfile.mkdtemp(prefix='aureole_cli_')
atexit.register(shutil.rmtree, scratch)
os.chdir(scratch)
FOLDER.mkdir()
timed(check_help)
timed(check_render)
timed(check_render_faults)
timed(check_places_that_take_no_files)
timed(check_options_of_another_backend)
timed(check_interrupted_sequence)
timed(check_score, timed(check_probe))
timed(check_trace)
timed(check_bench_and_devices)
timed(check_report)
timed(check_measure)
timed(check_fit, FOLDER / 'report/measurements.json')
timed(check_plan)
print('\n'.join(failures) if failures else 'the command line keeps its word')
sys.exit(1 if failures else 0)
