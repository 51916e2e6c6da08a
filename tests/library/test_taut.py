"""The library from Python."""
import pathlib
import tempfile
import typing
import unittest

import numpy as np
import taut

SIDE = 9
z, x = np.mgrid[0:SIDE, 0:SIDE] * 0.05
SQUARE = np.stack([x, 0 * x, z], axis=-1).reshape(-1, 3)
V = np.arange(SIDE * SIDE).reshape(SIDE, SIDE)
FACES = np.stack([V[:-1, :-1], V[1:, :-1], V[1:, 1:], V[:-1, 1:]], axis=-1).reshape(-1, 4)
BOX = np.array([[i & 1, (i >> 1) & 1, i >> 2] for i in range(8)], np.float32) * 0.1
SIDES = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]


class Calls(unittest.TestCase):
    def square(self, **options):
        return taut.Cloth(positions=SQUARE, faces=FACES, **options)

    def test_a_cloth_keeps_its_bound(self):
        with self.square(settings={'solver.max_stretch': 0.01}, counts_crossings=True) as cloth:
            cloth.pins = [0, SIDE - 1]
            self.assertEqual(cloth.pins.tolist(), [0, SIDE - 1])
            frame = cloth.step(30)
            self.assertEqual([type(value) for value in frame], list(typing.get_type_hints(taut.Frame).values()))
            self.assertEqual((frame.frame, frame.crossing_pairs, frame.is_bound_kept), (30, 0, True))
            self.assertTrue(1e-4 < frame.max_surface_stretch <= 0.01 + 1e-9)
            self.assertEqual(cloth.stretch.max(), frame.max_surface_stretch)
            edges, lengths = cloth.edges
            positions = cloth.positions()
            longest = np.linalg.norm(positions[edges[:, 0]] - positions[edges[:, 1]], axis=1) / lengths - 1
            self.assertAlmostEqual(longest.max(), frame.max_edge_stretch, 12)
            self.assertEqual(cloth.triangles.shape, (128, 3))
            self.assertEqual(cloth.state_hash, frame.state_hash)
        with self.assertRaisesRegex(taut.Error, 'there is no such cloth'):
            cloth.step()

    def test_positions_fill_an_array_of_the_caller(self):
        cloth = self.square()
        wide = np.zeros((81, 5), np.float32)
        view = wide[:, 1:4]
        self.assertIs(cloth.positions(view), view)
        np.testing.assert_array_equal(wide[:, 1:4], SQUARE.astype(np.float32))
        self.assertFalse(wide[:, 0].any() or wide[:, 4].any())
        for wrong in (np.zeros((81, 3), np.int32), np.zeros((3, 81)).T, np.zeros((80, 3)), np.zeros(243)):
            with self.assertRaises(taut.Error):
                cloth.positions(wrong)
        frozen = np.zeros((81, 3))
        frozen.flags.writeable = False
        with self.assertRaises(taut.Error):
            cloth.positions(frozen)

    def test_what_acts_on_it(self):
        cloth = self.square()
        cloth.set_gravity((0, 0, 0))
        cloth.pins = [0]
        target = SQUARE[:1] + (0, 0.01, 0)
        cloth.move_pins([0], target)
        cloth.step()
        np.testing.assert_allclose(cloth.positions()[0], target[0], atol=1e-9)
        cloth.set_wind((0, 4, 0))
        cloth.set_forces([80], [[0, 0.1, 0]])
        cloth.set('cloth.fabric', 'denim')
        cloth.step(2)
        self.assertGreater(cloth.positions()[80, 1], 0)
        with self.assertRaisesRegex(taut.Error, 'found vertex 5, expected one that is pinned'):
            cloth.move_pins([5], [[0, 0, 0]])
        with self.assertRaisesRegex(taut.Error, 'found 2 points for 1 vertices'):
            cloth.move_pins([0], np.zeros((2, 3)))

    def test_bodies(self):
        cloth = self.square(settings={'wind.direction': [0, 0, 1]})
        self.assertEqual(cloth.add_plane((0, -0.2, 0)), 0)
        box = BOX + np.float32([0.15, -0.12, 0.15])
        number = cloth.add_body(box, SIDES, name='box', friction=0.5)
        cloth.step(5)
        for _ in range(5):
            box += np.float32([0, 0.01, 0])
            cloth.move_body(number, box)
            cloth.step()
        self.assertGreater(cloth.positions()[:, 1].max(), 0.02)
        cloth.place_body(number, box + 3)
        with self.assertRaisesRegex(taut.Error, 'a body has no holes'):
            taut.Cloth('pinned-9x9-5').add_body(SQUARE * 10, FACES)

    def test_bodies_that_are_there_from_the_start_and_what_crosses(self):
        lines = []
        box = BOX + np.float32([0.15, -0.05, 0.15])
        bodies = [taut.Body(box, SIDES, name='box', friction=0.2), taut.Body(point=(0, -0.3, 0))]
        cloth = self.square(start=SQUARE + (0, 0.06, 0), bodies=bodies, log=lines.append)
        self.assertEqual((cloth.info.body_count, cloth.info.crossings_at_start, lines), (2, 0, []))
        cloth.step(20)
        self.assertGreater(cloth.positions()[:, 1].max(), 0.05)
        cloth.add_body(box + np.float32([0, 0.03, 0]), SIDES, name='higher')
        self.assertGreater(cloth.info.crossings_at_start, 0)
        self.assertRegex(lines[0], "pairs of triangles cross with the body 'higher'")
        with self.assertRaisesRegex(taut.Error, 'to be dressed'):
            self.square(bodies=[taut.Body(box, SIDES, dress=9)])

    def test_pictures(self):
        with self.square(settings={'picture.outside_colour': '"#ff0000"'}) as cloth, tempfile.TemporaryDirectory() as folder:
            rows = np.frombuffer(cloth.draw(48, 32), np.uint8).reshape(32, 48, 3)
            self.assertGreater((rows[..., 0] > 2 * rows[..., 1]).sum(), 50)
            file = pathlib.Path(folder, 'square.png')
            cloth.save_picture(file, 48, 32)
            self.assertEqual(file.read_bytes()[:8], b'\x89PNG\r\n\x1a\n')
            for size in ((15, 32), (48, -1)):
                with self.assertRaisesRegex(taut.Error, 'pixels, expected 16 to 16384'):
                    cloth.draw(*size)

    def test_names(self):
        self.assertIn('silk', taut.fabrics())
        self.assertIn('tshirt', taut.scenes())

    def test_it_goes_on_with_the_same_bits(self):
        cloth = self.square(start=SQUARE + (0, 1, 0))
        cloth.step(3)
        state = cloth.save()
        expected = cloth.step(3).state_hash
        other = self.square()
        other.restore(state)
        self.assertEqual(other.step(3).state_hash, expected)
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, 'state')
            cloth.save_file(file)
            other.restore_file(file)
        self.assertEqual(other.step().state_hash, cloth.step().state_hash)
        other.set_positions(SQUARE)
        np.testing.assert_array_equal(other.positions(), SQUARE)
        with self.assertRaises(taut.Error) as raised:
            other.restore(state[:-1])
        self.assertEqual(raised.exception.result, 4)

    def test_scenes_and_what_is_guessed(self):
        lines = []
        cloth = taut.Cloth(text='[garment.grid]\ncolumns = 4\n', threads=1, settings={'solver.contact': False},
                           log=lines.append)
        self.assertEqual(cloth.info.vertex_count, 36)
        with self.assertRaisesRegex(taut.Error, "did you mean 'tshirt'"):
            taut.Cloth('tshirtt')
        for given in ({}, {'scene': 'tshirt', 'text': ''}):
            with self.assertRaisesRegex(taut.Error, 'exactly one of scene, text and positions'):
                taut.Cloth(**given)
        for frames in (0, -1):
            with self.assertRaisesRegex(taut.Error, f'found {frames} frames, expected at least 1'):
                cloth.step(frames)
        self.assertEqual(repr(cloth), 'Cloth(frame 0, 48 triangles)')
        self.assertIn('vertex_count=36', repr(cloth.info))
        cloth.close()
        self.assertEqual(repr(cloth), 'Cloth(closed)')


if __name__ == '__main__':
    unittest.main()
