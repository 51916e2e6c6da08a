#!/usr/bin/env python3
"""No output takes the place of a file that the run reads: every option that names an output, with the name of every
input, and with a link to it.   outputs.py PROGRAM FOLDER [all]
Without `all` every output meets three of the inputs, and every input three or more of the outputs."""
import os
import pathlib
import shutil
import subprocess
import sys
import time
import zlib

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / 'support'))
import expecting
from expecting import expect

program, folder = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2])
is_whole = sys.argv[3:] == ['all']
ASSETS = pathlib.Path(__file__).resolve().parents[2] / 'assets'


def run(*arguments):
    return subprocess.run([program, *map(str, arguments)], cwd=folder, capture_output=True, text=True, timeout=120)


def png(side):
    def chunk(kind, data):
        return len(data).to_bytes(4, 'big') + kind + data + zlib.crc32(kind + data).to_bytes(4, 'big')
    size = side.to_bytes(4, 'big')
    rows = b''.join(b'\0' + b'\xc0\x20\x40' * side for _ in range(side))
    return (b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', size + size + b'\x08\x02\0\0\0') + chunk(b'IDAT', zlib.compress(rows)) +
            chunk(b'IEND', b''))


def sheet(columns, rows, extra=''):
    text = extra
    for r in range(rows):
        for c in range(columns):
            text += 'v %g %g 0\nvt %g %g\n' % (0.1 * c, 0.1 * r, c / columns, r / rows)
    for r in range(rows - 1):
        for c in range(columns - 1):
            a = r * columns + c + 1
            text += 'f ' + ' '.join('%d/%d' % (v, v) for v in (a, a + 1, a + columns + 1, a + columns)) + '\n'
    return text


BOX = ''.join('v %g %g %g\n' % (x, y - 3, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)) + \
    'f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n'


def write_inputs():
    write = lambda name, text: (folder / name).write_bytes(text if isinstance(text, bytes) else text.encode())
    write('dress.obj', sheet(6, 8, 'mtllib dress.mtl\nusemtl cloth\n'))
    write('dress.mtl', 'newmtl cloth\nKd 1 1 1\nmap_Kd dress.png\n')
    write('dress.png', png(64))
    write('dress.landmarks.toml', '[edges]\n')
    write('start.obj', sheet(6, 8))
    write('print.png', png(16))
    write('box.obj', BOX)
    write('own.toml', 'title = "a fabric"\n[garment]\nareal_density = 0.2\n')
    write('scene.toml', 'frames = 3\n'
          '[garment]\nfile = "dress.obj"\nstart = "start.obj"\nscale = 1\nup = "y"\nmesh = "model"\n'
          '[cloth]\nfabric = "own.toml"\n[picture]\nwidth = 64\nheight = 64\ntexture = "print.png"\n'
          '[[bodies]]\nshape = "mesh"\nfile = "box.obj"\nscale = 1\nup = "y"\n'.replace('frames = 3\n', ''))
    write('script.session', 'taut session 1\n')
    write('body.glb', (ASSETS / 'bodies/mannequin_male_40.glb').read_bytes())
    write('pattern.json', (ASSETS / 'patterns/wardrobe/skirt.json').read_bytes())


INPUTS = ['scene.toml', 'dress.obj', 'dress.mtl', 'dress.png', 'dress.landmarks.toml', 'start.obj', 'print.png', 'box.obj',
          'own.toml']
FILES = [*INPUTS, 'body.glb', 'pattern.json']

# Options that name an output, with the ending that its name must have; of each, the whole command without the name.
OUTPUTS = [(['render', 'scene.toml', '--frames', '1', '-o'], '.png'),
           (['render', 'scene.toml', '--frames', '1', '-o'], '.mp4'),
           (['render', 'scene.toml', '--frames', '1', '--stats'], '.csv'),
           (['render', 'scene.toml', '--frames', '1', '--export'], '.obj'),
           (['simulate', 'scene.toml', '--frames', '1', '--export'], '.obj'),
           (['simulate', 'scene.toml', '--frames', '1', '--export'], '.pc2'),
           (['simulate', 'scene.toml', '--frames', '1', '--export'], '.glb'),
           (['simulate', 'scene.toml', '--frames', '1', '--export'], '.usda'),
           (['simulate', 'scene.toml', '--frames', '1', '--stats'], '.jsonl'),
           (['simulate', 'scene.toml', '--frames', '1', '--checkpoint'], None),
           (['view', 'scene.toml', '--headless', '--screenshot'], None),
           (['view', 'scene.toml', '--headless', '--record'], None),
           (['view', 'scene.toml', '--headless', '--layout'], None)]


