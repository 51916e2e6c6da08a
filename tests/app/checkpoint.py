#!/usr/bin/env python3
"""A run that is stopped and resumed leaves what the run that was not stopped leaves.   checkpoint.py PROGRAM FOLDER"""
import pathlib
import shutil
import signal
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / 'support'))
import expecting
from expecting import expect
from statistics_files import records_without_times

program = sys.argv[1]
folder = pathlib.Path(sys.argv[2])
FRAMES = 240
SCENE = ['pinned-9x9-5', '--set', 'solver.kind="bounded"', '--set', 'solver.substeps=0', '--set', 'solver.max_stretch=0.002', '--set', 'wind.speed=5',
         '--set', 'wind.gust_amplitude=0.5', '--frames', ':%d' % FRAMES]


def simulate(name, *arguments, scene=SCENE):
    into = folder / name
    into.mkdir(exist_ok=True)
    command = [program, 'simulate', *scene, '--export', 'shapes/{frame:03}.obj', *arguments]
    return subprocess.Popen(command, cwd=into, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def done(process, code):
    out, err = process.communicate()
    expect(process.returncode == code, 'ended with %d, expected %d: %s' % (process.returncode, code, err))
    return err


def records(name):
    return records_without_times(folder / name / 'run.jsonl')


def shapes(name):
    return {file.name: file.read_bytes() for file in (folder / name / 'shapes').glob('*.obj')}


def wait_for_frame(name, frame):
    """Until the run has come so far, and not to its end."""
    last = folder / name / 'shapes' / ('%03d.obj' % frame)
    for _ in range(3000):
        if last.exists():
            return
        time.sleep(0.005)
    raise RuntimeError('%s: frame %d did not come' % (name, frame))


def expect_whole(name):
    expect(records(name) == records('whole'), name + ': the statistics differ')
    expect(shapes(name) == shapes('whole'), name + ': the shapes differ')


def terminated():
    """SIGTERM twice, and on from there each time."""
    arguments = ('--stats', 'run.jsonl', '--checkpoint', 'run.checkpoint')
    for number, frame in ((signal.SIGTERM, 20), (signal.SIGINT, 90)):
        run = simulate('terminated', *arguments)
        wait_for_frame('terminated', frame)
        run.send_signal(number)
        err = done(run, 75)
        expect("saved in 'run.checkpoint': the same command with --resume run.checkpoint goes on" in err,
               'no word of how to resume: ' + err)
        stopped = records('terminated')
        expect('frame' in stopped[-1] and frame <= stopped[-1]['frame'] < FRAMES, 'stopped at %r' % stopped[-1])
        arguments = ('--stats', 'run.jsonl', '--resume', 'run.checkpoint')
    done(simulate('terminated', *arguments), 0)
    expect_whole('terminated')
    expect(not list((folder / 'terminated').rglob('*.part*')), 'something unfinished is left')
    done(simulate('terminated', *arguments), 0)  # of a run at its end nothing is left to do
    expect_whole('terminated')


def handles_term(pid):
    """Whether the process has a handler of SIGTERM, from the kernel's mask of caught signals."""
    status = pathlib.Path('/proc/%d/status' % pid).read_text()
    caught = int(status.split('SigCgt:')[1].split()[0], 16)
    return caught >> (signal.SIGTERM - 1) & 1


def stopped_before_its_first_frame():
    """By a signal that comes as soon as it is heeded: the run that goes on leaves out nothing."""
    run = simulate('begun', '--stats', 'run.jsonl', '--checkpoint', 'run.checkpoint')
    while not handles_term(run.pid):
        time.sleep(0.001)
    run.send_signal(signal.SIGTERM)
    err = done(run, 75)
    expect('stopped after frame 0,' in err and not shapes('begun'), 'stopped later: %d %s' % (run.returncode, err))
    done(simulate('begun', '--stats', 'run.jsonl', '--resume', 'run.checkpoint'), 0)
    expect_whole('begun')


def killed():
    """Without a word, and on from what was saved last; the table is cut back to it."""
    run = simulate('killed', '--stats', 'run.jsonl', '--checkpoint', 'run.checkpoint', '--checkpoint-every', '25')
    wait_for_frame('killed', 61)
    run.kill()
    run.communicate()
    done(simulate('killed', '--stats', 'run.jsonl', '--resume', 'run.checkpoint'), 0)
    expect_whole('killed')


def refused():
    """Of another scene, of another program's file, of a file that was cut off."""
    def refusal(file, scene=SCENE):
        return done(simulate('refused', '--resume', file, scene=scene), 1)
    done(simulate('refused', '--checkpoint', 'run.checkpoint', scene=SCENE[:-1] + [':3']), 0)
    err = refusal('run.checkpoint', SCENE + ['--set', 'wind.speed=6'])
    expect("'pinned-9x9-5', which has wind.speed = 5.0; found the scene 'pinned-9x9-5' with wind.speed = 6.0" in err,
           'another wind: ' + err)
    whole = (folder / 'refused' / 'run.checkpoint').read_bytes()
    (folder / 'refused' / 'cut').write_bytes(whole[:len(whole) // 2])
    expect("cannot go on from 'cut': byte " in refusal('cut'), 'a file that was cut off')
    (folder / 'refused' / 'damaged').write_bytes(whole[:-40] + b'x' + whole[-39:])
    expect('the hash of all bytes before' in refusal('damaged'), 'a damaged file')
    (folder / 'refused' / 'foreign').write_text('Buy milk, and bread.\n')
    expect("found 'Buy milk', expected" in refusal('foreign'), 'a foreign file')
    expect('there is no file' in refusal('none'), 'a file that is not there')
    shutil.copy(folder / 'whole' / 'run.jsonl', folder / 'refused' / 'short.jsonl')
    lines = (folder / 'refused' / 'short.jsonl').read_text().splitlines(True)
    (folder / 'refused' / 'short.jsonl').write_text(''.join(lines[:2]))
    err = done(simulate('refused', '--resume', 'run.checkpoint', '--stats', 'short.jsonl'), 1)
    expect("cannot go on with 'short.jsonl': it has no line of frame 3" in err, 'another table: ' + err)


shutil.rmtree(folder, ignore_errors=True)
folder.mkdir(parents=True)
done(simulate('whole', '--stats', 'run.jsonl'), 0)
for check in (terminated, stopped_before_its_first_frame, killed, refused):
    try:
        check()
    except Exception as error:  # the other checks are made all the same
        expect(False, '%s: %r' % (check.__name__, error))
expecting.end()
