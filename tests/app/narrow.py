#!/usr/bin/env python3
"""In a terminal of 40 columns every line of help and of progress fits, but for words that are longer.   narrow.py PROGRAM FOLDER"""
import fcntl
import os
import pathlib
import pty
import re
import shutil
import struct
import subprocess
import sys
import termios

program, folder = sys.argv[1], pathlib.Path(sys.argv[2])
COLUMNS = 40
os.environ.pop('COLUMNS', None)


def said_to_terminal(words, environment={}):
    terminal, end = pty.openpty()
    fcntl.ioctl(end, termios.TIOCSWINSZ, struct.pack('HHHH', 24, COLUMNS, 0, 0))
    process = subprocess.Popen([program, *words.split()], cwd=folder, stdout=end, stderr=end, stdin=subprocess.DEVNULL,
                               env={**os.environ, **environment})
    os.close(end)
    said = b''
    try:
        while part := os.read(terminal, 65536):
            said += part
    except OSError:  # the other end is closed
        pass
    os.close(terminal)
    if process.wait() != 0:
        sys.exit('taut %s: exit code %d, %r' % (words, process.returncode, said))
    return said.decode()


def too_wide(text):
    """The lines that do not fit although a break between words would make them."""
    return [line for line in text.splitlines() if len(line) > COLUMNS and ' ' in line.strip()]


shutil.rmtree(folder, ignore_errors=True)
folder.mkdir(parents=True)
commands = re.findall(r'(?m)^  ([a-z]+)\b', said_to_terminal('--help').partition('Subcommands:')[2].partition('Examples:')[0])
failures = []
for words in ['--help'] + [command + option for command in commands for option in (' --help', ' --help-all')]:
    failures += ['taut %s: %s' % (words, line) for line in too_wide(said_to_terminal(words))]
if len(commands) < 8:
    failures.append('expected help to name the commands, found %s' % commands)
wide = subprocess.run([program, 'render', '--help-all'], env={**os.environ, 'COLUMNS': str(COLUMNS)}, capture_output=True,
                      text=True).stdout
failures += ['with COLUMNS = 40: ' + line for line in too_wide(wide)]

name = 'a_garment_with_a_name_that_is_longer_than_forty_columns.obj'
(folder / name).write_text('v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n')
importer = folder / 'slow_importer'
importer.write_text('#!/bin/sh\nsleep 2.5\nexec "%s" "$@"\n' % program)
importer.chmod(0o755)
progress = re.findall(r'\r\033\[K([^\r\n]+)(?=\r\033)', said_to_terminal('inspect ' + name, {'TAUT_IMPORTER': str(importer)}))
if not progress:
    failures.append('there is no progress')
failures += ['progress: ' + line for line in progress if len(line) >= COLUMNS]
print('\n'.join(failures))
sys.exit(1 if failures else 0)
