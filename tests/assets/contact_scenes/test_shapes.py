"""That the committed cloths and bodies of the scenes about contact are what the tool makes, and sound: nothing crosses,
bodies are closed, and the knot is a reef knot that hardly stretches."""

import math
import pathlib
import subprocess
import sys
import tempfile
import tomllib
import unittest
from collections import defaultdict

from crossings import crossing_pairs
from shapes import closest_vertices_m, read_shape, stretches, turns_around

ASSETS = pathlib.Path(__file__).resolve().parents[3] / "assets"
TOOL = ASSETS / "tools" / "contact_scenes" / "make_contact_scenes.py"

# Vertices, triangles, parts; and the shortest and the longest edge in mm.
GARMENTS = {
    "tube": (5104, 10032, 1, 13.4, 30.2),
    "ribbons": (5784, 9620, 2, 6.0, 8.5),
    "reef_knot": (5784, 9620, 2, 5.9, 8.5),
    "funnel_sheets": (7500, 14406, 3, 15.6, 35.1),
    "layers": (10125, 19360, 5, 17.4, 39.4),
    "table_cloth": (7827, 14892, 7, 8.1, 26.0),
    "washing": (2026, 3804, 3, 9.3, 68.7),
    "needle_cloth": (5184, 10082, 1, 10.9, 24.0),
}
BODIES = {"funnel": (2688, 5376), "needles": (1322, 2640), "pole": (32, 60), "table": (1178, 2352),
          "washing_line": (192, 324)}


def garment(name):
    return read_shape(ASSETS / "garments" / "contact" / f"{name}.obj")


def body(name):
    return read_shape(ASSETS / "bodies" / f"{name}.obj")


class Tool(unittest.TestCase):
    def test_makes_exactly_what_is_committed(self):
        with tempfile.TemporaryDirectory() as folder:
            made = pathlib.Path(folder)
            subprocess.run([sys.executable, "-B", TOOL, made], check=True, stdout=subprocess.DEVNULL)
            names = [path.relative_to(made) for path in sorted(made.rglob("*.*"))]
            self.assertEqual({path.stem for path in names if path.suffix == ".obj"}, {*GARMENTS, *BODIES})
            for name in names:
                self.assertTrue((made / name).read_bytes() == (ASSETS / name).read_bytes(),
                                f"{name} is not what is committed. If the change is meant: run {TOOL}")

    def test_says_what_is_wrong(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "file"
            file.write_text("")
            tool = [sys.executable, "-B", TOOL]
            run = subprocess.run([*tool, file], capture_output=True, text=True)
            self.assertEqual((run.returncode, run.stderr),
                             (1, f"make_contact_scenes: [Errno 20] Not a directory: '{file}/garments/contact'\n"))
            run = subprocess.run([*tool, "a", "b"], capture_output=True, text=True)
            self.assertEqual((run.returncode, run.stderr[:6]), (2, "Usage:"))


class Garments(unittest.TestCase):
    def test_are_as_large_as_they_should_be(self):
        for name, (vertices, triangles, parts, shortest_mm, longest_mm) in GARMENTS.items():
            with self.subTest(name):
                cloth = garment(name)
                self.assertEqual((len(cloth.points), len(cloth.triangles), len(cloth.parts())),
                                 (vertices, triangles, parts))
                lengths = cloth.edge_lengths_m()
                self.assertAlmostEqual(1000 * min(lengths), shortest_mm, delta=0.051)
                self.assertAlmostEqual(1000 * max(lengths), longest_mm, delta=0.051)

    def test_are_numbered_as_their_triangles_use_them(self):
        for name in GARMENTS:
            with self.subTest(name):
                used = dict.fromkeys(v for triangle in garment(name).triangles for v in triangle)
                self.assertEqual(list(used), list(range(GARMENTS[name][0])))

    def test_are_oriented_surfaces(self):
        for name in GARMENTS:
            with self.subTest(name):
                self.assertEqual(set(garment(name).edges().values()), {1})

    def test_do_not_cross_themselves(self):
        for name in GARMENTS:
            with self.subTest(name):
                cloth = garment(name)
                self.assertEqual(crossing_pairs(cloth.points, cloth.triangles), [])

    def test_landmarks_are_borders(self):
        for name in ("tube", "ribbons", "table_cloth", "washing", "needle_cloth"):
            with self.subTest(name):
                edges = garment(name).edges()
                border = {v for a, b in edges if (b, a) not in edges for v in (a, b)}
                text = (ASSETS / "garments" / "contact" / f"{name}.landmarks.toml").read_text(encoding="utf-8")
                for vertices in tomllib.loads(text).values():
                    self.assertEqual(set(vertices) - border, set())


class Bodies(unittest.TestCase):
    def test_are_closed_and_outside_out(self):
        for name, sizes in BODIES.items():
            with self.subTest(name):
                solid = body(name)
                self.assertEqual((len(solid.points), len(solid.triangles)), sizes)
                edges = solid.edges()
                self.assertEqual(set(edges.values()), {1})
                self.assertEqual({(b, a) for a, b in edges}, set(edges))
                a, b, c = (solid.points[v] for v in solid.triangles[0])
                u, v = ([q - p for p, q in zip(a, corner)] for corner in (b, c))
                normal = u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]
                # Half a millimetre below the middle of a triangle.
                length = sum(n * n for n in normal) ** 0.5
                inside = [sum(p) / 3 - 500 * n / length for p, n in zip(zip(a, b, c), normal)]
                self.assertAlmostEqual(turns_around(solid, inside), 1.0)

    def test_do_not_cross_themselves(self):
        for name in BODIES:
            with self.subTest(name):
                solid = body(name)
                self.assertEqual(crossing_pairs(solid.points, solid.triangles), [])

    def test_where_they_are(self):
        self.assertEqual(max(y for _, y, _ in body("table").points), 0)
        tips = [y for _, y, _ in body("needles").points if y > -80000]
        self.assertEqual(tips, [0] * 100)
        # There is a way through the funnel, 0.1 m wide on either side.
        funnel = body("funnel")
        self.assertAlmostEqual(min(math.hypot(x, z) for x, _, z in funnel.points) / 1e6, 0.1, places=6)
        self.assertAlmostEqual(turns_around(funnel, (0, -300000, 0)), 0.0)


