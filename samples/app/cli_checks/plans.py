"""`plan`."""
import json

from cli_checks.runner import BACKEND, FOLDER, ON_VULKAN, SCENES, expect, fails, run, works


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
    fails('tolerance: nothing is not allowed', 'plan', 'earth')
    fails('--tolerance: "2 per cent" is not allowed', 'plan', 'earth', '--tolerance', '2 per cent')
    fails('--budget: "1s" is not allowed; allowed: milliseconds of a frame as 1ms, or memory as 2MiB', 'plan', 'earth', '--budget',
          '1s')
    fails('sun_elevation_deg.most: -6 is not allowed', 'plan', 'earth', '--tolerance', '2%', '--sun-elevation', '6:-6')
    fails('--altitude: "high" is not allowed', 'plan', 'earth', '--tolerance', '2%', '--altitude', 'high')
    fails('--suns', 'plan', 'earth', '--tolerance', '2%', '--suns', 9)
    fails('none.toml', 'plan', 'none.toml', '--tolerance', '2%')


def check_measured_plan():
    calibrate = ['--calibrate'] if ON_VULKAN else []  # many pixels: slow on a CPU
    out = works('plan', 'earth', '--budget', '1000ms', '4MiB', '--size', '64x36', *calibrate, '--measure', *BACKEND, '--json',
                FOLDER / 'plan.json')
    measured = json.loads((FOLDER / 'plan.json').read_text())['measured']
    expect('measured here: ' in out and measured['frame_ms'] > 0 and measured['rebuild_ms'] > 0, f'plan: measured {out}')
