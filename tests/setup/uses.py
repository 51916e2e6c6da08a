"""Finds what a build folder and the scripts of the sources use of the machine: headers, libraries, programs."""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from packages import output_of

# A machine with a GPU would add its vendor's driver, which nothing here needs.
SOFTWARE_RASTERISER = {'LIBGL_ALWAYS_SOFTWARE': '1',
                       '__EGL_VENDOR_LIBRARY_FILENAMES': '/usr/share/glvnd/egl_vendor.d/50_mesa.json'}
SHELL_QUOTES = re.compile(r"""'[^']*'|"(?:\\.|[^"\\])*"|\\.|(?<![^\s;(])\#[^\n]*""", re.S)
SHELL_COMMAND = re.compile(r'(?:^|[\n;&|({`])\s*(?:(?:if|then|elif|else|while|until|do|!|exec|command -v|\w+=\S*)\s+)*'
                           r'([A-Za-z][\w.+-]*)')
CMAKE_COMMAND = re.compile(r'\bCOMMAND\s+([a-z][\w.+-]*)|find_program\(\w+\s+([\w.+-]+)')
PYTHON_COMMAND = re.compile(r"""\b(?:subprocess\.(?:run|Popen)\(\[|output_of\()['"]([\w.+-]+)['"]""")


def builds_in(folder):
    """This build and those that it makes of other compilers."""
    return [ninja.parent for pattern in ('build.ninja', 'builds_apart/*/build.ninja') for ninja in folder.glob(pattern)]


def built_from(build):
    """Every header and library that went into the build, and every program that made or tests it."""
    def ninja(*arguments):
        return output_of('ninja', '-C', str(build), '-t', *arguments)
    headers = [line for line in ninja('deps').splitlines() if line.startswith(' ')]
    files = {os.path.normpath(build / line.strip()) for line in headers + ninja('inputs', 'all').splitlines()}
    programs = set(re.findall(r'(?:^|&& )(/\S+)', ninja('commands'), re.M))
    tests = json.loads(output_of('ctest', '--test-dir', str(build), '--show-only=json-v1') or '{"tests": []}')
    programs |= {test['command'][0] for test in tests['tests'] if 'command' in test}
    return files, programs


def loaded_by(executables):
    """The libraries that programs are linked with."""
    return set(re.findall(r'(?:^|=>)\s*(/\S+) \(0x', output_of('ldd', *map(str, executables)), re.M))


def loaded_while_drawing(taut):
    """The libraries that drawing a picture loads, each way to OpenGL that is here, and the font of the window."""
    environment = {**os.environ, **SOFTWARE_RASTERISER, 'LD_DEBUG': 'files'}
    picture = [taut, 'render', 'cloth-fall', '--frames', '0', '--resolution', '16,16', '--backend']
    with tempfile.TemporaryDirectory() as folder:
        ways = [subprocess.run([*picture, way], cwd=folder, env=environment, capture_output=True, text=True)
                for way in ('osmesa', 'egl')]
    loaded = [set(re.findall(r'calling init: (/\S+)', way.stderr)) for way in ways if way.returncode == 0]
    if not loaded:
        sys.exit('%s draws nothing: %s' % (taut, ways[-1].stderr[-1000:]))
    return {output_of('fc-match', '-f', '%{file}', 'DejaVu Sans')}.union(*loaded)


def without_strings(script):
    """A shell script's commands: no comments, lists, text that is handed on, or strings but for commands within."""
    script = re.sub(r"<<-?\s*['\"]?(\w+)['\"]?([^\n]*)\n.*?\n\1\n", r'\2\n', script, flags=re.S)
    script = SHELL_QUOTES.sub(lambda quoted: '"' + '\n'.join(re.findall(r'\$\(.*', quoted[0])), script)
    return re.sub(r'=\([^)]*\)', '', script)


def words_of(path):
    """The words of a script that stand where a program's name would."""
    text = path.read_text(errors='replace')
    first_line = re.match(r'#!\s*(\S+)(?:\s+(\w\S*))?', text)
    interpreters = {os.path.basename(word) for word in first_line.groups() if word} if first_line else set()
    if path.suffix == '.py':
        return interpreters | set(PYTHON_COMMAND.findall(text))
    if path.suffix in ('.cmake', '.txt'):
        return {word for found in CMAKE_COMMAND.findall(text) for word in found if word}
    if path.suffix == '.sh' or interpreters & {'sh', 'bash'}:
        return interpreters | set(SHELL_COMMAND.findall(without_strings(text)))
    return interpreters


def scripts_in(sources):
    """All but setup.sh, which runs before it has brought anything."""
    for folder, folders, names in os.walk(sources):
        folders[:] = [name for name in folders if name not in ('build', '.git', 'node_modules')]
        for name in names:
            path = pathlib.Path(folder, name)
            if path.suffix in ('.sh', '.py', '.cmake') or name in ('CMakeLists.txt', 'run'):
                if path != sources / 'setup.sh':
                    yield path


def programs_of(scripts):
    """The programs that scripts run, each with a script that does, and those that programs run that are scripts."""
    run_by, waiting = {}, list(scripts)
    while waiting:
        script = waiting.pop()
        for word in words_of(script) - run_by.keys():
            program = shutil.which(word, path='/usr/bin:/usr/sbin:' + os.environ['PATH'])
            if program is None:
                continue
            run_by[word] = script
            with open(program, 'rb') as file:
                if file.read(2) == b'#!':
                    waiting.append(pathlib.Path(program))
    return run_by
