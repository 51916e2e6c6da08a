#!/usr/bin/env python3
"""Makes the documentation as a folder of static pages: those of the sources, and pages of what the program, the headers and
the Python module say of themselves, with the report of the figures where its folder is there. Needs MkDocs.
    docs.py SOURCES TAUT FOLDER [FIGURES]"""
import ast
import collections
import html.parser
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib

LINK = re.compile(r'(?<!!)\[([^\]]+)\]\(([^)#\s]+)(#[^)\s]*)?\)')
# What a compiler needs of a header and readers do not.
GUARDS = re.compile(r'(?m)^(#(ifndef|ifdef|if|else|endif|include|define TAUT_H|define TAUT_API).*|extern "C" \{|\}(  // extern.*)?)\n')
PICTURE = re.compile(r'!\[[^\]]*\]\(([^)\s]+)\)')


def pages_of(sources):
    """Pages of the sources, relative to them."""
    for folder, folders, names in os.walk(sources):
        folders[:] = sorted(name for name in folders if name not in ('build', 'node_modules') and not name.startswith('.'))
        yield from (pathlib.Path(folder, name).relative_to(sources) for name in sorted(names) if name.endswith('.md'))


def copy_page(sources, site, page):
    """Copies a page and its pictures. A link to a folder leads to its page; one to a source file becomes its name."""
    def link(found):
        text, target, anchor = found.groups()
        if '://' in target or target.endswith('.md'):
            return found[0]
        if (sources / page.parent / target / 'README.md').exists():
            return '[%s](%s/README.md%s)' % (text, target.rstrip('/'), anchor or '')
        return text
    text = (sources / page).read_text()
    (site / page).parent.mkdir(parents=True, exist_ok=True)
    (site / page).write_text(LINK.sub(link, text))
    for picture in PICTURE.findall(text):
        copy = site / os.path.normpath(page.parent / picture)
        copy.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(sources / page.parent / picture, copy)


def fenced(text, language=''):
    return '```%s\n%s\n```\n' % (language, text.strip('\n'))


def said_by(taut, *words):
    environment = {**os.environ, 'COLUMNS': '100'}
    return subprocess.run([taut, *words], check=True, capture_output=True, text=True, env=environment).stdout


def options_page(taut):
    commands = re.findall(r'(?m)^  ([a-z]+) ', said_by(taut, '--help').partition('Subcommands:')[2].partition('Examples:')[0])
    return '# Commands and options\n\n' + ''.join(
        '## taut %s\n\n%s\n' % (command, fenced(said_by(taut, command, '--help-all'), 'text')) for command in commands)


def c_page(header):
    """The comments of the header as text, and its declarations as code."""
    text = header.read_text()
    parts = ['# The C interface\n\nAll of `taut.h`.\n']
    for comment, code in re.findall(r'/\*(.*?)\*/(.*?)(?=^/\*|\Z)', text, re.S | re.M):
        code = re.sub(GUARDS, '', code)
        prose = re.sub(r'(?m)^ ?\* ?', '', comment).strip('*\n ')
        parts.append(re.sub(r'(?m)^  (?=\s*\S)', '    ', prose) + '\n')
        parts.append(fenced(code, 'c') if code.strip() else '')
    return '\n'.join(parts)


def python_page(module):
    """Signatures and docstrings of the module's public classes and functions."""
    tree = ast.parse(module.read_text())
    parts = ['# The Python module\n', ast.get_docstring(tree) or '']

    def add(node, depth, within=''):
        if node.name.startswith('_') and node.name != '__init__':
            return
        is_class = isinstance(node, ast.ClassDef)
        signature = within + node.name + ('' if is_class else '(%s)' % ast.unparse(node.args))
        parts.append('%s `%s`\n\n%s' % ('#' * depth, node.name, fenced(signature, 'python')))
        parts.append(ast.get_docstring(node) or '')
        for below in node.body if is_class else []:
            if isinstance(below, ast.FunctionDef):
                add(below, depth + 1, node.name + '.')
    for node in tree.body:
        if isinstance(node, (ast.ClassDef, ast.FunctionDef)):
            add(node, 2)
    return '\n\n'.join(parts) + '\n'


def gallery_page(sources, site):
    """Pictures, each with the command that makes it."""
    commands = tomllib.loads((sources / 'assets/pictures/gallery.toml').read_text())
    pictures = {file.stem for file in (sources / 'assets/pictures').glob('*.png')}
    if pictures != set(commands):
        sys.exit('gallery.toml: expected one command for each picture beside it, but not for %s' %
                 ', '.join(sorted(pictures ^ set(commands))))
    shutil.copytree(sources / 'assets/pictures', site / 'assets/pictures', dirs_exist_ok=True,
                    ignore=shutil.ignore_patterns('*.toml'))
    return '# Gallery\n\n' + '\n'.join('![%s](../assets/pictures/%s.png)\n\n%s\n' % (name, name, fenced(command, 'sh'))
                                       for name, command in commands.items())