class ReefKnot(unittest.TestCase):
    def setUp(self):
        self.rest, self.knot = garment("ribbons"), garment("reef_knot")
        self.middles = [self.middle_line(part) for part in self.knot.parts()]

    def middle_line(self, part):
        """Of the knotted ribbon, by its rows at rest."""
        rows = defaultdict(list)
        for v in {v for triangle in part for v in triangle}:
            rows[self.rest.points[v][0]].append(self.knot.points[v])
        return [[sum(c) / len(row) for c in zip(*row)] for _, row in sorted(rows.items())]

    def test_stretches_less_than_one_percent(self):
        self.assertEqual(self.rest.triangles, self.knot.triangles)
        largest, smallest = zip(*stretches(self.rest, self.knot))
        self.assertLess(max(largest), 0.01)
        self.assertGreater(min(smallest), -0.01)

    def test_has_room_between_layers(self):
        def are_of_two_layers(v, w):
            """On the two ribbons, or 0.12 m from each other along one."""
            (x, y, _), (u, s, _) = self.rest.points[v], self.rest.points[w]
            return (y > 0) != (s > 0) or abs(x - u) > 120000

        # No point of a triangle is farther than 5 mm from all its corners.
        self.assertGreater(closest_vertices_m(self.knot.points, are_of_two_layers), 0.005 + 2 * 0.005)

    def test_goes_over_and_under_as_a_reef_knot(self):
        left, right = self.middles
        self.assertEqual(self.passes(left, right), "under over under under over under")
        self.assertEqual(self.passes(right, left), "over under over over under over")
        for line in self.middles:
            self.assertEqual(self.passes(line[:len(line) // 2], line[len(line) // 2 + 1:]), "")

    @staticmethod
    def passes(line, other):
        """How a line passes another, seen from +z, along its way."""
        found = []
        for (p, q) in zip(line, line[1:]):
            for (r, s) in zip(other, other[1:]):
                area = (q[0] - p[0]) * (s[1] - r[1]) - (q[1] - p[1]) * (s[0] - r[0])
                if area == 0.0:
                    continue
                here = ((r[0] - p[0]) * (s[1] - r[1]) - (r[1] - p[1]) * (s[0] - r[0])) / area
                there = ((r[0] - p[0]) * (q[1] - p[1]) - (r[1] - p[1]) * (q[0] - p[0])) / area
                if 0.0 <= here < 1.0 and 0.0 <= there < 1.0:
                    height = p[2] + here * (q[2] - p[2]) - r[2] - there * (s[2] - r[2])
                    found.append("over" if height > 0.0 else "under")
        return " ".join(found)


if __name__ == "__main__":
    unittest.main()
