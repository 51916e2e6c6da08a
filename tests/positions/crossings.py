"""Which triangles of written positions cross each other, by nothing but files: shares no code with the program.

Exact: positions are doubles, which are whole multiples of one power of two, and Python's whole numbers have any
length. Convex sets have no common point if and only if one of finitely many axes separates them."""

from collections import defaultdict
from itertools import combinations


def minus(a, b):
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def cross(a, b):
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def whole_numbers(points):
    """The points as multiples of the largest power of two of which all coordinates are multiples."""
    ratios = [[x.as_integer_ratio() for x in point] for point in points]
    finest = max(d for point in ratios for _, d in point)
    return [tuple(n * (finest // d) for n, d in point) for point in ratios]


def normal(t):
    return cross(minus(t[1], t[0]), minus(t[2], t[0]))


def axes(a, b):
    """Of two triangles, or a segment and a triangle: normals, what is at right angles to a side of each, and what
    separates them within one plane."""
    normals = [normal(t) for t in (a, b) if len(t) == 3]
    yield from normals
    sides = [[minus(q, p) for p, q in combinations(t, 2)] for t in (a, b)]
    for s in sides[0]:
        for t in sides[1]:
            yield cross(s, t)
    for s in sides[0] + sides[1]:
        yield cross(normals[0], s)


def apart(a, b):
    for axis in axes(a, b):
        of_a, of_b = [dot(axis, p) for p in a], [dot(axis, p) for p in b]
        if max(of_a) < min(of_b) or max(of_b) < min(of_a):
            return True
    return False


def do_cross(points, a, b):
    """Of two triangles with an area, as indices of points: whether they have more in common than what they share."""
    shared = [v for v in a if v in b]
    if not shared:
        return not apart([points[v] for v in a], [points[v] for v in b])
    own_a, own_b = ([points[v] for v in t if v not in shared] for t in (a, b))
    at = points[shared[0]]
    if len(shared) == 1:
        return not (apart(own_a, [at, *own_b]) and apart(own_b, [at, *own_a]))
    if len(shared) == 3:
        return True
    sides = [cross(minus(points[shared[1]], at), minus(own[0], at)) for own in (own_a, own_b)]
    return cross(*sides) == (0, 0, 0) and dot(*sides) > 0


def neighbours(points, triangles):
    """Pairs of triangles whose bounding boxes share a cell of a grid as wide as the mean box."""
    boxes = [[(min(axis), max(axis)) for axis in zip(*(points[v] for v in t))] for t in triangles]
    width = 1 + sum(high - low for box in boxes for low, high in box) // (3 * len(boxes))
    cells = defaultdict(list)
    for t, box in enumerate(boxes):
        x, y, z = (range(low // width, high // width + 1) for low, high in box)
        for cell in ((i, j, k) for i in x for j in y for k in z):
            cells[cell].append(t)
    return {pair for cell in cells.values() for pair in combinations(cell, 2)
            if all(p[0] <= q[1] and q[0] <= p[1] for p, q in zip(boxes[pair[0]], boxes[pair[1]]))}


def crossing_pairs(points, faces):
    """Ordered pairs of triangles, numbered from 0; a face of four corners is the two that its first diagonal makes."""
    points = whole_numbers(points)
    triangles = [(face[0], *face[i:i + 2]) for face in faces for i in range(1, len(face) - 1)]
    for number, t in enumerate(triangles):
        if normal([points[v] for v in t]) == (0, 0, 0):
            raise ValueError(f"triangle {number} has no area")
    return sorted((a, b) for a, b in neighbours(points, triangles) if do_cross(points, triangles[a], triangles[b]))
