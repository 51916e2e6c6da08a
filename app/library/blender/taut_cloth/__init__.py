"""Taut in Blender: cloth that keeps a bound on its stretch and crosses nothing, as a cache or while the timeline plays.

`simulation` takes a garment and bodies from Blender to the library and back, `cache` is the file that stays with the
.blend file, `library` finds libtaut and fabrics.
"""
import bpy

from . import live, operators, panel, settings, sewing

bl_info = {
    'name': 'Taut Cloth',
    'description': 'Cloth that does not over-stretch and crosses nothing',
    'author': 'Taut',
    'version': (0, 1, 0),
    'blender': (3, 4, 0),
    'location': 'Properties > Physics > Taut',
    'category': 'Physics',
}

classes = (settings.TautPreferences, settings.TautSettings, operators.TAUT_OT_simulate, sewing.TAUT_OT_sew,
           panel.TAUT_PT_cloth)


def register():
    for each in classes:
        bpy.utils.register_class(each)
    bpy.types.Object.taut = bpy.props.PointerProperty(type=settings.TautSettings)
    live.register()


def unregister():
    live.unregister()
    del bpy.types.Object.taut
    for each in reversed(classes):
        bpy.utils.unregister_class(each)