def content():
    return {name: (folder / name).read_bytes() for name in FILES}


def is_kept(command, name, before, refusal='it would replace'):
    done = run(*command, name)
    expect(done.returncode == 2 and refusal in done.stderr,
           '%s %s: exit code %d, expected 2 and "%s": %s' % (' '.join(command), name, done.returncode, refusal, done.stderr))
    changed = [input for input, data in content().items() if data != before[input]]
    expect(not changed, '%s %s changed %s' % (' '.join(command), name, changed))
    if changed:
        write_inputs()


def refuses_every_input():
    before = content()
    for place, (command, ending) in enumerate(OUTPUTS):
        for input in INPUTS if is_whole else [INPUTS[(3 * place + k) % len(INPUTS)] for k in range(3)]:
            name = input
            if ending and not input.endswith(ending):
                name = 'link' + ending
                os.link(folder / input, folder / name)
            is_kept(command, name, before)
            if name != input:
                (folder / name).unlink(missing_ok=True)
    # Frames of a sequence, and what stands beside a cache.
    os.link(folder / 'dress.png', folder / '0003.png')
    is_kept(['render', 'scene.toml', '--frames', '1:5', '-o'], '{frame:04}.png', before)
    is_kept(['simulate', 'scene.toml', '--frames', '1:5', '--export'], 'start.pc2', before)


def refuses_inputs_of_other_commands():
    before = content()
    sew = ['sew', 'pattern.json', '--body', 'body.glb']
    for command, inputs, name in ((['inspect', 'dress.obj', '-o'], ('dress.obj', 'dress.mtl', 'dress.png'), 'link.png'),
                                  (['fit', 'dress.obj', '--body', 'body.glb', '-o'], ('dress.png', 'body.glb'), 'link.png'),
                                  ([*sew, '-o'], ('pattern.json', 'body.glb'), 'link.obj'),
                                  ([*sew, '-o', 'new.obj', '--picture'], ('pattern.json', 'body.glb'), 'link.png'),
                                  ([*sew, '-o', 'new.obj', '--steps'], ('pattern.json', 'body.glb'), 'link.png')):
        for input in inputs:
            os.link(folder / input, folder / name)
            is_kept(command, name, before)
            (folder / name).unlink()
    run('simulate', 'scene.toml', '--frames', '1', '--checkpoint', 'start.checkpoint')
    is_kept(['simulate', 'scene.toml', '--frames', '2', '--set', 'start.checkpoint=start.checkpoint', '--checkpoint'],
            'start.checkpoint', before)
    done = run('simulate', 'scene.toml', '--frames', '2', '--resume', 'start.checkpoint')
    expect(done.returncode == 0, 'a run does not go on in the file that it goes on from: ' + done.stderr)
    done = run('render', 'scene.toml', '--frames', '1', '-o', 'again.png')
    expect(done.returncode == 0, 'no picture: ' + done.stderr)
    is_kept(['render', 'again.png', '-o'], 'again.png', before)
    done = run('simulate', 'scene.toml', '--checkpoint', 'one.obj', '--export', './one.obj', '--frames', '1')
    expect(done.returncode == 2 and 'two outputs have this name' in done.stderr, 'two outputs of one name: ' + done.stderr)


def chooses_free_names():
    """The usual names of a dress and its texture: the picture gets another, and the second one that of the first."""
    texture = (folder / 'dress.png').read_bytes()
    for attempt in range(2):
        done = run('render', 'dress.obj', '--frames', '1', '--resolution', '64,64')
        expect(done.returncode == 0 and 'wrote dress-1.png' in done.stdout and "'dress.png' is there" in done.stderr,
               'rendered: %s %s' % (done.stdout, done.stderr))
        (folder / 'dress-1.png').unlink()
    expect((folder / 'dress.png').read_bytes() == texture, 'the texture has changed')
    (folder / 'plain.obj').write_text(sheet(6, 8))
    for attempt in range(2):
        done = run('render', 'plain.obj', '--frames', '1', '--resolution', '64,64')
        expect('wrote plain.png' in done.stdout and done.stderr == '', 'its own picture is not replaced: ' + done.stderr)
    (folder / 'own').mkdir()
    others = [folder / 'own/fig1.pdf', folder / 'own/fig1-1.pdf']
    for file in others:
        file.write_text('of another')
    for expected in ('own/fig1-2.png', 'own/fig1-3.png'):
        done = run('figures', '--only', 'fig1', '-o', 'own')
        expect(f'wrote {expected}' in done.stdout, 'figures: %s%s' % (done.stdout, done.stderr))
    for file in others:
        expect(file.read_bytes() == b'of another', f"another's {file.name} has changed")
        file.unlink()
    for attempt in range(2):
        done = run('figures', '--only', 'fig1', '-o', 'own')
        expect('wrote own/fig1.png' in done.stdout and done.stderr == '', 'its own figure: ' + done.stderr)


