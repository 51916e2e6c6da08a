#!/usr/bin/env python3
"""Tests what the program says of a run and of itself, and how much it writes.   said.py PROGRAM FOLDER"""
import csv
import json
import os
import pathlib
import re
import resource
import shutil
import signal
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / 'support'))
import expecting
from expecting import expect

program, folder = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2])

# Falls asleep within a few frames, for want of anything that moves it.
RESTING = ['pinned-9x9-5', '--set', 'gravity.acceleration=[0, 0, 0]', '--set', 'wind.speed=0']


def run(*arguments):
    done = subprocess.run([program, *arguments], cwd=folder, capture_output=True, text=True)
    expect(done.returncode == 0, '%s: exit code %d, %s' % (arguments, done.returncode, done.stderr))
    return done


def frame_lines(text):
    return [line for line in text.splitlines() if line.startswith('frame ')]


def says_sleep_once():
    said = run('simulate', *RESTING, '--frames', ':200').stdout
    asleep = [line for line in frame_lines(said) if 'asleep' in line]
    expect(len(asleep) == 1, '%d lines say that the cloth is asleep:\n%s' % (len(asleep), said))
    expect(frame_lines(said)[-1:] == asleep, 'lines go on after it fell asleep:\n' + said)
    expect('201 frames' in said and 'at rest since frame' in said, 'the summary lacks frames or the rest:\n' + said)


def prints_as_it_goes():
    """Fewer lines than fill a block, which is when a pipe would get them otherwise: all of them at the end."""
    process = subprocess.Popen([program, 'simulate', 'tshirt-gravity', '--frames', ':20'], cwd=folder,
                               stdout=subprocess.PIPE)
    first = os.read(process.stdout.fileno(), 65536).decode()
    process.communicate()
    expect('frame ' in first and 'largest stretch' not in first, 'what was read first is nothing or all:\n' + first)


def keeps_quiet():
    done = run('simulate', 'pinned-9x9-5', '--frames', ':5', '--quiet', '--stats', 'quiet.csv', '--export', 'quiet.obj')
    expect(done.stdout == '' and done.stderr == '', 'said with --quiet: %r %r' % (done.stdout, done.stderr))
    with open(folder / 'quiet.csv', newline='') as file:
        rows = list(csv.DictReader(file))
    expect([row['frame'] for row in rows] == ['0', '1', '2', '3', '4', '5'], 'rows of the table: %r' % rows)
    expect(all(float(row['max_stretch']) >= 0 for row in rows), 'a stretch in the table is no number')
    expect(all(float(row['max_surface_stretch']) >= float(row['max_stretch']) - 1e-9 for row in rows),
           'a triangle is stretched less than its edges')


def says_both_stretches():
    said = run('simulate', 'pinned-9x9-5', '--frames', ':5', '--stats', 'both.csv').stdout
    with open(folder / 'both.csv', newline='') as file:
        last = list(csv.DictReader(file))[-1]
    percent = {name: '%.4f' % (100 * float(last[name])) for name in last if name.endswith('_stretch')}
    line = re.search(r'^frame +5 .*max stretch +(\S+) %  p99 +(\S+) %  surface +(\S+) %  p99 +(\S+) %', said, re.M)
    names = ['max_stretch', 'p99_stretch', 'max_surface_stretch', 'p99_surface_stretch']
    expect(line and list(line.groups()) == [percent[name] for name in names], 'not the numbers of the table:\n' + said)
    end = re.search(r'at the end (\S+) %; of the surface .*at the end (\S+) %', said)
    expect(end and list(end.groups()) == [percent['max_stretch'], percent['max_surface_stretch']],
           'the summary ends otherwise than the table:\n' + said)


def speaks_json():
    done = run('simulate', 'pinned-9x9-5', '--frames', ':5', '--json', '--stats', 'run.jsonl')
    expect(done.stdout == (folder / 'run.jsonl').read_text(), 'standard output is not what --stats writes')
    expect(json.loads(done.stdout.splitlines()[-1])['summary']['frames'] == 6, 'not six frames')


