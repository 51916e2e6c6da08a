"""Triangle meshes with named vertices, and how they are written."""

import math
import os
import tomllib
from dataclasses import dataclass, field


@dataclass
class Mesh:
    """Metres, y up. Triangles are counter-clockwise seen from outside, from above or from the front."""

    points: list
    triangles: list
    landmarks: dict = field(default_factory=dict)  # name: vertices, counted from 0

    def mapped(self, change):
        """`change` takes a point and returns where it goes."""
        return Mesh([change(point) for point in self.points], self.triangles, self.landmarks)

    def moved(self, x, y, z):
        return self.mapped(lambda p: (p[0] + x, p[1] + y, p[2] + z))

    def named(self, name):
        """The same with its landmark `pegs` alone, by this name."""
        return Mesh(self.points, self.triangles, {name: self.landmarks["pegs"]})

    def turned(self, degrees):
        """About the y axis, from z to x."""
        cosine, sine = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
        return self.mapped(lambda p: (cosine * p[0] + sine * p[2], p[1], cosine * p[2] - sine * p[0]))


def joined(*meshes):
    """All of them as one, in their order."""
    points, triangles, landmarks = [], [], {}
    for mesh in meshes:
        first = len(points)
        points += mesh.points
        triangles += [tuple(first + v for v in triangle) for triangle in mesh.triangles]
        for name, vertices in mesh.landmarks.items():
            if name in landmarks:
                raise ValueError(f"two meshes name the vertices '{name}'")
            landmarks[name] = [first + v for v in vertices]
    return Mesh(points, triangles, landmarks)


def quads_as_triangles(quads):
    """Both triangles of each quad (a, b, c, d), cut along a-c where its number is even, else along b-d."""
    triangles = []
    for number, (a, b, c, d) in quads:
        triangles += [(a, b, c), (a, c, d)] if number % 2 == 0 else [(a, b, d), (b, c, d)]
    return triangles


def numbered_as_used(mesh):
    """The same mesh with its vertices in the order in which triangles first use them, which importers that rebuild the
    list of vertices keep. Every vertex has to be used."""
    order = list(dict.fromkeys(v for triangle in mesh.triangles for v in triangle))
    number = {v: i for i, v in enumerate(order)}
    return Mesh([mesh.points[v] for v in order],
                [tuple(number[v] for v in triangle) for triangle in mesh.triangles],
                {name: [number[v] for v in vertices] for name, vertices in mesh.landmarks.items()})


def read_mesh(path):
    """A mesh of triangles that another of these tools wrote, with its landmarks."""
    points, triangles = [], []
    for line in path.read_text(encoding="utf-8").splitlines():
        kind, *values = line.split()
        if kind == "v":
            points.append(tuple(map(float, values)))
        elif kind == "f":
            triangles.append(tuple(int(value.split("/")[0]) - 1 for value in values))
    landmarks = tomllib.loads(path.with_suffix(".landmarks.toml").read_text(encoding="utf-8"))
    return Mesh(points, triangles, landmarks)


def write_text(path, text):
    """Writes all of it or nothing."""
    unfinished = path.with_name(path.name + ".part")
    unfinished.write_text(text, encoding="utf-8", newline="\n")
    os.replace(unfinished, path)


def write_mesh(path, mesh, title):
    """The mesh as OBJ in whole micrometres and, beside it, its landmarks."""
    # Rounded before it is printed, and freed of the sign of zero by the sum: no "-0.000000".
    lines = [f"# {title}, in metres, y up.", "# Made by make_contact_scenes.py."]
    lines += ["v {:.6f} {:.6f} {:.6f}".format(*(round(c, 6) + 0.0 for c in point)) for point in mesh.points]
    lines += ["f {} {} {}".format(*(v + 1 for v in triangle)) for triangle in mesh.triangles]
    write_text(path, "\n".join(lines) + "\n")
    if mesh.landmarks:
        lists = [f"{name} = {vertices}" for name, vertices in mesh.landmarks.items()]
        write_text(path.with_suffix(".landmarks.toml"),
                   "\n".join([f"# Vertices of {path.name}, counted from 0.", *lists]) + "\n")
