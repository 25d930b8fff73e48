"""`render`: pictures of every model, what is refused, and what is left of pictures that cannot be written."""
from cli_checks.runner import BACKEND, FOLDER, HEADER, ON_VULKAN, QUICK, SCENES, expect, fails, models, put, run, works


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
    expect('4 wavelengths' in works('render', SCENES / 'twilight.toml', '-o', FOLDER / 'd.exr', *small), 'the wavelengths of the scene')
    for name in ('s-0001.png', 's-0003.png', 't01.png', 't02.png'):
        expect((FOLDER / name).exists(), f'{name} exists')
    expect((FOLDER / 's-0001.png').read_bytes() != (FOLDER / 's-0003.png').read_bytes(), 'the sun moves')


def check_render_options():
    """Wavelengths, and the model of the scene; how the path tracer tells its progress."""
    noon, small = SCENES / 'noon.toml', ['--size', '64x36', '--quality', 'low', *BACKEND]
    result = run('render', noon, '-o', FOLDER / 'r.png', '--model', 'reference', '--size', '16x9', '--quality', 'low', *BACKEND)
    expect('4/4  100%' in result.stderr and 'film' in result.stdout, 'the path tracer tells its progress', result)
    pictures = set()
    for wavelengths in ([], ['--spectral', 3], ['--spectral', 12]):
        out = works('render', noon, '-o', FOLDER / 's.exr', *wavelengths, *small)
        expect(not wavelengths or f'quality low, {wavelengths[1]} wavelengths' in out, f'render says how many wavelengths: {out}')
        pictures.add((FOLDER / 's.exr').read_bytes())
    expect(len(pictures) == 3, 'every set of wavelengths has its own picture')
    out = works('render', SCENES / 'twilight.toml', '-o', FOLDER / 'd.exr', '--model', 'single', *small)
    expect('model single, quality low, 4 wavelengths' in out, f'another model in the wavelengths of the scene: {out}')
    scene = put('model.toml', 'model = "hillaire"\n' + noon.read_text())
    works('render', scene, '-o', FOLDER / 'scene.exr', *small)
    expect((FOLDER / 'scene.exr').read_bytes() == (FOLDER / 'm-hillaire.exr').read_bytes(), 'the model of the scene')


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
    rows = put('in.csv', HEADER + '\n' + '30,0.2,10,45\n' * 20)
    fails('new.csv: cannot be written', 'probe', '--scene', noon, '--directions', rows, '--model', 'fog', *BACKEND, '-o',
          FOLDER / 'new.csv', file_bytes=100)
    expect(old.read_bytes() == b'old', 'a file that cannot be replaced stays')


def check_options_of_another_backend():
    noon, out = SCENES / 'noon.toml', ['-o', FOLDER / 'x.png']
    for backend in ('cpu', 'cpu-double'):
        fails(f'--device llvm: --backend {backend} is not allowed', 'render', noon, *out, '--backend', backend, '--device', 'llvm')
        fails(f'--validation: --backend {backend} is not allowed', 'bench', '--backend', backend, '--validation')
    fails('--threads 2: --backend vulkan is not allowed', 'render', noon, *out, '--backend', 'vulkan', '--threads', 2)
    if ON_VULKAN:
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
