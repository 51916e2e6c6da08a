"""The check itself has to notice: made-up shapes that are right, and one change at a time."""

import contextlib
import io
import pathlib
import sys
import tempfile
import unittest
import zlib
from functools import partial

import check_bounds
import check_positions
from check_still_air import masses_kg, motion
from crossings import crossing_pairs
from measure import Cloth, Printed, Shape, complaints, grid, read_obj
from program import Program, pdf_text
from ways_out import exported, ways_out

STRETCH = 0.004321


def made_up(printed=STRETCH, bound=0.005, move_m=0.0):
    """A grid in which the edge from vertex 7 to 8 is the longest; `move_m` moves vertex 8 on along it."""
    points, faces = grid(3, 3, 2.0, 2.0)
    written = list(points)
    written[8] = (2.0 + STRETCH + move_m, 2.0, 0.0)
    return Shape("made up", Cloth(points, faces), written, faces, [Printed("beside it", printed)], bound)


class Crossings(unittest.TestCase):
    def test_of_two_triangles(self):
        floor, tiny = [(0.0, 0.0, 0.0), (4.0, 0.0, 0.0), (0.0, 4.0, 0.0)], 5e-324
        for crosses, face, *others in (
                (True, [3, 4, 5], (1, 1, -1), (1, 1, 2), (3, 3, 2)), (True, [3, 4, 5], (1, 1, 0), (1, 1, 2), (3, 3, 2)),
                (True, [3, 4, 5], (1, 1, -tiny), (1, 1, 2), (3, 3, 2)), (False, [3, 4, 5], (1, 1, tiny), (1, 1, 2), (3, 3, 2)),
                (True, [3, 4, 5], (1, 1, 0), (2, 1, 0), (1, 2, 0)), (False, [3, 4, 5], (3, 3, 0), (4, 3, 0), (3, 4, 0)),
                (True, [0, 3, 4], (1, 1, 0), (1, 1, 1)), (False, [0, 3, 4], (1, 1, tiny), (1, 1, 1)),
                (False, [0, 3, 4], (-1, 1, 0), (-1, -1, 1)), (True, [1, 0, 3], (1, 1, 0)),
                (False, [1, 0, 3], (1, 1, tiny)), (False, [1, 0, 3], (1, -1, 0))):
            points = floor + [tuple(map(float, point)) for point in others]
            self.assertEqual(crossing_pairs(points, [[0, 1, 2], face]), [(0, 1)] * crosses, (face, others))

    def test_names_a_triangle_without_area(self):
        with self.assertRaisesRegex(ValueError, "triangle 1 has no area"):
            crossing_pairs([(0.0, 0.0, 0.0), (4.0, 0.0, 0.0), (0.0, 4.0, 0.0), (8.0, 0.0, 0.0)], [[0, 1, 2], [0, 1, 3]])


class Complaints(unittest.TestCase):
    def test_what_is_right_passes(self):
        self.assertEqual(complaints(made_up()), [])

    def test_an_edge_one_percent_longer(self):
        found = complaints(made_up(move_m=0.01))
        self.assertEqual(len(found), 2)
        self.assertIn("max_stretch is 1.4321", found[0])
        self.assertIn("more than 0.5 %", found[1])

    def test_the_fourth_digit_of_what_is_printed(self):
        self.assertEqual(len(complaints(made_up(printed=0.004322))), 1)

    def test_a_bound_that_is_a_little_smaller(self):
        self.assertEqual(len(complaints(made_up(bound=0.00432))), 1)

    def test_a_text_is_right_to_its_last_digit(self):
        for text, wrong in (("0.43", 0), ("0.4321", 0), ("0.4", 0), ("0", 0), ("0.44", 1), ("0.4322", 1)):
            shape = made_up()
            shape.printed = [Printed.percent("a caption", text)]
            self.assertEqual(len(complaints(shape)), wrong, text)

    def test_a_point_that_is_no_number(self):
        for lost in (float("nan"), float("inf")):
            shape = made_up()
            shape.points[0] = (lost, 0.0, 0.0)
            self.assertEqual(len(complaints(shape)), 1)

    def test_every_measure(self):
        # One edge of twelve is shorter, another one longer: of so few it is the 99th percentile as well.
        shape = made_up(move_m=-0.25)
        shortest, longest = STRETCH - 0.25, (1.0 + (0.25 - STRETCH) ** 2) ** 0.5 - 1.0
        right = {"max_stretch": longest, "p99_stretch": longest, "mean_stretch": (shortest + longest) / 12,
                 "max_compression": -shortest}
        for change in (None, *right):
            said = {name: value + (1e-6 if name == change else 0.0) for name, value in right.items()}
            shape.printed, shape.bound = Printed.all_of("beside it", said), None
            self.assertEqual(len(complaints(shape)), 0 if change is None else 1, change)

    def test_nothing_printed(self):
        shape = made_up()
        shape.printed = []
        self.assertEqual(len(complaints(shape)), 1)

    def test_another_cloth(self):
        for change in (lambda faces: faces.pop(), lambda faces: faces[0].reverse(), lambda faces: faces[3].pop()):
            shape = made_up()
            shape.faces = [list(face) for face in shape.faces]
            change(shape.faces)
            self.assertEqual(len(complaints(shape)), 1)


