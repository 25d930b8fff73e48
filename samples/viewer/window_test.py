#!/usr/bin/env python3
"""aureole-viewer in a window, driven by scripts: mouse and keys as somebody at the window would use them, and what the screen shows.

Usage: window_test.py AUREOLE_VIEWER AUREOLE SCENES. Starts an X server of its own (Xvfb). Exit code 77: there is none, or no Vulkan device.
"""
import atexit
import os
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import time
import zlib

VIEWER, AUREOLE, SCENES = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
COLUMN = 440  # pixels of the panels, left of the picture
WIDTH, HEIGHT = 760, 400
AREA = (WIDTH - COLUMN, HEIGHT)
failures = []


def check(condition, message):
    if not condition:
        failures.append(message)


def skip(why):
    print(f'skipped: {why}')
    sys.exit(77)


def start_display():
    if not shutil.which('Xvfb'):
        skip('Xvfb is not installed')
    reading, writing = os.pipe()
    server = subprocess.Popen(['Xvfb', '-displayfd', str(writing), '-screen', '0', '1280x800x24', '-nolisten', 'tcp'],
                              pass_fds=[writing], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    os.close(writing)
    atexit.register(lambda: (server.terminate(), server.wait()))
    with os.fdopen(reading) as answer:
        number = answer.readline().strip()
    if not number:
        skip('Xvfb does not start')
    os.environ['DISPLAY'] = f':{number}'


class Picture:
    """An 8-bit RGB PNG file."""

    def __init__(self, path):
        data = pathlib.Path(path).read_bytes()
        at, packed = 8, b''
        while at < len(data):
            length, kind = struct.unpack('>I4s', data[at:at + 8])
            body = data[at + 8:at + 8 + length]
            if kind == b'IHDR':
                self.width, self.height, depth, colour = struct.unpack('>IIBB', body[:10])
                assert (depth, colour) == (8, 2), path
            packed += body if kind == b'IDAT' else b''
            at += 12 + length
        self.rows = self.unfilter(zlib.decompress(packed))

    def unfilter(self, raw):
        stride, rows = 3 * self.width, []
        above = bytearray(stride)
        for y in range(self.height):
            begin = y * (stride + 1)
            kind, row = raw[begin], bytearray(raw[begin + 1:begin + 1 + stride])
            if kind == 1:
                for i in range(3, stride):
                    row[i] = (row[i] + row[i - 3]) & 255
            elif kind == 2:
                row = bytearray((a + b) & 255 for a, b in zip(row, above))
            elif kind == 3:
                for i in range(stride):
                    row[i] = (row[i] + ((row[i - 3] if i >= 3 else 0) + above[i]) // 2) & 255
            elif kind == 4:
                self.unpaeth(row, above)
            rows.append(bytes(row))
            above = row
        return rows

    @staticmethod
    def unpaeth(row, above):
        for i in range(len(row)):
            left, up, corner = (row[i - 3], above[i], above[i - 3]) if i >= 3 else (0, above[i], 0)
            of_left, of_up, of_corner = abs(up - corner), abs(left - corner), abs(left + up - 2 * corner)
            nearest = left if of_left <= of_up and of_left <= of_corner else up if of_up <= of_corner else corner
            row[i] = (row[i] + nearest) & 255

    def crop(self, x, width):
        part = object.__new__(Picture)
        part.width, part.height = width, self.height
        part.rows = [row[3 * x:3 * (x + width)] for row in self.rows]
        return part

    def apart(self, other):
        """Greatest difference of a channel, and the mean one."""
        if (self.width, self.height) != (other.width, other.height):
            return 999, 999
        steps = [abs(a - b) for mine, theirs in zip(self.rows, other.rows) for a, b in zip(mine, theirs)]
        return max(steps), sum(steps) / len(steps)

    def brightest(self):
        """Middle of all pixels that are as bright as the brightest."""
        lights = [(sum(row[3 * x:3 * x + 3]), x, y) for y, row in enumerate(self.rows) for x in range(self.width)]
        most = max(lights)[0]
        spots = [(x, y) for light, x, y in lights if light == most]
        return sum(x for x, _ in spots) / len(spots), sum(y for _, y in spots) / len(spots)

    def greatest(self):
        return max(max(row) for row in self.rows)


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
    return Picture(output)


SCENE = """
exposure = 9
[[sun]]
elevation_deg = 25
bearing_deg = -8
[camera]
altitude_m = 300
elevation_deg = 20
vertical_fov_deg = 60
"""


def check_pictures():
    """A pane is what the application renders, on the screen to the pixel; a dragged sun shines where it was dropped."""
    pathlib.Path('scene.toml').write_text(SCENE, encoding='utf-8')
    x, y = COLUMN + 240, 110
    said = view('pictures', f"""
        set view.resolution 1
        set view.labels false
        settle
        screenshot window.png
        picture a a.png
        drag right {COLUMN + 60} 200 {x} {y}
        settle
        picture a dragged.png
        print sun.1.elevation_deg
        save dragged.toml
        quit
        """, 'scene.toml')
    pane, rendered = Picture('a.png'), render('scene.toml', 'rendered.png')
    greatest, mean = pane.apart(rendered)
    check(greatest <= 1 and mean < 0.01, f'pane A and `aureole render`: apart by {greatest}, {mean:.4f} in the mean')
    check(Picture('window.png').crop(COLUMN, AREA[0]).apart(pane) == (0, 0), 'the screen does not show pane A as it was drawn')
    spot = Picture('dragged.png').brightest()
    check(abs(spot[0] - (x - COLUMN)) < 6 and abs(spot[1] - y) < 6, f'the sun was dragged to {x - COLUMN}, {y}; the brightest spot is at {spot}')
    before = Picture('a.png').brightest()
    check(abs(before[0] - spot[0]) + abs(before[1] - spot[1]) > 40, f'the bright spot has not moved: {before} to {spot}')
    check('sun.1.elevation_deg = ' in said, f'print says nothing: {said}')
    greatest, mean = Picture('dragged.png').apart(render('dragged.toml', 'again.png'))
    check(greatest <= 1 and mean < 0.01, f'the saved scene, rendered: apart by {greatest}, {mean:.4f} in the mean')


def check_comparison():
    """Two panes side by side; no difference where they are the same, and some where they are not. Clicked, not set."""
    said = view('comparison', f"""
        set view.resolution 0.5
        set view.labels false
        click tab.Panes
        click view.layout=difference
        settle
        picture shown none.png
        click b.model
        click b.model=hillaire
        settle
        print b.model
        picture shown some.png
        screenshot difference.png
        click view.layout=split
        settle
        drag left {COLUMN + AREA[0] // 2} 200 {COLUMN + AREA[0] // 4} 200
        wait 2
        print view.divider
        picture shown split.png
        picture a left.png
        picture b right.png
        click tab.Passes
        wait 2
        screenshot passes.png
        resize 620 300
        settle
        wait 2
        screenshot resized.png
        picture shown small.png
        quit
        """, 'scene.toml', '--validation')
    check(Picture('none.png').greatest() == 0, 'two equal panes differ')
    check(Picture('some.png').greatest() > 60, 'two models do not differ')
    check('b.model = hillaire' in said, f'clicking on a model did not choose it: {said}')
    divider = float(said.split('view.divider = ')[1].split()[0])
    check(abs(divider - 0.25) < 0.02, f'the divider was dragged to a quarter, and is at {divider}')
    split, left, right = Picture('split.png'), Picture('left.png'), Picture('right.png')
    at = round(divider * split.width)
    check(split.crop(0, at).apart(left.crop(0, at)) == (0, 0), 'left of the divider is not pane A')
    rest = split.width - at - 1
    resized, small = Picture('resized.png'), Picture('small.png')
    check((resized.width, resized.height) == (620, 300), f'resized to {resized.width}x{resized.height}')
    check((small.width, small.height) == ((620 - COLUMN) // 2, 150), f'the picture of a smaller window is {small.width}x{small.height}')
    check(split.crop(at + 1, rest).apart(right.crop(at + 1, rest)) == (0, 0), 'right of the divider is not pane B')


def check_flight():
    """Keys fly, a path is kept and flown again, a table's texels are told, scenes are loaded and saved through the panel."""
    said = view('flight', """
        set view.resolution 0.2
        set camera.altitude_m 100
        record start
        key e 90
        key w 30
        record stop path.csv
        print camera.altitude_m
        print sun.1.elevation_deg
        set camera.altitude_m 100
        play path.csv
        print camera.altitude_m
        click tab.Table
        set view.table_name sky_view
        settle
        texel 3 150
        hover texels
        screenshot table.png
        click tab.Curves
        settle
        screenshot curves.png
        click tab.Files
        click file
        type saved.toml
        click "Save scene"
        quit
        """, 'scene.toml', '--validation')
    altitudes = [float(line.split(' = ')[1]) for line in said.splitlines() if line.startswith('camera.altitude_m')]
    # 1.5 s at 0.8 of the height a second: 100 m exp(1.2).
    check(len(altitudes) == 2 and 280 < altitudes[0] < 380, f'flown up to {altitudes}')
    check(altitudes[0] == altitudes[1], f'the path does not end where it was flown to: {altitudes}')
    sun = [float(line.split(' = ')[1]) for line in said.splitlines() if line.startswith('sun.1')]
    check(sun and 25 < sun[0] < 25.01, f'flying north towards the sun did not raise it by a little: {sun}')
    texel = [line for line in said.splitlines() if line.startswith('texel sky_view 3 150')]
    check(texel and all(float(v) >= 0 for v in texel[0].split(': ')[1].split()), f'the texel: {said}')
    saved = pathlib.Path('saved.toml')
    check(saved.exists() and f'altitude_m = {altitudes[1]:.10g}'[:16] in saved.read_text(encoding='utf-8'), 'the panel did not save the scene')


def check_land():
    """Over land, on both backends, under the validation layer."""
    view('land', """
        set view.resolution 0.25
        set a.quality low
        set b.backend cpu
        set b.quality low
        set view.layout difference
        settle
        picture shown land_difference.png
        set view.layout a
        key w 20
        settle
        picture a land.png
        quit
        """, str(SCENES / 'terrain_near.toml'), '--validation')
    # Ten percent have the full colour: float rounds otherwise on another device, at edges of the land a pixel is another one.
    different = Picture('land_difference.png')
    bright = sum(max(row[3 * x:3 * x + 3]) > 90 for row in different.rows for x in range(different.width))
    check(bright < different.width * different.height / 100, f'backends differ in {bright} pixels')
    check(Picture('land.png').greatest() > 100, 'the land is dark')


def check_faults():
    said = view('faults', 'wait 2\nset sun.1.elevation_deg 100\n', 'scene.toml', ok=False)
    check('faults.txt:2: set: sun.1.elevation_deg: 100 is not allowed; allowed: in [-90, 90]' in said, f'what is wrong is not said: {said}')
    said = view('inside', 'set terrain.heightmap jacksboro\nset camera.altitude_m 1\nsettle\n', 'scene.toml', ok=False)
    check('camera.altitude_m: 1 is not allowed' in said, f'a camera inside the land: {said}')


start_display()
scratch = tempfile.mkdtemp(prefix='aureole_viewer_')
if '--keep' not in sys.argv:
    atexit.register(shutil.rmtree, scratch)
os.chdir(scratch)
check_pictures()
check_comparison()
check_flight()
check_land()
check_faults()
if '--keep' in sys.argv:
    print(f'kept: {scratch}')
print('\n'.join(failures) if failures else 'the window keeps its word')
sys.exit(1 if failures else 0)
