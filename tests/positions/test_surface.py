"""Triangles whose deformation is known, and the two kinds of bounds."""

import itertools
import math
import pathlib
import tempfile
import unittest

from measure import (ROUNDING, SURFACE_ROUNDING, Cloth, Printed, Shape, complaints, grid, largest_stretch, metric,
                     read_obj)


def mapped(gradient, points):
    """Points of the plane by a matrix of three rows and two columns."""
    return [tuple(row[0] * x + row[1] * y for row in gradient) for x, y, *_ in points]


def gradient_of(largest, smallest, along_rad, out_rad):
    """Lengths along a direction of the plane grow `largest` times and those across it `smallest` times; then the plane
    is turned about its first axis."""
    c, s, out = math.cos(along_rad), math.sin(along_rad), (math.cos(out_rad), math.sin(out_rad))
    a, b, d = largest * c * c + smallest * s * s, (largest - smallest) * c * s, largest * s * s + smallest * c * c
    return (a, b), (b * out[0], d * out[0]), (b * out[1], d * out[1])


def metric_of(points):
    return metric(math.dist(*points[:2]), math.dist(*points[::2]), math.dist(*points[1:]))


class Surfaces(unittest.TestCase):
    def test_triangles_of_known_singular_values(self):
        # Right, obtuse, long, and all but needles with the longest edge at every place.
        triangles = [[(0, 0), (1, 0), (0, 1)], [(1, 1), (1.02, 1), (0.97, 1.01)], [(0, 0), (40, 0), (1, 1)]]
        thin = [(0, 0), (1, 0), (0.3, 1.001e-3)]
        triangles += [thin, thin[1:] + thin[:1], thin[2:] + thin[:2]]
        values = [(1, 1), (1.01, 1), (1.01, 0.4), (1.35, 0.97), (1.2, 1.2), (3, 0), (0.9, 0.3)]
        for triangle, (largest, smallest), along, out in itertools.product(
                triangles, values, (0, 0.3, math.pi / 4, 2), (0, 1.1)):
            now = mapped(gradient_of(largest, smallest, along, out), triangle)
            self.assertAlmostEqual(largest_stretch(metric_of(triangle), metric_of(now)), largest - 1.0,
                                   delta=SURFACE_ROUNDING)

    def test_a_needle_has_edges_only(self):
        for height, needles in ((0.99e-3, 1), (1.01e-3, 0)):
            for first in range(3):
                points = [(0.0, 0.0, 0.0), (2.0, 0.0, 0.0), (0.9, 2.0 * height, 0.0)]
                cloth = Cloth(points, [[first, (first + 1) % 3, (first + 2) % 3]])
                points[2] = (0.9, 3.0 * height, 0.0)
                found = cloth.stretches(points, cloth.faces)
                self.assertEqual((cloth.needles, len(found.surface), len(found.structural)), (needles, 1 - needles, 3))
                self.assertTrue(all(stretch > 0.4 for stretch in found.surface), found.surface)

    def test_which_triangles_a_cell_has(self):
        points, faces = grid(2, 2, 1.0, 1.0)
        for corner, untouched in ((1, 1), (3, 0)):
            written = list(points)
            written[faces[0][corner]] = (0.7, 0.6, 0.9)
            surface = Cloth(points, faces).stretches(written, faces).surface
            self.assertAlmostEqual(surface[untouched], 0.0, delta=ROUNDING)
            self.assertGreater(surface[1 - untouched], 0.1)

    def test_both_diagonals_of_a_cell_are_springs(self):
        # A cell that becomes a rhombus: its sides stay, one diagonal grows.
        points, faces = grid(2, 2, 1.0, 1.0)
        for sine in (0.05, -0.05):
            written = mapped(((1, sine), (0, math.sqrt(1 - sine * sine)), (0, 0)), points)
            shape = Shape("made up", Cloth(points, faces), written, faces, [Printed("beside it", 0.0)], 0.02)
            self.assertEqual(complaints(shape), ["made up: a spring is stretched by 2.4695077 %, more than 2 %"])
            shape.bound = 0.025
            self.assertEqual(complaints(shape), [])

    def test_springs_that_are_held_do_not_hold_triangles(self):
        # Sides of 1.03 and 0.9 and a diagonal of 1.41: a triangle that is 1.05 times as long along its third direction.
        points, faces = grid(2, 2, 1.0, 1.0)
        written = mapped(((1.03, 0.12 / 1.03), (0, math.sqrt(0.81 - (0.12 / 1.03) ** 2)), (0, 0)), points)
        shape = Shape("made up", Cloth(points, faces), written, faces, [Printed("beside it", 0.03)], 0.03)
        self.assertEqual(complaints(shape), [])
        shape.bound_kind = "surface"
        largest = math.sqrt((1.0609 + 0.81) / 2 + math.hypot((1.0609 - 0.81) / 2, 0.12)) - 1.0
        self.assertEqual(complaints(shape),
                         [f"made up: a triangle is stretched by {100 * largest:.7f} %, more than 3 %"])

    def test_rolled_up_cloth_keeps_the_bound(self):
        # In files, as the program writes them. Chords are shorter than arcs: nothing is longer than the sheet was.
        points, faces = grid(9, 9, 1.0, 1.0)
        with tempfile.TemporaryDirectory() as folder:
            for frame, radius_m in enumerate((3.0, 0.3, 0.1)):
                path = pathlib.Path(folder, f"{frame}.obj")
                flat = mapped(gradient_of(1.01, 0.98, 0.4 * frame, 0), points)
                with open(path, "w", encoding="utf-8") as file:
                    file.writelines(f"v {radius_m * math.cos(x / radius_m)} {y} {radius_m * math.sin(x / radius_m)}\n"
                                    for x, y, _ in flat)
                    file.writelines(f"f {' '.join(str(corner + 1) for corner in face)}\n" for face in faces)
                shape = Shape(path.name, Cloth(points, faces), *read_obj(path), [], 0.01, "surface")
                self.assertEqual(complaints(shape), [f"{path.name}: nothing is said about its stretch"])

    def test_what_is_said_of_triangles(self):
        # Of 200, two or three grow by 4 % along no side of theirs, the others by 2 %.
        triangle, faces = [(0, 0), (1, 0), (0, 1)], [[i, i + 1, i + 2] for i in range(0, 600, 3)]
        points = [(x, y, i) for i in range(200) for x, y in triangle]
        for outliers, p99 in ((2, 0.02), (3, 0.04)):
            grown = [mapped(gradient_of(1.04 if i < outliers else 1.02, 1, 1, 0), triangle) for i in range(200)]
            shape = Shape("made up", Cloth(points, faces), [corner for corners in grown for corner in corners], faces)
            right = {"max_surface_stretch": 0.04, "p99_surface_stretch": p99}
            for name, wrong in itertools.product(right, (0.0, 1e-7)):
                shape.printed = Printed.all_of("beside it", {name: right[name] + wrong})
                self.assertEqual([name in found for found in complaints(shape)], [True] * bool(wrong) + [False])


if __name__ == "__main__":
    unittest.main()
