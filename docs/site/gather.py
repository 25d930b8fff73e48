#!/usr/bin/env python3
"""Gathers the tree's pages into one folder, as mkdocs wants them; mkdocs.yml, which says in which order they are shown, must name them all.

    gather.py ROOT STAGE

Pages keep their places in the tree, so links between them stay as they are. A link to a file of code leads to a page that shows it, one to a
folder to a list of what is in it. Below each page beside code stand its kernels.
"""
import os
import pathlib
import re
import shutil
import sys
import urllib.parse

SITE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(SITE.parent.parent / 'tests/docs'))
from links_test import FENCE, LINK, pages  # noqa: E402

LANGUAGES = {'.h': 'cpp', '.cpp': 'cpp', '.c': 'c', '.glsl': 'glsl', '.py': 'python', '.sh': 'bash', '.toml': 'toml', '.cmake': 'cmake',
             '.json': 'json', '.inc': 'cpp', '.js': 'javascript'}
IMAGES = {'.png', '.jpg', '.svg', '.gif'}
SOURCE = pathlib.PurePosixPath('source')
SHOWN = 200_000  # characters of a file
CODE = re.compile(r'`[^`\n]+`')
PASSES = ('transmittance', 'multi_scatter', 'sky_view', 'aerial_perspective', 'shadows', 'composite', 'light')
ROOMS = {f'atmosphere/{room}/{room}.md' for room in PASSES}
# A room's page begins with a table, in which one row leads to the kernel that its equations are in.
KERNEL = re.compile(r'^\| (?:Kernels?|Equations|Tables)\b[^\n]*?\]\([^)\s]+\.glsl\)[^\n]*', re.M)
GLSL = re.compile(r'\]\(([^)\s]+\.glsl)\)')
SECTION = re.compile(r'^## ', re.M)
LIST = re.compile(r'\s*([-*]|\d+\.) ')


