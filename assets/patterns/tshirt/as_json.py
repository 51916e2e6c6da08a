#!/usr/bin/env python3
"""Writes a T-shirt's outlines (teagan.toml and its like) as a sewing pattern for taut sew: as_json.py teagan.toml > tshirt.json

A jacket to be worn over it: as_json.py teagan.toml --larger 1.12 --sleeves 30 --open > jacket.json"""
import argparse
import json
import sys
import tomllib

OPENING_CM = 0.8  # between both halves of a front that is open
GAP_CM = 20.0  # of front and back from the middle of the wearer
NECK_POINT_CM = 150.0  # as high as they are placed; taut sew moves all to the shoulders


def line_of(table, name):
    """In cm, y up; the file has mm, y down."""
    piece, side = name.split('.')
    return [(x / 10, -y / 10) for x, y in table[piece][side]['points_mm']]


def mirrored(line):
    return [(-x, y) for x, y in reversed(line)]


def panel(sides, translation, rotation=(0, 0, 0)):
    """Sides in order, each a line from corner to corner."""
    vertices, edges = [], []
    for number, line in enumerate(sides):
        vertices.append(line[0])
        edge = {'endpoints': [number, (number + 1) % len(sides)]}
        if len(line) > 2:
            edge['curvature'] = {'type': 'polyline', 'params': line[1:-1]}
        edges.append(edge)
    return {'vertices': vertices, 'edges': edges, 'translation': translation, 'rotation': rotation}


def larger(table, factor, sleeves_cm):
    """All lines so many times as large, and the cuffs so much further from the caps."""
    cuffs = {'cuff': (0, -1), 'underarm_front': (0,), 'underarm_back': (-1,)}
    for piece in ('front', 'back', 'sleeve'):
        for name, side in table[piece].items():
            if isinstance(side, dict) and 'points_mm' in side:
                side['points_mm'] = [[factor * x, factor * y] for x, y in side['points_mm']]
                for end in cuffs.get(name, ()) if piece == 'sleeve' else ():
                    side['points_mm'][end][1] += 10 * sleeves_cm


def opened(front):
    """The wearer's left and right half: hem, centre and neckline in place of those of both."""
    vertices, edges = front['vertices'], front['edges']

    def half(numbers, cut, shift_cm):
        lines = []
        for number in numbers:
            a, b = edges[number]['endpoints']
            line = [vertices[a], *edges[number].get('curvature', {}).get('params', []), vertices[b]]
            lines.append(cut(line) if number in (0, 4) else line)
        lines.append([lines[-1][-1], lines[0][0]])
        x, y, z = front['translation']
        return panel(lines, [x + shift_cm, y, z])

    left = half([0, 1, 2, 3, 4], lambda line: [(0, y) if abs(x) < 1e-9 else (x, y) for x, y in line if x > -1e-9], OPENING_CM)
    right = half([4, 5, 6, 7, 0], lambda line: [(x, y) for x, y in line if x < 1e-9], -OPENING_CM)
    return left, right


def trunk(table, piece, depth_cm):
    half = [line_of(table, f'{piece}.{side}') for side in ('hem', 'side_seam', 'armhole', 'shoulder_seam', 'neckline')]
    hem, side, armhole, shoulder, neckline = half
    sides = [mirrored(hem)[:-1] + hem, side, armhole, shoulder, neckline[:-1] + mirrored(neckline),
             mirrored(shoulder), mirrored(armhole), mirrored(side)]
    top = max(y for _, y in shoulder)
    return panel(sides, [0, NECK_POINT_CM - top, depth_cm]), max(x for x, _ in armhole), top


def sleeves(table, outermost_cm):
    """Front and back of a sleeve are one piece, which is rolled around the arm from above."""
    sides = [line_of(table, f'sleeve.{side}') for side in ('cuff', 'underarm_front', 'cap_front', 'cap_back', 'underarm_back')]
    top = max(y for line in sides for _, y in line)
    made = {}
    for name, sign in (('right', -1), ('left', 1)):
        lines = sides if sign < 0 else [mirrored(line) for line in (sides[0], *reversed(sides[1:]))]
        # It lies flat above the arm: its cap towards the neck, its front towards the front.
        made[name] = panel(lines, [sign * (outermost_cm + top), NECK_POINT_CM - 2, 0], [-90, 90 * sign, 0])
    return made


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument('outlines', type=argparse.FileType('rb'))
    parser.add_argument('--larger', type=float, default=1.0, help='so many times as large')
    parser.add_argument('--sleeves', type=float, default=0.0, metavar='CM', help='so much longer')
    parser.add_argument('--open', action='store_true', help='with a front that is open')
    given = parser.parse_args()
    table = tomllib.load(given.outlines)
    larger(table, given.larger, given.sleeves)
    front, outermost, _ = trunk(table, 'front', GAP_CM)
    back, _, _ = trunk(table, 'back', -GAP_CM)
    rolled = sleeves(table, outermost)
    panels = {'front': front, 'back': back, 'right_sleeve': rolled['right'], 'left_sleeve': rolled['left']}

    def stitch(a, a_edge, b, b_edge):
        return [{'panel': a, 'edge': a_edge}, {'panel': b, 'edge': b_edge}]

    # On the front and the back the wearer's left is at x > 0: edges 1 to 3; at x < 0 edges 7 to 5.
    stitches = [stitch('front', e, 'back', e) for e in (1, 3, 5, 7)]
    stitches += [stitch('left_sleeve', 2, 'back', 2), stitch('left_sleeve', 3, 'front', 2), stitch('left_sleeve', 1, 'left_sleeve', 4)]
    stitches += [stitch('right_sleeve', 2, 'front', 6), stitch('right_sleeve', 3, 'back', 6), stitch('right_sleeve', 1, 'right_sleeve', 4)]
    if given.open:
        panels['left_front'], panels['right_front'] = opened(panels.pop('front'))
        for side in (side for pair in stitches for side in pair if side['panel'] == 'front'):
            # The right half begins with the neckline.
            is_left = side['edge'] < 4
            side.update(panel='left_front' if is_left else 'right_front', edge=side['edge'] - (0 if is_left else 4))
    json.dump({'pattern': {'panels': panels, 'stitches': stitches},
               'properties': {'curvature_coords': 'absolute', 'units_in_meter': 100}}, sys.stdout, indent=1)


if __name__ == '__main__':
    main()
