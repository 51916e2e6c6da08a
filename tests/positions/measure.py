"""How far written positions stretch a cloth, by nothing but files: shares no code with the program."""

import math
import statistics
from dataclasses import dataclass, field

# Of lengths that are computed here and there from the same numbers. Written positions have all digits of a double: what
# is left is the rounding of sums and roots, some 1e-15 of a length.
ROUNDING = 1e-11

# Below this height, in parts of its longest edge, a triangle is a needle: held and measured by its edges only.
THINNEST = 1e-3

# Squared edges are right to some 5e-16 of the longest. Areas are differences of their products, and divide that by the
# square of the smallest height as a part of the longest edge: 5e-10 in the thinnest triangle that is no needle.
SURFACE_ROUNDING = 1e-9


def nearest_rank_99(values):
    return sorted(values)[math.ceil(0.99 * len(values)) - 1]


# The words for the stretches of a cloth.
MEASURES = {
    "max_stretch": lambda of: max(of.structural),
    "p99_stretch": lambda of: nearest_rank_99(of.structural),
    "mean_stretch": lambda of: statistics.fmean(of.structural),
    "max_compression": lambda of: max(0.0, -min(of.structural)),
    "max_surface_stretch": lambda of: max(of.surface, default=0.0),
    "p99_surface_stretch": lambda of: nearest_rank_99(of.surface or [0.0]),
}


@dataclass
class Stretches:
    """Lengths now / lengths at rest - 1."""

    structural: list  # sides of faces
    shear: list  # both diagonals of grid cells
    surface: list  # of each triangle that is no needle, along the direction that is longest

    def over(self, bound, kind):
        """Returns what exceeds a bound of this kind, one text for springs and one for triangles."""
        springs, found = max(self.structural + self.shear), []
        if not springs <= bound + ROUNDING:
            found.append(f"a spring is stretched by {100 * springs:.7f} %, more than {100 * bound:g} %")
        triangles = max(self.surface, default=0.0)
        if kind == "surface" and not triangles <= bound + SURFACE_ROUNDING:
            found.append(f"a triangle is stretched by {100 * triangles:.7f} %, more than {100 * bound:g} %")
        return found


def metric(first, second, across):
    """First fundamental form E, F, G of a triangle by the lengths of its sides: two from one corner, one across."""
    return first * first, (first * first + second * second - across * across) / 2.0, second * second


def determinant(e, f, g):
    """Of a metric: the square of twice the area."""
    return e * g - f * f


def largest_stretch(rest, now):
    """Between two metrics of a triangle: the square root of the larger root of det(now - x rest) = 0, minus 1.

    With l, m, n for the metric now the roots are (t +- sqrt(t^2 - 4 det(rest) det(now))) / (2 det(rest)) where
    t = E n - 2 F m + G l. The number under the root cancels where the roots are alike. It equals r^2 - 4 p q of
    r = E n - G l, p = E m - F l, q = F n - G m (so do the equations of principal curvatures), and with
    E q = F r - G p the sum of the squares of r - 2 p F / E and 2 p sqrt(det(rest)) / E, which does not."""
    e, f, g = rest
    l, m, n = now
    det = determinant(e, f, g)
    p, r = e * m - f * l, e * n - g * l
    root = math.hypot(r - 2.0 * p * f / e, 2.0 * p * math.sqrt(det) / e)
    return math.sqrt((e * n - 2.0 * f * m + g * l + root) / (2.0 * det)) - 1.0


def ends(a, b):
    return (a, b) if a < b else (b, a)


