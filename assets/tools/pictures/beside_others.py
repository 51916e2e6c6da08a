"""Run by beside_others.sh in Blender: draws a mesh by Eevee as cotton or velvet, or by Cycles in Taut's own studio."""
import math
import sys

import bpy
from mathutils import Matrix, Vector
import numpy

mesh, picture, look, eye, target, degrees, floor_m, outside, inside, translucency = sys.argv[sys.argv.index('--') + 1:]
# Taut's studio: directions and strengths of the lamps and strength of the sky (renderer/frame_view), their colours
# (shaders/cloth_light.glsl), the key lamp's angular diameter (renderer/gl/gl_objects.cpp), and the floor.
LAMPS = {'key': ((-0.90, 1.50, 0.42), 1.2, (1.02, 1.0, 0.97), 2 * math.atan(0.10)),
         'fill': ((0.95, 0.30, 0.55), 0.12, (1, 1, 1), 1.0)}
SKY, SKY_COLOUR, FLOOR, BOUNCE = 0.27, (0.965, 1.0, 1.055), '#e2e1de', (1.13, 1.10, 1.04)
THROUGH_GAIN = 1.6
KNEE = 0.65  # film curve of shaders/frame.glsl


def linear(colour):
    """Returns the light of an sRGB colour as #rrggbb."""
    return [((c / 255 + 0.055) / 1.055) ** 2.4 for c in bytes.fromhex(colour[1:])]


def in_blender(x, y, z):
    """Blender's z is up."""
    return Vector((x, -z, y))


def looking(thing, at, towards):
    back = (at - towards).normalized()
    right = Vector((0, 0, 1)).cross(back).normalized()
    turn = Matrix((right, back.cross(right), back)).transposed().to_4x4()
    thing.matrix_world = Matrix.Translation(at) @ turn
    scene.collection.objects.link(thing)


def add_sun(name, direction, energy, angle, colour=(1, 1, 1)):
    sun = bpy.data.objects.new(name, bpy.data.lights.new(name, 'SUN'))
    sun.data.energy, sun.data.angle, sun.data.color = energy, angle, colour
    looking(sun, towards + direction, towards)


def material(name, colour, **inputs):
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    for key, value in {'Base Color': (*colour, 1), **inputs}.items():
        made.node_tree.nodes['Principled BSDF'].inputs[key.replace('_', ' ')].default_value = value
    return made


def matt_cloth():
    """Returns cloth that reflects its colour and lets light through as Taut's does."""
    made = bpy.data.materials.new('matt')
    made.use_nodes = True
    nodes, links = made.node_tree.nodes, made.node_tree.links
    both, there, through = (nodes.new('ShaderNode' + kind) for kind in ('AddShader', 'BsdfDiffuse', 'BsdfTranslucent'))
    side, colour = (nodes.new('ShaderNode' + kind) for kind in ('NewGeometry', 'MixRGB'))
    colour.inputs[1].default_value, colour.inputs[2].default_value = (*linear(outside), 1), (*linear(inside), 1)
    links.new(side.outputs['Backfacing'], colour.inputs['Fac'])
    links.new(colour.outputs[0], there.inputs['Color'])
    through.inputs['Color'].default_value = (*(THROUGH_GAIN * float(translucency) * c ** 1.5 for c in linear(outside)), 1)
    links.new(there.outputs[0], both.inputs[0])
    links.new(through.outputs[0], both.inputs[1])
    links.new(both.outputs[0], nodes['Material Output'].inputs['Surface'])
    return made


def floor_as_taut(colour):
    """Returns a floor that the camera sees in its colour and that lights cloth as Taut's does: by half of the sky."""
    made = material('floor', colour, Specular=0.0, Roughness=1.0)
    nodes, links = made.node_tree.nodes, made.node_tree.links
    ray, both, glow = (nodes.new('ShaderNode' + kind) for kind in ('LightPath', 'MixShader', 'Emission'))
    glow.inputs['Color'].default_value = (*(0.5 * SKY * c * b for c, b in zip(linear(FLOOR), BOUNCE)), 1)
    links.new(ray.outputs['Is Camera Ray'], both.inputs['Fac'])
    links.new(glow.outputs[0], both.inputs[1])
    links.new(nodes['Principled BSDF'].outputs[0], both.inputs[2])
    links.new(both.outputs[0], nodes['Material Output'].inputs['Surface'])
    return made


