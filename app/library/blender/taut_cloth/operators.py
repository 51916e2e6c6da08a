"""Simulate: in a window frame by frame, with Esc to end it; from a script all at once."""
import pathlib

import bpy

from . import cache
from .library import Refused
from .simulation import Simulation


class Run:
    """A simulation that becomes a cache, in any case of the frames that there are."""

    def __init__(self, context, obj):
        if not bpy.data.filepath:
            raise Refused('Save the .blend file first: the cache is kept beside it, in taut_cache')
        self.obj, self.last_frame = obj, obj.taut.frame_end
        obj.taut.live = False
        if self.last_frame <= obj.taut.frame_start:
            raise Refused(f'{obj.name}: found frames {obj.taut.frame_start} to {self.last_frame}')
        self.simulation = Simulation(context, obj)
        path = pathlib.Path(bpy.path.abspath(cache.relative_path(obj)))
        self.writer = cache.Writer(path, len(obj.data.vertices), obj.taut.frame_start)
        self.writer.add(self.simulation.positions)

    def is_done(self) -> bool:
        return self.simulation.frame >= self.last_frame

    def step(self) -> None:
        self.writer.add(self.simulation.step())

    def status(self) -> str:
        return f'Taut: frame {self.simulation.frame} of {self.last_frame}, stretch at most ' \
               f'{100 * self.simulation.largest_stretch:.2f} %. Esc: stop and keep the frames so far'

    def close(self) -> str:
        """Attaches what there is and says so."""
        self.simulation.cloth.close()
        self.writer.close()
        first, last = self.simulation.first_frame, self.simulation.frame
        cache.attach(self.obj, cache.relative_path(self.obj), first)
        kept = f'Frames {first} to {last}, stretch at most {100 * self.simulation.largest_stretch:.2f} %'
        stopped = [] if self.is_done() else [f'Stopped before frame {last + 1}']
        self.obj.taut.message = '\n'.join([*stopped, kept, *self.simulation.remarks])
        return self.obj.taut.message.replace('\n', '. ')


class TAUT_OT_simulate(bpy.types.Operator):
    """Simulate the cloth and keep it as a cache beside the .blend file"""
    bl_idname = 'taut.simulate'
    bl_label = 'Simulate'
    bl_options = {'UNDO'}

    @classmethod
    def poll(cls, context):
        return context.object is not None

    def begin(self, context) -> bool:
        try:
            self.run = Run(context, context.object)
        except (Refused, OSError) as refusal:
            self.report({'ERROR'}, str(refusal))
            return False
        return True

    def end(self, refusal=None):
        told = self.run.close()
        if refusal is not None:
            self.report({'ERROR'}, f'{refusal}. {told}')
        else:
            self.report({'INFO' if self.run.is_done() else 'WARNING'}, told)
        return {'FINISHED'}

    def execute(self, context):
        if not self.begin(context):
            return {'CANCELLED'}
        try:
            while not self.run.is_done():
                self.run.step()
        except (Refused, OSError) as refusal:
            return self.end(refusal)
        return self.end()

    def invoke(self, context, _event):
        if bpy.app.background:
            return self.execute(context)
        if not self.begin(context):
            return {'CANCELLED'}
        self.timer = context.window_manager.event_timer_add(0.001, window=context.window)
        context.window_manager.progress_begin(self.run.simulation.frame, self.run.last_frame)
        context.window_manager.modal_handler_add(self)
        return {'RUNNING_MODAL'}

    def modal(self, context, event):
        if event.type == 'ESC':
            return self.end_modal(context)
        if event.type == 'TIMER':
            try:
                self.run.step()
            except (Refused, OSError) as refusal:
                return self.end_modal(context, refusal)
            context.window_manager.progress_update(self.run.simulation.frame)
            context.workspace.status_text_set(self.run.status())
            if self.run.is_done():
                return self.end_modal(context)
        return {'RUNNING_MODAL'}

    def end_modal(self, context, refusal=None):
        context.window_manager.event_timer_remove(self.timer)
        context.window_manager.progress_end()
        context.workspace.status_text_set(None)
        return self.end(refusal)

    def cancel(self, context):
        """The window is closed."""
        self.end_modal(context)