class Cloth:
    """Faces of an input model and the lengths of its springs at rest, in metres. Faces are triangles or, in a grid,
    cells of four corners; a cell's triangles are its corners 0, 1, 2 and 0, 2, 3."""

    def __init__(self, points, faces, metres_per_unit=1.0):
        self.points, self.faces = points, faces
        first_at = {}
        welded = [first_at.setdefault(point, i) for i, point in enumerate(points)]
        corners = [[welded[i] for i in face] for face in faces]
        structural = {ends(a, b) for face in corners for a, b in zip(face, face[1:] + face[:1])}
        shear = {ends(a, b) for face in corners if len(face) == 4 for a, b in zip(face, face[2:])}
        self.springs = [(a, b, metres_per_unit * math.dist(points[a], points[b]))
                        for a, b in (*sorted(structural), *sorted(shear))]
        self.structural_count = len(structural)
        triangles = [(face[0], *face[i:i + 2]) for face in corners for i in range(1, len(face) - 1)]
        self._triangles = list(self._with_a_surface(triangles))
        self.needles = len(triangles) - len(self._triangles)
        self._places = (None, None)

    def _with_a_surface(self, triangles):
        """Of triangles that are no needles: numbers of their sides as `metric` takes them, and their metric at rest."""
        number = {(a, b): i for i, (a, b, _) in enumerate(self.springs)}
        for a, b, c in triangles:
            sides = number[ends(a, b)], number[ends(a, c)], number[ends(b, c)]
            rest = [self.springs[i][2] for i in sides]
            if determinant(*metric(*rest)) >= (THINNEST * max(rest) ** 2) ** 2:
                yield sides, metric(*rest)

    def stretches(self, points, faces):
        """In written positions, in metres. Faces have to be the input's in the same order; vertices may be numbered
        anew and welded where the input has them at one place."""
        if self._places[0] != faces:
            self._places = (faces, self._places_in(faces))
        place = self._places[1]
        for point in points:
            if not all(map(math.isfinite, point)):
                raise ValueError(f"a vertex is at {point}")
        lengths = [math.dist(points[place[a]], points[place[b]]) for a, b, _ in self.springs]
        springs = [length / rest - 1.0 for length, (_, _, rest) in zip(lengths, self.springs)]
        surface = [largest_stretch(rest, metric(lengths[i], lengths[j], lengths[k]))
                   for (i, j, k), rest in self._triangles]
        return Stretches(springs[:self.structural_count], springs[self.structural_count:], surface)

    def _places_in(self, faces):
        if len(faces) != len(self.faces):
            raise ValueError(f"found {len(faces)} faces, expected {len(self.faces)}")
        place, origin = {}, {}
        for mine, written in zip(self.faces, faces):
            if len(mine) != len(written):
                raise ValueError(f"found the face {written}, expected {len(mine)} corners")
            for a, b in zip(mine, written):
                if place.setdefault(a, b) != b or origin.setdefault(b, self.points[a]) != self.points[a]:
                    raise ValueError(f"the face {written} joins other vertices than that of the input")
        return place


def read_obj(path):
    """Points and faces, numbered from 0."""
    points, faces = [], []
    with open(path, encoding="utf-8") as lines:
        for line in lines:
            kind, *words = line.split() or [""]
            if kind == "v":
                points.append(tuple(map(float, words[:3])))
            elif kind == "f":
                faces.append([int(word.split("/")[0]) - 1 for word in words])
    return points, faces


def grid(columns, rows, width_m, height_m):
    """The quads of a regular cloth; vertex of row r and column c is r * columns + c."""
    points = [(width_m * c / (columns - 1), height_m * r / (rows - 1), 0.0)
              for r in range(rows) for c in range(columns)]
    corners = [r * columns + c for r in range(rows - 1) for c in range(columns - 1)]
    return points, [[i, i + columns, i + columns + 1, i + 1] for i in corners]


@dataclass
class Printed:
    """A number as the program says it."""

    where: str
    number: float
    measure: str = "max_stretch"
    half_a_digit: float = 0.0

    @classmethod
    def percent(cls, where, text, measure="max_stretch"):
        decimals = len(text.partition(".")[2])
        return cls(where, float(text) / 100.0, measure, 0.5 * 10.0 ** (-decimals - 2))

    @classmethod
    def all_of(cls, where, record):
        """Returns what a record of the program says, by the names of the measures."""
        return [cls(where, float(record[name]), name) for name in MEASURES if name in record]


@dataclass
class Shape:
    """Positions that left the program, and what is said about them."""

    where: str
    cloth: Cloth
    points: list
    faces: list
    printed: list = field(default_factory=list)
    bound: float | None = None
    bound_kind: str = "springs"  # or "surface", as solver.bound has it


def complaints(shape):
    """Returns what does not hold of a shape, one text each."""
    try:
        stretches = shape.cloth.stretches(shape.points, shape.faces)
    except (ValueError, IndexError) as error:
        return [f"{shape.where}: {error}"]
    found = []
    for said in shape.printed:
        number = MEASURES[said.measure](stretches)
        rounding = SURFACE_ROUNDING if "surface" in said.measure else ROUNDING
        if not abs(number - said.number) <= said.half_a_digit + rounding:
            found.append(f"{shape.where}: {said.measure} is {100 * number:.7f} %, "
                         f"but {said.where} says {100 * said.number:.7f} %")
    if not any(said.measure == "max_stretch" for said in shape.printed):
        found.append(f"{shape.where}: nothing is said about its stretch")
    if shape.bound is not None:
        found += [f"{shape.where}: {over}" for over in stretches.over(shape.bound, shape.bound_kind)]
    return found
