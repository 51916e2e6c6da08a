"""Cloth that begins in the shape it has at rest: sheets, stacks of them, a tube."""

import math
import random

from mesh import Mesh, joined, quads_as_triangles

# How far inner vertices are moved at random, in parts of a cell. Layers of one pattern would lie vertex on vertex and
# edge on edge, and a load that is symmetric would never choose where to fold.
JITTER = 0.12


def lattice(columns, rows, seed):
    """Places (c, r) in a grid, row by row: those on its border as they are, the others a little off."""
    chance = random.Random(seed)
    for r in range(rows):
        for c in range(columns):
            across, down = (JITTER * (2.0 * chance.random() - 1.0) for _ in range(2))
            is_inside = 0 < r < rows - 1 and 0 < c < columns - 1
            yield (c + across, r + down) if is_inside else (c, r)


def sheet(columns, rows, width_m, depth_m, seed):
    """A level sheet about the origin. Vertex r * columns + c is in row r, counted from the smallest z, and in column c,
    counted from the smallest x."""
    points = [(width_m * (c / (columns - 1) - 0.5), 0.0, depth_m * (r / (rows - 1) - 0.5))
              for c, r in lattice(columns, rows, seed)]
    corners = [(r + c, r * columns + c) for r in range(rows - 1) for c in range(columns - 1)]
    return Mesh(points, quads_as_triangles((k, (a, a + columns, a + columns + 1, a + 1)) for k, a in corners))


def stack(count, vertices_a_side, side_m, lowest_m, distance_m, turn_degrees, first_seed=1):
    """Square sheets, one above the other, each turned further than the one below by a little more than the last."""
    return joined(*(sheet(vertices_a_side, vertices_a_side, side_m, side_m, first_seed + k)
                    .turned(turn_degrees * k * (1.0 + 0.1 * k)).moved(0.0, lowest_m + k * distance_m, 0.0)
                    for k in range(count)))


def tube(around, rows, radius_m, length_m, seed):
    """About the x axis, outside out; `left_end` and `right_end` are its borders, the left with the smaller x.
    `around` is even, so that the diagonals alternate across the place where it closes too."""
    chance = random.Random(seed)
    points = []
    for r in range(rows):
        for k in range(around):
            along, about = (JITTER * (2.0 * chance.random() - 1.0) if 0 < r < rows - 1 else 0.0 for _ in range(2))
            angle = 2.0 * math.pi * (k + about) / around
            points.append((length_m * ((r + along) / (rows - 1) - 0.5),
                           radius_m * math.cos(angle), radius_m * math.sin(angle)))
    quads = []
    for r in range(rows - 1):
        for k in range(around):
            a, b = r * around + k, r * around + (k + 1) % around
            quads.append((r + k, (a, b, b + around, a + around)))
    last = (rows - 1) * around
    return Mesh(points, quads_as_triangles(quads),
                {"left_end": list(range(around)), "right_end": list(range(last, last + around))})


def table_cloth():
    """A cloth, held along `pulled_edge`, with two stacks of three napkins on it."""
    columns, rows = 81, 67
    cloth = sheet(columns, rows, 1.2, 1.0, seed=11)
    # Not to its corners: they hang down.
    cloth.landmarks["pulled_edge"] = [r * columns for r in range(rows // 5, rows - rows // 5)]
    napkins = (stack(3, 20, 0.2, 0.003, 0.003, 7.0, seed).turned(turn).moved(x, 0.0, z)
               for seed, turn, x, z in ((21, 20.0, 0.02, -0.17), (31, -35.0, 0.07, 0.16)))
    return joined(cloth, *napkins).moved(0.0, 0.0015, 0.0)


def cloth_on_needles():
    """A sheet just above y = 0, held along `pulled_edge`."""
    vertices_a_side = 72
    cloth = sheet(vertices_a_side, vertices_a_side, 1.0, 1.0, seed=41)
    cloth.landmarks["pulled_edge"] = [r * vertices_a_side for r in range(vertices_a_side)]
    return cloth.moved(0.0, 0.002, 0.0)
