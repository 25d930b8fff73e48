"""`bench`, `devices`, and what the program says of itself."""
import json

from cli_checks.runner import BACKEND, FOLDER, expect, fails, models, works


def check_help():
    for command in ([], ['render'], ['probe'], ['score'], ['trace'], ['truth'], ['measure'], ['fit'], ['plan'], ['bench'], ['report'],
                    ['devices'], ['completion'], ['man']):
        out = works(*command, '--help')
        expect(len(out.splitlines()) > 3, f'help of {command}')
    fails('ubcommand', )
    fails('COMMAND: "frobnicate" is not allowed; allowed: render, probe, score, trace, truth, measure, '
          'fit, plan, bench, report, devices, completion, man', '--verbose', 'frobnicate')
    version = works('--version')
    expect(version.startswith('aureole ') and version.split()[1][0].isdigit(), f'version: {version}')


def check_bench():
    out = works('bench', *BACKEND, '--size', '32x16', '--frames', 1, '--json', FOLDER / 'bench.json')
    bench = json.loads((FOLDER / 'bench.json').read_text())
    expect([(m['model'], m['quality']) for m in bench['models']] ==
           [(m, q) for m in ('aureole', 'hillaire') for q in ('low', 'default', 'high')], 'bench: models')
    expect(all(p['median_ms'] > 0 and p['bytes_written'] > 0 for m in bench['models'] for p in m['passes'] if p['invocations']),
           'bench: passes')
    expect(bench['models'][4]['ratio'] == {'to': 'hillaire default', 'per_frame': 1, 'full_rebuild': 1}, 'bench: ratio to itself')
    expect('hillaire default' in out and 'per frame' in out, 'bench prints a table')
    out = works('bench', *BACKEND, '--size', '32x16', '--frames', 1, '--model', 'aureole,aureole', '--quality', 'low')
    expect('aureole low' in out and 'aureole default' not in out and 'relative to aureole low' in out, f'bench of one: {out}')


def check_bench_faults():
    fails('--model', 'bench', *BACKEND, '--model', 'aureole,preetham')
    fails('--quality', 'bench', *BACKEND, '--quality', 'low,ultra')
    fails('--preset: none not in {earth,hazy_earth,mars,airless', 'bench', *BACKEND, '--preset', 'none')
    expect('earth, hazy_earth, mars, airless' in works('bench', '--help'), 'bench says which presets it takes')
    fails('--frames: 0 is not allowed; allowed: 1 to 100000', 'bench', *BACKEND, '--frames', 0)
    for text in ('abc', '3x', '-1', '1.5'):
        fails(f'--frames: "{text}" is not a whole number', 'bench', *BACKEND, f'--frames={text}')
    fails('--frames: 99999999999 is not allowed', 'bench', *BACKEND, '--frames', '99999999999')
    fails('there is no folder', 'bench', *BACKEND, '--json', FOLDER / 'none/x.json')


def check_devices():
    out = works('devices')
    expect('cpu-double' in out and 'vulkan' in out, f'devices: {out}')
    known = models()
    for text in (out, works('--help'), works('render', '--help'), works('probe', '--help'), works('bench', '--help')):
        expect(all(any(line.split()[:1] == [name] and len(line.split()) > 3 for line in text.splitlines()) for name in known),
               f'every model has a line: {text}')
