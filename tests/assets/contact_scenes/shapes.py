"""Reads meshes from OBJ files, and what can be said of them."""

import itertools
import math
from collections import Counter, defaultdict
from dataclasses import dataclass
from decimal import Decimal

from crossings import crossing_pairs

MICROMETRES = 1000000


@dataclass
class Shape:
    points: list  # whole micrometres
    triangles: list  # vertices counted from 0

    def parts(self):
        """Triangles of each connected part, the part of vertex 0 first."""
        leader = list(range(len(self.points)))

        def find(v):
            while leader[v] != v:
                leader[v] = v = leader[leader[v]]
            return v

        for a, b, c in self.triangles:
            leader[find(b)] = find(a)
            leader[find(c)] = find(a)
        parts = defaultdict(list)
        for triangle in self.triangles:
            parts[find(triangle[0])].append(triangle)
        return list(parts.values())

    def edges(self):
        """How many triangles go along each edge from its first vertex to its second."""
        return Counter((t[k], t[(k + 1) % 3]) for t in self.triangles for k in range(3))

    def edge_lengths_m(self):
        return [math.dist(self.points[a], self.points[b]) / MICROMETRES
                for a, b in {tuple(sorted(edge)) for edge in self.edges()}]


def read_shape(path):
    shape = Shape([], [])
    for line in path.read_text(encoding="utf-8").splitlines():
        kind, *words = line.split()
        if kind == "v":
            shape.points.append(tuple(whole_micrometres(word) for word in words))
        elif kind == "f":
            shape.triangles.append(tuple(int(word) - 1 for word in words))
    return shape


def whole_micrometres(word):
    number = Decimal(word) * MICROMETRES
    if number != int(number):
        raise ValueError(f"found {word}, expected six decimals at most")
    return int(number)


def crossings_with(body, cloth):
    """Pairs of triangles, of cloth and body, that have a point in common."""
    first = len(cloth.points)
    moved = [tuple(first + v for v in triangle) for triangle in body.triangles]
    return crossing_pairs(cloth.points + body.points, cloth.triangles, moved)


def turns_around(body, point):
    """How often a closed surface goes around a point that is not on it: the sum of its triangles' solid angles (A. van
    Oosterom and J. Strackee 1983) in parts of the whole."""
    total = 0.0
    for triangle in body.triangles:
        a, b, c = ([p - q for p, q in zip(body.points[v], point)] for v in triangle)
        la, lb, lc = math.hypot(*a), math.hypot(*b), math.hypot(*c)
        ab, bc, ca = (sum(p * q for p, q in zip(u, v)) for u, v in ((a, b), (b, c), (c, a)))
        volume = (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2])
                  + a[2] * (b[0] * c[1] - b[1] * c[0]))
        total += math.atan2(volume, la * lb * lc + ab * lc + bc * la + ca * lb)
    return total / (2.0 * math.pi)


def stretches(rest, now):
    """Of two Shapes of the same triangles: largest and smallest singular value of the deformation of each, minus 1.
    Their squares are the roots x of det(G - x R) = 0 for the metrics G now and R at rest."""
    for triangle in rest.triangles:
        (e, f, g), (l, m, n) = (metric(*(shape.points[v] for v in triangle)) for shape in (rest, now))
        determinant, trace = e * g - f * f, e * n - 2 * f * m + g * l
        # All whole numbers so far: nothing cancels.
        root = math.sqrt(trace * trace - 4 * determinant * (l * n - m * m))
        yield tuple(math.sqrt((trace + sign * root) / (2 * determinant)) - 1.0 for sign in (1, -1))


def metric(a, b, c):
    """First fundamental form E, F, G by two sides from the corner a."""
    u, v = ([q - p for p, q in zip(a, corner)] for corner in (b, c))
    return tuple(sum(p * q for p, q in zip(s, t)) for s, t in ((u, u), (u, v), (v, v)))


def closest_vertices_m(points, are_compared):
    """The smallest distance in metres between two vertices that `are_compared`, if it is below 40 mm, else infinity."""
    cell, cells, smallest = 40000, defaultdict(list), math.inf
    for v, point in enumerate(points):
        key = tuple(c // cell for c in point)
        for offset in itertools.product((-1, 0, 1), repeat=3):
            for w in cells.get(tuple(map(sum, zip(key, offset))), ()):
                if are_compared(v, w):
                    smallest = min(smallest, math.dist(point, points[w]))
        cells[key].append(v)
    return smallest / MICROMETRES
