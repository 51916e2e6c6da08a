import bpy

from .operators import TAUT_OT_simulate
from .sewing import TAUT_OT_sew


class TAUT_PT_cloth(bpy.types.Panel):
    bl_label = 'Taut'
    bl_space_type = 'PROPERTIES'
    bl_region_type = 'WINDOW'
    bl_context = 'physics'
    bl_options = {'DEFAULT_CLOSED'}

    @classmethod
    def poll(cls, context):
        return context.object is not None and context.object.type == 'MESH'

    def draw(self, context):
        layout, settings = self.layout, context.object.taut
        layout.use_property_split = True
        layout.prop(settings, 'fabric')
        layout.prop(settings, 'max_stretch')
        layout.prop(settings, 'mesh')
        layout.prop_search(settings, 'pin_group', context.object, 'vertex_groups')
        layout.prop(settings, 'bodies')
        layout.prop(settings, 'wind')
        frames = layout.column(align=True)
        frames.prop(settings, 'frame_start')
        frames.prop(settings, 'frame_end')
        layout.operator(TAUT_OT_simulate.bl_idname)
        layout.prop(settings, 'live', toggle=True)
        layout.operator(TAUT_OT_sew.bl_idname)
        # Labels do not wrap.
        for line in settings.message.splitlines():
            layout.label(text=line)
