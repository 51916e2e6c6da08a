"""The add-on in Blender's window: xvfb-run -a blender --factory-startup --enable-event-simulate --python-exit-code 3
--python test_window.py -- ZIP

Simulate shows how far it is, and Esc ends it with the frames so far, which play.
"""
import os
import pathlib
import shutil
import struct
import sys
import tempfile
import time

import bpy
import numpy as np

folder = pathlib.Path(tempfile.mkdtemp())
cache = folder / 'taut_cache' / 'Grid.pc2'
told = []


def make_scene():
    bpy.ops.preferences.addon_install(filepath=sys.argv[-1])
    bpy.ops.preferences.addon_enable(module='taut_cloth')
    bpy.ops.mesh.primitive_grid_add(x_subdivisions=40, y_subdivisions=40, size=0.5)
    obj = bpy.context.object
    obj.vertex_groups.new(name='corner').add([0], 1, 'REPLACE')
    obj.taut.pin_group = 'corner'
    obj.taut.frame_end = 5000
    bpy.ops.wm.save_as_mainfile(filepath=str(folder / 'scene.blend'))
    sys.modules['taut_cloth.operators'].Run.status = lambda run, of=sys.modules['taut_cloth.operators'].Run.status: \
        told.append(of(run)) or told[-1]
    return obj


def check(obj):
    """The frames that were kept are those that were told of, and play."""
    data = cache.read_bytes()
    count, frames = struct.unpack('<16xi8xi', data[:32])
    assert os.listdir(cache.parent) == ['Grid.pc2'], os.listdir(cache.parent)
    assert frames == len(told) + 1 and count == len(obj.data.vertices), (frames, len(told), count)
    assert told[4].startswith('Taut: frame 6 of 5000, stretch at most 0.') and 'Esc' in told[4], told[4]
    assert obj.taut.message.startswith(f'Stopped before frame {frames + 1}\nFrames 1 to {frames},'), obj.taut.message
    bpy.context.scene.frame_set(frames)
    shown = np.array([v.co for v in obj.evaluated_get(bpy.context.view_layer.depsgraph).data.vertices], '<f4')
    assert shown.tobytes() == data[-12 * count:] and shown[:, 2].min() < -0.01, shown[:, 2].min()


def wait_until(is_so, what):
    end = time.monotonic() + 60
    while time.monotonic() < end:
        if is_so():
            return
        yield 0.1
    raise AssertionError(f'waited a minute until {what}')


def drive():
    """Does what a person does, one thing after the other; each yields the seconds until the next."""
    window = bpy.context.window_manager.windows[0]
    area = next(area for area in window.screen.areas if area.type == 'VIEW_3D')
    with bpy.context.temp_override(window=window, area=area):
        obj = make_scene()
        yield 0.5
        bpy.ops.taut.simulate('INVOKE_DEFAULT')
    yield from wait_until(lambda: len(told) >= 10, 'ten frames were told of')
    assert not cache.exists() and cache.with_name('Grid.pc2.part').exists()
    for value in ('PRESS', 'RELEASE'):
        window.event_simulate(type='ESC', value=value, x=100, y=100)
    yield from wait_until(cache.exists, 'Esc kept the frames')
    yield 0.5
    check(obj)


steps = drive()


def next_step():
    try:
        return next(steps)
    except StopIteration:
        code = 0
    except BaseException:
        sys.excepthook(*sys.exc_info())
        code = 3
    shutil.rmtree(folder)
    print('window: ok' if code == 0 else 'window: failed', flush=True)
    os._exit(code)


bpy.app.timers.register(next_step, first_interval=1)