# Stands in for the program: `taut simulate` of a square that grows by 1 % a frame, with one change to what it writes.
FAKE = """#!{python}
import json, sys
change = {change}
if sys.argv[1] == "scenes":
    sys.exit(print("square           A square"))
frames, records = next(int(word.removeprefix("time.frames=")) for word in sys.argv if word.startswith("time.f")), []
for frame in range(1, frames + 1):
    size = 1.0 + 0.01 * frame
    points = [[0, 0, 0], [size, 0, 0], [size, size, 0], [0, size, 0]]
    said = dict(frame=frame, max_stretch=size - 1.0, printed=f"{{100 * (size - 1.0):.4f}}")
    if frame == 2:
        change(points, said)
    with open(f"{{frame}}.obj", "w") as file:
        file.writelines(f"v {{x}} {{y}} {{z}}\\n" for x, y, z in points)
        file.write("f 1 2 3 4\\n")
    print(f"frame {{frame:5}}  time 0 s  max stretch {{said.pop('printed'):>8}} %  p99")
    records.append(said)
with open("run.jsonl", "w") as file:
    for line in [dict(scene="fake"), *records, dict(summary=dict())]:
        print(json.dumps(line), file=file)
"""


class Runs(unittest.TestCase):
    def run_with(self, change):
        with tempfile.TemporaryDirectory() as folder:
            fake = pathlib.Path(folder, "taut")
            fake.write_text(FAKE.format(python=sys.executable, change=change), encoding="utf-8")
            fake.chmod(0o755)
            square = Cloth([(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (1.0, 1.0, 0.0), (0.0, 1.0, 0.0)], [[0, 1, 2, 3]])
            program = Program(fake, folder, pathlib.Path(folder, "out"))
            return check_positions.check(program, partial(exported, "square", square, 0.03, 3, {}))

    def test_what_is_right_passes(self):
        self.assertEqual(self.run_with("lambda points, said: None"), (3, []))

    def test_one_vertex_of_one_frame(self):
        # Edges of 1.02, one of them longer by 1 %: more than is said in two places, and more than the bound.
        _, found = self.run_with("lambda points, said: points[1].__setitem__(0, 1.02 * 1.01)")
        self.assertEqual(len(found), 3, found)
        self.assertTrue(all(text.startswith("frame 2: ") and " 3.02" in text for text in found), found)

    def test_the_fourth_digit_of_one_number(self):
        for change in ("max_stretch=0.02001", "printed='2.0010'"):
            _, found = self.run_with(f"lambda points, said: said.update({change})")
            self.assertEqual(len(found), 1, found)

    def test_a_frame_that_is_missing(self):
        found = self.run_with("lambda points, said: said.update(frame=7)")[1]
        self.assertIn("run.jsonl has not the frames 1 to 3", found)


class Bounds(unittest.TestCase):
    def run_for(self, frame_rate, kind):
        """Every frame is 1 % longer than the one before."""
        with tempfile.TemporaryDirectory() as folder:
            fake, scenes = pathlib.Path(folder, "taut"), pathlib.Path(folder, "assets", "scenes")
            fake.write_text(FAKE.format(python=sys.executable, change="lambda points, said: None"), encoding="utf-8")
            fake.chmod(0o755)
            scenes.mkdir(parents=True)
            sides = {"columns": 2, "rows": 2, "width": 1.0, "height": 1.0}
            keys = [f"garment.grid.{key} = {value}" for key, value in sides.items()]
            (scenes / "square.toml").write_text("\n".join([*keys, f"time.frame_rate = {frame_rate}"]), encoding="utf-8")
            with contextlib.redirect_stdout(io.StringIO()) as said:
                code = check_bounds.main(fake, folder, pathlib.Path(folder, "out"), kind, kind)
            return code, said.getvalue()

    def test_every_scene_of_the_program_in_every_frame(self):
        for kind, complaints_of_frame_2 in (("springs", 1), ("surface", 2)):
            code, said = self.run_for(1 / check_bounds.SECONDS, kind)
            self.assertEqual(code, 0)
            self.assertEqual(said, f"square, {kind} held, {kind} checked: 1 frames, 0 needles, 0 complaints\n")
            code, said = self.run_for(2 / check_bounds.SECONDS, kind)
            self.assertEqual(code, 1)
            self.assertIn(f": 2 frames, 0 needles, {complaints_of_frame_2} complaints\n  frame 2: a spring", said)

    def test_another_kind_of_bound(self):
        with self.assertRaisesRegex(SystemExit, "found the kind of bound edges, expected springs or surface"):
            self.run_for(1, "edges")


class Cloths(unittest.TestCase):
    def test_vertices_may_be_numbered_anew_and_welded(self):
        square = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (1.0, 1.0, 0.0), (0.0, 1.0, 0.0)]
        apart = Cloth([square[i] for i in (0, 1, 2, 0, 2, 3)], [[0, 1, 2], [3, 4, 5]])
        self.assertEqual(apart.stretches(square[::-1], [[3, 2, 1], [3, 1, 0]]).structural, [0.0] * 5)
        with self.assertRaises(ValueError):
            apart.stretches(square, [[0, 1, 2], [0, 1, 3]])

    def test_units(self):
        millimetres = Cloth([(0.0, 0.0, 0.0), (1000.0, 0.0, 0.0), (0.0, 1000.0, 0.0)], [[0, 1, 2]], 0.001)
        written = [(0.0, 0.0, 0.0), (1.25, 0.0, 0.0), (0.0, 1.0, 0.0)]
        self.assertAlmostEqual(max(millimetres.stretches(written, [[0, 1, 2]]).structural), 0.25)


