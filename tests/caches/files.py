#!/usr/bin/env python3
"""The program writes each format, is stopped and goes on; the files are read here.   files.py PROGRAM FOLDER"""
import ast
import json
import pathlib
import re
import shutil
import signal
import struct
import subprocess
import sys
import time
import zlib

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / 'support'))
import expecting
from expecting import expect

program, folder = pathlib.Path(sys.argv[1]).absolute(), pathlib.Path(sys.argv[2])
FRAMES = 40
# A strip of quads whose print has a seam, where vertices are doubled.
ROWS = 40
MODEL = 'mtllib strip.mtl\n' + ''.join('v %g %g 0\n' % (x, 1 - 0.02 * y) for y in range(ROWS) for x in (0, 0.05, 0.05, 0.1))
MODEL += 'vt 0 0\nvt 0.4 0\nvt 0.6 0\nvt 1 0\ng strip\nusemtl cloth\n'
MODEL += ''.join('f %s\n' % ' '.join('%d/%d' % (4 * (y + row) + x + 1, x + 1) for x, row in ((a, 0), (a, 1), (a + 1, 1), (a + 1, 0)))
                 for y in range(ROWS - 1) for a in (0, 2))
CHUNKS = ((b'IHDR', struct.pack('>IIBBBBB', 2, 2, 8, 2, 0, 0, 0)), (b'IDAT', zlib.compress(b'\0\xff\0\0\0\xff\0' * 2)), (b'IEND', b''))
PRINT = b'\x89PNG\r\n\x1a\n' + b''.join(struct.pack('>I', len(data)) + kind + data + struct.pack('>I', zlib.crc32(kind + data))
                                      for kind, data in CHUNKS)


def command(*arguments):
    return [str(program), 'simulate', 'strip.obj', '--units', 'm', '--up', 'y', '--set', 'garment.mesh=model', '--wind', '4', '--frames', ':%d' % FRAMES, *arguments]


def run(*arguments, code=0):
    done = subprocess.run(command(*arguments), cwd=folder, capture_output=True, text=True)
    expect(done.returncode == code, '%s: exit code %d, %s' % (arguments, done.returncode, done.stderr))
    return done.stdout + done.stderr


def positions_of(obj):
    return [tuple(map(float, line.split()[1:])) for line in obj.read_text().splitlines() if line.startswith('v ')]


def close(found, expected, within):
    return len(found) == len(expected) and all(abs(a - b) <= within for f, e in zip(found, expected) for a, b in zip(f, e))


def single(value):
    return struct.unpack('<f', struct.pack('<f', value))[0]


def expect_point_caches():
    """Each number where the format has it."""
    shapes = [positions_of(folder / ('shapes/%02d.obj' % frame)) for frame in range(FRAMES + 1)]
    numbers = [single(c) for shape in shapes for vertex in shape for c in vertex]
    pc2 = (folder / 'clip.pc2').read_bytes()
    expect(pc2[:32] == b'POINTCACHE2\0' + struct.pack('<iiffi', 1, 4 * ROWS, 0, 1, FRAMES + 1), 'header of PC2: %r' % pc2[:32])
    expect(pc2[32:] == struct.pack('<%df' % len(numbers), *numbers), 'frames of PC2')
    expect(positions_of(folder / 'clip.obj') == positions_of(folder / 'strip.obj'), 'the rest shape')


