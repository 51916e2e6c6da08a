#!/usr/bin/env python3
"""Makes bad files of every kind that Taut reads, and holds it to its verdict on each: an error that names the file, or a
report where the file can be read after all; never a signal, more than 10 s or more than 2 GB.

bad_files.py PROGRAM FOLDER [NAME...]"""
import concurrent.futures
import json
import os
import pathlib
import random
import re
import struct
import subprocess
import sys
import tempfile
import threading
import zlib

import shapes as s
import writers as w

MAX_S = 10  # of processor time
GIVE_UP_S = 120
MAX_BYTES = 2_000_000_000
PROCESSES = 2
NAN = float('nan')
INF = float('inf')


class Bad:
    """A file, the command that reads it with `{}` for its name, and the error that it is refused with; None: it is read."""
    def __init__(self, name, data, error, command):
        self.name, self.data, self.error, self.command = name, data, error, command


ASSETS = pathlib.Path(__file__).resolve().parents[2] / 'assets'
MANNEQUIN = str(ASSETS / 'bodies/mannequin_male_40.glb')
INSPECT = ('inspect', '{}')
SIMULATE = ('simulate', '{}', '--frames', '1')


def cut_files():
    """Files that end too early."""
    sheet, soup = s.sheet(), s.sheet(quads=False)
    whole = {'ply': w.ply(sheet), 'bin.ply': w.ply_binary(sheet), 'off': w.off(sheet), 'stl': w.stl(soup),
             'bin.stl': w.stl_binary(soup), 'gltf': w.gltf(sheet), 'glb': w.glb(sheet), 'dae': w.dae(sheet),
             'fbx': w.fbx(sheet)}
    for ending, data in whole.items():
        for percent in (1, 10, 25, 50, 75, 90, 97):
            yield Bad('cut%d.%s' % (percent, ending), data[:len(data) * percent // 100], 'cannot read a model|is empty', INSPECT)
    obj = w.obj(sheet)
    for percent in (1, 25, 40):
        yield Bad('cut%d.obj' % percent, obj[:len(obj) * percent // 100], 'cannot read a model', INSPECT)


def damaged_files():
    """A byte in sixteen replaced, from the tenth on, so that the kind of file stays what it is."""
    sheet = s.sheet()
    whole = {'bin.ply': w.ply_binary(sheet), 'glb': w.glb(sheet), 'fbx': w.fbx(sheet), 'gltf': w.gltf(sheet)}
    for ending, data in whole.items():
        for seed in range(4):
            changed = bytearray(data)
            for k in range(10 + seed, len(changed), 16):
                changed[k] = (changed[k] * 7 + 13 * seed + k) % 256
            yield Bad('damaged%d.%s' % (seed, ending), bytes(changed), 'cannot read a model', INSPECT)


def models():
    def obj(name, text, error):
        return Bad(name + '.obj', text.encode(), error, SIMULATE)
    triangle = 'v 0 0 0\nv 1 0 0\nv 0 1 0\n'
    for word in ('nan', 'inf', '-inf', '1e999', 'zero', '0x1p3', '1,5', '--1', '', '1e400'):
        yield obj('coordinate_%s' % re.sub(r'\W', '_', word), triangle + 'v 0 0 %s\nf 1 2 3\n' % word, 'line 4: |vertex 3 has a coordinate that is not finite')
    for word in ('0', '4', '-4', '99999999999999999999', '1.5', 'x', '4294967297', '/', '1//x'):
        yield obj('index_%s' % re.sub(r'\W', '_', word), triangle + 'f 1 2 %s\n' % word, 'line 4: |no triangle')
    yield obj('no_faces', triangle, 'has no faces')
    yield obj('lines_alone', triangle + 'l 1 2\nl 2 3\n', 'has no faces')
    yield obj('one_corner', triangle + 'f 1\n', 'has no faces')
    yield obj('no_area', 'v 0 0 0\n' * 3 + 'f 1 2 3\n', 'no triangle|area')
    yield obj('on_a_line', 'v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n', 'no triangle|area')
    yield obj('same_vertex', triangle + 'f 1 1 2\nf 2 2 2\n', 'no triangle|area')
    yield obj('vast', 'v 1e300 0 0\nv 0 1e300 0\nv 0 0 1e300\nf 1 2 3\n', None)
    yield obj('far', 'v 1e17 0 0\nv 100000000000000100 1 0\nv 1e17 1 0\nf 1 2 3\n', None)
    yield obj('tiny', 'v 1e-300 0 0\nv 0 1e-300 0\nv 0 0 1e-300\nf 1 2 3\n', 'size|small|area|expected')
    yield obj('nothing', '', 'is empty')
    yield obj('zeros', '\0' * 4096, 'cannot read a model')
    yield obj('words', 'Buy milk, and bread.\n' * 100, 'cannot read a model')
    yield obj('long_line', 'v ' + '1 ' * 100_000 + '\nf 1 1 1\n', 'cannot read a model|no triangle|area')
    yield obj('long_polygon', ''.join('v %d %d 0\n' % (k % 60, k // 60) for k in range(3000)) + 'f ' +
              ' '.join(map(str, range(1, 3001))) + '\n', None)
    for count, complaint in ((1000, None), (3000, '3000 triangles meet at one edge, of vertices 0 and 1; expected at most 1000')):
        yield obj('fan_%d' % count, 'v 0 0 0\nv 0 1 0\n' + ''.join('v 1 0 %g\n' % (0.001 * k) for k in range(count)) +
                  ''.join('f 1 2 %d\n' % (k + 3) for k in range(count)), complaint)
    chance = random.Random(1)
    ends = [[[chance.uniform(-1, 1) for _ in 'xyz'] for _ in 'ab'] for _ in range(2000)]
    yield obj('needles', ''.join('v %g %g %g\nv %g %g %g\nv %g %g %g\n' % (*a, *b, *(x + chance.uniform(-0.002, 0.002) for x in b))
                                 for a, b in ends) + ''.join('f %d %d %d\n' % (3 * k + 1, 3 * k + 2, 3 * k + 3) for k in range(2000)), None)
    yield obj('single_triangles', ''.join('v %g 0 0\nv %g 1 0\nv %g 0 1\n' % ((3 * k,) * 3) for k in range(50)) +
              ''.join('f %d %d %d\n' % (3 * k + 1, 3 * k + 2, 3 * k + 3) for k in range(50)), None)
    yield obj('library_of_itself', 'mtllib library_of_itself.obj\n' + triangle + 'f 1 2 3\n', None)
    yield obj('library_elsewhere', 'mtllib ../../../etc/passwd\n' + triangle + 'f 1 2 3\n', None)
    yield obj('escape', triangle + 'v \x1b[31m\x07 0 0\nf 1 2 3\n', 'line 4: found')
    header = 'ply\nformat %s 1.0\nelement vertex %s\nproperty float x\nproperty float y\nproperty float z\nelement face %s\n' \
        'property list uchar int vertex_indices\nend_header\n'
    for name, kind, vertices, faces in (('many', 'ascii', 10 ** 18, 10 ** 18), ('minus', 'ascii', -1, -1),
                                        ('many_bin', 'binary_little_endian', 2 ** 40, 2 ** 40),
                                        ('no_number', 'ascii', 'x', 'y'), ('big_endian', 'binary_big_endian', 3, 1),
                                        ('zero', 'ascii', 0, 0), ('kind', 'sideways', 3, 1)):
        yield Bad('header_%s.ply' % name, (header % (kind, vertices, faces) + '0 0 0\n1 0 0\n0 1 0\n').encode(),
                  'cannot read a model', INSPECT)
    for name, counts in (('many', '1000000000000 1000000000000 0'), ('minus', '-3 -1 0'), ('words', 'x y z'), ('none', '')):
        yield Bad('header_%s.off' % name, ('OFF\n%s\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n' % counts).encode(), 'cannot read a model', INSPECT)
    yield Bad('count.stl', b'cloth'.ljust(80) + struct.pack('<I', 2 ** 32 - 1) + b'\0' * 500, 'cannot read a model', INSPECT)
    yield Bad('nan.stl', w.stl_binary(s.sheet(quads=False))[:100] + struct.pack('<ff', NAN, INF) +
              w.stl_binary(s.sheet(quads=False))[108:], 'finite|number|cannot read a model', SIMULATE)
    for ending, text in (('fbx', b'Kaydara FBX Binary  \0\x1a\0' + b'\xff' * 200), ('glb', b'glTF' + b'\xff' * 200),
                         ('dae', b'<COLLADA>' + b'<node>' * 50_000), ('3mf', b'PK\3\4' + b'\xff' * 200),
                         ('gltf', b'[' * 100_000), ('x3d', b'<X3D>' + b'<Transform>' * 20_000), ('3ds', b'MM' + b'\xff' * 200)):
        yield Bad('nonsense.' + ending, text, 'cannot read a model', INSPECT)
    gltf = json.loads(w.gltf(s.sheet()))
    def changed(name, change, error='cannot read a model'):
        copy = json.loads(json.dumps(gltf))
        change(copy)
        return Bad(name + '.gltf', json.dumps(copy).encode(), error, INSPECT)
    yield changed('node_below_itself', lambda g: g['nodes'][0].update(children=[0]))
    yield changed('count', lambda g: g['accessors'][0].update(count=2 ** 62))
    yield changed('offset', lambda g: g['bufferViews'][0].update(byteOffset=2 ** 62))
    yield changed('no_uri', lambda g: (g['buffers'][0].pop('uri', None), g.update(extensionsUsed=['EXT_meshopt_compression'])))
    yield changed('uri_elsewhere', lambda g: g['buffers'][0].update(uri='../../../etc/passwd'))
    yield changed('uri_missing', lambda g: g['buffers'][0].update(uri='not_there.bin'))


def scenes():
    grid = '[garment.grid]\ncolumns = 5\nrows = 5\n'
    def scene(name, text, error):
        return Bad(name + '.toml', text.encode(), error, SIMULATE)
    yield scene('dots', 'a' + '.a' * 100_000 + ' = 1\n', 'nested|deep|dots|keys')
    yield scene('brackets', 'a = ' + '[' * 100_000 + '\n', 'nested|deep|brackets')
    yield scene('tables', '[' + 'a.' * 50_000 + 'a]\n', 'nested|deep|dots|keys')
    yield scene('braces', 'a = ' + '{a=' * 50_000 + '\n', 'nested|deep|brackets')
    yield scene('unclosed', grid + '[solver\n', 'TOML')
    yield scene('twice', grid + '[solver]\nsubsteps = 1\nsubsteps = 2\n', 'TOML')
    yield scene('zeros', '\0' * 1000, 'TOML')
    yield scene('no_utf8', '\xff\xfe'.encode('latin-1').decode('latin-1') + grid, 'TOML')
    for key in ('garment.grid.columns', 'garment.grid.rows', 'garment.grid.width', 'garment.grid.height', 'cloth.thickness',
                'garment.areal_density', 'cloth.bending_rigidity', 'cloth.friction', 'solver.substeps', 'solver.max_stretch',
                'wind.speed', 'time.frame_rate', 'time.frames', 'picture.width'):
        section, name = key.rsplit('.', 1)
        for label, value in (('nan', 'nan'), ('inf', 'inf'), ('vast', '1e300'), ('minus', '-1e300'), ('text', '"x"'), ('list', '[1]'),
                             ('table', '{ a = 1 }'), ('long', '9223372036854775807')):
            if label == 'long' and key not in ('garment.grid.columns', 'garment.grid.rows', 'solver.substeps', 'time.frames'):
                continue
            keys = grid.replace('columns = 5\n', '').replace('rows = 5\n', '') if section == 'garment.grid' else grid + '[%s]\n' % section
            yield scene('%s_%s' % (key.replace('.', '_'), label), keys + '%s = %s\n' % (name, value), '%s: (found|there)' % re.escape(key))
    yield scene('columns_1', '[garment.grid]\ncolumns = 1\n', 'garment.grid.columns')
    yield scene('no_garment', 'title = "x"\n', 'no garment is given')
    yield scene('two_garments', grid + '[garment]\nfile = "a.obj"\n', 'TOML|both')
    yield scene('unknown_key', grid + '[solver]\nsubstep = 1\n', "did you mean 'solver.substeps'")
    for kind in ('directory', 'fifo', 'socket_like'):
        yield scene('garment_is_' + kind, '[garment]\nfile = "%s"\n' % {'directory': '.', 'fifo': 'a_fifo', 'socket_like': '/dev/zero'}[kind],
                    'garment.file: .*(folder|pipe|device)')
    yield scene('texture_zero', grid + '[picture]\ntexture = "/dev/zero"\n', None)
    yield scene('force_vertex', grid + '[[forces]]\nvertex = 4294967295\nforce = [0, 1, 0]\n', 'vertex')
    yield scene('force_vast', grid + '[[forces]]\nvertex = 1\nforce = [0, 1e300, 0]\n', 'force')
    yield scene('body_vast', grid + '[[bodies]]\nshape = "sphere"\nradius = 1e300\n', 'radius')
    yield scene('pin_far', grid + '[pins]\nat = [{ nearest = [1e300, 0, 0] }]\n', None)


def patterns():
    sew = ('sew', '{}', '--body', MANNEQUIN, '--frames', '1', '-o', '{}.sewn.obj')
    skirt = json.loads((ASSETS / 'patterns/wardrobe/skirt.json').read_text())
    def text(name, data, error):
        return Bad(name + '.json', data.encode(), error, sew)
    yield text('pattern_words', 'Buy milk', 'expected a sewing pattern')
    yield text('pattern_empty', '{}', 'expected')
    yield text('pattern_list', '[]', 'expected')
    yield text('pattern_brackets', '[' * 100_000, 'nested|deep')
    yield text('pattern_braces', '{"a":' * 100_000, 'nested|deep')
    panel = next(iter(skirt['pattern']['panels']))
    def changed(name, change, error):
        copy = json.loads(json.dumps(skirt))
        change(copy['pattern'], copy['pattern']['panels'][panel])
        return text('pattern_' + name, json.dumps(copy), error)
    deep = [[]]
    for _ in range(400):
        deep = [deep]
    yield changed('deep_stitches', lambda p, _: p.update(stitches=deep), 'nested|deep|stitches')
    for name, value in (('text', 'x'), ('number', 3), ('null', None), ('list', [1, 2]), ('object', {'a': 1})):
        yield changed('panels_' + name, lambda p, _: p.update(panels=value), 'panels')
        yield changed('vertices_' + name, lambda p, q: q.update(vertices=value), 'vertices')
        yield changed('edges_' + name, lambda p, q: q.update(edges=value), 'edges')
        yield changed('stitches_' + name, lambda p, q: p.update(stitches=value), 'stitches')
        yield changed('translation_' + name, lambda p, q: q.update(translation=value), 'translation' if value is not None else None)
        yield changed('rotation_' + name, lambda p, q: q.update(rotation=value), 'rotation' if value is not None else None)
    for name, value in (('vast', 1e300), ('huge', 1e9), ('far', 1e5)):
        yield changed('vertex_' + name, lambda p, q: q['vertices'][0].__setitem__(0, value), 'vertices|m|cm')
        yield changed('translation_at_' + name, lambda p, q: q['translation'].__setitem__(0, value), 'translation')
    yield changed('vertex_tiny', lambda p, q: q.update(vertices=[[1e-9 * c for c in v] for v in q['vertices']]), 'vertices|panel|small|cm')
    for name, value in (('end', 10 ** 19), ('minus', -1), ('text', 'x'), ('half', 0.5), ('null', None)):
        yield changed('edge_' + name, lambda p, q: q['edges'][0].update(endpoints=[0, value]), 'endpoints|edge')
        yield changed('stitch_' + name, lambda p, q: p['stitches'][0][0].update(edge=value), 'stitch|edge')
    yield changed('curve_vast', lambda p, q: q['edges'][0].update(curvature={'type': 'cubic', 'params': [[1e9, 1e9], [1e9, -1e9]]}), 'edge|curv|m')
    yield changed('panel_unknown', lambda p, q: p['stitches'][0][0].update(panel='nobody'), 'nobody')


def other_files():
    dress = ('simulate', 'tshirt', '--frames', '1')
    yield Bad('fabric_empty.toml', b'', 'is empty', dress + ('--fabric', '{}'))
    yield Bad('fabric_key.toml', b'[wind]\nspeed = 3\n', 'wind', dress + ('--fabric', '{}'))
    yield Bad('fabric_vast.toml', b'[garment]\nareal_density = 1e300\n', 'areal_density', dress + ('--fabric', '{}'))
    yield Bad('fabric_thin.toml', b'[cloth]\nthickness = 1e-300\n', 'thickness', dress + ('--fabric', '{}'))
    moved = ('simulate', 'tshirt', '--frames', '1', '--body', MANNEQUIN, '--dress', '0', '--body-motion', '{}')
    joint = 'JOINT a\n{\nOFFSET 0 0 0\nCHANNELS 3 Xrotation Yrotation Zrotation\n'
    root = 'HIERARCHY\nROOT Hips\n{\nOFFSET 0 0 0\nCHANNELS 3 Xrotation Yrotation Zrotation\nEnd Site\n{\nOFFSET 0 1 0\n}\n}\n'
    for name, data, error in (('words', 'Buy milk', 'expected'), ('deep', root[:60] + joint * 50_000, 'nested|deep|expected|found'),
                              ('cut', root, 'found|expected|MOTION'),
                              ('frames', root + 'MOTION\nFrames: 2000000000\nFrame Time: 0.1\n0 0 0\n', 'frame|found|expected'),
                              ('minus', root + 'MOTION\nFrames: -1\nFrame Time: 0.1\n', 'found|expected'),
                              ('time', root + 'MOTION\nFrames: 1\nFrame Time: nan\n0 0 0\n', 'found|expected'),
                              ('nan', root + 'MOTION\nFrames: 1\nFrame Time: 0.1\nnan 0 0\n', 'found|expected'),
                              ('escape', root + 'MOTION\nFrames: \x1b[31m\x07\n', 'found|expected')):
        yield Bad('motion_%s.bvh' % name, data.encode(), error, moved)
    head = b'POINTCACHE2\0'
    for name, data in (('words', b'Buy milk' * 20), ('many', head + struct.pack('<iiffi', 1, 2 ** 31 - 1, 0, 1, 2 ** 31 - 1) + b'\0' * 96),
                       ('minus', head + struct.pack('<iiffi', 1, -1, 0, 1, -1)), ('cut', head), ('none', head + struct.pack('<iiffi', 1, 0, 0, 1, 0)),
                       ('nan', head + struct.pack('<iiffi', 1, 3, 0, 1, 1) + struct.pack('<fff', NAN, INF, 0) * 3)):
        yield Bad('cache_%s.pc2' % name, data, 'found|expected', moved)
    view = ('view', '--headless', '--script', '{}')
    for name, data in (('words', b'Buy milk\n'), ('long', b'set ' + b'x' * 500_000 + b'\n'), ('zeros', b'\0' * 100)):
        yield Bad('session_%s.txt' % name, data, 'line|expected', view)
    resume = ('simulate', 'pinned-9x9-5', '--frames', '2', '--resume', '{}')
    for name, data in (('words', b'Buy milk' * 20), ('magic', b'TAUTRUN\n' + b'\xff' * 200), ('cut', b'TAUTRUN\n\5\0\0\0')):
        yield Bad('run_%s.checkpoint' % name, data, 'cannot go on', resume)
    again = ('render', '{}', '-o', '{}.again.png')
    def png(*chunks):
        data = b'\x89PNG\r\n\x1a\n'
        for kind, content in ((b'IHDR', struct.pack('>IIBBBBB', 1, 1, 8, 2, 0, 0, 0)), *chunks):
            data += struct.pack('>I', len(content)) + kind + content + struct.pack('>I', zlib.crc32(kind + content))
        return data + b'\0\0\0\0IEND\xaeB`\x82'
    scene = b'[garment.grid]\ncolumns = 3\nrows = 3\n[picture]\ntexture = "/dev/zero"\n'
    entries = lambda frame, text: [(b'tEXt', b'Taut Scene\0' + text), (b'tEXt', b'Taut Frame\0' + frame), (b'tEXt', b'Taut State\x000'),
                                   (b'tEXt', b'Software\0\x1b[31mtaut'), (b'tEXt', b'Taut Renderer\0x')]
    yield Bad('late.png', png(*entries(b'2000000000', scene)), 'expected a frame|not in the picture', again)
    yield Bad('zero.png', png(*entries(b'0', scene)), 'not in the picture|device', again)
    yield Bad('no_entry.png', png(), 'does not say how it was made', again)
    yield Bad('words.png', b'Buy milk', 'no PNG', again)
    yield Bad('chunk.png', png()[:40] + b'\xff\xff\xff\xfftEXt', 'ends in the middle', again)
    yield Bad('dots.png', png(*entries(b'0', b'a' + b'.a' * 100_000 + b' = 1')), 'nested|deep|dots|keys', again)


def special_files():
    """What is no file at all, made by its name."""
    for command, ending in ((INSPECT, '.obj'), (SIMULATE, '.toml'), (('sew', '{}', '--body', MANNEQUIN), '.json'), (('render', '{}', '-o', '{}.x.png'), '.png'),
                            (('simulate', 'tshirt', '--fabric', '{}'), '.toml'), (('simulate', 'tshirt', '--body', '{}'), '.glb'),
                            (('simulate', 'tshirt', '--body', '{}'), '.obj'), (('view', '--headless', '--script', '{}'), '.txt'),
                            (('simulate', 'tshirt', '--frames', '1', '--resume', '{}'), '.checkpoint'),
                            (('render', 'tshirt', '--frames', '1', '-o', '{}.x.png', '--texture', '{}'), '.jpg')):
        kind = command[0] + ('_' + command[2].strip('-') if len(command) > 2 and command[1] != '{}' else '')
        for label, make, error in (('fifo', lambda path: os.mkfifo(path), 'pipe'),
                                   ('zero', lambda path: path.symlink_to('/dev/zero'), 'device'),
                                   ('null', lambda path: path.symlink_to('/dev/null'), 'device'),
                                   ('sparse', lambda path: (path.touch(), os.truncate(path, 1 << 33)), 'bytes, expected at most'),
                                   ('folder', lambda path: path.mkdir(), 'folder'),
                                   ('loop', lambda path: path.symlink_to(path.name), 'cannot read|there is no file|symbolic')):
            yield Bad('%s_%s%s' % (kind, label, ending), make, error, command)


def write(bad, path):
    if path.is_symlink() or (path.exists() and not path.is_dir()):
        path.unlink()
    if path.is_dir():
        path.rmdir()
    if callable(bad.data):
        bad.data(path)
    else:
        path.write_bytes(bad.data)


def run(program, bad, folder):
    """The exit code, what was said, the seconds and the largest memory of the program or of a child of it, in bytes."""
    command = [str(part).replace('{}', bad.name) for part in bad.command]
    with tempfile.TemporaryFile() as said:
        process = subprocess.Popen([program, *command], cwd=folder, stdin=subprocess.DEVNULL, stdout=said, stderr=said)
        give_up = threading.Timer(GIVE_UP_S, process.kill)
        give_up.start()
        status, used = os.wait4(process.pid, 0)[1:]
        give_up.cancel()
        process.returncode = os.waitstatus_to_exitcode(status)
        said.seek(0)
        return process.returncode, said.read().decode(errors='replace'), used.ru_utime + used.ru_stime, 1024 * used.ru_maxrss


def faults(program, bad, folder):
    write(bad, folder / bad.name)
    code, said, seconds, memory = run(program, bad, folder)
    if seconds > MAX_S:
        yield 'took %.1f s' % seconds
    if memory > MAX_BYTES:
        yield 'took %.1f GB' % (memory / 1e9)
    if code < 0:
        yield 'ended by signal %d' % -code
    elif bad.error is None:
        if code not in (0, 1, 3):
            yield 'exit code %d: %s' % (code, said[:300])
    elif code not in (1, 2) or not re.search(bad.error, said) or bad.name.rsplit('.', 1)[0] not in said:
        yield 'exit code %d, expected an error of %s like %r: %s' % (code, bad.name, bad.error, said[:400])
    if re.search(r'[\x00-\x08\x0b-\x1f\x7f]', said):
        yield 'said control characters: %r' % said[:300]
    if len(said) > 5000:
        yield 'said %d characters' % len(said)
    if 'json.exception' in said or 'std::' in said:
        yield 'speaks of its insides: ' + said[:300]


def main():
    program, folder = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    if not (folder / 'a_fifo').exists():
        os.mkfifo(folder / 'a_fifo')
    files = [bad for part in (cut_files, damaged_files, models, scenes, patterns, other_files, special_files) for bad in part()]
    names = [bad.name for bad in files]
    assert len(set(names)) == len(names), sorted(name for name in names if names.count(name) > 1)
    failed = 0
    asked = [bad for bad in files if not sys.argv[3:] or bad.name in sys.argv[3:]]
    # Two, as the test may take two processors; more would slow each other beyond MAX_S.
    with concurrent.futures.ThreadPoolExecutor(PROCESSES) as pool:
        for bad, found in zip(asked, pool.map(lambda bad: list(faults(program, bad, folder)), asked)):
            for fault in found:
                failed += 1
                print('%s: %s' % (bad.name, fault))
    print('%d bad files, %d faults' % (len(files), failed))
    sys.exit(failed > 0)


if __name__ == '__main__':
    main()
