"""Run by beside_others.sh in Blender: draws a mesh by Eevee, as cotton or velvet."""
import math
import sys

import bpy
from mathutils import Matrix, Vector

mesh, picture, look, eye, target, degrees = sys.argv[sys.argv.index('--') + 1:]


def in_blender(text):
    """Blender's z is up."""
    x, y, z = map(float, text.split(','))
    return Vector((x, -z, y))


scene = bpy.context.scene
for thing in list(bpy.data.objects):
    bpy.data.objects.remove(thing)
bpy.ops.import_scene.obj(filepath=mesh)
shirt = bpy.context.selected_objects[0]
for polygon in shirt.data.polygons:
    polygon.use_smooth = True

cloth = bpy.data.materials.new('cloth')
cloth.use_nodes = True
shader = cloth.node_tree.nodes['Principled BSDF']
colour = (0.76, 0.75, 0.69, 1) if look == 'cotton' else (0.09, 0.10, 0.11, 1)
for name, value in {'Base Color': colour, 'Roughness': 0.9 if look == 'cotton' else 1.0, 'Specular': 0.2,
                    'Sheen': 0.3 if look == 'cotton' else 1.0, 'Sheen Tint': 0.5}.items():
    shader.inputs[name].default_value = value
shirt.data.materials.clear()
shirt.data.materials.append(cloth)

bpy.ops.mesh.primitive_plane_add(size=40, location=(0, 0, 0.82))
floor = bpy.data.materials.new('floor')
floor.use_nodes = True
floor.node_tree.nodes['Principled BSDF'].inputs['Base Color'].default_value = (0.85, 0.85, 0.84, 1)
bpy.context.object.data.materials.append(floor)


def looking(thing, at, towards):
    back = (at - towards).normalized()
    right = Vector((0, 0, 1)).cross(back).normalized()
    turn = Matrix((right, back.cross(right), back)).transposed().to_4x4()
    thing.matrix_world = Matrix.Translation(at) @ turn
    scene.collection.objects.link(thing)


at, towards = in_blender(eye), in_blender(target)
camera = bpy.data.objects.new('camera', bpy.data.cameras.new('camera'))
camera.data.sensor_fit = 'VERTICAL'
camera.data.angle_y = math.radians(float(degrees))
looking(camera, at, towards)
scene.camera = camera
sun = bpy.data.objects.new('sun', bpy.data.lights.new('sun', 'SUN'))
sun.data.energy, sun.data.angle = 3.0, 0.2
looking(sun, towards + Vector((-1.4, -1.6, 4.0)), towards)

scene.world.use_nodes = True
scene.world.node_tree.nodes['Background'].inputs['Color'].default_value = (0.75, 0.78, 0.82, 1)
scene.world.node_tree.nodes['Background'].inputs['Strength'].default_value = 0.6
scene.render.engine = 'BLENDER_EEVEE'
scene.eevee.taa_render_samples = 16
scene.eevee.use_gtao = True
scene.eevee.use_soft_shadows = True
scene.view_settings.view_transform = 'Standard'
scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = 640, 720, 100
scene.render.filepath = picture
bpy.ops.render.render(write_still=True)
