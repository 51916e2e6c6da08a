"""Sew: a pattern becomes a garment on the body that is the active object."""
import pathlib
import tempfile

import bpy
import numpy as np

from . import library
from .library import Refused, fabric_file
from .simulation import coordinates, evaluated, faces_of, transformed, turned, turned_back


def write_body(path: pathlib.Path, points: np.ndarray, faces: list) -> None:
    lines = ['v %.9g %.9g %.9g' % tuple(point) for point in points]
    lines += ['f ' + ' '.join(str(v + 1) for v in face) for face in faces]
    path.write_text('\n'.join(lines) + '\n')


def sew(context, pattern: pathlib.Path, fabric: str, max_stretch: float):
    """The garment as a new object: its mesh is as it is worn. Raises Refused with what to mend."""
    body, units = context.object, context.scene.unit_settings
    scale = 1.0 if units.system == 'NONE' else units.scale_length
    taut = library.load()
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / 'body.obj'
        with evaluated(body, context.view_layer.depsgraph) as (mesh, matrix):
            write_body(file, turned(transformed(coordinates(mesh), matrix)) * scale, faces_of(mesh))
        settings = {'body.file': str(file), 'body.scale': 1.0, 'body.up': 'y', 'solver.max_stretch': max_stretch / 100}
        if fabric:
            settings['cloth.fabric'] = fabric_file(fabric)
        try:
            with taut.Cloth(str(pattern), settings=settings,
                            log=lambda line: print(f'Taut: {pattern.name}: {line}')) as cloth:
                points, triangles = turned_back(cloth.positions()) / scale, cloth.triangles
        except taut.Error as error:
            raise Refused(f'{pattern.name}: {error}') from error
    made = bpy.data.meshes.new(pattern.stem)
    made.from_pydata(points.tolist(), [], np.asarray(triangles).tolist())
    garment = bpy.data.objects.new(pattern.stem, made)
    context.collection.objects.link(garment)
    bodies = bpy.data.collections.new(f'{body.name} in {pattern.stem}')
    bodies.objects.link(body)
    garment.taut.bodies, garment.taut.fabric, garment.taut.max_stretch = bodies, fabric, max_stretch
    return garment


class TAUT_OT_sew(bpy.types.Operator):
    """Sew a pattern, in the JSON of GarmentCode, on the active object, which is a person"""
    bl_idname = 'taut.sew'
    bl_label = 'Sew Pattern'
    bl_options = {'REGISTER', 'UNDO'}

    filepath: bpy.props.StringProperty(subtype='FILE_PATH')
    filter_glob: bpy.props.StringProperty(default='*.json', options={'HIDDEN'})
    fabric: bpy.props.StringProperty(name='Fabric', default='cotton')
    max_stretch: bpy.props.FloatProperty(name='Largest stretch', default=8, min=0.01, max=100, subtype='PERCENTAGE')

    @classmethod
    def poll(cls, context):
        return context.object is not None and context.object.type == 'MESH'

    def invoke(self, context, _event):
        context.window_manager.fileselect_add(self)
        return {'RUNNING_MODAL'}

    def execute(self, context):
        try:
            garment = sew(context, pathlib.Path(bpy.path.abspath(self.filepath)), self.fabric, self.max_stretch)
        except (Refused, OSError) as refusal:
            self.report({'ERROR'}, str(refusal))
            return {'CANCELLED'}
        self.report({'INFO'}, f'{garment.name} is sewn')
        return {'FINISHED'}
