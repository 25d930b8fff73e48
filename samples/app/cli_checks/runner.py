"""What every check of the command line needs: the program, the folder that it writes to, and what is expected of a call."""
import pathlib
import resource
import subprocess
import sys
import time

AUREOLE, SCENES = str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2]).resolve()
BACKEND = ['--backend', sys.argv[3] if len(sys.argv) > 3 else 'cpu']
ON_VULKAN = BACKEND[1] == 'vulkan'
QUICK = sys.argv[4:] == ['quick']
FOLDER = pathlib.Path('cli')
HEADER = 'sun_zenith_deg,altitude_km,view_zenith_deg,azimuth_deg'
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
