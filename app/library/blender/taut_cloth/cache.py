"""A PC2 file, which the Mesh Cache modifier plays, and other programs too."""
import os
import pathlib
import re
import struct

import bpy
import numpy as np

HEADER = struct.Struct('<12siiffi')
MODIFIER = 'Taut'
# Modifiers that keep the vertices there are: what stands before the cache leads the pins.
DEFORMING = {'ARMATURE', 'CAST', 'CORRECTIVE_SMOOTH', 'CURVE', 'DISPLACE', 'HOOK', 'LAPLACIANDEFORM', 'LAPLACIANSMOOTH',
             'LATTICE', 'MESH_CACHE', 'MESH_DEFORM', 'MESH_SEQUENCE_CACHE', 'SHRINKWRAP', 'SIMPLE_DEFORM', 'SMOOTH',
             'SURFACE_DEFORM', 'WARP', 'WAVE'}


class Writer:
    """Writes frames under a temporary name; close() gives the file its own, with the frames there are."""

    def __init__(self, path: pathlib.Path, vertex_count: int, first_frame: int):
        self.path = path
        self.partial = path.with_name(path.name + '.part')
        self.head = (b'POINTCACHE2\0', 1, vertex_count, first_frame, 1)
        self.frames = 0
        path.parent.mkdir(parents=True, exist_ok=True)
        self.file = open(self.partial, 'wb')

    def add(self, positions: np.ndarray) -> None:
        """From here on the file can be played with this frame, too."""
        self.frames += 1
        self.file.seek(0)
        self.file.write(HEADER.pack(*self.head, self.frames))
        self.file.seek(0, os.SEEK_END)
        self.file.write(np.ascontiguousarray(positions, '<f4').tobytes())
        self.file.flush()

    def close(self) -> None:
        self.file.close()
        os.replace(self.partial, self.path)

    def give_up(self) -> None:
        self.file.close()
        self.partial.unlink(missing_ok=True)


def relative_path(obj) -> str:
    """Names of objects are made names of files, different ones different."""
    return '//taut_cache/' + re.sub(r'[^\w -]', lambda c: f'%{ord(c[0]):02X}', obj.name) + '.pc2'


def place_in_stack(obj) -> int:
    """Where the cache stands or belongs: before the first modifier that adds vertices or takes some."""
    at = obj.modifiers.find(MODIFIER)
    kept = [modifier.type in DEFORMING for modifier in obj.modifiers]
    return at if at >= 0 else (kept + [False]).index(False)


def attach(obj, path: str, first_frame: int) -> None:
    place = place_in_stack(obj)
    modifier = obj.modifiers.get(MODIFIER)
    if modifier is None:
        modifier = obj.modifiers.new(MODIFIER, 'MESH_CACHE')
        with bpy.context.temp_override(object=obj):
            bpy.ops.object.modifier_move_to_index(modifier=MODIFIER, index=place)
    modifier.cache_format = 'PC2'
    modifier.forward_axis, modifier.up_axis = 'POS_Y', 'POS_Z'
    modifier.frame_start = first_frame
    modifier.filepath = path
    obj.update_tag()


def detach(obj) -> None:
    """Back to the cache that stays, or to none."""
    path = relative_path(obj)
    if bpy.data.filepath and os.path.exists(bpy.path.abspath(path)):
        attach(obj, path, obj.taut.frame_start)
    elif MODIFIER in obj.modifiers:
        obj.modifiers.remove(obj.modifiers[MODIFIER])