def exports():
    run('simulate', 'pinned-9x9-5', '--frames', ':4', '--export', 'all/{frame}.obj')
    run('simulate', 'pinned-9x9-5', '--frames', ':4', '--export', 'one.obj')
    run('simulate', 'pinned-9x9-5', '--set', 'time.frames=4', '--export', 'default.obj')
    run('simulate', 'pinned-9x9-5', '--frames', '3', '--export', 'third.obj')
    said = run('simulate', 'pinned-9x9-5', '--set', 'time.frames=4', '--frames', 'last', '--export', 'last/{frame}.obj')
    expect(sorted(f.name for f in (folder / 'all').iterdir()) == ['%d.obj' % i for i in range(5)], 'not frames 0 to 4')
    expect([f.name for f in (folder / 'last').iterdir()] == ['4.obj'], 'not the last frame alone')
    expect(len(frame_lines(said.stdout)) == 1, 'more lines than the last:\n' + said.stdout)
    for name, frame in (('one', 4), ('default', 4), ('third', 3), ('last/4', 4)):
        expect((folder / (name + '.obj')).read_bytes() == (folder / ('all/%d.obj' % frame)).read_bytes(),
               '%s.obj is not frame %d' % (name, frame))


def processor_time_of_children_ms():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return 1e3 * (used.ru_utime + used.ru_stime)


def measures_processor_time():
    """Made to wait, as by whoever else wants the processor, a run has not cost more."""
    before_ms = processor_time_of_children_ms()
    process = subprocess.Popen([program, 'simulate', 'tshirt-gravity', '--frames', '40', '--stats', 'times.jsonl'],
                               cwd=folder, stdout=subprocess.PIPE, text=True)
    waits = 0
    while process.poll() is None and waits < 5:
        time.sleep(0.1)
        process.send_signal(signal.SIGSTOP)
        time.sleep(0.4)
        process.send_signal(signal.SIGCONT)
        waits += 1
    process.communicate()
    used_ms = processor_time_of_children_ms() - before_ms
    expect(process.returncode == 0 and waits > 0, 'simulate ended with %d' % process.returncode)
    said_ms = json.loads((folder / 'times.jsonl').read_text().splitlines()[-1])['summary']['total_sim_ms']
    expect(0 < said_ms <= used_ms, 'sim_ms adds up to %g ms, of %g ms that the processor spent' % (said_ms, used_ms))


def names_the_scene_of_a_missing_garment():
    (folder / 'lost.toml').write_text('title = "Lost"\n[garment]\nfile = "nowhere.obj"\n')
    done = subprocess.run([program, 'simulate', 'lost.toml'], cwd=folder, capture_output=True, text=True)
    expect(done.returncode == 1 and "lost.toml:3: garment.file: there is no file 'nowhere.obj'" in done.stderr,
           'a garment that is missing: %d %s' % (done.returncode, done.stderr))


# A triangle above one that is held: as if there were no contact, it falls through it on its edge.
FALLS_THROUGH = ('v -1 0 -1\nv 1 0 -1\nv 0 0 1\nv 0 .05 0\nv .2 .25 0\nv -.2 .25 0\nf 1 2 3\nf 4 5 6\n',
                 ['--set', 'garment.mesh=model', '--set', 'garment.weld=1e-6', '--set', 'garment.scale=1', '--set', 'garment.up=y', '--set', 'pins.at=[0, 1, 2]',
                  '--set', 'solver.kind=ideal', '--set', 'solver.substeps=10'])
PAIR = r'1 pair of triangles crosses, the first: triangle 0 \(vertices 0, 1, 2\) and triangle 1 \(vertices 3, 4, 5\) at \[.*\] m'


