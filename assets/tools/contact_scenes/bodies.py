"""Closed bodies: solids of revolution, a plate with rounded edges, a bed of needles."""

import math

from mesh import Mesh, quads_as_triangles


def arc(centre, radius_m, from_degrees, to_degrees, pieces):
    """Points (r, y) of an arc of a circle, both ends included."""
    for k in range(pieces + 1):
        angle = math.radians(from_degrees + (to_degrees - from_degrees) * k / pieces)
        yield centre[0] + radius_m * math.cos(angle), centre[1] + radius_m * math.sin(angle)


def inner_points(start, end, pieces):
    """Points that cut the way from start to end into pieces, both ends left out."""
    for k in range(1, pieces):
        yield tuple(s + (e - s) * k / pieces for s, e in zip(start, end))


def ring_of_revolution(profile, around):
    """Turns a closed line of points (r, y), r > 0, about the y axis. The line goes counter-clockwise where r goes
    to the right."""
    count = len(profile)
    points = [(r * math.sin(2.0 * math.pi * k / around), y, r * math.cos(2.0 * math.pi * k / around))
              for k in range(around) for r, y in profile]
    quads = []
    for k in range(around):
        here, there = k * count, (k + 1) % around * count
        for i in range(count):
            j = (i + 1) % count
            quads.append((k + i, (here + i, there + i, there + j, here + j)))
    return Mesh(points, quads_as_triangles(quads))


def funnel():
    """A cone that opens to the top, of sheet metal 2 cm thick: its rim is 0.75 m from the axis, its top at y = 0, and a
    spout of 0.1 m inner radius leads down to y = -0.6. All that cloth slides over is round."""
    half, bend_radius, spout_radius = 0.01, 0.05, 0.10
    slope = 35.0
    rim, end = (0.75, -half), (spout_radius + half, -0.59)
    # The middle of the sheet metal touches a circle about the bend's centre and goes through the rim's.
    bend_r = spout_radius + bend_radius
    bend_y = rim[1] - ((bend_radius - half) / math.cos(math.radians(slope))
                       + (rim[0] - bend_r) * math.tan(math.radians(slope)))
    bend = (bend_r, bend_y)
    at_rim = list(arc(rim, half, slope - 90.0, slope + 90.0, 6))
    inside = list(arc(bend, bend_radius, slope + 90.0, 180.0, 5))
    at_end = list(arc(end, half, 180.0, 360.0, 6))
    outside = list(arc(bend, bend_radius - 2.0 * half, 180.0, slope + 90.0, 5))
    return ring_of_revolution([*at_rim, *inner_points(at_rim[-1], inside[0], 8), *inside,
                               *inner_points(inside[-1], at_end[0], 2), *at_end,
                               *inner_points(at_end[-1], outside[0], 2), *outside,
                               *inner_points(outside[-1], at_rim[0], 8)], 64)


def plate(half_sizes_m, radius_m, top_m):
    """A box with rounded edges about the y axis, its top at y = top_m."""
    pieces_of_bend, pieces_between = 3, 8
    ticks = []
    for half in half_sizes_m:
        flat = half - radius_m
        # Even angles about the bend's centre, half of the bend on this face.
        bend = [flat + radius_m * math.tan(math.radians(45.0 * k / pieces_of_bend))
                for k in range(1, pieces_of_bend + 1)]
        middle = [flat * (2.0 * k / pieces_between - 1.0) for k in range(pieces_between + 1)]
        ticks.append([-t for t in reversed(bend)] + middle + bend)
    return _box(ticks, lambda p: _rounded(p, half_sizes_m, radius_m)).moved(0.0, top_m - half_sizes_m[1], 0.0)


def _rounded(point, half_sizes_m, radius_m):
    """Where a point of the surface of a box goes when its edges are rounded."""
    inner = [max(radius_m - h, min(h - radius_m, c)) for c, h in zip(point, half_sizes_m)]
    away = [c - i for c, i in zip(point, inner)]
    return tuple(i + radius_m * a / math.hypot(*away) for i, a in zip(inner, away))


def _box(ticks, place):
    """The surface of a box with vertices at these coordinates along x, y and z, each moved by `place`."""
    number, points, quads = {}, [], []

    def vertex(*key):
        if key not in number:
            number[key] = len(points)
            points.append(place([ticks[axis][i] for axis, i in enumerate(key)]))
        return number[key]

    last = [len(t) - 1 for t in ticks]
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        for side in (0, last[axis]):
            for i in range(last[u]):
                for j in range(last[v]):
                    key = [0, 0, 0]
                    key[axis] = side
                    corners = []
                    for key[u], key[v] in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)):
                        corners.append(vertex(*key))
                    quads.append((i + j, corners if side else corners[::-1]))
    return Mesh(points, quads_as_triangles(quads))


# Counter-clockwise seen from above, from +z on.
AROUND = [(0, 1), (1, 1), (1, 0), (1, -1), (0, -1), (-1, -1), (-1, 0), (-1, 1)]


def needle_bed(needles=10, distance_m=0.1, height_m=0.08, foot_radius_m=0.004, plate_m=0.02):
    """Needles in rows, each a thin cone with its tip at y = 0, on a plate: one surface. Around each needle's foot
    the plate's top is a square with a hole, which shares corners and the middles of its sides with those beside it."""
    number, points, triangles = {}, [], []

    def vertex(i, y, j):
        """The plate's vertex at i, j halves of the distance between needles."""
        if (i, y, j) not in number:
            number[i, y, j] = len(points)
            points.append((0.5 * distance_m * (i - needles), y, 0.5 * distance_m * (j - needles)))
        return number[i, y, j]

    for i in range(1, 2 * needles, 2):
        for j in range(1, 2 * needles, 2):
            square = [vertex(i + di, -height_m, j + dj) for di, dj in AROUND]
            x, z = points[square[2]][0] - 0.5 * distance_m, points[square[2]][2]
            foot, tip = len(points), len(points) + 8
            reach = [foot_radius_m / math.hypot(*direction) for direction in AROUND]
            points += [(x + r * di, -height_m, z + r * dj) for r, (di, dj) in zip(reach, AROUND)]
            points.append((x, 0.0, z))
            for k in range(8):
                n = (k + 1) % 8
                triangles += [(square[k], square[n], foot + n), (square[k], foot + n, foot + k),
                              (foot + k, foot + n, tip)]
    triangles += _sides_and_underside(vertex, 2 * needles, -height_m, -height_m - plate_m)
    return Mesh(points, triangles)


def _sides_and_underside(vertex, last, top, bottom):
    """Triangles of a plate whose top has vertices all around its border, at whole numbers from 0 to last."""
    border = ([(0, k) for k in range(last)] + [(k, last) for k in range(last)]
              + [(last, last - k) for k in range(last)] + [(last - k, 0) for k in range(last)])
    middle = vertex(last // 2, bottom, last // 2)
    for (i, j), (m, n) in zip(border, border[1:] + border[:1]):
        a, b, c, d = vertex(i, top, j), vertex(m, top, n), vertex(i, bottom, j), vertex(m, bottom, n)
        yield from ((a, c, d), (a, d, b), (c, middle, d))