def light_as_taut():
    back = at - towards
    behind = Vector((back.x, back.y, 0)).normalized()
    right = Vector((-behind.y, behind.x, 0))
    for name, (lamp, strength, colour, angle) in LAMPS.items():
        direction = lamp[0] * right + lamp[1] * Vector((0, 0, 1)) + lamp[2] * behind
        add_sun(name, direction, math.pi * strength, angle, colour)
    nodes, links = scene.world.node_tree.nodes, scene.world.node_tree.links
    place, parts, upper = (nodes.new('ShaderNode' + kind) for kind in ('TexCoord', 'SeparateXYZ', 'Math'))
    upper.operation, upper.inputs[1].default_value = 'GREATER_THAN', 0.0
    links.new(place.outputs['Generated'], parts.inputs[0])
    links.new(parts.outputs['Z'], upper.inputs[0])
    links.new(upper.outputs[0], nodes['Background'].inputs['Strength'])
    nodes['Background'].inputs['Color'].default_value = (*(SKY * c for c in SKY_COLOUR), 1)
    key, direction = LAMPS['key'][1], Vector(LAMPS['key'][0]).normalized()
    return [c / (key * direction.y + SKY) for c in linear(FLOOR)]  # the floor shows its colour where nothing shades it


def develop(raw):
    """Maps the tones of a picture of linear light as Taut's film does."""
    loaded = bpy.data.images.load(raw)
    loaded.colorspace_settings.name = 'Non-Color'
    light = numpy.array(loaded.pixels[:]).reshape(-1, 4)
    rgb = light[:, :3]

    def bend(x):
        over = numpy.maximum(x - KNEE, 0) / (1 - KNEE)
        return numpy.minimum(x, KNEE) + (1 - KNEE) * over / (1 + over)
    peak = numpy.maximum(rgb.max(axis=1, keepdims=True), 1e-4)
    rgb = 0.6 * rgb * bend(peak) / peak + 0.4 * bend(rgb)
    encoded = numpy.where(rgb < 0.0031308, rgb * 12.92, 1.055 * numpy.maximum(rgb, 1e-9) ** (1 / 2.4) - 0.055)
    done = bpy.data.images.new('done', *loaded.size)
    done.colorspace_settings.name = 'Non-Color'
    done.pixels = numpy.column_stack((encoded, numpy.ones(len(rgb)))).ravel()
    done.filepath_raw, done.file_format = picture, 'PNG'
    done.save()


scene = bpy.context.scene
for thing in list(bpy.data.objects):
    bpy.data.objects.remove(thing)
bpy.ops.import_scene.obj(filepath=mesh)
shirt = bpy.context.selected_objects[0]
for polygon in shirt.data.polygons:
    polygon.use_smooth = True
at, towards = (in_blender(*map(float, text.split(','))) for text in (eye, target))
camera = bpy.data.objects.new('camera', bpy.data.cameras.new('camera'))
camera.data.sensor_fit = 'VERTICAL'
camera.data.angle_y = math.radians(float(degrees))
looking(camera, at, towards)
scene.camera = camera
scene.world.use_nodes = True
scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = 640, 720, 100
scene.render.filepath = picture
scene.view_settings.view_transform = 'Standard'
shirt.data.materials.clear()
if look == 'cycles':
    shirt.modifiers.new('smooth', 'SUBSURF').render_levels = 2
    shirt.data.materials.append(matt_cloth())
    floor = floor_as_taut(light_as_taut())
    scene.render.engine = 'CYCLES'
    scene.cycles.samples, scene.cycles.use_denoising, scene.cycles.max_bounces = 256, False, 8
    scene.view_settings.view_transform = 'Raw'
    scene.render.image_settings.file_format, scene.render.filepath = 'OPEN_EXR', picture + '.exr'
else:
    colour = (0.76, 0.75, 0.69) if look == 'cotton' else (0.09, 0.10, 0.11)
    shirt.data.materials.append(material(
        'cloth', colour, Roughness=0.9 if look == 'cotton' else 1.0, Specular=0.2,
        Sheen=0.3 if look == 'cotton' else 1.0, Sheen_Tint=0.5))
    floor = material('floor', (0.85, 0.85, 0.84), Specular=0.0, Roughness=1.0)
    add_sun('sun', Vector((-1.4, -1.6, 4.0)), 3.0, 0.2)
    scene.world.node_tree.nodes['Background'].inputs['Color'].default_value = (0.75, 0.78, 0.82, 1)
    scene.world.node_tree.nodes['Background'].inputs['Strength'].default_value = 0.6
    scene.render.engine = 'BLENDER_EEVEE'
    scene.eevee.taa_render_samples = 16
    scene.eevee.use_gtao = True
    scene.eevee.use_soft_shadows = True
bpy.ops.mesh.primitive_plane_add(size=40, location=(0, 0, float(floor_m)))
bpy.context.object.data.materials.append(floor)
bpy.ops.render.render(write_still=True)
if look == 'cycles':
    develop(picture + '.exr')
