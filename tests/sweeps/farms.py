#!/usr/bin/env python3
"""A study handed to a farm by the script in app/sweeps/README.md, and run by the farm's own program.
farms.py PROGRAM FOLDER parallel|snakemake README"""
import csv
import os
import pathlib
import re
import shutil
import subprocess
import sys

program, farm = os.path.abspath(sys.argv[1]), sys.argv[3]
folder = pathlib.Path(sys.argv[2]).resolve() / "it's {a} study"
SCENE = '''
[garment.grid]
columns = 4
rows = 4
width = 0.3
height = 0.3
[pins]
at = ["top-left"]
[[pins.moving]]
at = ["top-right"]
shift = { velocity = [0.4, 0.0, 0.0], until = 0.2 }
[solver]
kind = "bounded"
max_substeps = 20
'''
# The tighter bound cannot be kept.
STUDY = '''
scene = "scene.toml"
frames = 20
[axes]
solver.max_stretch = [0.6, 0.05]
wind.speed = [0, 3]
'''


def run(*command, where='.'):
    done = subprocess.run(command, cwd=folder / where, env={**os.environ, 'PATH': '%s:%s' % (folder, os.environ['PATH'])},
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode:
        sys.exit('%s ended with %d:\n%s' % (command, done.returncode, done.stdout))
    return done.stdout


def results():
    return {file: file.stat().st_mtime_ns for file in folder.glob('sweep/runs/*.json')}


if not shutil.which(farm):
    print('SKIPPED: no %s; setup.sh --farms installs it' % farm)
    sys.exit(77)
shutil.rmtree(folder, ignore_errors=True)
folder.mkdir(parents=True)
(folder / 'scene.toml').write_text(SCENE)
(folder / 'study.toml').write_text(STUDY)
run(program, 'sweep', 'plan', 'study.toml', '-o', 'sweep')
(folder / 'taut').symlink_to(program)
language = 'sh' if farm == 'parallel' else 'python'
script = re.search('```%s\n((?!#!).*?)```' % language, pathlib.Path(sys.argv[4]).read_text(), re.DOTALL).group(1)
(folder / 'sweep/farm').write_text(script)
command = ['bash', 'farm', '--jobs', '2'] if farm == 'parallel' else ['snakemake', '--snakefile', 'farm', '--cores', '2']
said = run(*command, where='sweep')
first = results()
status = run(program, 'sweep', 'status', 'sweep')
with open(folder / 'sweep/table.csv', newline='') as file:
    ends = [row['end'] for row in csv.DictReader(file)]
if len(first) != 4 or ends != ['done', 'done', 'broken', 'broken'] or run(
        program, 'sweep', 'status', 'sweep', '--missing') != '\n':
    sys.exit('not all was run: %s\n%s\n%s' % (ends, status, said))
run(*command, where='sweep')
if results() != first:
    sys.exit('what was there was run again')