def expect_gltf():
    glb = (folder / 'clip.glb').read_bytes()
    length = struct.unpack('<I', glb[12:16])[0]
    scene, binary = json.loads(glb[20:20 + length]), glb[28 + length:]

    def vectors(accessor):
        view = scene['bufferViews'][scene['accessors'][accessor]['bufferView']]
        values = struct.unpack_from('<%df' % (view['byteLength'] // 4), binary, view['byteOffset'])
        return list(zip(values[::3], values[1::3], values[2::3]))
    primitive = scene['meshes'][0]['primitives'][0]
    rest, targets = vectors(primitive['attributes']['POSITION']), primitive['targets']
    expect(len(targets) == FRAMES + 1 and len(rest) == 4 * ROWS, '%d targets of %d vertices' % (len(targets), len(rest)))
    image = scene['bufferViews'][scene['images'][0]['bufferView']]
    expect(binary[image['byteOffset']:][:4] == b'\x89PNG' and len(scene['materials']) == 1, 'no image in glTF')
    for frame in (0, 7, FRAMES):
        moved = [tuple(a + b for a, b in zip(*pair)) for pair in zip(rest, vectors(targets[frame]['POSITION']))]
        shape = positions_of(folder / ('shapes/%02d.obj' % frame))
        expect(close(sorted(moved), sorted(shape), 2e-7), 'glTF: frame %d' % frame)
    sheen = scene['materials'][0]['extensions']['KHR_materials_sheen']
    expect(scene['extensionsUsed'] == ['KHR_materials_sheen'] and 0 < min(sheen['sheenColorFactor']) <= 1 and
           abs(sheen['sheenRoughnessFactor'] - 0.65) < 1e-6, 'no sheen of jersey in glTF')


def usd_value(text, name):
    """Returns the text behind NAME = on its line, or in the braces that begin there, by its keys."""
    found = re.search(r'\b%s = (.*)' % re.escape(name), text)
    expect(found, 'USD: no ' + name)
    if found.group(1) != '{':
        return ast.literal_eval(found.group(1).removesuffix(' ('))
    return ast.literal_eval('{' + text[found.end():text.index('}', found.end())] + '}')


def expect_usd():
    text = (folder / 'clip.usda').read_text()
    expect(text.startswith('#usda 1.0\n'), 'USD: ' + text[:20])
    open_brackets = []
    for bracket in re.sub(r'"[^"]*"', '', text):
        if bracket in '([{':
            open_brackets.append(bracket)
        elif bracket in ')]}':
            expect(open_brackets and open_brackets.pop() + bracket in ('()', '[]', '{}'), 'USD: unpaired ' + bracket)
    expect(not open_brackets, 'USD: open %s' % open_brackets)
    expect(usd_value(text, 'endTimeCode') == FRAMES and usd_value(text, 'timeCodesPerSecond') == 60 and
           usd_value(text, 'upAxis') == 'Y' and usd_value(text, 'metersPerUnit') == 1, 'USD: its head')
    counts, corners = usd_value(text, 'faceVertexCounts'), usd_value(text, 'faceVertexIndices')
    faces = [[int(word.split('/')[0]) - 1 for word in line.split()[1:]] for line in MODEL.splitlines() if line.startswith('f ')]
    expect(counts == [4] * len(faces) and corners == sum(faces, []), 'USD: the faces')
    expect(len(usd_value(text, 'primvars:st')) == len(corners), 'USD: texture coordinates')
    points, extents = usd_value(text, 'points.timeSamples'), usd_value(text, 'extent.timeSamples')
    expect(list(points) == list(range(FRAMES + 1)) == list(extents), 'USD: frames %s' % list(points))
    for frame in (0, 7, FRAMES):
        shape = positions_of(folder / ('shapes/%02d.obj' % frame))
        expect(close(points[frame], shape, 2e-7), 'USD: frame %d' % frame)
        expect(close(extents[frame], [tuple(map(end, zip(*shape))) for end in (min, max)], 2e-7), 'USD: extent %d' % frame)
    expect('rel material:binding = </Garment/Cloth>' in text and 'def Material "Cloth"' in text, 'USD: its material')
    expect(0 < usd_value(text, 'inputs:sheen') <= 1, 'USD: no sheen')


def expect_same_after_a_stop(name, grows, *more):
    """Stopped at some frame, killed at another, and gone on with each time."""
    expected = {path: path.read_bytes() for pattern in (name, *more) for path in folder.glob(pattern)}
    for path in expected:
        path.unlink()
    arguments = ('--checkpoint', 'run.checkpoint')
    for end, size in ((signal.SIGTERM, 5), (signal.SIGKILL, 20)):
        process = subprocess.Popen(command('--export', name, '--checkpoint-every', '6', *arguments), cwd=folder, stdout=subprocess.PIPE,
                                   stderr=subprocess.STDOUT)
        while process.poll() is None and grows() < size:
            time.sleep(0.002)
        process.send_signal(end)
        said = process.communicate()[0].decode()
        expect(process.returncode == (75 if end == signal.SIGTERM else -9), '%s: ended with %d, %s' % (name, process.returncode, said))
        expect(not (folder / name).exists(), name + ' is there before its end')
        arguments = ('--resume', 'run.checkpoint')
    for _ in range(2):  # of a run at its end nothing is left to do
        run('--export', name, *arguments)
        for path, content in expected.items():
            expect(path.exists() and path.read_bytes() == content, '%s differs after a stop' % path)
    expect(not list(folder.rglob('*.part')), 'something unfinished is left')


def frames_in(name, header, frame_bytes):
    part = folder / (name + '.part')
    return lambda: (part.stat().st_size - header) // frame_bytes if part.exists() else 0


def expect_render_exports():
    """The frames that are drawn."""
    draw = ['render' if word == 'simulate' else word for word in command()[:-2]]
    done = subprocess.run([*draw, '--frames', '38:40', '--resolution', '32x32', '--output', '{frame}.png', '--export', 'drawn.pc2'], cwd=folder,
                          capture_output=True, text=True)
    expect('wrote drawn.pc2, 3 frames of 160 vertices' in done.stdout, 'render: ' + done.stdout + done.stderr)
    expect((folder / 'drawn.pc2').read_bytes()[32:] == (folder / 'clip.pc2').read_bytes()[-3 * 48 * ROWS:], 'the frames that are drawn')


shutil.rmtree(folder, ignore_errors=True)
folder.mkdir(parents=True)
(folder / 'strip.obj').write_text(MODEL)
(folder / 'strip.mtl').write_text('newmtl cloth\nmap_Kd print.png\n')
(folder / 'print.png').write_bytes(PRINT)
run('--export', 'shapes/{frame:02}.obj')
for ending in ('pc2', 'glb', 'usda'):
    said = run('--export', 'clip.' + ending)
    expect('wrote clip.%s, 41 frames' % ending in said, said)
expect_point_caches()
expect_gltf()
expect_usd()
expect_render_exports()
expect_same_after_a_stop('clip.pc2', frames_in('clip.pc2', 32, 48 * ROWS), 'clip.obj')
expect('cannot be gone on with' in run('--export', 'clip.glb', '--checkpoint', 'run.checkpoint', code=2), 'a .glb that shall be resumed')
expect('cannot be gone on with' in run('--export', 'clip.usda', '--checkpoint', 'run.checkpoint', code=2), 'a .usda that shall be resumed')
expecting.end()