def ends_where_a_frame_crosses():
    model, keys = FALLS_THROUGH
    (folder / 'falls.obj').write_text(model)
    run('simulate', 'falls.obj', *keys, '--frames', ':9', '--export', 'fall/{frame}.obj')
    lowest = [min(float(line.split()[2]) for line in (folder / ('fall/%d.obj' % i)).read_text().splitlines()
                  if line.startswith('v ')) for i in range(10)]
    first = min(i for i in range(10) if lowest[i] < 0)
    said = r'^taut: error: frame %d, 0\.\d+ s: %s$' % (first, PAIR)
    for command in (['simulate', '--export'], ['render', '--resolution', '64,64', '--output']):
        ending = '{frame}.obj' if command[0] == 'simulate' else '{frame}.png'
        done = subprocess.run([program, command[0], 'falls.obj', *keys, '--frames', ':9', '--verify', '--stats',
                               'falls.csv', *command[1:], command[0] + '/' + ending],
                              cwd=folder, capture_output=True, text=True)
        expect(done.returncode == 3 and re.search(said, done.stderr, re.M), '%s: %d %s' % (command, done.returncode, done.stderr))
        written = sorted(int(file.stem) for file in (folder / command[0]).iterdir())
        expect(written == list(range(first)), '%s wrote the frames %s, of which %d crosses' % (command, written, first))
        with open(folder / 'falls.csv', newline='') as file:
            counts = [row['crossing_pairs'] for row in csv.DictReader(file)]
        expect(counts == ['0'] * first + ['1'], 'counts in the table: %s' % counts)
    said = run('simulate', 'falls.obj', *keys, '--frames', ':%d' % (first - 1), '--verify').stdout
    expect('verified %d frames: 0 crossing pairs, largest stretch 0.0000 %%' % first in said, 'no summary:\n' + said)
    expect('crossing_pairs' not in run('simulate', 'falls.obj', *keys, '--frames', ':1', '--json').stdout,
           'counted although nobody asked')


def names_what_crosses_at_the_start():
    model, keys = FALLS_THROUGH
    (folder / 'crosses.obj').write_text(model.replace('.05', '-.05'))
    said = r'^crosses.obj: at the start %s; --untangle parts what it can$' % PAIR
    for command in (['simulate'], ['render', '--resolution', '64,64', '--output', 'crosses.png']):
        done = run(command[0], 'crosses.obj', *keys, '--frames', '1', *command[1:])
        expect(re.search(said, done.stdout, re.M), '%s: %s' % (command, done.stdout))
    expect(re.search('^at the start ' + PAIR, run('view', '--headless', 'crosses.obj', *keys).stdout, re.M), 'not in the window')
    expect(re.search('^crossings +pairs 1, .* said ' + PAIR, run('inspect', 'crosses.obj', *keys).stdout, re.M), 'not inspected')
    found = json.loads(run('inspect', 'crosses.obj', *keys, '--json').stdout)['crossings']
    expect(found['pairs'] == 1 and found['first']['triangles'] == [0, 1], 'as JSON: %s' % found)
    expect(abs(found['first']['place_m'][1]) < 1e-9, 'the place is not on the lower triangle: %s' % found)
    inspected = run('inspect', 'crosses.obj', *keys, '--untangle').stdout
    expect(re.search('^crossings +pairs 0, said none$', inspected, re.M), 'still crosses: ' + inspected)
    expect(re.search('^untangling .* said of 1 pair of triangles that crossed at the start 0 are left', inspected, re.M), inspected)
    parted = json.loads(run('inspect', 'crosses.obj', *keys, '--untangle', '--json').stdout)
    expect(parted['crossings']['pairs'] == 0 and parted['untangling']['pairs_before'] == 1, 'as JSON: %s' % parted['untangling'])
    done = run('simulate', 'crosses.obj', *keys, '--untangle', '--frames', '1')
    expect('crosses.obj: of 1 pair of triangles' in done.stdout and 'at the start 1 pair' not in done.stdout, done.stdout)
    done = subprocess.run([program, 'simulate', 'crosses.obj', *keys, '--verify'], cwd=folder, capture_output=True, text=True)
    expect(done.returncode == 0 and '0 crossing pairs outside what crosses since the start: 1 pairs then, 0 at the end' in done.stdout,
           'the pair that crosses at the start counts: ' + done.stderr + done.stdout)


def ribbons():
    """Returns an OBJ of two sheets that ribbons join. These are too narrow to be simulated, so that one sheet falls."""
    places, faces = [], []

    def grid(left, low, width, height, columns, rows):
        first = len(places) + 1
        places.extend((left + width * x / columns, low + height * y / rows)
                      for y in range(rows + 1) for x in range(columns + 1))
        faces.extend((first + y * (columns + 1) + x, first + y * (columns + 1) + x + 1,
                      first + (y + 1) * (columns + 1) + x + 1, first + (y + 1) * (columns + 1) + x)
                     for y in range(rows) for x in range(columns))

    grid(-.2, 1.2, .4, .2, 20, 10)
    grid(-.2, .85, .4, .3, 20, 15)
    for ribbon in range(12):
        grid(-.19 + .03 * ribbon, 1.15, .001, .05, 1, 20)
    return ''.join('v %.4f %.4f 0\n' % place for place in places) + ''.join('f %d %d %d %d\n' % face for face in faces)