class Site:
    def __init__(self, root, stage):
        self.root, self.stage = root, stage
        self.pages = {page.relative_to(root).as_posix() for page in pages(root)}
        self.sources = set()  # files and folders that get a page of their own
        self.made = set()

    def page_of(self, path):
        """Where a file or folder of the tree is shown: a path in the stage."""
        if path in self.pages:
            return pathlib.PurePosixPath('index.md' if path == 'README.md' else path)
        if pathlib.PurePosixPath(path).suffix in IMAGES:
            self.copy(path)
            return pathlib.PurePosixPath(path)
        self.sources.add(path)
        return self.source_page(path)

    def source_page(self, path):
        shown = re.sub(r'(^|/)\.', r'\1_', path)  # mkdocs passes over names that begin with a dot
        return SOURCE / shown / 'index.md' if (self.root / path).is_dir() else SOURCE / (shown + '.md')

    def copy(self, path):
        target = self.stage / path
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(self.root / path, target)

    def link(self, page, shown_at, target):
        """What a link on a page of the tree is on the site."""
        parts = urllib.parse.urlsplit(target)
        if parts.scheme or not parts.path:
            return target
        file = (self.root / page).parent / urllib.parse.unquote(parts.path)
        if not file.exists():
            return target
        path = pathlib.PurePosixPath(os.path.relpath(file, self.root)).as_posix()
        if path == 'docs/README.md':
            path = 'README.md'  # the site's own navigation takes the place of the index
        relative = os.path.relpath(self.page_of(path), shown_at.parent)
        return relative + ('#' + parts.fragment if parts.fragment else '')

    def convert(self, page, text, shown_at):
        """Links, and blank lines that GitHub does without and Python's Markdown does not. Code stays as it is."""
        pieces, end = [], 0
        for fence in FENCE.finditer(text):
            pieces += [self.convert_prose(page, text[end:fence.start()], shown_at), fence.group(0)]
            end = fence.end()
        return ''.join([*pieces, self.convert_prose(page, text[end:], shown_at)])

    def convert_prose(self, page, text, shown_at):
        def replaced(match):
            start, stop = match.span(1)
            return match.group(0)[:start - match.start()] + self.link(page, shown_at, match.group(1)) + match.group(0)[stop - match.start():]
        text = re.sub(r'(\[!\[[^\]]*\]\()([^()\s]+)(\)\]\()', lambda m: m.group(1) + self.link(page, shown_at, m.group(2)) + m.group(3), text)
        text = LINK.sub(replaced, text)
        lines, opening = [], ''  # the first line of the paragraph
        for line in text.split('\n'):
            before = lines[-1] if lines else ''
            opening = line if not before.strip() else opening
            begins_list = LIST.match(line) and before.strip() and not LIST.match(opening) and not before.startswith('|')
            begins_table = line.startswith('|') and before.strip() and not before.startswith('|')
            if begins_list or begins_table:
                lines.append('')
                opening = line
            # In a cell GitHub wants a bar of code escaped; Python's Markdown shows the escape.
            lines.append(CODE.sub(lambda code: code.group(0).replace('\\|', '|'), line) if line.startswith('|') else line)
        return '\n'.join(lines)

    def write(self, place, text):
        target = self.stage / place
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text, encoding='utf-8')
        self.made.add(str(place))

    def write_page(self, page):
        place = self.page_of(page)
        text = self.convert(page, (self.root / page).read_text(encoding='utf-8'), place)
        self.write(place, self.beside(page, text) + self.kernels(page))

    def shown(self, file, opened):
        """A kernel that folds; its own page is made, too."""
        self.sources.add(file.relative_to(self.root).as_posix())
        code = '\n'.join(('    ' + line).rstrip() for line in file.read_text(encoding='utf-8').rstrip('\n').split('\n'))
        return f'\n???{"+" if opened else ""} example kernel "{file.name}"\n\n    ```glsl\n{code}\n    ```\n'

    def beside(self, page, text):
        """The kernel that a page's first table names, below the page's first section: that is where the equations are."""
        row = KERNEL.search((self.root / page).read_text(encoding='utf-8')) if page.startswith('atmosphere/') else None
        sections = [match.start() for match in SECTION.finditer(text)]
        if not row or len(sections) < 2:
            return text
        folder = (self.root / page).parent
        named = [(folder / name).resolve() for name in GLSL.findall(row[0])]
        named += [file for file in [folder / (folder.name + '.glsl')] if file.exists()]  # what the kernel includes of its own room
        kernels = ''.join(self.shown(file, opened=file == named[0]) for file in dict.fromkeys(named))
        return text[:sections[1]] + kernels + '\n' + text[sections[1]:]

    def kernels(self, page):
        """The kernels of the room that a page stands in, folded up."""
        files = sorted((self.root / page).parent.glob('*.glsl'))
        if not files or not page.startswith('atmosphere/'):
            return ''
        text = '\n\n## Source of the kernels\n\nAs they are compiled, for the GPU and for the CPU in float and double.\n'
        return text + ''.join(self.shown(file, opened=False) for file in files)

    def write_source(self, path):
        file = self.root / path
        name = pathlib.PurePosixPath(path)
        if file.is_dir():
            kept = [each for each in sorted(file.iterdir()) if not each.name.startswith('.') and each.name not in ('build', 'out', '__pycache__')]
            lines = []
            for each in kept:
                inside = each.relative_to(self.root).as_posix()
                known = inside in self.pages or inside in self.sources
                shown = each.name + ('/' if each.is_dir() else '')
                lines.append(f'- [{shown}]({os.path.relpath(self.page_of(inside), self.source_page(path).parent)})' if known else f'- {shown}')
            self.write(self.source_page(path), f'# {path}/\n\n' + '\n'.join(lines) + '\n')
            return
        text = file.read_text(encoding='utf-8', errors='replace')
        cut = '\n…' if len(text) > SHOWN else ''
        fence = '~~~~~~'
        language = LANGUAGES.get(name.suffix, 'text')
        self.write(self.source_page(path), f'# {name.name}\n\n`{path}`\n\n{fence}{language}\n{text[:SHOWN]}{cut}\n{fence}\n')

    def write_all(self):
        for page in sorted(self.pages - {'docs/README.md'}):
            self.write_page(page)
        done = set()
        while self.sources - done:
            path = sorted(self.sources - done)[0]
            self.write_source(path)
            done.add(path)


def navigation_problems(site):
    """The navigation of mkdocs.yml names every page, and no other."""
    named = set(re.findall(r': (\S+\.md)$', (SITE / 'mkdocs.yml').read_text(encoding='utf-8'), re.M))
    shown = {str(site.page_of(page)) for page in site.pages - {'docs/README.md'}}
    return [f'mkdocs.yml: {page}: no such page' for page in sorted(named - shown)] + \
           [f'mkdocs.yml: {page}: no place in the navigation' for page in sorted(shown - named)]


def incomplete(site):
    """The page of each pass and of each model has equations, a picture that the project's own program makes, and names its kernel."""
    problems = []
    for page in sorted(site.pages):
        room = pathlib.PurePosixPath(page).parent
        if page not in ROOMS and not (str(room.parent) == 'atmosphere/models' and room.name == pathlib.PurePosixPath(page).stem):
            continue
        text = (site.root / page).read_text(encoding='utf-8')
        wanted = {'equation': re.search(r'\$', text), 'picture': '![' in text and 'docs/pictures.py' in text, 'kernel in its first table': KERNEL.search(text)}
        problems += [f'{page}: no {what}' for what, found in wanted.items() if not found]
    return problems


def main():
    root, stage = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    if stage.exists():
        shutil.rmtree(stage)
    site = Site(root, stage)
    site.write_all()
    shutil.copytree(SITE / 'theme', stage / 'theme')
    problems = navigation_problems(site) + incomplete(site)
    if problems:
        sys.exit('\n'.join(problems))
    print(f'{len(site.pages)} pages, {len(site.sources)} files and folders that they link to')


if __name__ == '__main__':
    main()
