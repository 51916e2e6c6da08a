#!/usr/bin/env python3
"""taut sweep as a person uses it on one machine.   sweep.py PROGRAM FOLDER"""
import csv
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time

program, folder = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()
failures = 0
STUDY = '''
scene = "pinned-9x9-5"
frames = 2000
[axes]
solver.kind = ["bounded"]
rest.speed = [0]
wind.gust_amplitude = [0.5]
wind.speed = [1, 2, 3, 4, 5, 6]
'''


def expect(is_so, otherwise):
    global failures
    if not is_so:
        failures += 1
        print(otherwise)


def sweep(*arguments, code=0, **how):
    done = subprocess.run([program, 'sweep', *arguments], cwd=folder, capture_output=True, text=True, **how)
    expect(done.returncode == code, '%s ended with %d, expected %d: %s' % (arguments, done.returncode, code, done.stderr))
    return done.stdout + done.stderr


def start(*arguments):
    return subprocess.Popen([program, 'sweep', *arguments], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)


def rows(name):
    sweep('merge', name)
    with open(folder / name / 'table.csv', newline='') as file:
        return [{key: row[key] for key in ('index', 'end', 'wind.speed', 'frames', 'max_stretch', 'state_hash')}
                for row in csv.DictReader(file)]


def stops_and_goes_on():
    stopped = start('run', 'stopped', '--all', '--jobs', '2')
    for _ in range(1000):
        if list((folder / 'stopped').rglob('*.checkpoint')):
            break
        time.sleep(0.01)
    stopped.send_signal(signal.SIGTERM)
    stopped.communicate()
    expect(stopped.returncode == 75, 'SIGTERM ended it with %d' % stopped.returncode)
    expect(list((folder / 'stopped').rglob('*.checkpoint')), 'nothing was saved')
    killed = start('run', 'stopped', '--index', '5')
    time.sleep(0.3)
    killed.kill()
    killed.communicate()
    sweep('run', 'stopped', '--all', '--jobs', '2')


def two_at_once():
    both = [start('run', 'twice', '--all', '--jobs', '2') for _ in range(2)]
    for process in both:
        process.communicate()
        expect(process.returncode == 0, 'one of two ended with %d' % process.returncode)
    sweep('run', 'twice', '--all')


def one_by_one():
    for index in range(6):
        sweep('run', 'one', '--index', str(index))
    expect(sweep('status', 'one', '--missing') == '\n', 'a run was left out')
    # As a machine leaves it whose power fails.
    (folder / 'one/runs/000002.json').write_text('{"index": 2')
    expect(sweep('status', 'one', '--missing') == '2\n', 'what is missing is not said')
    expect('expected one of --index and --all' in sweep('run', 'one', code=2), 'it does not ask which runs')
    sweep('run', 'one', '--all')


shutil.rmtree(folder, ignore_errors=True)
folder.mkdir(parents=True)
(folder / 'study.toml').write_text(STUDY)
for name in ('stopped', 'twice', 'one'):
    sweep('plan', 'study.toml', '-o', name)
stops_and_goes_on()
two_at_once()
one_by_one()
expect(rows('stopped') == rows('twice') == rows('one'), 'the same runs differ')
expect([row['end'] for row in rows('twice')] == ['done'] * 6, 'not all are done: %s' % rows('twice'))
shown = subprocess.run([program, 'simulate', 'twice/runs/000003.toml', '--json'], cwd=folder, capture_output=True, text=True)
expect(json.loads(shown.stdout.splitlines()[-2])['state_hash'] == rows('twice')[3]['state_hash'],
       'the scene of a run is not what is simulated')
sys.exit(1 if failures else 0)
