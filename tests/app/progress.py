#!/usr/bin/env python3
"""A terminal is told what takes long while a model is read; a pipe is told after ten seconds.   progress.py PROGRAM FOLDER"""
import os
import pathlib
import pty
import re
import shutil
import subprocess
import sys

program, folder = sys.argv[1], pathlib.Path(sys.argv[2])


def said_to_terminal(command):
    terminal, end = pty.openpty()
    process = subprocess.Popen(command, cwd=folder, stdout=end, stderr=end, stdin=subprocess.DEVNULL)
    os.close(end)
    said = b''
    while True:
        try:
            part = os.read(terminal, 65536)
        except OSError:  # the other end is closed
            break
        if not part:
            break
        said += part
    os.close(terminal)
    return process.wait(), said.decode(errors='replace')


def said_to_pipe(command):
    done = subprocess.run(command, cwd=folder, capture_output=True)
    return done.returncode, (done.stdout + done.stderr).decode(errors='replace')


shutil.rmtree(folder, ignore_errors=True)
folder.mkdir(parents=True)
(folder / 'triangle.obj').write_text('v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n')
importer = folder / 'slow_importer'
importer.write_text('#!/bin/sh\nsleep ${SLEEP_S:-2.5}\nexec "%s" "$@"\n' % program)
importer.chmod(0o755)
os.environ['TAUT_IMPORTER'] = str(importer)

failures = 0
for words in ('inspect triangle.obj', 'simulate triangle.obj --frames 2',
              'render triangle.obj --frames 2 --resolution 64,64 --output triangle.png'):
    for where, run, wanted in (('a terminal', said_to_terminal, True), ('a pipe', said_to_pipe, False)):
        code, said = run([program, *words.split()])
        tells = re.search(r'reading triangle\.obj \(\d+ s\)', said) is not None
        if code != 0 or tells != wanted or ('\r\033' in said) != wanted:
            failures += 1
            print('taut %s, to %s: exit code %d, %r' % (words, where, code, said))
os.environ['SLEEP_S'] = '11'
code, said = said_to_pipe([program, 'inspect', 'triangle.obj'])
if code != 0 or len(re.findall(r'(?m)^.*reading triangle\.obj \((9|1\d) s\)$', said)) != 1:
    failures += 1
    print('taut inspect triangle.obj, to a pipe: exit code %d, %r' % (code, said))
sys.exit(1 if failures else 0)
