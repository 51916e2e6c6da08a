"""A T-shirt on a mannequin that walks, simulated by the add-on and drawn by Cycles:

    blender -b --addons taut_cloth --python-exit-code 3 --python walking.py -- ASSETS [picture.png [SAMPLES]]

ASSETS is share/taut of an installed Taut, whose program puts the shirt on. Leaves walking.blend, with its cache, here.
"""
import math
import pathlib
import subprocess
import sys

import bpy
import numpy as np
from mathutils import Matrix, Vector

FRAMES = 70
SHOWN = (34, 43, 51)  # of the stride
TO_Z_UP = Matrix.Rotation(math.radians(90), 3, 'X')

arguments = sys.argv[sys.argv.index('--') + 1:]
assets = pathlib.Path(arguments[0])


def put_on():
    """The shirt as it is sewn, and as it lies on the mannequin: vertices in one order."""
    shirt = str(assets / 'garments' / 'tshirt_10600.obj')
    body = ['--body', str(assets / 'bodies' / 'mannequin_male_40.glb'), '--dress', '90', '--set', 'pins.at="none"',
            '--set', 'solver.max_stretch=0.01', '--fabric', 'jersey']
    for name, more in (('sewn.obj', []), ('worn.obj', body)):
        subprocess.run(['taut', 'simulate', shirt, '--frames', '0', '--quiet', '--export', name, *more], check=True)


def read_obj(name):
    lines = [line.split() for line in pathlib.Path(name).read_text().splitlines()]
    points = [TO_Z_UP @ Vector(map(float, line[1:4])) for line in lines if line[:1] == ['v']]
    return points, [[int(corner.split('/')[0]) - 1 for corner in line[1:]] for line in lines if line[:1] == ['f']]


def make_shirt(bodies):
    mesh = bpy.data.meshes.new('T-shirt')
    points, faces = read_obj('sewn.obj')
    mesh.from_pydata(points, [], faces)
    shirt = bpy.data.objects.new('T-shirt', mesh)
    bpy.context.scene.collection.objects.link(shirt)
    shirt.shape_key_add(name='sewn')
    worn = shirt.shape_key_add(name='worn')
    for key, point in zip(worn.data, read_obj('worn.obj')[0]):
        key.co = point
    worn.value = 1
    settings = shirt.taut
    settings.fabric, settings.max_stretch, settings.bodies = 'jersey', 1, bodies
    settings.wind = 6, 2, 0
    settings.frame_start, settings.frame_end = 1, FRAMES
    return shirt


def make_mannequin():
    np.bool = bool  # which Blender 3.4's glTF names, and numpy no longer has
    bpy.ops.import_scene.gltf(filepath=str(assets / 'bodies' / 'mannequin_male_40.glb'))
    imported = bpy.context.selected_objects
    bodies = bpy.data.collections.new('bodies')
    bpy.context.scene.collection.children.link(bodies)
    body = max((obj for obj in imported if obj.type == 'MESH'), key=lambda obj: len(obj.data.vertices))
    bodies.objects.link(body)
    return bodies, body, next(obj for obj in imported if obj.type == 'ARMATURE')


def joints_and_values(path):
    """Names of joints and their rotations (frames, joints, 3) in degrees about z, x and y, and where the hips are."""
    words = path.read_text().split()
    joints = [words[k + 1] for k, word in enumerate(words) if word in ('ROOT', 'JOINT')]
    values = np.array(words[words.index('Time:') + 2:], float).reshape(-1, 3 + 3 * len(joints))
    return joints, values[:, 3:].reshape(len(values), -1, 3), values[:, :3]


def walk(armature):
    """All angles 0 is the pose at rest; angles are about the axes of the world there."""
    joints, angles, hips = joints_and_values(assets / 'motions' / 'walk.bvh')
    for k, name in enumerate(joints):
        bone = armature.pose.bones[name]
        bone.rotation_mode = 'QUATERNION'
        rest = bone.bone.matrix_local.to_3x3()
        for frame in range(FRAMES):
            z, x, y = (Matrix.Rotation(math.radians(a), 3, axis) for a, axis in zip(angles[frame, k], 'ZXY'))
            turn = TO_Z_UP @ z @ x @ y @ TO_Z_UP.transposed()
            bone.rotation_quaternion = (rest.inverted() @ turn @ rest).to_quaternion()
            bone.keyframe_insert('rotation_quaternion', frame=1 + frame)
            if k == 0:
                bone.location = rest.inverted() @ TO_Z_UP @ Vector(hips[frame] - hips[0])
                bone.keyframe_insert('location', frame=1 + frame)


