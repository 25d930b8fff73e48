#!/usr/bin/env python3
"""The host in a window: nothing for validation to say, nothing allocated in its frames, and the sky that `aureole render` draws.

    window_test.py HOST_VULKAN AUREOLE SCENES

Run by ctest in a folder of its own. The window is Xvfb's; without it the test is skipped (exit code 77).
"""
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import zlib

HOST, AUREOLE, SCENES = sys.argv[1:]
SIZE = ['--size', '320x180']
SKY_ROWS = 36  # of the valley's picture
problems = []


def expect(holds, what):
    if not holds:
        problems.append(what)
        print('FAILED:', what)


def run(*command):
    done = subprocess.run([str(c) for c in command], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True, timeout=240)
    print('$', *command, '\n' + done.stdout)
    return done


def read_png(path):
    """Rows of bytes of an RGB PNG of 8 bits, by the format's own words (PNG 1.2, sections 3 and 6)."""
    data = pathlib.Path(path).read_bytes()
    at, packed = 8, b''
    while at < len(data):
        length, kind = struct.unpack('>I4s', data[at:at + 8])
        if kind == b'IHDR':
            width, height, bits, color = struct.unpack('>IIBB', data[at + 8:at + 18])
            assert (bits, color) == (8, 2), 'an RGB PNG of 8 bits'
        if kind == b'IDAT':
            packed += data[at + 8:at + 8 + length]
        at += 12 + length
    raw, stride, rows = zlib.decompress(packed), 3 * width, []
    above = bytes(stride)
    for y in range(height):
        start = y * (stride + 1)
        kind, row = raw[start], bytearray(raw[start + 1:start + 1 + stride])
        for i in range(stride):
            a, b, c = (row[i - 3] if i >= 3 else 0), above[i], (above[i - 3] if i >= 3 else 0)
            if kind == 1:
                row[i] = (row[i] + a) & 255
            elif kind == 2:
                row[i] = (row[i] + b) & 255
            elif kind == 3:
                row[i] = (row[i] + (a + b) // 2) & 255
            elif kind == 4:
                p = a + b - c
                nearest = min((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - c), 2, c))[2]
                row[i] = (row[i] + nearest) & 255
        rows.append(bytes(row))
        above = rows[-1]
    return rows


def rendered(scene):
    """The picture of `aureole render`, a pixel a sample, and its exposure."""
    done = run(AUREOLE, 'render', scene, '-o', f'{pathlib.Path(scene).stem}.png', '--samples', 1, '--backend', 'vulkan', *SIZE)
    expect(done.returncode == 0, f'aureole renders {scene}')
    return read_png(f'{pathlib.Path(scene).stem}.png'), re.search(r'exposure (\S+)', done.stdout).group(1)


def hosted(name, scene, exposure, *options):
    """The host's last frame, after what it says at its end has been checked."""
    done = run('xvfb-run', '-a', HOST, '--scene', scene, '--exposure', exposure, '--screenshot', f'{name}.png', *SIZE, *options)
    if 'no Vulkan 1.3 device' in done.stdout or 'is not installed' in done.stdout:
        print('skipped:', done.stdout)
        sys.exit(77)
    expect(done.returncode == 0, f'{name}: the host ends well')
    # The validation layer allocates in the calls in which Aureole may not: one or the other is counted.
    for said in ('Vulkan objects and memory made in these frames: 0',
                 'validation messages: 0' if '--validate' in options else 'heap allocations of Aureole in these frames: 0'):
        expect(re.search(re.escape(said) + r'$', done.stdout, re.M), f'{name}: {said}')
    counts = re.search(r'frames: (\d+), resizes: (\d+)', done.stdout)
    expect(counts and int(counts.group(1)) >= 4, f'{name}: at least 4 frames were counted')
    expect(counts and int(counts.group(2)) >= 2, f'{name}: at least 2 resizes')
    return read_png(f'{name}.png')


def compare(name, expected, found, rows):
    """Steps of 8 bits between two pictures in their first rows: the largest, and the mean with its sign."""
    differences = [b - a for y in range(rows) for a, b in zip(expected[y], found[y], strict=True)]
    worst, mean = max(map(abs, differences)), sum(differences) / len(differences)
    print(f'{name}: worst {worst}, mean {mean:.3f} of 255, {rows} rows')
    return worst, mean


def main():
    # Sky and bare ground, every pixel. Each picture is within a step and a half of what it stands for (dither of one step, rounding
    # of half a step), so two are within three; half floats of the host's target add a tenth of one. On average they are the same.
    noon = SCENES + '/noon.toml'
    picture, exposure = rendered(noon)
    found = hosted('host_noon', noon, exposure, '--frames', 18, '--resize-every', 5, '--sway', 20, '--spheres', 0)
    worst, mean = compare('noon', picture, found, len(picture))
    expect(worst <= 3 and abs(mean) <= 0.1, 'noon: the picture of aureole render')

    # Land, shadows, shafts of light and glass, three frames in flight: under validation, and the same to the last bit where the tables
    # have command buffers of their own.
    valley = SCENES + '/terrain_shafts.toml'
    picture, exposure = rendered(valley)
    options = ['--frames', 14, '--resize-every', 5, '--sway', 10, '--frames-in-flight', 3, '--validate']
    found = hosted('host_valley', valley, exposure, *options)
    async_found = hosted('host_valley_async', valley, exposure, *options, '--async-compute', 'on')
    expect(found == async_found, 'asynchronous compute changes nothing')
    # The sky over the land, above the sun's disk. Both subtract what the land shades, each by a map of its own: by drawn triangles
    # here, by rays there.
    worst, mean = compare('valley', picture, found, SKY_ROWS)
    expect(worst <= 4 and abs(mean) <= 0.5, 'valley: the sky of aureole render')


if __name__ == '__main__':
    if not shutil.which('xvfb-run') or not shutil.which('xauth'):
        print('skipped: xvfb-run is not here (packages xvfb and xauth)')
        sys.exit(77)
    main()
    sys.exit(1 if problems else 0)
