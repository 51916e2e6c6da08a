"""The add-on in Blender, from its zip: blender -b --factory-startup --python-exit-code 3 --python test_addon.py -- ZIP TAUT

TAUT is the program, whose bits are compared with; $TAUT_LIBRARY is the library.
"""
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

ZIP, TAUT = sys.argv[sys.argv.index('--') + 1:][:2]
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
        install()
        bpy.context.scene.render.fps = 60

    def save(self):
        bpy.ops.wm.save_as_mainfile(filepath=str(self.folder / 'made' / 'scene.blend'), check_existing=False)

    def cloth(self, height=1.0, frames=12):
        bpy.ops.mesh.primitive_grid_add(x_subdivisions=SIDE - 1, y_subdivisions=SIDE - 1, size=0.5)
        obj = bpy.context.object
        for vertex in obj.data.vertices:
            vertex.co.z = height
        obj.vertex_groups.new(name='corners').add([0, SIDE - 1], 1, 'REPLACE')
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

    def simulate(self, obj):
        (self.folder / 'made').mkdir(exist_ok=True)
        if not bpy.data.filepath:
            self.save()
        with bpy.context.temp_override(object=obj):
            return bpy.ops.taut.simulate()

    def cache(self, obj):
        return cached(self.folder / 'made' / 'taut_cache' / (obj.name + '.pc2'))

    def by_program(self, obj, frames, more=''):
        """Positions as `taut simulate` gives them, z up, from the mesh as an OBJ file."""
        points = np.array([v.co for v in obj.data.vertices], np.float32)
        write_obj(self.folder / 'cloth.obj', y_up(points), [list(f.vertices) for f in obj.data.polygons])
        (self.folder / 'scene.toml').write_text(
            f'garment = {{ file = "cloth.obj", scale = 1.0, up = "y" }}\npins = {{ at = [0, {SIDE - 1}] }}\n'
            f'solver = {{ max_stretch = 0.01 }}\ncloth = {{ fabric = "cotton" }}\ntime = {{ frames = {frames} }}\n' + more)
        subprocess.run([TAUT, 'simulate', 'scene.toml', '--quiet', '--export', 'end.obj'], cwd=self.folder, check=True)
        # The program numbers vertices as faces name them.
        order = list(dict.fromkeys(v for face in obj.data.polygons for v in face.vertices))
        end = np.empty((len(points), 3))
        end[order] = read_obj(self.folder / 'end.obj')
        return np.stack([end[:, 0], -end[:, 2], end[:, 1]], axis=1)


    def test_x(self):
        obj = self.cloth()
        print(self.simulate(obj), obj.taut.message)
        start, frames = self.cache(obj)
        print(start, frames.shape)
        end = self.by_program(obj, 12)
        print('program', np.abs(end - frames[-1]).max(), np.array_equal(end.astype(np.float32), frames[-1]))
        bpy.context.scene.frame_set(13)
        print('shown', np.abs(world(obj) - frames[-1]).max())
        ball, obj.taut.bodies = self.ball()
        obj.taut.pin_group = ''
        obj.taut.frame_end = 30
        ball.keyframe_insert('location', frame=1)
        ball.location.z += 0.1
        ball.keyframe_insert('location', frame=20)
        print(self.simulate(obj), obj.taut.message)


if __name__ == '__main__':
    result = unittest.main(argv=['test_addon', '-v'], exit=False).result
    if not result.wasSuccessful():
        raise SystemExit(3)
