"""The add-on in Blender, from its zip: blender -b --factory-startup --python-exit-code 3 --python test_addon.py -- ZIP TAUT ASSETS

TAUT is the program, whose bits are compared with; $TAUT_LIBRARY is the library.
"""
import json
import os
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest

import bpy
import numpy as np
from mathutils import Matrix

ZIP, TAUT, ASSETS = sys.argv[sys.argv.index('--') + 1:][:3]
SIDE = 17


def install():
    bpy.ops.preferences.addon_install(filepath=ZIP)
    bpy.ops.preferences.addon_enable(module='taut_cloth')


def world(obj):
    """Positions in the world as Blender shows them, z up."""
    instance = obj.evaluated_get(bpy.context.view_layer.depsgraph)
    points = np.empty(3 * len(instance.data.vertices), np.float32)
    instance.data.vertices.foreach_get('co', points)
    matrix = np.array(instance.matrix_world)
    return points.reshape(-1, 3) @ matrix[:3, :3].T + matrix[:3, 3]


def cached(path):
    data = pathlib.Path(path).read_bytes()
    magic, _, vertices, start, _, frames = struct.unpack('<12siiffi', data[:32])
    assert magic == b'POINTCACHE2\0' and len(data) == 32 + 12 * vertices * frames, (magic, vertices, frames, len(data))
    return start, np.frombuffer(data[32:], '<f4').reshape(frames, vertices, 3)


def y_up(points):
    return np.stack([points[:, 0], points[:, 2], -points[:, 1]], axis=1)


def write_obj(path, points, faces):
    """With all digits: the program reads the very numbers."""
    lines = ['v %.17g %.17g %.17g' % tuple(p) for p in points.astype(float)]
    lines += ['f ' + ' '.join(str(v + 1) for v in face) for face in faces]
    path.write_text('\n'.join(lines) + '\n')


def read_obj(path):
    return np.array([line.split()[1:4] for line in path.read_text().splitlines() if line.startswith('v ')], float)


