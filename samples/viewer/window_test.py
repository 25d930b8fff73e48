#!/usr/bin/env python3
"""aureole-viewer in a window, driven by scripts: mouse and keys as somebody at the window would use them, and what the screen shows.

Usage: window_test.py AUREOLE_VIEWER AUREOLE SCENES. Starts an X server of its own (Xvfb). Exit code 77: there is none, or no Vulkan device.
"""
import atexit
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / 'common'))
from window_checks import Display, read_png  # noqa: E402
from window_runner import AREA, AUREOLE, COLUMN, HEIGHT, SCENES, VIEWER, WIDTH, check, failures, render, values, view  # noqa: E402

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
    pane, rendered = read_png('a.png'), render('scene.toml', 'rendered.png')
    greatest, mean = pane.apart(rendered)
    check(greatest <= 1 and mean < 0.01, f'pane A and `aureole render`: apart by {greatest}, {mean:.4f} in the mean')
    check(read_png('window.png').crop(COLUMN, AREA[0]).apart(pane) == (0, 0), 'the screen does not show pane A as it was drawn')
    spot = read_png('dragged.png').brightest()
    check(abs(spot[0] - (x - COLUMN)) < 6 and abs(spot[1] - y) < 6, f'the sun was dragged to {x - COLUMN}, {y}; the brightest spot is at {spot}')
    before = read_png('a.png').brightest()
    check(abs(before[0] - spot[0]) + abs(before[1] - spot[1]) > 40, f'the bright spot has not moved: {before} to {spot}')
    check('sun.1.elevation_deg = ' in said, f'print says nothing: {said}')
    greatest, mean = read_png('dragged.png').apart(render('dragged.toml', 'again.png'))
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
    check(read_png('none.png').greatest() == 0, 'two equal panes differ')
    check(read_png('some.png').greatest() > 60, 'two models do not differ')
    check('b.model = hillaire' in said, f'clicking on a model did not choose it: {said}')
    divider = float(said.split('view.divider = ')[1].split()[0])
    check(abs(divider - 0.25) < 0.02, f'the divider was dragged to a quarter, and is at {divider}')
    split, left, right = read_png('split.png'), read_png('left.png'), read_png('right.png')
    at = round(divider * split.width)
    check(split.crop(0, at).apart(left.crop(0, at)) == (0, 0), 'left of the divider is not pane A')
    rest = split.width - at - 1
    resized, small = read_png('resized.png'), read_png('small.png')
    check((resized.width, resized.height) == (620, 300), f'resized to {resized.width}x{resized.height}')
    check((small.width, small.height) == ((620 - COLUMN) // 2, 150), f'the picture of a smaller window is {small.width}x{small.height}')
    check(split.crop(at + 1, rest).apart(right.crop(at + 1, rest)) == (0, 0), 'right of the divider is not pane B')


def check_plan():
    """A pane that the planner chooses for: what `aureole plan` says of the same scene and tolerance, clicked and typed."""
    said = view('plan', """
        set view.resolution 0.25
        set view.layout split
        click tab.Panes
        settle
        click b.planned
        settle
        click b.tolerance ctrl
        type 0.3
        key enter 2
        settle
        describe a
        describe b
        print b.tolerance
        click b.plan
        wait 2
        screenshot plan.png
        set view.layout difference
        settle
        picture shown planned_difference.png
        quit
        """, 'scene.toml', '--validation')
    check(values(said, 'b.tolerance') == ['0.3'], f'the tolerance was typed: {said}')
    plan = subprocess.run([AUREOLE, 'plan', 'scene.toml', '--tolerance', '0.3', '--no-light', '--size', f'{AREA[0] // 4}x{AREA[1] // 4}'], check=True,
                          capture_output=True, text=True, timeout=60, stdin=subprocess.DEVNULL).stdout.splitlines()[0]
    check(f'pane b: {plan}, vulkan on ' in said, f'the planner: {plan}; the viewer: {said}')
    check('pane a: model aureole, quality default, vulkan on ' in said and 'costs as on' in said, f'models and reasons: {said}')


def check_table():
    """The inspector: the texel under the mouse, its numbers, and its colour on the screen."""
    said = view('table', """
        click tab.Table
        settle
        click view.table_name
        click view.table_name=transmittance
        settle
        hover texels
        texel
        wait 2
        screenshot table.png
        quit
        """, 'scene.toml')
    texel = re.search(r'texel transmittance (\d+) (\d+) of slice 0: (.*); greatest (.*)', said)
    check(texel, f'no texel under the mouse: {said}')
    numbers, greatest = [float(v) for v in texel.group(3).split()], float(texel.group(4))
    check(0 < min(numbers[:3]) and max(numbers[:3]) <= greatest, f'optical depths: {said}')
    # The mouse is in the middle of the table, whose texels are small: the colour under it is on the screen around there.
    wanted = [round(255 * math.sqrt(v / greatest)) for v in numbers[:3]]
    shown = read_png('table.png')
    near = min(max(abs(a - b) for a, b in zip(wanted, shown.pixel(x, y), strict=True)) for x in range(0, COLUMN, 2) for y in range(100, HEIGHT - 90))
    check(near <= 1, f'no texel of the colour {wanted} is shown')


def check_path():
    """Two suns and a flight, recorded and flown again: the same numbers and the same picture. The panel's buttons do it."""
    pathlib.Path('two.toml').write_text(SCENE + '[[sun]]\nelevation_deg = 12\nbearing_deg = 25\n', encoding='utf-8')
    looks = 'print camera.altitude_m\nprint sun.1.elevation_deg\nprint sun.2.elevation_deg\nprint sun.2.bearing_deg\n'
    said = view('path', f"""
        set view.resolution 0.25
        set view.labels false
        click tab.Files
        click file
        type two.csv
        click "Record path"
        set sun.2.elevation_deg 30
        key e 30
        key d 20
        wheel 2
        click "Stop and write path"
        settle
        {looks}
        print camera.vertical_fov_deg
        picture shown flown.png
        load two.toml
        settle
        {looks}
        click "Play path"
        wait 120
        settle
        {looks}
        print camera.vertical_fov_deg
        picture shown again.png
        quit
        """, 'two.toml')
    for field in ('camera.altitude_m', 'sun.1.elevation_deg', 'sun.2.elevation_deg', 'sun.2.bearing_deg'):
        flown, fresh, again = values(said, field)
        check(flown == again, f'{field}: {flown} was recorded, {again} played')
        check(fresh != flown, f'{field} has not changed by the flight: {flown}')
    check(read_png('flown.png').apart(read_png('again.png')) == (0, 0), 'the path, flown again, ends with another picture')
    check('sun_2_bearing_deg' in pathlib.Path('two.csv').read_text(encoding='utf-8'), 'the path has no second sun')


def check_edit():
    """A number typed, a table of densities with a row more; the scene saved, and loaded in another run: the same picture."""
    said = view('edit', """
        set view.resolution 0.25
        set view.labels false
        settle
        picture a plain.png
        click tab.Scene
        click camera.elevation_deg ctrl
        type 35
        key enter 2
        print camera.elevation_deg
        click camera.elevation_deg ctrl
        type 95
        key enter 2
        print camera.elevation_deg
        click tab.Air
        click "part.term rayleigh"
        click "part.term rayleigh"
        click "part.term mie"
        click term.mie.profile
        click term.mie.profile=tabulated
        click term.mie.profile.insert.1
        click term.mie.profile.density.2 ctrl
        type 6
        key enter 2
        click term.mie.profile.remove.4
        print term.mie.profile.altitude_m.2
        print term.mie.profile.density.2
        print term.mie.profile.altitude_m.3
        wait 2
        screenshot edit.png
        settle
        picture a edited.png
        click tab.Files
        click file
        type edited.toml
        click "Save scene"
        key e 20
        click "Load scene"
        settle
        picture a loaded.png
        quit
        """, 'scene.toml')
    check(values(said, 'camera.elevation_deg') == ['35', '35'], f'typed into a slider, and refused beyond its range: {said}')
    rows = [values(said, 'term.mie.profile.' + name) for name in ('altitude_m.2', 'density.2', 'altitude_m.3')]
    check(rows == [['500'], ['6'], ['1000']], f'rows of the table: {rows}')
    plain, edited, loaded = read_png('plain.png'), read_png('edited.png'), read_png('loaded.png')
    check(plain.apart(edited)[1] > 5, f'editing has changed little: {plain.apart(edited)}')
    check(edited.apart(loaded) == (0, 0), f'saved and loaded, the scene looks otherwise: {edited.apart(loaded)}')
    view('reload', 'set view.resolution 0.25\nload edited.toml\nsettle\npicture a reloaded.png\nquit\n', 'scene.toml')
    check(edited.apart(read_png('reloaded.png')) == (0, 0), 'saved, and loaded by another viewer, the scene looks otherwise')


def check_screen(display):
    """What is on the X server's screen is what the screenshot says, whether the surface encodes sRGB by itself or not."""
    for option in ([], ['--srgb-surface']):
        pathlib.Path('screen.txt').write_text('set view.resolution 1\nclick tab.Files\nclick file\ntype window.png\nmouse 2 2\n'
                                              'click "Save screenshot"\nmouse 2 2\nsettle\nwait 5\nscreenshot shown.png\n'
                                              'print view.layout\nwait 100000\n', encoding='utf-8')
        viewer = subprocess.Popen([VIEWER, 'scene.toml', '--validation', '--script', 'screen.txt', '--size', f'{WIDTH}x{HEIGHT}', *option],
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, stdin=subprocess.DEVNULL)
        said = viewer.stdout.readline()
        time.sleep(0.5)
        screen = display.shown()
        viewer.terminate()
        viewer.communicate(timeout=20)
        if not said.startswith('view.layout'):
            check(False, f'{option}: {said}')
            continue
        shown = read_png('shown.png')
        on_screen = screen.crop(0, WIDTH)
        on_screen.height, on_screen.rows = HEIGHT, on_screen.rows[:HEIGHT]
        check(on_screen.apart(shown) == (0, 0), f'{option}: the screen and the screenshot: apart by {on_screen.apart(shown)}')
        check(shown.greatest() > 100 and read_png('window.png').crop(COLUMN, AREA[0]).greatest() > 100, f'{option}: dark')


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
    altitudes = [float(value) for value in values(said, 'camera.altitude_m')]
    # 1.5 s at 0.8 of the height a second: 100 m exp(1.2).
    check(len(altitudes) == 2 and 280 < altitudes[0] < 380, f'flown up to {altitudes}')
    check(altitudes[0] == altitudes[1], f'the path does not end where it was flown to: {altitudes}')
    sun = [float(value) for value in values(said, 'sun.1.elevation_deg')]
    check(sun and 25 < sun[0] < 25.01, f'flying north towards the sun did not raise it by a little: {sun}')
    texel = [line for line in said.splitlines() if line.startswith('texel sky_view 3 150')]
    check(texel and all(float(v) >= 0 for v in texel[0].split(': ')[1].split(';')[0].split()), f'the texel: {said}')
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
    different = read_png('land_difference.png')
    bright = sum(max(row[3 * x:3 * x + 3]) > 90 for row in different.rows for x in range(different.width))
    check(bright < different.width * different.height / 100, f'backends differ in {bright} pixels')
    check(read_png('land.png').greatest() > 100, 'the land is dark')


def check_faults():
    said = view('faults', 'wait 2\nset sun.1.elevation_deg 100\n', 'scene.toml', ok=False)
    check('faults.txt:2: set: sun.1.elevation_deg: 100 is not allowed; allowed: in [-90, 90]' in said, f'what is wrong is not said: {said}')
    said = view('inside', 'set terrain.heightmap jacksboro\nset camera.altitude_m 1\nsettle\n', 'scene.toml', ok=False)
    check('camera.altitude_m: 1 is not allowed' in said, f'a camera inside the land: {said}')


display = Display(1280, 800)
atexit.register(display.close)
scratch = tempfile.mkdtemp(prefix='aureole_viewer_')
if '--keep' not in sys.argv:
    atexit.register(shutil.rmtree, scratch)
os.chdir(scratch)
check_pictures()
check_comparison()
check_plan()
check_table()
check_flight()
check_path()
check_edit()
check_screen(display)
check_land()
check_faults()
if '--keep' in sys.argv:
    print(f'kept: {scratch}')
print('\n'.join(failures) if failures else 'the window keeps its word')
sys.exit(1 if failures else 0)
