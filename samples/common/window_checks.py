"""For tests of programs with a window: a display in memory, what is on it, and pictures."""
import contextlib
import os
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import zlib


def skip(why):
    """As ctest is told by SKIP_RETURN_CODE."""
    print(f'skipped: {why}')
    sys.exit(77)


class Picture:
    """Rows of 8-bit RGB."""

    def __init__(self, width, height, rows):
        self.width, self.height, self.rows = width, height, rows

    def crop(self, x, width):
        return Picture(width, self.height, [row[3 * x:3 * (x + width)] for row in self.rows])

    def pixel(self, x, y):
        return tuple(self.rows[y][3 * x:3 * x + 3])

    def apart(self, other):
        """Greatest difference of a channel, and the mean one."""
        if (self.width, self.height) != (other.width, other.height):
            return 999, 999
        steps = [abs(a - b) for mine, theirs in zip(self.rows, other.rows, strict=True) for a, b in zip(mine, theirs, strict=True)]
        return max(steps), sum(steps) / len(steps)

    def brightest(self):
        """Middle of all pixels that are as bright as the brightest."""
        lights = [(sum(row[3 * x:3 * x + 3]), x, y) for y, row in enumerate(self.rows) for x in range(self.width)]
        most = max(lights)[0]
        spots = [(x, y) for light, x, y in lights if light == most]
        return sum(x for x, _ in spots) / len(spots), sum(y for _, y in spots) / len(spots)

    def greatest(self):
        return max(max(row) for row in self.rows)


def unfilter(kind, row, above):
    """A line of a PNG, in place (PNG 1.2, section 6)."""
    for i in range(len(row)):
        left, up, corner = (row[i - 3] if i >= 3 else 0), above[i], (above[i - 3] if i >= 3 else 0)
        if kind == 1:
            row[i] = (row[i] + left) & 255
        elif kind == 2:
            row[i] = (row[i] + up) & 255
        elif kind == 3:
            row[i] = (row[i] + (left + up) // 2) & 255
        elif kind == 4:
            p = left + up - corner
            nearest = min((abs(p - left), 0, left), (abs(p - up), 1, up), (abs(p - corner), 2, corner))[2]
            row[i] = (row[i] + nearest) & 255


def read_png(path):
    """An RGB PNG of 8 bits (PNG 1.2, section 3)."""
    data = pathlib.Path(path).read_bytes()
    at, packed, width, height = 8, b'', 0, 0
    while at < len(data):
        length, kind = struct.unpack('>I4s', data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b'IHDR':
            width, height, depth, colour = struct.unpack('>IIBB', body[:10])
            assert (depth, colour) == (8, 2), f'{path}: an RGB PNG of 8 bits'
        packed += body if kind == b'IDAT' else b''
        at += 12 + length
    raw, stride, rows = zlib.decompress(packed), 3 * width, []
    above = bytearray(stride)
    for y in range(height):
        begin = y * (stride + 1)
        row = bytearray(raw[begin + 1:begin + 1 + stride])
        if raw[begin]:
            unfilter(raw[begin], row, above)
        rows.append(bytes(row))
        above = row
    return Picture(width, height, rows)


class Display:
    """A screen of Xvfb's; `DISPLAY` is set to it. Skips the test where there is no Xvfb."""

    def __init__(self, width=1280, height=1024):
        if not shutil.which('Xvfb'):
            skip('Xvfb is not installed (package xvfb)')
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix='aureole_display_'))
        reading, writing = os.pipe()
        self.server = subprocess.Popen(['Xvfb', '-displayfd', str(writing), '-screen', '0', f'{width}x{height}x24', '-nolisten', 'tcp',
                                        '-fbdir', str(self.folder)], pass_fds=[writing], stdin=subprocess.DEVNULL,
                                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(writing)
        with os.fdopen(reading) as answer:
            number = answer.readline().strip()
        if not number:
            self.close()
            skip('Xvfb does not start')
        os.environ['DISPLAY'] = f':{number}'

    def close(self):
        self.server.terminate()
        self.server.wait()
        shutil.rmtree(self.folder, ignore_errors=True)

    def shown(self):
        """What is on the screen: Xvfb keeps it in a file, as xwd writes windows (XWDFile.h)."""
        data = (self.folder / 'Xvfb_screen0').read_bytes()
        header = struct.unpack('>25I', data[:100])
        size, width, height, bits, line, colours = header[0], header[4], header[5], header[11], header[12], header[19]
        assert bits == 32 and header[7] == 0, 'four bytes a pixel, blue first'
        begin = size + 12 * colours
        rows = []
        for y in range(height):
            row = data[begin + y * line:begin + y * line + 4 * width]
            rgb = bytearray(3 * width)
            rgb[0::3], rgb[1::3], rgb[2::3] = row[2::4], row[1::4], row[0::4]
            rows.append(bytes(rgb))
        return Picture(width, height, rows)


@contextlib.contextmanager
def display(*size):
    opened = Display(*size)
    try:
        yield opened
    finally:
        opened.close()
