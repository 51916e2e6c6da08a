#!/usr/bin/env python3
"""Tests a run that cannot go on without a crossing, and what --verify leaves out.   blocked.py PROGRAM FOLDER SCENE"""
import json
import pathlib
import re
import shutil
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / 'support'))
import expecting
from expecting import expect

program, scene = sys.argv[1], sys.argv[3]
folder = pathlib.Path(sys.argv[2])


def run(code, *arguments):
    done = subprocess.run([program, *arguments], cwd=folder, capture_output=True, text=True)
    expect(done.returncode == code, '%s ended with %d, expected %d: %s' % (arguments, done.returncode, code, done.stderr))
    return done.stdout, done.stderr


def files(under):
    return sorted(file.name for file in (folder / under).glob('*'))


def size_of(picture):
    head = (folder / picture).read_bytes()[:24]
    expect(head.startswith(b'\x89PNG'), '%s is no picture' % picture)
    return int.from_bytes(head[16:20], 'big'), int.from_bytes(head[20:24], 'big')


def blocked_frame(said, picture):
    """The frame that a message names, which has to name all else as well."""
    found = re.fullmatch(r"taut: error: frame (\d+): something would cross at 0\.2\d* s: the body '(left|right)' closes in on the "
                         r"triangle of the vertices \d+, \d+, \d+, which the body '(left|right)' keeps from giving way; they are "
                         r"[\d.]+ mm apart at \[[-\d., ]+\] m; '(.*)' shows where, in the frame before; "
                         r'solver.allow_exceeding = "contact" goes on all the same\n', said)
    expect(found is not None, 'said: ' + said)
    expect(found is None or found[4] == picture, 'names %s, expected %s' % (found and found[4], picture))
    return int(found[1]) if found else 0


shutil.rmtree(folder, ignore_errors=True)
folder.mkdir(parents=True)

# Nothing of the frame is written, and the picture takes the place of nothing.
frame = blocked_frame(run(3, 'simulate', scene, '--quiet', '--stats', 'run.jsonl', '--export', 'shapes/{frame:02}.obj')[1],
                      'shapes/blocked-1.png')
lines = [json.loads(line) for line in (folder / 'run.jsonl').read_text().splitlines()]
expect([line['frame'] for line in lines[1:]] == list(range(1, frame)), 'the statistics go on: %s' % lines[-1])
expect(files('shapes') == ['%02d.obj' % n for n in range(1, frame)] + ['blocked-1.png'], 'shapes: %s' % files('shapes'))
blocked_frame(run(3, 'simulate', scene, '--quiet')[1], 'blocked-1.png')
taken = (folder / 'blocked-1.png').read_bytes()
blocked_frame(run(3, 'simulate', scene, '--quiet')[1], 'blocked-2.png')
expect((folder / 'blocked-1.png').read_bytes() == taken, 'blocked-1.png was written over')
blocked_frame(run(3, 'render', scene, '--resolution', '160,120', '--frames', ':40', '--output', 'frames/{frame}.png')[1],
              'frames/blocked-1.png')
expect(set(files('frames')) == {'%d.png' % n for n in range(frame)} | {'blocked-1.png'}, 'frames: %s' % files('frames'))
if shutil.which('ffmpeg'):
    out, err = run(3, 'render', scene, '--resolution', '160,120', '--frames', ':40', '--output', 'film/run.mp4')
    blocked_frame(err, 'blocked-3.png')
    expect('wrote film/run.mp4, %d frames\n' % frame in out, 'said of the video: ' + out)
    expect(files('film') == ['run.mp4'], 'film: %s' % files('film'))
    counted = subprocess.run(['ffprobe', '-v', 'error', '-count_frames', '-show_entries', 'stream=nb_read_frames', '-of', 'csv=p=0',
                              str(folder / 'film/run.mp4')], capture_output=True, text=True).stdout.strip()
    expect(counted == str(frame), 'the video has %s frames, expected %d' % (counted, frame))
width, height = size_of('frames/blocked-1.png')
expect(width == 320 and height > 120, 'the picture has %d x %d pixels' % (width, height))
out, warned = run(0, 'simulate', scene, '--quiet', '--set', 'solver.allow_exceeding=contact')
expect('frames pins or bodies closed in so that something may cross, first in frame %d' % frame in warned, 'warned: ' + warned)

# A sheet whose upper edge is in a level one falls out of it.
vertices, faces = [], []


def add_sheet(count, place):
    first = len(vertices) + 1
    vertices.extend(place(i / (count - 1) - 0.5, j / (count - 1) - 0.5) for j in range(count) for i in range(count))
    for j in range(count - 1):
        for i in range(count - 1):
            a = first + j * count + i
            faces.append((a, a + 1, a + count + 1, a + count))


def write_model(name):
    lines = ['v %f %f %f' % v for v in vertices] + ['f %d %d %d %d' % f for f in faces]
    (folder / name).write_text('\n'.join(lines) + '\n')


add_sheet(9, lambda u, v: (0.4 * u, 0.0, 0.4 * v))
add_sheet(5, lambda u, v: (0.013 + 0.1 * u, 0.1 * v - 0.045, 0.007))
write_model('through.obj')
flags = ['--units', 'm', '--up', 'y', '--set', 'garment.mesh=model', '--set', 'garment.weld=1e-6', '--set', 'pins.at=[%s]' % ', '.join(map(str, range(81)))]
through = ['through.obj', *flags, '--verify', '--set', 'solver.contact=true']
out, _ = run(0, 'simulate', *through, '--frames', ':30', '--stats', 'through.jsonl', '--checkpoint', 'saved', '--checkpoint-every', '3')
remarks = [line for line in out.splitlines() if line.startswith('through.obj: at the start ')]
expect(len(remarks) == 1 and 'cross' in remarks[0], 'remarks: %s' % remarks)
expect(re.search(r'verified 31 frames: 0 crossing pairs outside what crosses since the start: [1-9]\d* pairs then, 0 at the end', out), out)
expect('"crossing_pairs":0' in (folder / 'through.jsonl').read_text(), 'nothing was counted')
run(0, 'simulate', *through, '--frames', ':3', '--checkpoint', 'early')
out, _ = run(0, 'simulate', *through, '--frames', ':30', '--resume', 'early')
expect(re.search(r'outside what crosses since the start: [1-9]\d* pairs then', out), 'resumed: ' + out)

# Crossings from before a run is resumed count, although they cross where the run goes on.
vertices, faces = [], []
add_sheet(9, lambda u, v: (0.4 * u, 0.0, 0.4 * v))
add_sheet(5, lambda u, v: (0.013 + 0.1 * u, 0.1 * v + 0.06, 0.007))
write_model('above.obj')
above = [*flags, '--set', 'solver.contact=false']
run(0, 'simulate', 'above.obj', *above, '--frames', ':8', '--checkpoint', 'crossed', '--quiet')
_, err = run(3, 'simulate', 'above.obj', *above, '--frames', ':9', '--resume', 'crossed', '--verify', '--quiet')
expect(re.match(r'taut: error: frame 8, 0\.1333 s: \d+ pairs of triangles cross', err), 'resumed: ' + err)
expecting.end()
