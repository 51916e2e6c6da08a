"""Within Blender: what Taut wrote is played, and is where the OBJ of the same frame has it.
    blender -b --factory-startup --python-exit-code 3 --python read_in_blender.py -- FOLDER"""
import pathlib
import sys

import bpy
import numpy

numpy.bool = bool  # Blender 3.4 reads glTF with a name that newer versions of numpy have dropped.
folder = pathlib.Path(sys.argv[sys.argv.index('--') + 1])


def fresh():
    bpy.ops.wm.read_factory_settings(use_empty=True)


def positions_in(path):
    return numpy.array([line.split()[1:] for line in path.read_text().splitlines() if line.startswith('v ')], float)


def coordinates(mesh):
    values = numpy.empty(3 * len(mesh.vertices), numpy.float32)
    mesh.vertices.foreach_get('co', values)
    return values.reshape(-1, 3)


def shape(frame):
    return positions_in(folder / ('shapes/%02d.obj' % frame)).astype(numpy.float32)


def shown(thing):
    return coordinates(thing.evaluated_get(bpy.context.evaluated_depsgraph_get()).data)


fresh()
bpy.ops.wm.obj_import(filepath=str(folder / 'clip.obj'))
garment = bpy.context.selected_objects[0]
cache = garment.modifiers.new('cache', 'MESH_CACHE')
cache.cache_format, cache.filepath = 'PC2', str(folder / 'clip.pc2')
cache.forward_axis, cache.up_axis = 'POS_Y', 'POS_Z'
for frame in (0, 1, 17, 40):
    bpy.context.scene.frame_set(frame)
    assert numpy.array_equal(shown(garment), shape(frame)), 'PC2, frame %d' % frame
upright = garment.matrix_world @ garment.data.vertices[0].co
assert abs(upright.z - garment.data.vertices[0].co.y) < 1e-6, 'not upright'

fresh()
bpy.ops.wm.obj_import(filepath=str(folder / 'shapes/17.obj'))
read = bpy.context.selected_objects[0]
assert abs(coordinates(read.data) - shape(17)).max() < 1e-7, 'OBJ'
assert all(len(face.vertices) == 4 for face in read.data.polygons), 'quads'
assert [group.name for group in read.data.materials] == ['cloth'] and read.data.uv_layers, 'materials and coordinates'

fresh()
bpy.ops.import_scene.gltf(filepath=str(folder / 'clip.glb'))
played = next(thing for thing in bpy.data.objects if thing.type == 'MESH')
rate = bpy.context.scene.render.fps
expected = shape(40)
bpy.context.scene.frame_set(int(40 * rate / 60), subframe=40 * rate / 60 % 1)
found = shown(played)[:, [0, 2, 1]] * [1, 1, -1]
order = lambda points: points[numpy.lexsort(numpy.round(points, 4).T)]
assert found.shape == expected.shape and abs(order(found) - order(expected)).max() < 1e-4, 'glTF: %r' % abs(order(found) - order(expected)).max()
print('Blender %s has read all of it' % bpy.app.version_string)
