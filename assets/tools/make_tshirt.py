#!/usr/bin/env python3
"""Sews the T-shirt of a pattern file by taut sew, as models: make_tshirt.py TAUT [PATTERN [FOLDER]]

It is sewn on the mannequin of its size, with exactly 10600, 5280, 2640 and 1028 triangles, and rests for a moment without
body and gravity. FOLDER (assets/garments) gets tshirt_N.obj and tshirt_N.landmarks.toml; of a PATTERN that names its
wearer it is tshirt_NAME.obj, of 5280 triangles. The same program and pattern give the same files, byte for byte.
"""
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

ASSETS = Path(__file__).resolve().parent.parent
METRES_PER_UV = 1.5
# Per panel, where the middle of its width and the origin of its heights are in the square of texture coordinates, in m.
PLACES_M = {'front': (0.375, 1.45), 'back': (1.125, 1.45), 'left_sleeve': (0.375, 0.35), 'right_sleeve': (1.125, 0.35)}
SEAMS = {'left_shoulder_seam': 'front, edge 3 with back, edge 3', 'right_shoulder_seam': 'front, edge 5 with back, edge 5',
         'left_side_seam': 'front, edge 1 with back, edge 1', 'right_side_seam': 'front, edge 7 with back, edge 7',
         'left_cuff': 'left_sleeve, edge 1 with left_sleeve, edge 4', 'right_cuff': 'right_sleeve, edge 1 with right_sleeve, edge 4'}


def settings(*words):
    return [word for setting in words for word in ('--set', setting)]


def sew(taut, outlines, body, triangles, folder):
    """Returns the file of the garment at rest, and the vertices of its seams."""
    pattern, sewn, rested = folder / 'tshirt.json', folder / 'sewn.obj', folder / 'rested.obj'
    with open(pattern, 'w', encoding='utf-8') as out:
        subprocess.run([sys.executable, '-B', ASSETS / 'patterns/tshirt/as_json.py', outlines], stdout=out, check=True)
    # With so many triangles it is chance whether the last millimetres at an armpit close.
    for bound in (0.003, 0.005, 0.01):
        words = [taut, 'sew', pattern, '--body', body, '--triangles', str(triangles), '--exact', '--frames', '0',
                 '--picture', folder / 'sewn.png', '-o', sewn, *settings(f'solver.max_stretch={bound}')]
        if subprocess.run(words, check=False).returncode == 0:
            break
    else:
        sys.exit(f'make_tshirt.py: {outlines} cannot be sewn of {triangles} triangles')
    # The body has pressed it together: cloth that is stiff and pushes back finds its lengths again, without folds.
    subprocess.run([taut, 'simulate', sewn, '--quiet', '--frames', 'last', '--export', rested, *settings(
        'gravity.acceleration=[0,0,0]', 'air.drag=20', 'cloth.bending_rigidity=2e-5', 'cloth.compression_stiffness=200',
        'cloth.friction=0', 'solver.max_stretch=0.001', 'pins.at=none', 'time.frames=60')], check=True)
    with open(sewn.with_suffix('.landmarks.toml'), 'rb') as file:
        return rested, tomllib.load(file)['seams']