def title_of(page):
    """The first heading, without the marks of code."""
    return re.search(r'(?m)^# (.+)$', page.read_text())[1].replace('`', '')


def navigation(site, pages):
    """Lists pages by the folder they are in, as MkDocs reads it."""
    parts = {}
    for page in pages:
        parts.setdefault(page.parts[0] if len(page.parts) > 1 else '', []).append(page)
    titles = {page: title_of(site / page) for page in pages}
    counts = collections.Counter(titles.values())
    lines = []
    for part, within in parts.items():
        lines += ['  - %s:' % part] if part else []
        for page in within:
            title = titles[page] if counts[titles[page]] == 1 else '%s (%s)' % (titles[page], page.parent)
            lines.append('%s  - %s: %s' % ('    ' if part else '', json.dumps(title), page))
    return '\n'.join(lines) + '\n'


class Sections(html.parser.HTMLParser):
    """Headings of a page, each with its anchor and the text below it."""

    def __init__(self, file):
        super().__init__()
        self.sections, self.is_heading, self.skipped = [], False, None
        text = file.read_text()
        self.feed(text[max(text.find('<article'), text.find('<body')):].partition('</article>')[0])

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        if tag in ('h1', 'h2', 'h3') and not self.skipped:
            self.is_heading = True
            self.sections.append([attributes.get('id', ''), '', ''])
        if tag in ('script', 'style') or attributes.get('class') == 'headerlink':
            self.skipped = tag

    def handle_endtag(self, tag):
        self.is_heading = self.is_heading and tag not in ('h1', 'h2', 'h3')
        self.skipped = None if tag == self.skipped else self.skipped

    def handle_data(self, data):
        if self.sections and not self.skipped:
            self.sections[-1][1 if self.is_heading else 2] += data


def write_search_index(folder):
    """What search.js looks through: page, heading, address and text of each section."""
    entries = []
    for file in sorted(folder.rglob('*.html')):
        sections = [[part, *(' '.join(text.split()) for text in texts)] for part, *texts in Sections(file).sections]
        address = str(file.relative_to(folder))
        entries += [[sections[0][1], heading, address + ('#' + part if part else ''), text]
                    for part, heading, text in sections]
    (folder / 'search_index.js').write_text('globalThis.tautSections=%s;\n' % json.dumps(entries, ensure_ascii=False))


def main():
    if len(sys.argv) not in (4, 5):
        sys.exit(__doc__)
    sources, taut, folder, *figures = (pathlib.Path(word).resolve() for word in sys.argv[1:])
    with tempfile.TemporaryDirectory() as name:
        root = pathlib.Path(name)
        site = root / 'pages'
        pages = list(pages_of(sources))
        for page in pages:
            copy_page(sources, site, page)
        (site / 'reference').mkdir()
        reference = {
            'gallery': gallery_page(sources, site),
            'options': options_page(taut),
            'keys': '# Keys of scenes\n\n' + fenced(said_by(taut, 'help', 'scene'), 'text'),
            'statistics': '# Columns of statistics\n\n' + fenced(said_by(taut, 'help', 'stats'), 'text'),
            'c': c_page(sources / 'app/library/taut.h'),
            'python': python_page(sources / 'app/library/python/taut/__init__.py')}
        shutil.copy(sources / 'app/install/search.js', site)
        for name, text in reference.items():
            (site / 'reference' / (name + '.md')).write_text(text)
        start = pathlib.Path('README.md')
        ordered = [start, *(pathlib.Path('reference/%s.md' % name) for name in reference),
                   *(page for page in pages if page != start)]
        for report in (folder / 'report.html' for folder in figures):
            shutil.copy(report, site / 'report.html')
        (root / 'mkdocs.yml').write_text(
            'site_name: Taut\nsite_url: ""\ndocs_dir: pages\nuse_directory_urls: false\nplugins: []\n'
            'theme:\n  name: material\n  font: false\n  palette: {primary: blue grey}\n'
            'extra_javascript: [search.js]\nmarkdown_extensions: [sane_lists]\nnav:\n' + navigation(site, ordered) +
            ('  - The report: report.html\n' if figures else ''))
        shutil.rmtree(folder, ignore_errors=True)
        subprocess.run(['mkdocs', 'build', '--quiet', '--config-file', root / 'mkdocs.yml', '--site-dir', folder], check=True)
    (folder / '404.html').unlink()  # which only a server shows
    write_search_index(folder)
    print('wrote %s/index.html' % folder)


main()
