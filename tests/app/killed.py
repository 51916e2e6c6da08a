#!/usr/bin/env python3
"""A run that is ended by SIGTERM or SIGKILL at any moment leaves nothing half-written, and goes on from its checkpoint to
the bytes of a run that was not ended.   killed.py PROGRAM FOLDER [TIMES]"""
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / 'support'))
from statistics_files import records_without_times

program, folder = sys.argv[1], pathlib.Path(sys.argv[2])
TIMES = int(sys.argv[3]) if len(sys.argv) > 3 else 20
SCENE = ['pinned-9x9-5', '--set', 'solver.kind="bounded"', '--set', 'solver.substeps=0', '--set', 'wind.speed=5']
SHAPES = ['simulate', *SCENE, '--frames', ':600']
PICTURES = ['render', *SCENE, '--frames', '0:90', '--resolution', '64,64', '--samples', '1', '--set', 'picture.shadows=false']
# What is written, and whether a checkpoint lets it go on.
KINDS = {
    'shapes': (SHAPES + ['--export', 'shapes/{frame:03}.obj'], True),
    'pc2': (SHAPES + ['--export', 'clip.pc2'], True),
    'glb': (SHAPES + ['--export', 'clip.glb'], False),
    'usda': (SHAPES + ['--export', 'clip.usda'], False),
    'csv': (SHAPES + ['--stats', 'run.csv'], True),
    'jsonl': (SHAPES + ['--stats', 'run.jsonl'], True),
    'pictures': (PICTURES + ['--output', '{frame:03}.png'], False),
    'mp4': (PICTURES + ['--output', 'film.mp4'], False),
    'gif': (PICTURES + ['--output', 'film.gif'], False),
}


def outputs(into):
    found = {}
    for file in into.rglob('*'):
        if file.is_file() and file.suffix in ('.csv', '.jsonl'):
            found[str(file.relative_to(into))] = records_without_times(file)
        elif file.is_file() and 'checkpoint' not in file.name:
            found[str(file.relative_to(into))] = file.read_bytes()
    return found


def start(into, arguments):
    return subprocess.Popen([program, *arguments], cwd=into, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)


def begin(into, command, can_go_on):
    saved = into / 'run.checkpoint'
    if not can_go_on:
        return start(into, command)
    return start(into, [*command, *(['--resume', saved.name] if saved.exists() else ['--checkpoint', saved.name])])


def is_whole(name, content, whole):
    """Statistics are lines of frames so far; everything else is there as it will be, or not at all."""
    if name.endswith(('.csv', '.jsonl')):
        return content == whole[name][:len(content)]
    return content == whole[name]


def judge(kind, seed, whole, lasts_s, command, can_go_on):
    chance = random.Random('%s %d' % (kind, seed))
    into = folder / kind / str(seed)
    into.mkdir(parents=True)
    number = chance.choice([signal.SIGTERM, signal.SIGKILL])
    run = begin(into, command, can_go_on)
    time.sleep(chance.uniform(0.0, lasts_s))
    run.send_signal(number)
    said = run.communicate(timeout=120)[1]
    what = '%s, %s, seed %d: ' % (kind, number.name, seed)
    if run.returncode not in (0, 75, -number):
        return what + 'ended with %d: %s' % (run.returncode, said)
    left = outputs(into)
    unfinished = [name for name in left if name not in whole]
    # A killed program removes nothing, and names what is unfinished otherwise.
    if unfinished and number == signal.SIGTERM and not (can_go_on and run.returncode == 75):
        return what + 'left ' + ', '.join(unfinished)
    torn = [name for name in left if name in whole and not is_whole(name, left[name], whole)]
    if torn and not (kind in ('mp4', 'gif') and number == signal.SIGTERM):  # frames so far, in a film that plays
        return what + 'half-written: ' + ', '.join(torn)
    again = begin(into, command, can_go_on)
    said = again.communicate(timeout=120)[1]
    if again.returncode != 0:
        return what + 'does not go on, %d: %s' % (again.returncode, said)
    now = outputs(into)
    differs = [name for name in whole if now.get(name) != whole[name]]
    if differs:
        return what + 'differs in the end: ' + ', '.join(differs)
    shutil.rmtree(into)
    return None


faults = []
shutil.rmtree(folder, ignore_errors=True)
for kind, (command, can_go_on) in KINDS.items():
    if kind in ('mp4', 'gif') and not shutil.which('ffmpeg'):
        continue
    into = folder / kind / 'whole'
    into.mkdir(parents=True)
    began = time.monotonic()
    run = begin(into, command, can_go_on)
    said = run.communicate()[1]
    if run.returncode != 0:
        sys.exit('%s: ended with %d: %s' % (kind, run.returncode, said))
    lasts_s = time.monotonic() - began
    whole = outputs(into)
    found = [judge(kind, seed, whole, lasts_s, command, can_go_on) for seed in range(TIMES)]
    faults += [fault for fault in found if fault]
    print('%s: %d ends in %.1f s, %d faults' % (kind, TIMES, lasts_s, len([fault for fault in found if fault])), flush=True)
print('\n'.join(faults))
sys.exit(1 if faults else 0)
