"""`truth`, `measure`, `fit` and `report`."""
import json

from cli_checks.runner import BACKEND, FOLDER, QUICK, SCENES, expect, fails, put, works

TINY, TABLE, REPORT = FOLDER / 'tiny.toml', FOLDER / 'truth/earth.csv', FOLDER / 'report'
MEASURE = ['measure', '--suite', TINY, *BACKEND, '-o', REPORT]


def suite(elevations, more=''):
    return put('tiny.toml', 'truth_error = 0.1\ntruth_max_paths = 4096\n[[air]]\nname = "earth"\n[[scenes]]\nclass = "Day"\n'
               f'air = "earth"\nsun_elevation_deg = {elevations}\naltitude_m = [2]\n[[setting]]\nmodel = ["fog", "single-lut"]\n{more}')


def check_truth():
    """A suite's truth is traced and kept; it is always traced on the CPU in double, whatever measures against it."""
    suite('[30]')
    fails('earth.csv lacks scenes of the suite; `aureole truth` adds them', *MEASURE)
    expect('are missing' in works('truth', TINY) and 'complete' in works('truth', TINY), 'truth says what is missing')
    fails('--airs: mars is not allowed', 'truth', TINY, '--airs', 'mars')
    if QUICK:
        return
    first = TABLE.read_text().splitlines()
    works('truth', suite('[30, 10]'), '--airs', 'earth')
    more = TABLE.read_text().splitlines()
    expect(len(more) > 1.8 * len(first) - 4 and set(first) < set(more), 'truth adds what is missing and leaves the rest')


def check_measure():
    works('truth', suite('[30]'))
    out = works(*MEASURE, '--rounds', 1, '--cost-size', '64x36', '--no-html')
    expect('single-lut default' in out and 'median_%' in out and BACKEND[1] + ' on ' in out, f'measure says what it did: {out}')
    measured = json.loads((REPORT / 'measurements.json').read_text())
    errors = {r['setting']: r['regions']['all']['median'] for r in measured['results']}
    expect(errors['fog default'] > errors['single-lut default'] > 0.1, f'measure: errors {errors}')
    expect(all(r['split']['all']['model']['median'] > 0 for r in measured['results']) and measured['library'], 'measure: parts')
    expect([c['setting'] for c in measured['costs']] == ['fog default', 'single-lut default'] and
           measured['costs'][1]['composite_ms']['median'] > 0 and measured['costs'][1]['rebuild']['medium_evaluations'] > 0 and
           measured['pictures'] == [], f'measure: costs {measured["costs"]}')
    expect(measured['cost_size'] == [64, 36], 'measure: size of the pictures with costs')
    expect((REPORT / 'tables.md').exists() and (REPORT / 'results.csv').exists(), 'measure: tables')
    return REPORT / 'measurements.json'


def check_measure_faults():
    fails('--cost-size: "huge"', *MEASURE, '--cost-size', 'huge')
    fails('--models', *MEASURE, '--models', 'aureole')
    fails('none.toml', 'measure', '--suite', FOLDER / 'none.toml', *BACKEND, '-o', REPORT)
    fails('--suite: "tiny" is not allowed; allowed: full, small', 'measure', '--suite', 'tiny', *BACKEND, '-o', REPORT)
    suite('[30]', '\ncolour = 1\n')
    fails('tiny.toml:13: setting[0].colour', *MEASURE)
    suite('[30]')
    put('truth/earth.csv', TABLE.read_text().replace('ground_albedo=0.3,', 'ground_albedo=0.4,'))
    fails('is the truth of another air', *MEASURE)


def check_fit(measurements):
    out = works('fit', measurements, '-o', FOLDER)
    expect('rgb: ' in out and 'wavelengths: no scenes' in out, f'fit: {out}')
    expect('fog' in (FOLDER / 'measured_rgb.inc').read_text(), 'fit: writes the table')
    put('broken.json', '{')
    fails('is no JSON', 'fit', FOLDER / 'broken.json')
    fails("key 'settings' not found", 'fit', put('empty.json', '{}'))
    fails('measured without costs', 'fit', put('no_costs.json', '{"settings": [], "scenes": [], "results": []}'))


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
