"""A study is made by Snakemake: all runs, none twice, on from where one was stopped, and a table of them.
run_study.py TAUT SNAKEFILE FOLDER"""
import csv
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time

taut, snakefile, folder = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
folder /= "it's a study"
SCENE = '''
garment.file = "sheet.obj"
pins.at = [0]
pins.moving = [{ at = [1], shift = { velocity = [0.4, 0.0, 0.0], until = 0.2 } }]
'''
SHEET = 'v 0 0 0\nv 0.3 0 0\nv 0.3 0.3 0\nv 0 0.3 0\nf 1 2 3\nf 1 3 4\n'
STUDY = '''
scene = "scene.toml"
frames = 20
[axes]
"solver.max_stretch" = [0.6, 0.05]  # the second cannot be kept
wind.speed = [0, 3]
solver.kind = ["bounded"]
forces = [[{ vertex = 2, force = [0, -0.0001, 0] }]]
'''
LONG = 'scene = "pinned-9x9-5"\nframes = 9000\n[axes]\nrest.speed = [0]\nwind.speed = [3]\n'


def expect(is_so, otherwise):
    if not is_so:
        sys.exit(otherwise)


def start(study):
    command = ['snakemake', '--snakefile', snakefile, '--cores', '2', '--config', 'study=' + study, f'taut={taut}']
    streams = {'stdout': subprocess.PIPE, 'stderr': subprocess.STDOUT, 'text': True}
    return subprocess.Popen(command, cwd=folder, start_new_session=True, **streams)


def make(study='study.toml', code=0):
    said = (process := start(study)).communicate()[0]
    expect(process.returncode == code, f'{study}: ended with {process.returncode}, expected {code}:\n{said}')
    return said


def results(study='study'):
    return {file: file.stat().st_mtime_ns for file in folder.glob(study + '/*/result.json')}


def read_table(study):
    return list(csv.DictReader((folder / study / 'table.csv').open()))


def check_table():
    rows = read_table('study')
    found = [(row['solver.max_stretch'], row['wind.speed'], row['end'], row['vertices']) for row in rows]
    wanted = [(bound, wind, end, '4') for bound, end in (('0.6', 'done'), ('0.05', 'broken')) for wind in '03']
    expect(found == wanted, f'expected the rows {wanted}, found {found}')
    expect(rows[0]['frames'] == '20' and 0.05 < float(rows[0]['max_stretch']) < 0.6, f'measured: {rows[0]}')
    expect('would cross' in rows[2]['reason'] and 0 < int(rows[2]['frames']) < 20, f'blocked: {rows[2]}')
    expect((folder / 'study' / rows[2]['run'] / 'blocked-1.png').exists(), 'no picture of what blocks a run')


def check_repeats():
    first = results()
    expect('Nothing to be done' in make() and results() == first, 'runs that are there were made again')
    (deleted := next(iter(first))).unlink()
    make()
    again = {file for file, time_ns in results().items() if time_ns != first.get(file)}
    expect(again == {deleted}, f'expected that {deleted} alone is made again, found {again}')
    (folder / 'sheet.obj').write_text(SHEET.replace('0.3', '0.4'))
    make()
    expect(len(results()) == 8, 'a scene whose model has changed is not made again')


def check_stop():
    process = start('long.toml')
    while not list(folder.glob('long/*/checkpoint')) and process.poll() is None:
        time.sleep(0.01)
    os.killpg(process.pid, signal.SIGINT)
    expect('exit code 75' in process.communicate()[0] and not results('long'), 'it was not stopped')
    frames = next(folder.glob('long/*/frames.jsonl'))
    frames.write_text(frames.read_text().replace('pinned', 'PINNED', 1))
    make('long.toml')
    is_resumed, is_saved = 'PINNED' in frames.read_text(), (frames.parent / 'checkpoint').exists()
    expect(is_resumed and not is_saved, f'is resumed: {is_resumed}, still has a checkpoint: {is_saved}')
    sets = 'pinned-9x9-5 --json --set rest.speed=0 --set wind.speed=3 --set time.frames=9000'.split()
    alone = subprocess.run([taut, 'simulate', *sets], capture_output=True, text=True).stdout
    hashes = [read_table('long')[0]['state_hash'], json.loads(alone.splitlines()[-2])['state_hash']]
    expect(hashes[0] == hashes[1], f'a run that was stopped ends otherwise: {hashes}')


def check_refusals():
    for key, value in (('wind.sped', '[1]'), ('wind.seed', '1')):
        (folder / 'wrong.toml').write_text(f'{STUDY}{key} = {value}')
        said = make('wrong.toml', code=1)
        expect(f'wrong.toml: {key}: ' in said and not (folder / 'wrong').exists(), f'expected {key} and file: {said}')


if not shutil.which('snakemake'):
    print('SKIPPED: no snakemake; setup.sh --sweeps installs it')
    sys.exit(77)
shutil.rmtree(folder, ignore_errors=True)
folder.mkdir(parents=True)
for name, text in {'scene.toml': SCENE, 'sheet.obj': SHEET, 'study.toml': STUDY, 'long.toml': LONG}.items():
    (folder / name).write_text(text)
make()
check_table()
check_repeats()
check_stop()
check_refusals()