class Garment:
    def __init__(self, file):
        self.positions, self.places, self.faces, self.panels = [], [], [], []
        for line in open(file, encoding='utf-8'):
            kind, *words = line.split()
            if kind == 'v':
                self.positions.append([float(w) for w in words])
            elif kind == 'vt':
                self.places.append([float(w) / 100 for w in words])
            elif kind == 'g':
                panel = words[0]
            elif kind == 'f':
                self.faces.append([[int(n) - 1 for n in w.split('/')] for w in words])
                self.panels.append(panel)
        self.move_places()
        self.number_vertices()
        edges = {(a, b) for face in self.faces for (a, _), (b, _) in zip(face, face[1:] + face[:1])}
        self.after = {a: b for a, b in edges if (b, a) not in edges}

    def move_places(self):
        """Into the square of texture coordinates."""
        moved = {}
        for name, (x_m, y_m) in PLACES_M.items():
            own = {place for face, panel in zip(self.faces, self.panels) if panel == name for _, place in face}
            xs = [self.places[n][0] for n in own]
            middle = (min(xs) + max(xs)) / 2
            for n in own:
                moved[n] = ((self.places[n][0] - middle + x_m) / METRES_PER_UV, (self.places[n][1] + y_m) / METRES_PER_UV)
        self.places = [moved[n] for n in range(len(self.places))]

    def number_vertices(self):
        """In the order in which faces first use them: importers that rebuild the list of vertices keep that."""
        self.number = {}
        for face in self.faces:
            for vertex, _ in face:
                self.number.setdefault(vertex, len(self.number))
        self.positions = [self.positions[vertex] for vertex in self.number]
        self.faces = [[(self.number[vertex], place) for vertex, place in face] for face in self.faces]

    def border(self, begin, end):
        """Its vertices, the garment on the left."""
        walk = [begin]
        while len(walk) == 1 or walk[-1] != end:
            walk.append(self.after[walk[-1]])
        return walk

    def landmarks(self, seams):
        found = {}
        for name, seam in SEAMS.items():
            line = [self.number[vertex] for vertex in seams[seam]]
            # From the border; shoulder seams to it.
            is_border_first = line[0] in self.after
            found[name] = line if is_border_first != ('shoulder' in name) else line[::-1]
        left, right = found['left_shoulder_seam'][-1], found['right_shoulder_seam'][-1]
        loop = {name: self.border(found[seam][0], found[seam][0])[:-1]
                for name, seam in (('hem', 'right_side_seam'), ('left_cuff', 'left_cuff'), ('right_cuff', 'right_cuff'))}
        return {'left_shoulder_seam': found['left_shoulder_seam'], 'right_shoulder_seam': found['right_shoulder_seam'],
                'back_neckline': self.border(right, left), 'front_neckline': self.border(left, right), **loop,
                'left_side_seam': found['left_side_seam'], 'right_side_seam': found['right_side_seam']}


def write(garment, landmarks, source, file):
    lines = [f'# A T-shirt of {len(garment.faces)} triangles, in metres, y up, worn facing +z with the feet on y = 0.',
             f'# Made by make_tshirt.py from {source["pattern"]}, {source["package"]} {source["version"]}.',
             f'# Licence of the pattern: {source["licence"]}.']
    lines += ['v ' + ' '.join(f'{x:.6f}' for x in position) for position in garment.positions]
    lines += ['vt ' + ' '.join(f'{x:.8f}' for x in place) for place in garment.places]
    lines += ['f ' + ' '.join(f'{vertex + 1}/{place + 1}' for vertex, place in face) for face in garment.faces]
    file.write_text('\n'.join(lines) + '\n', encoding='utf-8')
    lines = [f'# Vertices of {file.name}, counted from 0, in order along each seam or border.',
             '# Left and right are the wearer\'s. Texture coordinates are the pieces as they are cut, to scale.',
             f'metres_per_uv = {METRES_PER_UV}']
    for name, walk in landmarks.items():
        rows = [', '.join(map(str, walk[k:k + 16])) for k in range(0, len(walk), 16)]
        lines.append(f'{name} = [' + ',\n  '.join(rows) + ']')
    file.with_suffix('.landmarks.toml').write_text('\n'.join(lines) + '\n', encoding='utf-8')


def main():
    if len(sys.argv) not in (2, 3, 4) or sys.argv[1].startswith('-'):
        sys.exit(__doc__.strip())
    taut, outlines, out = sys.argv[1:] + [ASSETS / 'patterns/tshirt/teagan.toml', ASSETS / 'garments'][len(sys.argv) - 2:]
    try:
        with open(outlines, 'rb') as file:
            table = tomllib.load(file)
        wearer = table.get('wearer', {}).get('name', '')
        body = ASSETS / f'bodies/mannequin_{wearer or "male_40"}.glb'
        for size in (5280,) if wearer else (10600, 5280, 2640, 1028):
            with tempfile.TemporaryDirectory() as folder:
                rested, seams = sew(taut, outlines, body, size, Path(folder))
                garment = Garment(rested)
                write(garment, garment.landmarks(seams), table['source'], Path(out) / f'tshirt_{wearer or size}.obj')
    except (OSError, tomllib.TOMLDecodeError, subprocess.CalledProcessError) as error:
        sys.exit(f'make_tshirt.py: {error}')


if __name__ == '__main__':
    main()
