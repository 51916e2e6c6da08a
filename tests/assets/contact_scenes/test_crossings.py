"""That the exact test of two triangles sees what it has to see."""

import itertools
import random
import unittest
from fractions import Fraction

from crossings import crossing_pairs, triangles_meet

LEVEL = [(0, 0, 0), (10, 0, 0), (0, 10, 0)]


def meet(*corners):
    """Whether LEVEL and a triangle of its own corners meet."""
    return triangles_meet([*LEVEL, *corners], (0, 1, 2), (3, 4, 5))


def meet_by_fractions(corners):
    """The same by solving for each side: where it goes through the other's plane, and whether that is inside. Knows
    nothing of triangles in one plane."""
    for one, other in ((LEVEL, corners), (corners, LEVEL)):
        a, u, v = one[0], *(tuple(p - q for p, q in zip(corner, one[0])) for corner in one[1:])
        normal = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
        height = [sum(n * (p - q) for n, p, q in zip(normal, corner, a)) for corner in other]
        for k, n in ((0, 1), (1, 2), (2, 0)):
            if height[k] == height[n]:
                continue
            part = Fraction(height[k], height[k] - height[n])
            w = [p + part * (q - p) - o for p, q, o in zip(other[k], other[n], a)]
            uu, uv, vv = (sum(x * y for x, y in zip(s, t)) for s, t in ((u, u), (u, v), (v, v)))
            wu, wv = (sum(x * y for x, y in zip(w, s)) for s in (u, v))
            scale = uu * vv - uv * uv
            s, t = (wu * vv - wv * uv), (wv * uu - wu * uv)
            if 0 <= part <= 1 and s >= 0 and t >= 0 and s + t <= scale:
                return True
    return False


class TwoTriangles(unittest.TestCase):
    def test_that_pierce_touch_or_miss(self):
        self.assertTrue(meet((2, 2, -1), (2, 3, 5), (3, 2, 5)))
        self.assertTrue(meet((2, 2, 0), (2, 3, 5), (3, 2, 5)), "a corner on the face")
        self.assertTrue(meet((0, 0, 0), (-5, -5, 5), (-5, -4, 5)), "a corner on a corner")
        self.assertTrue(meet((5, -5, -5), (5, -5, 5), (5, 5, 0)), "a side through a face, tip first")
        self.assertFalse(meet((2, 2, 1), (2, 3, 5), (3, 2, 5)))
        self.assertFalse(meet((6, 6, -1), (6, 6, 1), (9, 9, 0)), "beside it, through its plane")

    def test_in_one_plane(self):
        self.assertTrue(meet((1, 1, 0), (2, 1, 0), (1, 2, 0)), "one within the other")
        self.assertTrue(meet((-1, 5, 0), (20, 5, 0), (20, 6, 0)), "sides that cross")
        self.assertTrue(meet((10, 0, 0), (20, 0, 0), (20, 5, 0)), "corners that touch")
        self.assertFalse(meet((11, 0, 0), (20, 0, 0), (20, 5, 0)), "in line with a side, behind its end")
        self.assertFalse(meet((6, 6, 0), (9, 9, 0), (6, 9, 0)))

    def test_that_share_vertices(self):
        points = [*LEVEL, (-5, -5, 3), (-5, -4, 3), (10, 10, 5), (10, 10, -5), (2, 2, 0), (10, 10, 0)]
        self.assertFalse(triangles_meet(points, (0, 1, 2), (0, 3, 4)))
        self.assertTrue(triangles_meet(points, (0, 1, 2), (0, 5, 6)), "the side across goes by, the face cuts through")
        self.assertFalse(triangles_meet(points, (0, 1, 2), (1, 2, 5)), "a fold")
        self.assertTrue(triangles_meet(points, (0, 1, 2), (1, 2, 7)), "folded flat")
        self.assertFalse(triangles_meet(points, (0, 1, 2), (1, 2, 8)), "a flat sheet")

    def test_at_random_as_fractions_have_it(self):
        chance, seen = random.Random(3), {True: 0, False: 0}
        while sum(seen.values()) < 2000:
            corners = [tuple(chance.randint(-4, 12) for _ in "xyz") for _ in range(3)]
            if all(z == 0 for _, _, z in corners) or not self.has_area(corners):
                continue
            expected = meet_by_fractions(corners)
            seen[expected] += 1
            self.assertEqual(meet(*corners), expected, corners)
        self.assertGreater(min(seen.values()), 300)

    @staticmethod
    def has_area(corners):
        u, v = (tuple(p - q for p, q in zip(corner, corners[0])) for corner in corners[1:])
        return any((u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]))

    def test_search_finds_the_pairs_of_all_pairs(self):
        chance = random.Random(5)
        points = [tuple(chance.randint(0, 100000) for _ in "xyz") for _ in range(240)]
        triangles = [(k, k + 1, k + 2) for k in range(0, 240, 3)]
        # Near their first corner: some as small as a cell of the search, some across many.
        for k, (a, b, c) in enumerate(triangles):
            for v in (b, c):
                points[v] = tuple(p + (q - p) // (1 + k % 4) for p, q in zip(points[a], points[v]))
        pairs = [(i, j) for i, j in itertools.combinations(range(80), 2)
                 if triangles_meet(points, triangles[i], triangles[j])]
        self.assertGreater(len(pairs), 20)
        self.assertEqual(crossing_pairs(points, triangles), pairs)
        half = [(i, j - 40) for i, j in pairs if i < 40 <= j]
        self.assertEqual(crossing_pairs(points, triangles[:40], triangles[40:]), half)


if __name__ == "__main__":
    unittest.main()
