"""How far written positions stretch a cloth, by nothing but files: shares no code with the program."""

import math
import statistics
from dataclasses import dataclass, field

# Of lengths that are computed here and there from the same decimals.
ROUNDING = 1e-11

# What is said of the stretches of a cloth's edges.
MEASURES = {
    "max_stretch": max,
    "p99_stretch": lambda stretches: sorted(stretches)[math.ceil(0.99 * len(stretches)) - 1],
    "mean_stretch": statistics.fmean,
    "max_compression": lambda stretches: max(0.0, -min(stretches)),
}


class Cloth:
    """Faces of an input model and the rest lengths of their edges in metres."""

    def __init__(self, points, faces, metres_per_unit=1.0):
        self.points, self.faces = points, faces
        first_at = {}
        welded = [first_at.setdefault(point, i) for i, point in enumerate(points)]
        corners = [[welded[i] for i in face] for face in faces]
        edges = {(min(a, b), max(a, b)) for face in corners for a, b in zip(face, face[1:] + face[:1])}
        self.edges = [(a, b, metres_per_unit * math.dist(points[a], points[b])) for a, b in sorted(edges)]
        self._places = (None, None)

    def stretches(self, points, faces):
        """Of every edge in written positions, in metres. Faces have to be the input's in the same order; vertices may be
        numbered anew and welded where the input has them at one place."""
        if self._places[0] != faces:
            self._places = (faces, self._places_in(faces))
        place = self._places[1]
        for point in points:
            if not all(map(math.isfinite, point)):
                raise ValueError(f"a vertex is at {point}")
        return [math.dist(points[place[a]], points[place[b]]) / rest - 1.0 for a, b, rest in self.edges]

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
        """What a record of the program says, by the names of the measures."""
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


def complaints(shape):
    """What does not hold of a shape, one text each."""
    try:
        stretches = shape.cloth.stretches(shape.points, shape.faces)
    except (ValueError, IndexError) as error:
        return [f"{shape.where}: {error}"]
    found = []
    for said in shape.printed:
        number = MEASURES[said.measure](stretches)
        if not abs(number - said.number) <= said.half_a_digit + ROUNDING:
            found.append(f"{shape.where}: {said.measure} is {100 * number:.7f} %, "
                         f"but {said.where} says {100 * said.number:.7f} %")
    if not any(said.measure == "max_stretch" for said in shape.printed):
        found.append(f"{shape.where}: nothing is said about its stretch")
    if shape.bound is not None and not max(stretches) <= shape.bound + ROUNDING:
        found.append(f"{shape.where}: stretched by {100 * max(stretches):.7f} %, more than {100 * shape.bound:g} %")
    return found
