#!/usr/bin/env python3
"""Every link and picture of a folder of pages leads to a file in it, and to a place in it.   site_links.py FOLDER"""
import html.parser
import pathlib
import sys
import urllib.parse


class Page(html.parser.HTMLParser):
    def __init__(self, file):
        super().__init__()
        self.places, self.targets = set(), []
        self.feed(file.read_text())

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.places.update(filter(None, (attributes.get('id'), attributes.get('name'))))
        self.targets += filter(None, (attributes.get('href'), attributes.get('src')))


folder = pathlib.Path(sys.argv[1]).resolve()
pages = {file: Page(file) for file in folder.rglob('*.html')}
broken, links = [], 0
for file, page in pages.items():
    for target in page.targets:
        parts = urllib.parse.urlsplit(target)
        if parts.scheme or parts.netloc:
            continue
        links += 1
        to = (file.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else file
        anchor = urllib.parse.unquote(parts.fragment)
        if not to.is_file() or not to.is_relative_to(folder) or (anchor and to in pages and anchor not in pages[to].places):
            broken.append('%s: %s' % (file.relative_to(folder), target))
print('\n'.join([*broken, '%d links in %d pages, %d broken' % (links, len(pages), len(broken))]))
sys.exit(1 if broken or links == 0 else 0)
