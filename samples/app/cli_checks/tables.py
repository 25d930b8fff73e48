"""`probe` and `score`; tables that cannot be written."""
import json

from cli_checks.runner import BACKEND, FOLDER, HEADER, SCENES, expect, fails, put, run, works

PROBE = ['probe', '--scene', SCENES / 'truth_earth.toml', *BACKEND, '--quality', 'low', '-o']


def check_probe():
    rows = put('in.csv', f'# comment\n{HEADER},L_r_per_sr,note\n30,0.2,10,45,1,x\n85,10,95,0,2,y\n')
    works(*PROBE, FOLDER / 'other.csv', '--directions', rows, '--model', 'hillaire')
    works(*PROBE, FOLDER / 'out.csv', '--directions', rows)
    expect(', model hillaire, quality low' in (FOLDER / 'other.csv').read_text(), 'a probe says which model')
    lines = [line for line in (FOLDER / 'out.csv').read_text().splitlines() if not line.startswith('#')]
    expect(lines[0] == HEADER + ',r,g,b' and lines[1].startswith('30,0.2,10,45,') and len(lines) == 3, f'probe wrote {lines}')
    expect(all(0 < float(x) < 1 for line in lines[1:] for x in line.split(',')[4:]), f'plausible radiances {lines}')
    return FOLDER / 'out.csv'


def check_probe_faults():
    for part, text in (('column azimuth_deg is missing', 'sun_zenith_deg,altitude_km,view_zenith_deg\n1,2,3\n'),
                       ('f.csv:2: azimuth_deg: "nan"', HEADER + '\n1,2,3,nan\n'), ('f.csv:2: 3 cells', HEADER + '\n1,2,3\n'),
                       ('holds no row', HEADER + '\n'), ('holds no row', ''), ('f.csv:3: view_zenith_deg: 300', HEADER + '\n1,2,3,4\n1,2,300,4\n')):
        fails(part, *PROBE, FOLDER / 'x.csv', '--directions', put('f.csv', text))
    fails('there is no such file', *PROBE, FOLDER / 'x.csv', '--directions', 'none.csv')
    fails('there is no folder', *PROBE, FOLDER / 'none/x.csv', '--directions', FOLDER / 'in.csv')


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


def check_tables_that_take_no_files():
    rows = put('in.csv', HEADER + '\n' + '30,0.2,10,45\n' * 20)
    trace = ['trace', '--preset', 'airless', '--directions', rows, *BACKEND, '--max-paths', 4096, '-o', FOLDER / 'new.csv']
    result = run(*trace, '--checkpoint', FOLDER / 'new.json', file_bytes=100)
    said = [line for line in result.stderr.splitlines() if line.startswith('aureole: ')]
    expect(result.returncode == 2 and said == [f'aureole: {FOLDER}/new.json: cannot be written (is the disk full?)'],
           'a checkpoint that cannot be written is told', result)
    expect(not list(FOLDER.glob('*new.*')), 'and leaves nothing')
    fails('new.md: cannot be written', 'report', SCENES.parent / 'report/example.json', '--markdown', FOLDER / 'new.md', file_bytes=100)
