"""Small models, made anew by every run: a Shape is points and faces, and what is wrong with it is on purpose."""
import math
import random


class Shape:
    def __init__(self, points, faces, lines=(), lone_points=()):
        self.points = [tuple(map(float, p)) for p in points]
        self.faces = [tuple(f) for f in faces]
        self.lines = list(lines)
        self.lone_points = list(lone_points)

    def mapped(self, change):
        return Shape([change(*p) for p in self.points], self.faces, self.lines, self.lone_points)

    def scaled(self, factor):
        return self.mapped(lambda x, y, z: (factor * x, factor * y, factor * z))

    def moved(self, dx, dy, dz):
        return self.mapped(lambda x, y, z: (x + dx, y + dy, z + dz))

    def with_faces(self, faces):
        return Shape(self.points, faces, self.lines, self.lone_points)

    def with_z_up(self):
        return self.mapped(lambda x, y, z: (x, -z, y))

    def soup(self):
        """Every face with points of its own, as STL has them and FBX often does."""
        points, faces = [], []
        for face in self.faces:
            faces.append(tuple(range(len(points), len(points) + len(face))))
            points += [self.points[v] for v in face]
        return Shape(points, faces)


def joined(*shapes):
    points, faces = [], []
    for shape in shapes:
        faces += [tuple(v + len(points) for v in face) for face in shape.faces]
        points += shape.points
    return Shape(points, faces)


def triangle():
    return Shape([(0, 1, 0), (-0.4, 0, 0), (0.4, 0, 0)], [(0, 1, 2)])


def two_triangles():
    return Shape([(0, 0, 0), (0.6, 0, 0), (0.6, 0.8, 0), (0, 0.8, 0)], [(0, 1, 2), (0, 2, 3)])


def sheet(columns=6, rows=8, width=0.6, height=0.8, quads=True):
    points = [(width * (c / (columns - 1) - 0.5), height * r / (rows - 1), 0.0)
              for r in range(rows) for c in range(columns)]
    faces = []
    for r in range(rows - 1):
        for c in range(columns - 1):
            a = r * columns + c
            quad = (a, a + 1, a + columns + 1, a + columns)
            faces += [quad] if quads else [quad[:3], (quad[0], quad[2], quad[3])]
    return Shape(points, faces)


def tube(around=12, rows=6, radius=0.2, height=0.7, flare=0.0, closed=False):
    points, faces = [], []
    for r in range(rows):
        reach = radius + flare * (1 - r / (rows - 1))
        for k in range(around):
            angle = 2 * math.pi * k / around
            points.append((reach * math.cos(angle), height * r / (rows - 1), -reach * math.sin(angle)))
    for r in range(rows - 1):
        for k in range(around):
            a, b = r * around + k, r * around + (k + 1) % around
            faces.append((a, b, b + around, a + around))
    if closed:
        faces.append(tuple(reversed(range(around))))
        faces.append(tuple(range((rows - 1) * around, rows * around)))
    return Shape(points, faces)


def shell(thickness=0.004, **size):
    """A tube with an inner and an outer side, joined at both rims: cloth modelled with a thickness."""
    outer, around, rows = tube(**size), 12, 6
    inner = outer.mapped(lambda x, y, z: (x * (1 - 5 * thickness), y, z * (1 - 5 * thickness)))
    count = len(outer.points)
    faces = list(outer.faces) + [tuple(reversed([v + count for v in f])) for f in inner.faces]
    for k in range(around):
        n = (k + 1) % around
        faces.append((n, k, k + count, n + count))
        a, b = (rows - 1) * around + k, (rows - 1) * around + n
        faces.append((a, b, b + count, a + count))
    return Shape(outer.points + inner.points, faces)


def star(tips=9):
    points = []
    for k in range(2 * tips):
        angle, reach = math.pi * k / tips, 0.5 if k % 2 == 0 else 0.15
        points.append((reach * math.sin(angle), 0.5 + reach * math.cos(angle), 0.0))
    return Shape(points, [tuple(reversed(range(2 * tips)))])


def moebius(around=24):
    points, faces = [], []
    for k in range(around):
        angle = 2 * math.pi * k / around
        for side in (-0.1, 0.1):
            reach = 0.4 + side * math.cos(angle / 2)
            points.append((reach * math.cos(angle), side * math.sin(angle / 2) + 0.5, reach * math.sin(angle)))
    for k in range(around - 1):
        faces.append((2 * k, 2 * k + 1, 2 * k + 3, 2 * k + 2))
    faces.append((2 * around - 2, 2 * around - 1, 0, 1))
    return Shape(points, faces)


def fin():
    """Three triangles at one edge."""
    return Shape([(0, 1, 0), (0, 0, 0), (0.5, 0.5, 0), (-0.5, 0.5, 0), (0, 0.5, 0.5)], [(0, 1, 2), (0, 3, 1), (0, 1, 4)])


def touching_layers():
    """Two tents whose tops touch in a point; each has points of its own."""
    tent = Shape([(0, 0.5, 0), (0.4, 0, 0), (0, 0, -0.4), (-0.4, 0, 0), (0, 0, 0.4)],
                 [(0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 1)])
    return joined(tent, tent.mapped(lambda x, y, z: (x, 1 - y, z)))


def turned_some(shape, every=5):
    return shape.with_faces([tuple(reversed(f)) if k % every == 0 else f for k, f in enumerate(shape.faces)])


def needles():
    """A strip whose triangles are a thousand times as long as wide."""
    points = [(0.5 * side, 0.9 - 0.0005 * k, 0.0) for k in range(20) for side in (-1, 1)]
    faces = [(2 * k, 2 * k + 2, 2 * k + 1) for k in range(19)] + [(2 * k + 1, 2 * k + 2, 2 * k + 3) for k in range(19)]
    return Shape(points, faces)


def hung_by_a_thread(links=40, width=1e-5, length=0.4):
    """A cloth below a string of needles that weighs a hundred-millionth of it."""
    string, faces = [(0, 0.5, 0), (width, 0.5, 0)], []
    for k in range(1, links + 1):
        string += [(0, 0.5 - length * k / links, 0), (width, 0.5 - length * k / links, 0)]
        faces += [(2 * k - 2, 2 * k, 2 * k - 1), (2 * k - 1, 2 * k, 2 * k + 1)]
    cloth = sheet(5, 5).moved(0, 0.499 - length - 0.8, 0)
    top = max(range(len(cloth.points)), key=lambda v: (cloth.points[v][1], -abs(cloth.points[v][0])))
    both = joined(Shape(string, faces), cloth)
    return both.with_faces(both.faces + [(2 * links, len(string) + top, 2 * links + 1)])


def crumpled(seed=7):
    chance = random.Random(seed)
    return sheet(12, 12).mapped(lambda x, y, z: (x, y, 0.03 * chance.uniform(-1, 1)))