class AddOn(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)
        bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True)
        # Times that rounding does not touch: that of a frame is that of all frames before and its own.
        bpy.context.scene.render.fps = 64

    def save(self):
        bpy.ops.wm.save_as_mainfile(filepath=str(self.folder / 'made' / 'scene.blend'), check_existing=False)

    def cloth(self, height=1.0, frames=12):
        bpy.ops.mesh.primitive_grid_add(x_subdivisions=SIDE - 1, y_subdivisions=SIDE - 1, size=0.5)
        obj = bpy.context.object
        for vertex in obj.data.vertices:
            vertex.co.z = height
        self.corners = [v.index for v in obj.data.vertices if v.co.y < -0.24 and abs(v.co.x) > 0.24]
        obj.vertex_groups.new(name='corners').add(self.corners, 1, 'REPLACE')
        obj.taut.pin_group = 'corners'
        obj.taut.frame_start, obj.taut.frame_end = 1, 1 + frames
        return obj

    def ball(self, location=(0, 0, 0.8)):
        bpy.ops.mesh.primitive_uv_sphere_add(radius=0.15, segments=16, ring_count=8, location=location)
        ball = bpy.context.object
        bodies = bpy.data.collections.new('bodies')
        bpy.context.scene.collection.children.link(bodies)
        bodies.objects.link(ball)
        return ball, bodies

    def test_sews_a_pattern_on_a_person(self):
        np.bool = bool  # which Blender 3.4's glTF names, and numpy no longer has
        bpy.ops.import_scene.gltf(filepath=str(pathlib.Path(ASSETS) / 'bodies' / 'mannequin_female_34.glb'))
        person = next(obj for obj in bpy.context.selected_objects if obj.type == 'MESH')
        sides = [{'panel': name, 'edge': edge} for edge in (0, 2) for name in ('front', 'back')]
        panel = {'vertices': [[-20, 0], [-30, -40], [30, -40], [20, 0]], 'rotation': [0, 0, 0],
                 'edges': [{'endpoints': [k, (k + 1) % 4]} for k in range(4)]}
        pattern = {'pattern': {'panels': {'front': {**panel, 'translation': [0, 105, 20]},
                                          'back': {**panel, 'translation': [0, 105, -20]}},
                               'stitches': [sides[:2], sides[2:]]}}
        (self.folder / 'skirt.json').write_text(json.dumps(pattern))
        with bpy.context.temp_override(object=person, active_object=person):
            self.assertEqual(bpy.ops.taut.sew(filepath=str(self.folder / 'skirt.json')), {'FINISHED'})
        skirt = bpy.data.objects['skirt']
        height = world(skirt)[:, 2]
        self.assertGreater(height.min(), 0.4)
        self.assertLess(height.max(), 1.3)
        self.assertEqual(list(skirt.taut.bodies.objects), [person])
        with self.assertRaisesRegex(RuntimeError, 'skirt.json: .*pattern.panels: found {}'):
            (self.folder / 'skirt.json').write_text('{"pattern": {"panels": {}}}')
            with bpy.context.temp_override(object=person, active_object=person):
                bpy.ops.taut.sew(filepath=str(self.folder / 'skirt.json'))

    def simulate(self, obj):
        (self.folder / 'made').mkdir(exist_ok=True)
        if not bpy.data.filepath:
            self.save()
        with bpy.context.temp_override(object=obj):
            return bpy.ops.taut.simulate()

    def cache(self, obj):
        return cached(self.folder / 'made' / 'taut_cache' / (obj.name + '.pc2'))

    def by_program(self, obj, frames, more='', pins=None, bound=0.01):
        """Positions as `taut simulate` gives them, z up, from the mesh as an OBJ file."""
        points = np.array([v.co for v in obj.data.vertices], np.float32)
        write_obj(self.folder / 'cloth.obj', y_up(points), [list(f.vertices) for f in obj.data.polygons])
        (self.folder / 'scene.toml').write_text(
            'garment = { file = "cloth.obj", scale = 1.0, up = "y", mesh = "model" }\ncloth = { fabric = "cotton" }\n'
            f'pins = {{ at = {self.corners if pins is None else pins} }}\nsolver = {{ max_stretch = {bound} }}\n'
            f'time = {{ frames = {frames}, frame_rate = 64 }}\n' + more)
        subprocess.run([TAUT, 'simulate', 'scene.toml', '--quiet', '--export', 'end.obj'], cwd=self.folder, check=True)
        end = read_obj(self.folder / 'end.obj')
        return np.stack([end[:, 0], -end[:, 2], end[:, 1]], axis=1)

    def keyed(self, owner, path, values):
        """Goes in straight lines through these values, by frame."""
        for frame, value in values.items():
            setattr(owner, path, value)
            owner.keyframe_insert(path, frame=frame)
        for curve in owner.id_data.animation_data.action.fcurves:
            for point in curve.keyframe_points:
                point.interpolation = 'LINEAR'

    def armature(self, mesh):
        """Of one bone, which has all of the mesh."""
        armature = bpy.data.objects.new('armature', bpy.data.armatures.new('armature'))
        bpy.context.scene.collection.objects.link(armature)
        bpy.context.view_layer.objects.active = armature
        bpy.ops.object.mode_set(mode='EDIT')
        bone = armature.data.edit_bones.new('bone')
        bone.tail = (0, 0, 1)
        bpy.ops.object.mode_set(mode='OBJECT')
        mesh.vertex_groups.new(name='bone').add(range(len(mesh.data.vertices)), 1, 'REPLACE')
        mesh.modifiers.new('armature', 'ARMATURE').object = armature
        return armature

    def test_a_pinned_cloth_has_the_bits_of_the_program(self):
        obj = self.cloth(frames=100)
        obj.taut.max_stretch = 0.7
        self.assertEqual(self.simulate(obj), {'FINISHED'})
        start, frames = self.cache(obj)
        self.assertEqual((start, frames.shape), (1, (101, SIDE * SIDE, 3)))
        np.testing.assert_array_equal(frames[0], np.array([v.co for v in obj.data.vertices], np.float32))
        np.testing.assert_array_equal(frames[-1], self.by_program(obj, 100, bound=0.007).astype(np.float32))
        bpy.context.scene.frame_set(101)
        np.testing.assert_array_equal(world(obj), frames[-1])
        modifier = obj.modifiers['Taut']
        self.assertEqual(modifier.filepath, '//taut_cache/Grid.pc2')
        self.assertEqual(os.listdir(self.folder / 'made' / 'taut_cache'), ['Grid.pc2'])
        self.assertRegex(obj.taut.message, r'^Frames 1 to 101, stretch at most 0\.\d\d %$')

    def test_a_mesh_follows_one_that_is_fitted_to_it(self):
        obj = self.cloth(frames=12)
        obj.taut.mesh = 'fitted'
        self.assertEqual(self.simulate(obj), {'FINISHED'})
        modelled = np.array([v.co for v in obj.data.vertices])
        _, frames = self.cache(obj)
        self.assertEqual(frames.shape, (13, SIDE * SIDE, 3))
        np.testing.assert_allclose(frames[0], modelled, atol=1e-6)
        np.testing.assert_allclose(frames[-1][self.corners], modelled[self.corners], atol=2e-3)
        self.assertLess(frames[-1][:, 2].min(), modelled[:, 2].min() - 0.05)

    def test_a_body_that_an_armature_moves_has_the_bits_of_the_program(self):
        obj = self.cloth(height=0.96, frames=8)
        obj.taut.pin_group = ''
        ball, obj.taut.bodies = self.ball(location=(0, 0, 0))
        ball.data.transform(Matrix.Translation((0, 0, 0.8)))
        armature = self.armature(ball)
        bone = armature.pose.bones[0]
        self.keyed(bone, 'location', {1: (0, 0, 0), 13: (0.02, 0.15, 0.01)})
        self.simulate(obj)
        frames = self.cache(obj)[1]
        # The program reads the body at the first frame, and where its vertices are in each.
        shapes = []
        for frame in range(1, 10):
            bpy.context.scene.frame_set(frame)
            shapes.append(y_up(world(ball)).astype('<f4'))
        write_obj(self.folder / 'ball.obj', shapes[0], [list(f.vertices) for f in ball.data.polygons])
        head = struct.pack('<12siiffi', b'POINTCACHE2\0', 1, len(shapes[0]), 0, 1, len(shapes))
        (self.folder / 'ball.pc2').write_bytes(head + b''.join(shape.tobytes() for shape in shapes))
        expected = self.by_program(obj, 8, '[[bodies]]\nname = "Sphere"\nshape = "mesh"\nfile = "ball.obj"\n'
                                   'motion = "ball.pc2"\nframe_rate = 64\nscale = 1.0\nup = "y"\n', pins='[]')
        np.testing.assert_array_equal(frames[-1], expected.astype(np.float32))
        # It is pushed up.
        self.assertGreater(frames[-1][:, 2].max(), 1.05)
        ball.hide_set(True)
        self.simulate(obj)
        np.testing.assert_array_equal(self.cache(obj)[1], frames)
        ball.hide_viewport = True
        self.refused(obj, 'Sphere: found it disabled in viewports')
        ball.hide_set(False)
        bpy.context.scene.collection.objects.unlink(ball)
        for ball.hide_viewport, obj.taut.bodies.hide_viewport in ((True, False), (False, True)):
            self.refused(obj, 'Sphere: found it disabled in viewports')

    def test_transforms_and_units_change_nothing(self):
        def world_at_end(prepare):
            obj = self.cloth(frames=6)
            prepare(obj)
            self.simulate(obj)
            bpy.context.scene.frame_set(7)
            end = world(obj)
            bpy.data.objects.remove(obj)
            return end

        def placed(obj):
            matrix = Matrix.Translation((1, 2, 3)) @ Matrix.Rotation(0.7, 4, (1, 2, 3)) @ Matrix.Diagonal((2, 0.5, -3, 1))
            obj.data.transform(matrix.inverted())
            obj.matrix_world = matrix

        def moved(obj):
            # All of it goes aside: its local positions are others in every frame.
            self.keyed(obj, 'location', {1: (0, 0, 0), 7: (3, 0, 0)})
            obj.taut.pin_group = ''

        def in_centimetres(obj):
            units = bpy.context.scene.unit_settings
            units.system, units.scale_length = 'METRIC', 0.01
            bpy.context.scene.gravity[2] = -981
            obj.data.transform(Matrix.Scale(100, 4))

        plain = world_at_end(lambda obj: None)
        self.assertLess(plain[:, 2].min(), 0.98)
        np.testing.assert_allclose(world_at_end(placed), plain, atol=0.01)
        free = world_at_end(lambda obj: setattr(obj.taut, 'pin_group', ''))
        np.testing.assert_allclose(world_at_end(moved), free, atol=1e-6)
        np.testing.assert_allclose(world_at_end(in_centimetres) / 100, plain, atol=0.01)

    def test_pins_go_where_shape_keys_and_modifiers_take_them(self):
        obj = self.cloth()
        obj.shape_key_add(name='Basis')
        key = obj.shape_key_add(name='lifted')
        for v in range(len(obj.data.vertices)):
            key.data[v].co.z += 0.05
        self.keyed(key, 'value', {1: 0, 13: 1})
        hook = obj.modifiers.new('wave', 'DISPLACE')
        hook.strength = 0
        obj.modifiers.new('finer', 'SUBSURF')
        self.simulate(obj)
        self.assertEqual([m.name for m in obj.modifiers], ['wave', 'Taut', 'finer'])
        self.assertTrue(all(m.show_viewport for m in obj.modifiers))
        frames = self.cache(obj)[1]
        np.testing.assert_allclose(frames[:, 0, 2], np.linspace(1, 1.05, 13), atol=2e-3)
        np.testing.assert_allclose(frames[-1, self.corners[1]], key.data[self.corners[1]].co, atol=1e-6)
        self.assertLess(frames[-1, :, 2].min(), 1)
        bpy.context.scene.frame_set(13)
        self.assertGreater(len(world(obj)), 4 * len(frames[0]) - 4 * SIDE)
        # And once more, from what was made.
        self.simulate(obj)
        np.testing.assert_array_equal(self.cache(obj)[1], frames)

    def test_wind_and_fabric_act(self):
        obj = self.cloth()
        self.simulate(obj)
        cotton = self.cache(obj)[1]
        obj.taut.wind = (0, 8, 0)
        self.simulate(obj)
        blown = self.cache(obj)[1]
        self.assertGreater(blown[-1, :, 1].mean(), cotton[-1, :, 1].mean() + 0.001)
        obj.taut.wind, obj.taut.fabric = (0, 0, 0), 'denim'
        self.simulate(obj)
        self.assertFalse(np.array_equal(self.cache(obj)[1], cotton))

    def test_the_folder_is_moved_and_opened_by_another_blender(self):
        obj = self.cloth()
        self.simulate(obj)
        self.save()
        frames = self.cache(obj)[1]
        (self.folder / 'made').rename(self.folder / 'elsewhere')
        play = self.folder / 'play.py'
        play.write_text('import bpy, numpy as np\n'
                        'shown = []\nfor f in range(1, 14):\n  bpy.context.scene.frame_set(f)\n'
                        '  o = bpy.data.objects["Grid"].evaluated_get(bpy.context.view_layer.depsgraph)\n'
                        '  shown.append([v.co[:] for v in o.data.vertices])\n'
                        f'np.save({str(self.folder / "shown.npy")!r}, np.array(shown, np.float32))\n')
        # Without the add-on: the cache is Blender's own.
        subprocess.run([bpy.app.binary_path, '-b', '--factory-startup', str(self.folder / 'elsewhere' / 'scene.blend'),
                        '--python-exit-code', '3', '--python', str(play)], check=True, stdout=subprocess.DEVNULL)
        np.testing.assert_array_equal(np.load(self.folder / 'shown.npy'), frames)

    def test_live_has_the_bits_of_simulate(self):
        obj = self.cloth()
        self.simulate(obj)
        frames = self.cache(obj)[1]
        obj.taut.live = True
        for _ in range(2):
            for frame in range(1, 14):
                bpy.context.scene.frame_set(frame)
                bpy.context.view_layer.update()
                np.testing.assert_array_equal(world(obj), frames[frame - 1])
        bpy.context.scene.frame_set(5)
        np.testing.assert_array_equal(world(obj), frames[4])
        bpy.context.scene.frame_set(20)
        self.assertIn('Live is at frame 13', obj.taut.message)
        self.simulate(obj)
        self.assertFalse(obj.taut.live)
        np.testing.assert_array_equal(self.cache(obj)[1], frames)
        self.assertEqual(obj.modifiers['Taut'].filepath, '//taut_cache/Grid.pc2')
        bpy.context.scene.frame_set(13)
        np.testing.assert_array_equal(world(obj), frames[12])

    def test_live_asks_for_no_file_and_leaves_nothing(self):
        obj = self.cloth()
        obj.taut.live = True
        bpy.context.scene.frame_set(4)
        self.assertEqual(obj.taut.message, 'Live begins at frame 1')
        bpy.context.scene.frame_set(1)
        bpy.context.scene.frame_set(2)
        kept = pathlib.Path(obj.modifiers['Taut'].filepath)
        self.assertTrue(kept.exists())
        obj.taut.live = False
        self.assertFalse(kept.exists() or 'Taut' in obj.modifiers)

    def refused(self, obj, text):
        with self.assertRaisesRegex(RuntimeError, text):
            self.simulate(obj)

    def test_frames_are_the_scenes_until_they_are_set(self):
        bpy.ops.mesh.primitive_grid_add()
        settings = bpy.context.object.taut
        bpy.context.scene.frame_start, bpy.context.scene.frame_end = 3, 10
        self.assertEqual((settings.frame_start, settings.frame_end), (3, 10))
        settings.frame_end = 20
        bpy.context.scene.frame_end = 30
        self.assertEqual((settings.frame_start, settings.frame_end), (3, 20))

    def test_what_cannot_be_used_is_said(self):
        obj = self.cloth()
        with self.assertRaisesRegex(RuntimeError, 'Save the .blend file first'):
            bpy.ops.taut.simulate()
        obj.taut.pin_group = 'sleeve'
        self.refused(obj, 'Grid: pins: found no such vertex group: sleeve')
        obj.vertex_groups.new(name='sleeve').add([3], 0.4, 'REPLACE')
        self.refused(obj, 'Grid: pins: found no vertex of weight 0.5 or more: sleeve')
        obj.taut.pin_group = 'corners'
        obj.taut.frame_end = 1
        self.refused(obj, 'Grid: found frames 1 to 1')
        obj.taut.frame_end = 3
        obj.taut.fabric = 'iron'
        self.refused(obj, 'iron')
        obj.taut.fabric = 'cotton'
        bpy.ops.mesh.primitive_plane_add()
        plane = bpy.context.object
        obj.taut.bodies = bpy.data.collections.new('bodies')
        self.refused(obj, 'Grid: bodies: found no mesh in bodies')
        obj.taut.bodies.objects.link(plane)
        self.refused(obj, "Grid: bodies: 'Plane': found the edge from .* with 1 triangle")
        obj.taut.bodies = None
        obj.rotation_euler = 1, 2, 3
        obj.scale = (1, 1, 0)
        self.refused(obj, 'Grid: found a scale of 0')
        obj.scale = (1, 1, 1)
        mask = obj.modifiers.new('Taut', 'MESH_CACHE')
        finer = obj.modifiers.new('finer', 'SUBSURF')
        with bpy.context.temp_override(object=obj):
            bpy.ops.object.modifier_move_to_index(modifier='finer', index=0)
        self.refused(obj, 'Grid: found 1089 vertices with its modifiers and 289 without')
        bpy.context.scene.frame_set(1)
        empty = bpy.data.objects.new('empty', None)
        points = bpy.data.objects.new('points', bpy.data.meshes.new('points'))
        self.refused(empty, 'empty: found an object that is no mesh')
        self.refused(points, 'points: found it left out of the view layer')
        bpy.context.scene.collection.objects.link(points)
        self.refused(points, 'points: found a mesh without faces')
        cache = self.folder / 'made' / 'taut_cache'
        self.assertFalse(cache.exists())
        obj.modifiers.clear()
        cache.write_text('')
        self.refused(obj, 'File exists: .*taut_cache')

    def test_a_frame_that_cannot_be_made_ends_the_run_and_those_before_are_kept(self):
        obj = self.cloth(height=0.96)
        obj.taut.pin_group = ''
        obj.vertex_groups.new(name='all').add(list(range(SIDE * SIDE)), 1, 'REPLACE')
        obj.taut.pin_group = 'all'
        ball, obj.taut.bodies = self.ball()
        self.keyed(ball, 'location', {1: (0, 0, 0.8), 4: (0, 0, 0.8), 8: (0, 0, 1.0)})
        self.refused(obj, r"Frame \d+: .*'Sphere' close in .* at \[[^]]*, 0\.9\d+\]\. "
                     r'Stopped before frame \d+\. Frames 1 to \d+, stretch')
        frames = self.cache(obj)[1]
        self.assertTrue(4 <= len(frames) <= 8)
        self.assertIn(f'Frames 1 to {len(frames)},', obj.taut.message)

    def test_what_crosses_at_the_start_is_said(self):
        obj = self.cloth(height=0.9, frames=1)
        ball, obj.taut.bodies = self.ball()
        self.simulate(obj)
        self.assertRegex(obj.taut.message, r'\nCrossings with Sphere at the start, which may stay: \d+$')
        ball.scale = 9, 9, 9
        self.simulate(obj)
        self.assertRegex(obj.taut.message, r': 1$', 'it is wholly within')
        ball.location.z, ball.scale = 0, (1, 1, 1)
        self.simulate(obj)
        self.assertNotIn('Crossings', obj.taut.message)

    def test_it_begins_as_posed_and_has_the_lengths_it_is_modelled_with(self):
        obj = self.cloth(frames=30)
        obj.taut.pin_group = ''
        obj.shape_key_add(name='Basis')
        narrow = obj.shape_key_add(name='narrow')
        for point in narrow.data:
            point.co.x *= 0.8
        narrow.value = 1
        bpy.context.scene.gravity = (0, 0, 0)
        self.simulate(obj)
        frames = self.cache(obj)[1]
        np.testing.assert_array_equal(frames[0], np.array([point.co for point in narrow.data], np.float32))
        # Cloth that is pressed together goes apart.
        self.assertGreater(np.ptp(frames[-1][:, 0]), 0.43)

    def test_a_mirrored_body_keeps_cloth_out(self):
        obj = self.cloth(height=0.96)
        obj.taut.pin_group = ''
        ball, obj.taut.bodies = self.ball()
        ball.scale.x = -1
        self.simulate(obj)
        self.assertGreater(self.cache(obj)[1][-1][:, 2].max(), 0.95)

    def test_what_is_keyed_counts_at_the_start_too(self):
        obj = self.cloth(frames=1)
        obj.taut.pin_group = ''
        self.keyed(obj, 'location', {1: (0, 0, 0), 3: (0.02, 0, 0)})
        bpy.context.scene.frame_set(1)
        obj.location.x = 5
        self.simulate(obj)
        self.assertLess(np.abs(self.cache(obj)[1]).max(), 1.1)

    def test_without_the_library_it_says_where_it_looked(self):
        obj = self.cloth()
        preferences = bpy.context.preferences.addons['taut_cloth'].preferences
        preferences.library = '/nowhere/libtaut.so'
        self.addCleanup(lambda: setattr(preferences, 'library', ''))
        self.refused(obj, 'libtaut was not found in /nowhere/libtaut.so .*Preferences > Add-ons > Taut Cloth')
        preferences.library = os.environ['TAUT_LIBRARY']
        self.assertEqual(self.simulate(obj), {'FINISHED'})


if __name__ == '__main__':
    install()
    result = unittest.main(argv=['test_addon', '-v'], exit=False).result
    if not result.wasSuccessful():
        raise SystemExit(3)
