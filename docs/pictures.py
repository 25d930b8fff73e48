#!/usr/bin/env python3
"""Makes the pictures of the pages again, with the program and from scene files; needs python3-pil.

    docs/pictures.py [--program build/release/bin/aureole] [NAME...]

Scenes of docs/pictures are rendered once for each value behind "# pictures:" on a line, beside each other into docs/images/pictures/NAME.jpg; where
several lines have values, the first picture takes the first of each. A scene that says "# each apart" is kept value by value, too, as NAME-VALUE.jpg. Scenes of samples/scenes become docs/images/gallery/NAME.jpg.
"""
import argparse
import pathlib
import re
import subprocess
import sys
import tempfile

from PIL import Image

DOCS = pathlib.Path(__file__).resolve().parent
VALUES = re.compile(r'^(?P<key>\w+ = )(?P<value>.*?)  # pictures: (?P<all>.*)$', re.M)
# Values inside of a table: the last number of the line is the one that changes, unless they are whole tables.
INSIDE = re.compile(r'[-+.\de]+(?= \}$)')
PANEL, GALLERY = (400, 225), (960, 540)
COLUMNS = 4
APART = '# each apart'
NO_PICTURES = ('truth_',)  # scenes of tables


def values(text):
    """What the first line with values has, without quotation marks."""
    return [value.strip('"') for value in VALUES.search(text)['all'].split(' | ')]


def variants(text):
    """The texts of a scene, one for each of its values."""
    counts = {len(match['all'].split(' | ')) for match in VALUES.finditer(text)}
    if len(counts) != 1:
        raise ValueError(f'lines with "# pictures:" have {sorted(counts)} values; wanted: as many on each')

    def line(match, i):
        value = match['all'].split(' | ')[i]
        inside = match['value'].startswith('{') and not value.startswith('{')
        return match['key'] + (INSIDE.sub(value, match['value']) if inside else value)
    return [VALUES.sub(lambda match, i=i: line(match, i), text) for i in range(counts.pop())]


def render(program, scene, size, folder, options=()):
    output = folder / 'picture.png'
    command = [program, 'render', scene, '-o', output, '--size', f'{size[0]}x{size[1]}', *options]
    done = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f'{scene}: {done.stderr.strip()}')
    return Image.open(output).convert('RGB').copy()


def panel(program, scene, text, folder):
    """A fisheye's circle in the middle; all else fills the panel."""
    if 'projection = "fisheye"' not in text:
        return render(program, scene, PANEL, folder)
    whole = Image.new('RGB', PANEL)
    whole.paste(render(program, scene, (PANEL[1], PANEL[1]), folder), ((PANEL[0] - PANEL[1]) // 2, 0))
    return whole


def beside(panels):
    """In rows of four at most; of seven four and three."""
    gap, (width, height) = 4, PANEL
    rows = -(-len(panels) // COLUMNS)
    columns = min(len(panels), COLUMNS)
    strip = Image.new('RGB', (columns * (width + gap) - gap, rows * (height + gap) - gap), 'white')
    for i, panel in enumerate(panels):
        strip.paste(panel, (i % COLUMNS * (width + gap), i // COLUMNS * (height + gap)))
    return strip


def save(image, path):
    path.parent.mkdir(parents=True, exist_ok=True)
    image.save(path, quality=88, subsampling=0, optimize=True)
    print(f'{path.relative_to(DOCS.parent)}: {image.width} x {image.height}, {path.stat().st_size // 1024} KiB', flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--program', type=pathlib.Path, default=DOCS.parent / 'build/release/bin/aureole')
    parser.add_argument('names', nargs='*')
    options = parser.parse_args()
    wanted = lambda path: not options.names or path.stem in options.names
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        for path in filter(wanted, sorted((DOCS / 'pictures').glob('*.toml'))):
            panels = []
            for text in variants(path.read_text(encoding='utf-8')):
                scene = folder / path.name
                scene.write_text(text, encoding='utf-8')
                panels.append(panel(options.program, scene, text, folder))
            save(beside(panels), DOCS / 'images/pictures' / f'{path.stem}.jpg')
            if APART in path.read_text(encoding='utf-8'):
                for value, one in zip(values(path.read_text(encoding='utf-8')), panels):
                    save(one, DOCS / 'images/pictures' / f'{path.stem}-{value}.jpg')
        for path in filter(wanted, sorted((DOCS.parent / 'samples/scenes').glob('*.toml'))):
            if not path.stem.startswith(NO_PICTURES):
                save(render(options.program, path, GALLERY, folder), DOCS / 'images/gallery' / f'{path.stem}.jpg')


if __name__ == '__main__':
    main()