class Motions(unittest.TestCase):
    def test_cloth_that_moves_as_a_whole(self):
        before = [(0.0, 0.0, 0.0), (2.0, 0.0, 0.0), (0.0, 3.0, 0.0)]
        masses = masses_kg(before, [[0, 1, 2]])
        self.assertAlmostEqual(sum(masses), 0.45)
        moved = motion(before, [(x, y, z + 0.05) for x, y, z in before], masses, 60)
        self.assertAlmostEqual(moved["rms_speed"], 3.0)
        self.assertAlmostEqual(moved["convergence"], 0.05)
        self.assertAlmostEqual(moved["kinetic_energy"], 0.5 * 0.45 * 9.0)


class Files(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_obj(self):
        (self.folder / "a.obj").write_text("# v 1 2 3\nv 1 2 3.5\nv 0 0 1e-3 9\n\nf 1/1 2//4 1\n", encoding="utf-8")
        self.assertEqual(read_obj(self.folder / "a.obj"), ([(1.0, 2.0, 3.5), (0.0, 0.0, 0.001)], [[0, 1, 0]]))

    def test_captions(self):
        words = zlib.compress(rb"BT (\(a\) ) Tj (largest stretch 1.0 %)Tj ET")
        (self.folder / "a.pdf").write_bytes(b"<< /Filter /FlateDecode\n>>\nstream\n" + words + b"\nendstream\n")
        self.assertIn("largest stretch 1.0 %\n", pdf_text(self.folder / "a.pdf"))

    def test_a_folder_with_what_failed_stays(self):
        program = Program("taut", self.folder, self.folder / "out")
        self.assertEqual(check_positions.check(program, lambda _: [made_up()]), (1, []))
        self.assertFalse(program.folder.exists())
        for way in (lambda _: [], lambda _: [made_up(), made_up(move_m=0.01)]):
            self.assertNotEqual(check_positions.check(program, way)[1], [])
            self.assertTrue(program.folder.exists())

    def test_a_program_that_fails(self):
        program = Program("false", self.folder, self.folder / "out")
        for name, way in ways_out(self.folder).items():
            if not name.startswith("export_"):
                self.assertNotEqual(check_positions.check(program, way)[1], [], name)


if __name__ == "__main__":
    unittest.main()
