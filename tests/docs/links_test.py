#!/usr/bin/env python3
"""Every relative link in the tree's Markdown files leads to a file, and to a heading where it names one.

Run by ctest with the root of the tree. `--self-test` checks that each kind of dead link is found.
"""
import pathlib
import re
import sys
import tempfile
import urllib.parse

SKIP = {'build', 'out', '.git'}
LINK = re.compile(r'!?\[(?:[^\[\]]|\[[^\[\]]*\])*\]\(\s*<?([^()\s>]+)>?(?:\s+"[^"]*")?\s*\)')
REFERENCE = re.compile(r'^\s{0,3}\[[^\]]+\]:\s+<?(\S+?)>?\s*$', re.M)
FENCE = re.compile(r'^(```|~~~).*?^\1\s*$', re.M | re.S)


def pages(root):
    for path in sorted(root.rglob('*.md')):
        if not SKIP.intersection(path.relative_to(root).parts):
            yield path


def prose(text):
    """Without code blocks, code spans and formulas: what looks like a link there is none."""
    text = FENCE.sub(lambda m: '\n' * m.group(0).count('\n'), text)
    for pattern in (r'`[^`\n]*`', r'\$\$.*?\$\$', r'\$[^$\n]+\$'):
        text = re.sub(pattern, lambda m: 'x' + '\n' * m.group(0).count('\n'), text, flags=re.S)
    return text


def anchors(path):
    """Headings as GitHub names them: lower case, punctuation dropped, spaces to hyphens, repeats numbered."""
    seen = {}
    found = set()
    for line in FENCE.sub('', path.read_text(encoding='utf-8')).splitlines():
        match = re.match(r'#{1,6}\s+(.*?)\s*#*$', line)
        if not match:
            continue
        title = re.sub(r'\[([^\]]*)\]\([^)]*\)', r'\1', match.group(1)).lower()
        slug = re.sub(r'[^\w\- ]', '', title).replace(' ', '-')
        count = seen.get(slug, 0)
        seen[slug] = count + 1
        found.add(f'{slug}-{count}' if count else slug)
    return found


def check(root):
    problems = []
    for page in pages(root):
        text = prose(page.read_text(encoding='utf-8'))
        targets = [(m.start(), m.group(1)) for pattern in (LINK, REFERENCE) for m in pattern.finditer(text)]
        for start, target in targets:
            where = f'{page.relative_to(root)}:{text.count(chr(10), 0, start) + 1}: {target}'
            parts = urllib.parse.urlsplit(target)
            if parts.scheme in ('http', 'https', 'mailto'):
                continue
            file = (page.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else page
            if root.resolve() not in [file, *file.parents]:
                problems.append(f'{where}: leads out of the tree')
            elif not file.exists():
                problems.append(f'{where}: no such file')
            elif parts.fragment and parts.fragment not in anchors(file):
                problems.append(f'{where}: no such heading')
    return problems


PAGES = {
    'README.md': '# A b\n[good](docs/a.md#two-words) [self](#a-b) ![no](docs/missing.png) `[code](none.md)`\n',
    'docs/a.md': '# Two `words`\n## Two words\n[up](../README.md) [second](#two-words-1)\n```\n[code](none.md)\n```\n'
                 '[dead heading](../README.md#nothing) [out](../../etc) [web](https://example.org/x)\n$[x](y.md)$\n[ref]: gone.md\n',
}
DEAD = ['README.md:2: docs/missing.png: no such file', 'docs/a.md:7: ../../etc: leads out of the tree',
        'docs/a.md:7: ../README.md#nothing: no such heading', 'docs/a.md:9: gone.md: no such file']


def self_test():
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for name, text in PAGES.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text, encoding='utf-8')
        found = sorted(check(root))
    return [] if found == DEAD else [f'self-test: expected {DEAD}, found {found}']


if __name__ == '__main__':
    report = self_test() if sys.argv[1] == '--self-test' else check(pathlib.Path(sys.argv[1]))
    print('\n'.join(report) if report else 'every link leads somewhere')
    sys.exit(1 if report else 0)
