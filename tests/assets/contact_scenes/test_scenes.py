"""That scenes about contact can keep their promise at the start: their cloth is outside of their bodies, and what moves
is held and moves within the run."""

import math
import pathlib
import tomllib
import unittest

from crossings import cross, dot, minus
from shapes import MICROMETRES, Shape, crossings_with, read_shape, turns_around

SCENES = pathlib.Path(__file__).resolve().parents[3] / "assets" / "scenes" / "contact"


def scenes():
    """Names and contents of those that name a body or move pins."""
    for path in sorted(SCENES.glob("*.toml")):
        scene = tomllib.loads(path.read_text(encoding="utf-8"))
        if "bodies" in scene or "moving" in scene.get("pins", {}):
            yield path.stem, scene


def file_of(scene, key):
    return SCENES / scene["garment"][key]


def cloth_of(scene):
    """Where a scene's cloth begins. Of a grid the two triangles that cover it: it is level."""
    garment = scene["garment"]
    if "grid" not in garment:
        return read_shape(file_of(scene, "start" if "start" in garment else "file"))
    grid = garment["grid"]
    if grid["plane"] != "horizontal":
        raise ValueError("a level grid is expected")
    (x, y, z), half_m, depth_m = grid["top"], 0.5 * grid["width"], grid["height"]
    corners = [(x - half_m, y, z), (x - half_m, y, z + depth_m), (x + half_m, y, z + depth_m), (x + half_m, y, z)]
    return Shape([tuple(round(MICROMETRES * c) for c in corner) for corner in corners], [(0, 1, 2), (0, 2, 3)])


def distance_to_triangle(point, a, b, c):
    """From a point to the nearest of a triangle: within it, or else on one of its sides."""
    normal = cross(minus(b, a), minus(c, a))
    inside = [dot(normal, cross(minus(e, s), minus(point, s))) for s, e in ((a, b), (b, c), (c, a))]
    if min(inside) >= 0:
        return abs(dot(normal, minus(point, a))) / math.hypot(*normal)
    return min(distance_to_segment(point, s, e) for s, e in ((a, b), (b, c), (c, a)))


def distance_to_segment(point, start, end):
    along = minus(end, start)
    part = min(1.0, max(0.0, dot(along, minus(point, start)) / dot(along, along)))
    return math.dist(point, [s + part * d for s, d in zip(start, along)])


def gap_m(body, cloth):
    """Between the cloth and a sphere or a plane; negative inside."""
    if body["shape"] == "sphere":
        centre = [MICROMETRES * c for c in body["centre"]]
        nearest = min(distance_to_triangle(centre, *(cloth.points[v] for v in t)) for t in cloth.triangles)
        return nearest / MICROMETRES - body["radius"]
    if body["shape"] == "plane":
        point, normal = [MICROMETRES * c for c in body["point"]], body.get("normal", (0.0, 1.0, 0.0))
        return min(dot(normal, minus(p, point)) for p in cloth.points) / (MICROMETRES * math.hypot(*normal))
    raise ValueError(f"found {body['shape']}, expected a sphere or a plane")


class Scenes(unittest.TestCase):
    def test_begin_outside_of_their_bodies(self):
        checked = 0
        for name, scene in scenes():
            cloth = cloth_of(scene)
            for body in scene.get("bodies", ()):
                with self.subTest(name, body=body["name"]):
                    checked += 1
                    if body["shape"] != "mesh":
                        # Not nearer than cloth is thick.
                        self.assertGreaterEqual(gap_m(body, cloth), 0.001)
                        continue
                    solid = read_shape(SCENES / body["file"])
                    self.assertEqual(crossings_with(solid, cloth), [])
                    for part in cloth.parts():
                        self.assertLess(abs(turns_around(solid, cloth.points[part[0][0]])), 1e-6)
        self.assertGreaterEqual(checked, 12)

    def test_say_the_unit_and_the_axis(self):
        for name, scene in scenes():
            for model in (scene["garment"], *scene.get("bodies", ())):
                if "file" in model:
                    with self.subTest(name, file=model["file"]):
                        self.assertEqual((model["scale"], model["up"]), (1.0, "y"))

    def test_move_what_is_held_and_within_the_run(self):
        for name, scene in scenes():
            end_s = scene["time"]["frames"] / 60
            pins = scene["pins"]
            for moving in (*pins.get("moving", ()), *scene.get("bodies", ())):
                for motion in ("shift", "spin"):
                    if motion in moving:
                        with self.subTest(name, motion=motion):
                            self.assertLess(moving[motion]["from"], moving[motion].get("until", end_s))
                            self.assertLessEqual(moving[motion].get("until", end_s), end_s)
            for moving in pins.get("moving", ()):
                with self.subTest(name):
                    landmarks = file_of(scene, "file").with_suffix(".landmarks.toml")
                    known = tomllib.loads(landmarks.read_text(encoding="utf-8"))
                    self.assertEqual(set(moving["at"]) - (set(known) & set(pins["at"])), set())


if __name__ == "__main__":
    unittest.main()
