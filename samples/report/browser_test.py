#!/usr/bin/env python3
"""The page of `aureole report` in a browser: it opens from a file without a network, and every chart of every choice is drawn.

    browser_test.py AUREOLE example.json

A script that is added to the page goes through all choices and counts marks; what they must be follows from the measurements.
A second page whose charts are broken on purpose must be found out. Exit code 77: there is no Chromium, or no page (no npm).
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

AUREOLE, EXAMPLE = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
NAMES = ('chromium', 'chromium-browser', 'google-chrome')
# Waits for all charts, then counts what each section shows; then the same for each option of each choice.
PROBE = """
<script>
window.addEventListener('load', async () => {
    const drawn = async () => { do await new Promise((done) => setTimeout(done, 20)); while (undrawn > 0); };
    const marks = (chart, kind) => [...chart.querySelectorAll(`svg g.role-mark.mark-${kind} path`)].filter((path) => {
        const box = path.getBoundingClientRect(), frame = chart.getBoundingClientRect();
        const shape = path.getAttribute('d') + (path.getAttribute('transform') ?? '');
        return path.getAttribute('d') && !/NaN|Infinity/.test(shape) && box.right >= frame.left && box.left <= frame.right;
    }).length;
    const look = (section) => ({
        charts: Object.fromEntries([...section.querySelectorAll('.chart')].map((chart) => [chart.dataset.chart, {
            points: marks(chart, 'symbol'), lines: marks(chart, 'line'), bars: marks(chart, 'rect'),
            text: chart.querySelector('.missing, .failure')?.textContent ?? '',
            titles: [...chart.querySelectorAll('g.role-axis-title text')].map((text) => text.textContent)}])),
        lists: [...section.querySelectorAll('.panel li')].map((item) => item.textContent),
        tables: [...section.querySelectorAll('tbody')].map((body) => body.rows.length),
        cells: [...section.querySelectorAll('td')].map((cell) => cell.textContent),
        images: [...section.querySelectorAll('img')].filter((image) => image.complete && image.naturalWidth > 0).length});
    const found = {};
    await drawn();
    for (const section of document.querySelectorAll('section')) {
        found[section.id] = look(section);
        for (const select of section.querySelectorAll('select')) {
            const before = select.value;
            for (const option of [...select.options]) {
                select.value = option.value;
                select.dispatchEvent(new Event('change'));
                await drawn();
                found[`${section.id} ${select.name}=${option.value}`] = look(section);
            }
            select.value = before;
            select.dispatchEvent(new Event('change'));
        }
    }
    const point = document.querySelector('#fronts svg g.role-mark.mark-symbol path'), box = point?.getBoundingClientRect();
    if (point) for (const type of ['pointerover', 'pointermove', 'mouseover', 'mousemove'])
        point.dispatchEvent(new PointerEvent(type, {bubbles: true, clientX: (box.left + box.right) / 2, clientY: (box.top + box.bottom) / 2}));
    await new Promise((done) => setTimeout(done, 100));
    found.hover = document.getElementById('vg-tooltip-element')?.textContent ?? 'nothing';
    document.querySelector('#sun input[name="aureole high"]')?.click();
    document.querySelector('#fronts .legend button')?.click();
    document.getElementById('theme').click();
    await drawn();
    found['sun with one more'] = look(document.getElementById('sun'));
    found['fronts with one model less'] = look(document.getElementById('fronts'));
    document.body.replaceChildren(Object.assign(document.createElement('pre'), {id: 'found', textContent: JSON.stringify(found)}));
});
</script>
"""
BROKEN = "<script>frontChart = () => ({mark: 'no such mark', data: {values: []}}); sunChart = () => ({mark: 'line', data: {values: []}});</script>"
failures = []


def expect(truth, what):
    if not truth:
        failures.append(what)


def browser():
    return next(filter(None, map(shutil.which, NAMES)), None)


def open_page(program, page, folder, *more):
    """The page as it is in the end, and everything that was said on the console. No host name leads anywhere."""
    command = [program, '--headless', '--no-sandbox', '--disable-gpu', '--no-first-run', '--disable-extensions',
               '--disable-background-networking', '--disable-dev-shm-usage', '--host-resolver-rules=MAP * ~NOTFOUND',
               '--window-size=1366,900', '--enable-logging=stderr', '--v=0', f'--user-data-dir={folder / "profile"}',
               '--virtual-time-budget=60000', *more, page.resolve().as_uri()]
    done = subprocess.run(command, capture_output=True, text=True, timeout=120, env={**os.environ, 'HOME': str(folder)})
    said = [line for line in done.stderr.splitlines() if 'CONSOLE' in line]
    return done.stdout, said


def visit(program, page, folder):
    dom, said = open_page(program, page, folder, '--dump-dom')
    match = re.search(r'<pre id="found">(.*)</pre>', dom, re.S)
    found = json.loads(match.group(1).replace('&lt;', '<').replace('&gt;', '>').replace('&amp;', '&')) if match else None
    return found, said


def skip(why):
    print(f'skipped: {why}')
    sys.exit(77)


def make_pages(folder):
    made = subprocess.run([AUREOLE, 'report', EXAMPLE, '-o', folder], capture_output=True, text=True)
    if 'built without' in made.stderr:
        skip(made.stderr.strip())
    made.check_returncode()
    page = (folder / 'report.html').read_text(encoding='utf-8')
    head, end = page.rsplit('</body>', 1)
    (folder / 'probed.html').write_text(f'{head}{PROBE}</body>{end}', encoding='utf-8')
    (folder / 'broken.html').write_text(f'{head}{BROKEN}{PROBE}</body>{end}', encoding='utf-8')
    bare = json.loads(EXAMPLE.read_text(encoding='utf-8'))
    for name in ('costs', 'pictures'):
        del bare[name]
    for result in bare['results']:
        result.pop('split', None)
    (folder / 'bare.json').write_text(json.dumps(bare), encoding='utf-8')
    subprocess.run([AUREOLE, 'report', folder / 'bare.json', '-o', folder / 'bare'], check=True, stdout=subprocess.DEVNULL)
    head, end = (folder / 'bare/report.html').read_text(encoding='utf-8').rsplit('</body>', 1)
    (folder / 'bare.html').write_text(f'{head}{PROBE}</body>{end}', encoding='utf-8')
    return page


def check_text(page):
    """Nothing to load, and the policy that forbids it; the licences of what is inside."""
    shown = re.sub(r'(<script[^>]*>).*?(?=</script>)', r'\1', page, flags=re.S)
    expect(not re.search(r'<(?:script|link|img|iframe)[^>]*\s(?:src|href)\s*=\s*(?!["\']?data:)', shown), 'the page refers to a file')
    expect(not re.search(r'@import|url\(\s*["\']?https?:', shown), "the page's style refers to a file")
    expect("default-src 'none'" in page, 'the page has no policy against loading')
    expect('University of Washington Interactive Data Lab' in page and 'Mike Bostock' in page, 'licences are missing')


def rows_of(measurements, scene_class):
    scenes = {scene['id'] for scene in measurements['scenes'] if scene['class'] == scene_class}
    return [result for result in measurements['results'] if result['scene'] in scenes]


def check_charts(found, measurements):
    """What the measurements ask for: a point a setting with a cost, a line a chart, bars for parts with a tick for their total."""
    wrong = []

    def same(key, chart, kind, wanted):
        seen = found[key]['charts'].get(chart, {})
        if seen.get(kind) != wanted:
            wrong.append(f'{key}: {chart}: {wanted} {kind} wanted: {seen}')

    airs = {scene['class']: scene['air'] for scene in measurements['scenes']}
    models = {setting['id']: setting['model'] for setting in measurements['settings']}
    for name, air in airs.items():
        chart = f'fronts: {name}'
        paid = {cost['setting'] for cost in measurements['costs'] if cost['air'] == air}
        measured = {result['setting'] for result in rows_of(measurements, name)}
        points = len(paid & measured)
        for key in (key for key in found if key.startswith('fronts')):
            missing = key.endswith(('=nadir', '=antisolar', '=aerial', '=aerial near', '=aerial far', '=composite_ms'))
            left = sum(models[setting] != 'hillaire' for setting in paid & measured)
            wanted = 0 if missing else left if key.endswith('less') else points
            same(key, chart, 'points', wanted)
            same(key, chart, 'lines', min(wanted, 1))
            if missing and 'not measured' not in found[key]['charts'][chart]['text']:
                wrong.append(f'{key}: {chart} does not say that it was not measured')
    chosen = ['hillaire default', 'aureole default']
    for key in (key for key in found if key.startswith('sun')):
        name = key.split('Scenes=')[1] if 'Scenes=' in key else 'Earth by day'
        settings = chosen + ['aureole high'] * key.endswith('more')
        missing = key.endswith(('=nadir', '=antisolar', '=aerial', '=aerial near', '=aerial far'))
        points = [result for result in rows_of(measurements, name) if result['setting'] in settings]
        same(key, 'sun', 'points', 0 if missing else len(points))
        same(key, 'sun', 'lines', 0 if missing else len({result['setting'] for result in points}))
    for key in (key for key in found if key.startswith('split')):
        name = key.split('Scenes=')[1] if 'Scenes=' in key else 'Earth by day'
        of = key.split('Of=')[1] if 'Of=' in key else 'all'
        regions = {result['setting'] for result in rows_of(measurements, name) if of in result.get('split', {})}
        figures = {result['setting'] for result in rows_of(measurements, name) if of in result.get('figure_split', {})}
        settings, log = len(regions | figures), key.endswith('=log')
        same(key, 'split', 'bars', settings + (0 if log else 3 * settings))  # a tick for the total
        same(key, 'split', 'points', 3 * settings if log else 0)
    return wrong


def check_rest(found):
    expect(found['simplifications']['tables'] == [1], f'simplifications: {found["simplifications"]}')
    cells = found['simplifications']['cells']
    expect(cells[:5] == ['ozone', 'aureole default', '2', '+3.7', '+18.4'] and '0.1 (20 %)' in cells, f'simplifications: {cells}')
    expect(found['numbers']['tables'] == [4] and '900 k' in found['numbers']['cells'], f'numbers: {found["numbers"]}')
    expect(found['numbers Scenes=Mars']['tables'] == [3], f'numbers on Mars: {found["numbers Scenes=Mars"]}')
    expect(found['pictures']['images'] == 3, 'pictures are not shown')
    expect(all(text in found['hover'] for text in ('hillaire default', 'per frame', '1.5 ms', '12 %', '3 M', 'not measured')),
           f'what hovering shows: {found["hover"]}')
    front = ['aureole default, no ozone (0.4 ms, 20 %)', 'aureole default (0.5 ms, 1.6 %)', 'aureole high (1.2 ms, 0.8 %)',
             'aureole default (1 ms, 2.4 %)']
    expect(found['fronts']['lists'] == front, f'on the front: {found["fronts"]["lists"]}')
    titles = found['fronts']['charts']['fronts: Mars']['titles']
    expect(titles == ['per frame, ms', '95th percentile of the error (all), %'], f'titles of axes: {titles}')


def check_bare(found, said):
    expect(found is not None and not said, f'without costs, parts and pictures: {said}')
    for section, chart in (('fronts', 'fronts: Mars'), ('split', 'split')):
        expect(found and 'not measured' in found[section]['charts'][chart]['text'], f'{section}: does not say what is missing')


def main():
    program = browser()
    if program is None:
        skip(f'none of {", ".join(NAMES)} is installed')
    started = time.monotonic()
    measurements = json.loads(EXAMPLE.read_text(encoding='utf-8'))
    with tempfile.TemporaryDirectory(prefix='aureole_report_', ignore_cleanup_errors=True) as name:
        folder = pathlib.Path(name)
        check_text(make_pages(folder))
        found, said = visit(program, folder / 'probed.html', folder)
        expect(found is not None, 'the page did not come to an end')
        expect(not said, 'on the console:\n' + '\n'.join(said))
        if found:
            failures.extend(check_charts(found, measurements))
            check_rest(found)
        check_bare(*visit(program, folder / 'bare.html', folder))
        broken, said = visit(program, folder / 'broken.html', folder)
        expect(broken is not None and check_charts(broken, measurements) and said, 'broken charts were not found out')
    print('\n'.join(failures) if failures else f'{len(found)} choices are drawn; {time.monotonic() - started:.1f} s')
    sys.exit(1 if failures else 0)


main()
