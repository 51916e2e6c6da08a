"""The settings of a cloth, saved with its object."""
import bpy
from bpy.props import (BoolProperty, EnumProperty, FloatProperty, FloatVectorProperty, IntProperty, PointerProperty,
                       StringProperty)

from . import library, live


def frame_or_scenes(name):
    """The access to a frame that is the scene's of this name until it is set."""
    return {'get': lambda settings: settings.get(name, getattr(bpy.context.scene, name)),
            'set': lambda settings, frame: settings.__setitem__(name, frame)}


class TautPreferences(bpy.types.AddonPreferences):
    bl_idname = __package__
    library: StringProperty(name='Library', subtype='FILE_PATH', update=lambda _self, _context: library.forget(),
                            description='libtaut.so of an installed Taut; empty: looked for')

    def draw(self, _context):
        self.layout.prop(self, 'library')


class TautSettings(bpy.types.PropertyGroup):
    fabric: StringProperty(
        name='Fabric', default='cotton', options=set(), search_options={'SUGGESTION'},
        search=lambda _self, _context, _typed: sorted(file.stem for file in library.FABRICS.glob('*.toml')),
        description='What it is made of: one of the list, or a file like theirs; empty: light and soft')
    max_stretch: FloatProperty(
        name='Largest stretch', default=1, min=0.01, max=100, subtype='PERCENTAGE', precision=2, options=set(),
        description='No triangle is ever longer than this, along any direction')
    mesh: EnumProperty(
        name='Simulate', default='auto', options=set(),
        items=[('auto', 'Whatever is fit for it', 'The mesh itself, unless it crosses itself, has two walls, needles or '
                'more than 16000 triangles'),
               ('model', 'The mesh itself', 'Each vertex is simulated'),
               ('fitted', 'A mesh that is fitted to it', 'The mesh follows one of even triangles; both promises are '
                'kept by that one')],
        description='Which mesh is simulated')
    pin_group: StringProperty(
        name='Pins', options=set(), description='Vertex group; vertices of weight 0.5 and more go where the object, its '
        'shape keys and its armature take them')
    wind: FloatVectorProperty(name='Wind', subtype='XYZ', description='Velocity of the air in m/s; may be animated')
    bodies: PointerProperty(name='Bodies', type=bpy.types.Collection,
                            description='Meshes that the cloth stays out of: closed, and moved by whatever moves them')
    frame_start: IntProperty(name='Start', options=set(), description='The cloth is as it is modelled or posed here; '
                             'the first frame of the scene until it is set', **frame_or_scenes('frame_start'))
    frame_end: IntProperty(name='End', options=set(), description='The last frame of the scene until it is set',
                           **frame_or_scenes('frame_end'))
    live: BoolProperty(name='Live', update=live.switched, options=set(),
                       description='Simulates while the timeline plays, from the start frame on')
    message: StringProperty(options={'SKIP_SAVE'})