def opens_nothing_outside_of_a_pictures_folder():
    (folder / 'sent').mkdir()
    run('render', 'plain.obj', '--frames', '1', '--resolution', '64,64', '-o', 'sent/plain.png')
    shutil.copy(folder / 'plain.obj', folder / 'elsewhere.obj')
    refused = run('render', 'sent/plain.png', '-o', 'a.png')
    expect(refused.returncode == 1 and "plain.obj', which is not in the picture's folder" in refused.stderr,
           'opened: ' + refused.stdout + refused.stderr)
    trusted = run('render', 'sent/plain.png', '-o', 'a.png', '--trust')
    expect(trusted.returncode == 0 and "plain.obj'" in trusted.stdout, 'with --trust: ' + trusted.stdout + trusted.stderr)
    shutil.copy(folder / 'plain.obj', folder / 'sent')
    beside = run('render', 'sent/plain.png', '-o', 'b.png')
    expect(beside.returncode == 0 and "sent/plain.obj'" in beside.stdout, 'beside it: ' + beside.stdout + beside.stderr)


def keeps_a_second_program_away():
    long = ['simulate', 'pinned-9x9-5', '--set', 'rest.speed=0', '--quiet', '--frames', '100000']
    for option, name in (('--stats', 'run.csv'), ('--checkpoint', 'run.checkpoint'), ('--export', 'run.pc2')):
        first = subprocess.Popen([program, *long, option, name], cwd=folder, stderr=subprocess.DEVNULL)
        try:
            time.sleep(0.5)  # until it has claimed the file
            done = run('simulate', 'pinned-9x9-5', '--frames', '1', option, name)
            expect(done.returncode == 1 and 'another program is writing it' in done.stderr,
                   'two programs write %s: %d %s' % (name, done.returncode, done.stderr))
        finally:
            first.kill()
            first.wait()
        done = run('simulate', 'pinned-9x9-5', '--frames', '1', option, name)
        expect(done.returncode == 0, 'after the first one was killed: ' + done.stderr)


def makes_the_folder_of_what_the_window_keeps():
    done = run('view', 'pinned-9x9-5', '--headless', '--keep', 'kept/today')
    expect(done.returncode == 0 and (folder / 'kept/today').is_dir(), 'no folder to keep in: ' + done.stderr)
    refused = run('view', 'pinned-9x9-5', '--headless', '--keep', 'plain.obj/today')
    expect(refused.returncode == 1 and "cannot make the output folder 'plain.obj/today'" in refused.stderr,
           'kept below a file: %d %s' % (refused.returncode, refused.stderr))


def writes_a_picture_to_a_pipe():
    render = [program, 'render', 'plain.obj', '--resolution', '64,64', '-o', '-']
    done = subprocess.run([*render, '--frames', '1', '--stats', 'piped.csv'], cwd=folder, capture_output=True, timeout=120)
    whole = done.stdout.startswith(b'\x89PNG') and done.stdout.endswith(b'IEND\xae\x42\x60\x82')
    expect(done.returncode == 0 and whole and b'wrote -, 1 frame' in done.stderr and (folder / 'piped.csv').exists(),
           'piped: %d, %d bytes, %s' % (done.returncode, len(done.stdout), done.stderr))
    done = subprocess.run([*render, '--frames', '1:2'], cwd=folder, capture_output=True, text=True, timeout=120)
    expect(done.returncode == 2 and 'found 2 frames, expected one picture' in done.stderr and not done.stdout,
           'two frames: %d %s' % (done.returncode, done.stderr))
    with open('/dev/full', 'wb') as full:
        done = subprocess.run([*render, '--frames', '1'], cwd=folder, stdout=full, stderr=subprocess.PIPE, text=True, timeout=120)
    expect(done.returncode == 1 and "cannot write '-': No space left" in done.stderr, 'full: %d %s' % (done.returncode, done.stderr))


shutil.rmtree(folder, ignore_errors=True)
folder.mkdir(parents=True)
write_inputs()
for check in (refuses_every_input, refuses_inputs_of_other_commands, chooses_free_names,
              opens_nothing_outside_of_a_pictures_folder, keeps_a_second_program_away,
              makes_the_folder_of_what_the_window_keeps, writes_a_picture_to_a_pipe):
    before = expecting.failures
    try:
        check()
    except Exception as error:  # the other checks are made all the same
        expect(False, repr(error))
    if expecting.failures > before:
        print('^ %s' % check.__name__)
expecting.end()
