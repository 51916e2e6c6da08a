"""Live: cloths that go on as the timeline plays. Their frames are kept in a file that ends with the session."""
import pathlib

import bpy
from bpy.app.handlers import persistent

from . import cache
from .library import Refused
from .simulation import Simulation

runs = {}


def end(name: str) -> None:
    if name in runs:
        simulation, writer = runs.pop(name)
        simulation.cloth.close()
        writer.give_up()


def switched(settings, _context) -> None:
    obj = settings.id_data
    if not settings.live and obj.name in runs:
        end(obj.name)
        cache.detach(obj)


def begin(obj) -> None:
    end(obj.name)
    simulation = Simulation(bpy.context, obj, follows_timeline=True)
    path = pathlib.Path(bpy.app.tempdir) / pathlib.Path(cache.relative_path(obj)).name
    writer = cache.Writer(path, len(obj.data.vertices), simulation.first_frame)
    writer.add(simulation.positions)
    runs[obj.name] = simulation, writer
    cache.attach(obj, str(writer.partial), simulation.first_frame)


def follow(obj, frame: int) -> None:
    """The cloth at this frame, if it is the start, the next, or one that was."""
    if frame == obj.taut.frame_start:
        begin(obj)
        obj.taut.message = '\n'.join(runs[obj.name][0].remarks)
    elif obj.name not in runs:
        obj.taut.message = f'Live begins at frame {obj.taut.frame_start}'
    elif frame == runs[obj.name][0].frame + 1:
        simulation, writer = runs[obj.name]
        writer.add(simulation.step())
        obj.taut.message = f'Stretch at most {100 * simulation.largest_stretch:.2f} %'
    elif frame > runs[obj.name][0].frame:
        obj.taut.message = f'Live is at frame {runs[obj.name][0].frame}\nand needs every frame'


@persistent
def frame_changed(scene, _depsgraph) -> None:
    for obj in scene.objects:
        if obj.type == 'MESH' and obj.taut.live:
            try:
                follow(obj, scene.frame_current)
            except Refused as refusal:
                print(f'Taut: {refusal}')
                obj.taut.message = str(refusal)


@persistent
def file_opened(_file) -> None:
    for name in list(runs):
        end(name)


def register() -> None:
    bpy.app.handlers.frame_change_post.append(frame_changed)
    bpy.app.handlers.load_pre.append(file_opened)


def unregister() -> None:
    bpy.app.handlers.frame_change_post.remove(frame_changed)
    bpy.app.handlers.load_pre.remove(file_opened)
    file_opened('')