def shows_what_is_simulated_if_the_model_tears():
    (folder / 'ribbons.obj').write_text(ribbons())
    keys = ['ribbons.obj', '--set', 'garment.mesh=fitted', '--set', 'garment.triangles=1500', '--set', 'garment.scale=1',
            '--set', 'garment.up=y', '--set', 'pins.at=[210, 230]', '--frames', ':24']
    reason = r'the model that follows is stretched by [\d.]+ % in the 99th percentile, more than 50 %'
    alone = run('simulate', *keys)
    expect('begins again' not in alone.stderr and 'the model that follows it is stretched' in alone.stdout, alone.stdout)
    for command in (['simulate', '--quiet', '--export'], ['simulate', '--export'],
                    ['render', '--resolution', '64,64', '--output', 'torn/{frame}.png', '--export']):
        done = run(command[0], *keys, *command[1:], 'torn/{frame}.obj')
        expect(re.search('^taut: %s: begins again' % reason, done.stderr, re.M), '%s: %s' % (command, done.stderr))
        told = re.search('^%s: the simulated mesh is shown instead' % reason, done.stdout, re.M)
        expect(bool(told) != ('--quiet' in command), '%s: %s' % (command, done.stdout))
        expect(len(frame_lines(done.stdout)) == len(set(frame_lines(done.stdout))), 'lines are repeated: ' + done.stdout)
        counts = {sum(line.startswith('v ') for line in (folder / ('torn/%d.obj' % frame)).read_text().splitlines())
                  for frame in range(25)}
        if command[0] == 'render':
            expect(len(list((folder / 'torn').glob('*.png'))) == 25, 'not 25 pictures')
        expect(len(counts) == 1 and counts != {ribbons().count('v ')}, '%s: counts of vertices: %s' % (command, counts))
        shutil.rmtree(folder / 'torn')
    lines = run('simulate', *keys, '--json', '--export', 'torn.pc2').stdout.splitlines()
    frames = [json.loads(line)['frame'] for line in lines[1:-1]]
    expect(frames == list(range(25)), 'frames as JSON: %s' % frames)
    kept = run('simulate', *keys, '--checkpoint', 'torn.state', '--export', 'kept.pc2')
    expect('the model that follows it is stretched' in kept.stdout, 'what can be resumed began again: ' + kept.stdout)


def untold(said):
    """The options of a help text of which it says nothing, beside them or on the line below."""
    lines = said.splitlines()
    return [line for line, below in zip(lines, lines[1:] + [''])
            if line.startswith('  -') and not (re.match(r'.{28}  \S', line) or below.startswith(30 * ' '))]


def helps():
    overview = run('help').stdout
    expect(overview == run('--help').stdout and 'simulate' in overview, 'taut help is not taut --help')
    for command in ('figures', 'render', 'simulate', 'view', 'inspect', 'bench', 'scenes', 'help'):
        expect(re.search('^  %s ' % command, overview, re.M), 'taut help does not list ' + command)
        expect(run('help', command).stdout == run(command, '--help-all').stdout,
               'taut help %s is not taut %s --help-all' % (command, command))
    for command in re.findall('^  ([a-z]+) ', overview.partition('Examples:')[0], re.M):
        without = untold(run('help', command).stdout)
        expect(not without, 'taut help %s says nothing of %s' % (command, without))
    for command in ('render', 'simulate'):
        said = ' '.join(run('help', command).stdout.split())
        expect('A:B, A: to the last, :B from 0, last, or a number: that frame alone' in said, '%s does not explain --frames' % command)


shutil.rmtree(folder, ignore_errors=True)
folder.mkdir(parents=True)
for check in (says_sleep_once, prints_as_it_goes, keeps_quiet, says_both_stretches, speaks_json, exports,
              measures_processor_time, ends_where_a_frame_crosses,
              names_what_crosses_at_the_start, names_the_scene_of_a_missing_garment,
              shows_what_is_simulated_if_the_model_tears, helps):
    before = expecting.failures
    try:
        check()
    except Exception as error:  # the other checks are made all the same
        expect(False, repr(error))
    if expecting.failures > before:
        print('^ %s' % check.__name__)
expecting.end()