def material(name, colour, roughness, sheen=0.0):
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    shader = made.node_tree.nodes['Principled BSDF'].inputs
    shader['Base Color'].default_value = (*colour, 1)
    shader['Roughness'].default_value, shader['Sheen'].default_value = roughness, sheen
    shader['Specular'].default_value = 0.25
    return made


def moment(objects, frame, aside):
    """Copies the objects as they are at a frame, and puts the copies aside."""
    bpy.context.scene.frame_set(frame)
    for obj in objects:
        mesh = bpy.data.meshes.new_from_object(obj.evaluated_get(bpy.context.view_layer.depsgraph))
        copy = bpy.data.objects.new(f'{obj.name} {frame}', mesh)
        copy.matrix_world = Matrix.Translation((aside, 0, 0)) @ obj.matrix_world
        bpy.context.scene.collection.objects.link(copy)


def backdrop():
    """A floor that bends up into a wall, so that there is no horizon."""
    bend = [(6 + 4 * math.sin(a), 4 - 4 * math.cos(a)) for a in np.linspace(0, math.pi / 2, 25)]
    points = [(x, y, z) for y, z in [(-30, 0), *bend, (10, 30)] for x in (-60, 60)]
    mesh = bpy.data.meshes.new('backdrop')
    mesh.from_pydata(points, [], [(k, k + 1, k + 3, k + 2) for k in range(0, len(points) - 2, 2)])
    mesh.materials.append(material('paper', (0.62, 0.62, 0.62), 1.0))
    for face in mesh.polygons:
        face.use_smooth = True
    bpy.context.scene.collection.objects.link(bpy.data.objects.new('backdrop', mesh))


def sun(energy, direction):
    lamp = bpy.data.objects.new('sun', bpy.data.lights.new('sun', 'SUN'))
    lamp.data.energy, lamp.data.angle = energy, math.radians(12)
    lamp.rotation_euler = Vector(direction).to_track_quat('-Z', 'Y').to_euler()
    bpy.context.scene.collection.objects.link(lamp)


def draw(shirt, body, path, samples):
    scene = bpy.context.scene
    shirt.data.materials.append(material('jersey', (0.05, 0.26, 0.30), 0.85, 0.3))
    body.data.materials.clear()
    body.data.materials.append(material('plaster', (0.62, 0.60, 0.57), 0.55))
    for obj in (shirt, body):
        for face in obj.data.polygons:
            face.use_smooth = True
    for k, frame in enumerate(SHOWN):
        moment((shirt, body), frame, 1.08 * (k - 1))
    for obj in (shirt, body):
        obj.hide_render = True
    backdrop()
    sun(3.2, (0.9, 0.35, -0.75))
    scene.world = bpy.data.worlds.new('sky')
    scene.world.use_nodes = True
    scene.world.node_tree.nodes['Background'].inputs[0].default_value = (0.95, 0.97, 1, 1)
    scene.world.node_tree.nodes['Background'].inputs[1].default_value = 0.35
    camera = bpy.data.objects.new('camera', bpy.data.cameras.new('camera'))
    scene.collection.objects.link(camera)
    camera.location = (2.6, -8.4, 1.35)
    camera.data.lens = 85
    camera.rotation_euler = (Vector((0.04, 0, 0.93)) - camera.location).to_track_quat('-Z', 'Y').to_euler()
    scene.camera = camera
    scene.render.engine = 'CYCLES'
    scene.cycles.samples, scene.cycles.use_denoising = samples, False
    scene.render.resolution_x, scene.render.resolution_y = 1000, 600
    scene.view_settings.view_transform = 'Standard'
    scene.render.filepath = str(pathlib.Path(path).absolute())
    bpy.ops.render.render(write_still=True)


bpy.ops.wm.read_homefile(use_factory_startup=True, use_empty=True, load_ui=False)
bpy.ops.preferences.addon_enable(module='taut_cloth')
bpy.context.scene.render.fps = 30
put_on()
bodies, body, armature = make_mannequin()
walk(armature)
shirt = make_shirt(bodies)
bpy.ops.wm.save_as_mainfile(filepath=str(pathlib.Path('walking.blend').absolute()))
with bpy.context.temp_override(object=shirt):
    bpy.ops.taut.simulate()
bpy.ops.wm.save_mainfile()
if len(arguments) > 1:
    draw(shirt, body, arguments[1], int(arguments[2]) if len(arguments) > 2 else 128)
