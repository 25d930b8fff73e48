#!/usr/bin/env python3
"""Every link of a built site leads to a file that is there, and to an anchor in it; no page needs a network.

    check.py SITE         Exit code 1 if anything is wrong. `--self-test` checks that each kind of fault is found.
"""
import html.parser
import pathlib
import sys
import tempfile
import urllib.parse

LOADED = {'img': 'src', 'script': 'src', 'link': 'href', 'iframe': 'src', 'source': 'src', 'video': 'src'}
NOT_LOADED = {'canonical', 'next', 'prev', 'author'}


class Page(html.parser.HTMLParser):
    """Anchors and links of one page."""
    def __init__(self):
        super().__init__(convert_charrefs=True)
        self.anchors, self.links, self.remote = set(), set(), set()

    def handle_starttag(self, tag, attrs):
        attrs = dict(attrs)
        self.anchors.update(value for value in (attrs.get('id'), attrs.get('name') if tag == 'a' else None) if value)
        target = attrs.get('href' if tag in ('a', 'link') else 'src')
        if not target or (tag == 'link' and attrs.get('rel') in NOT_LOADED):
            return
        if urllib.parse.urlsplit(target).scheme in ('http', 'https') or target.startswith('//'):
            if tag in LOADED:
                self.remote.add(target)
        elif not target.startswith(('mailto:', 'data:', 'javascript:')):
            self.links.add(target)


def read(path):
    page = Page()
    page.feed(path.read_text(encoding='utf-8', errors='replace'))
    return page


def check(site):
    parsed = {path.resolve(): read(path) for path in sorted(site.rglob('*.html'))}
    problems = []
    for path, page in parsed.items():
        where = path.relative_to(site.resolve())
        problems += [f'{where}: is fetched from elsewhere: {target}' for target in sorted(page.remote)]
        for target in sorted(page.links):
            parts = urllib.parse.urlsplit(target)
            file = (path.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else path
            if file.is_dir():
                file = file / 'index.html'
            anchor = urllib.parse.unquote(parts.fragment)
            if not file.exists():
                problems.append(f'{where}: {target}: no such file')
            elif anchor and file in parsed and anchor not in parsed[file].anchors:
                problems.append(f'{where}: {target}: no such anchor')
    for path in site.rglob('*.css'):
        text = path.read_text(encoding='utf-8', errors='replace')
        problems += [f'{path.relative_to(site)}: fetches from elsewhere'] * any(f'url({quote}{scheme}' in text for quote in ('', '"', "'")
                                                                              for scheme in ('http', '//'))
    return len(parsed), problems


def self_test():
    with tempfile.TemporaryDirectory() as folder:
        site = pathlib.Path(folder)
        (site / 'a').mkdir()
        (site / 'index.html').write_text('<h1 id="x">x</h1><a href="a/b.html#y">y</a><a href="#x">x</a><a href="a/c.html">c</a>'
                                         '<a href="https://example.org">far</a><a href="a/b.html#z">z</a>')
        (site / 'a/b.html').write_text('<a name="y"></a><img src="gone.png"><script src="https://example.org/x.js"></script>')
        (site / 'a/x.css').write_text('@import url(//example.org/font)')
        found = sorted(check(site)[1])
    wanted = ['a/b.html: gone.png: no such file', 'a/b.html: is fetched from elsewhere: https://example.org/x.js',
              'a/x.css: fetches from elsewhere', 'index.html: a/b.html#z: no such anchor', 'index.html: a/c.html: no such file']
    return [] if found == wanted else [f'self-test: expected {wanted}, found {found}']


if __name__ == '__main__':
    count, report = (0, self_test()) if sys.argv[1] == '--self-test' else check(pathlib.Path(sys.argv[1]))
    print('\n'.join(report) if report else f'{count} pages: every link leads somewhere, and none leaves the site to be shown')
    sys.exit(1 if report else 0)
