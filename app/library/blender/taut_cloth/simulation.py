"""A garment of Blender as a cloth of the library. There, metres count and y is up."""
import contextlib
import re

import numpy as np

from . import cache, library
from .library import Refused, fabric_file


def turned(points: np.ndarray) -> np.ndarray:
    """From z up to y up."""
    return np.stack([points[..., 0], points[..., 2], -points[..., 1]], axis=-1)


def turned_back(points: np.ndarray) -> np.ndarray:
    return np.stack([points[..., 0], -points[..., 2], points[..., 1]], axis=-1)


def coordinates(mesh) -> np.ndarray:
    flat = np.empty(3 * len(mesh.vertices), np.float32)
    mesh.vertices.foreach_get('co', flat)
    return flat.reshape(-1, 3).astype(float)


def transformed(points: np.ndarray, matrix: np.ndarray) -> np.ndarray:
    return sum(points[:, k:k + 1] * matrix[:3, k] for k in range(3)) + matrix[:3, 3]


def faces_of(mesh) -> list:
    return [tuple(face.vertices) for face in mesh.polygons]


@contextlib.contextmanager
def evaluated(obj, depsgraph):
    """Its mesh with all that moves it, and its matrix."""
    instance = obj.evaluated_get(depsgraph)
    if not instance.is_evaluated:
        raise Refused(f'{obj.name}: found it left out of the view layer')
    try:
        yield instance.to_mesh(), np.array(instance.matrix_world)
    finally:
        instance.to_mesh_clear()


@contextlib.contextmanager
def without_cache(obj):
    """The modifiers before the cache alone."""
    off = [modifier for modifier in obj.modifiers[cache.place_in_stack(obj):] if modifier.show_viewport]
    for modifier in off:
        modifier.show_viewport = False
    try:
        yield
    finally:
        for modifier in off:
            modifier.show_viewport = True


class Simulation:
    """Goes from frame to frame with what leads the cloth there. Raises Refused with what to mend."""

    def __init__(self, context, obj, follows_timeline=False):
        self.follows_timeline = follows_timeline
        self.scene, self.view_layer, self.obj = context.scene, context.view_layer, obj
        self.taut = library.load()
        units = self.scene.unit_settings
        self.scale = 1.0 if units.system == 'NONE' else units.scale_length
        self.frame = self.first_frame = obj.taut.frame_start
        self.largest_stretch = 0.0
        self.remarks = []
        self.crossings = 0  # so far
        self.wind = None
        self.pins = pinned(obj)
        self.bodies = []  # and where they are
        with self.evaluation(self.frame) as depsgraph:
            self.cloth = self.make_cloth(depsgraph)
            self.remark_on_start('itself')
            self.positions = self.read_back()
            for body in bodies_of(obj):
                self.add_body(body, depsgraph)

    @contextlib.contextmanager
    def evaluation(self, frame: int):
        with without_cache(self.obj):
            # The current frame too: changes by hand since it came give way to keyed values.
            if not self.follows_timeline:
                self.scene.frame_set(frame)
            self.view_layer.update()
            yield self.view_layer.depsgraph

    def in_world(self, points: np.ndarray, matrix: np.ndarray) -> np.ndarray:
        return turned(transformed(points, matrix)) * self.scale

    def garment(self, depsgraph) -> np.ndarray:
        """Where the garment is before the cache, and self.matrix of this frame."""
        with evaluated(self.obj, depsgraph) as (mesh, self.matrix):
            if len(mesh.vertices) != len(self.obj.data.vertices):
                raise Refused(f'{self.obj.name}: found {len(mesh.vertices)} vertices with its modifiers and '
                              f'{len(self.obj.data.vertices)} without. Move what changes them below {cache.MODIFIER}')
            if np.linalg.cond(self.matrix[:3, :3]) > 1e6:
                raise Refused(f'{self.obj.name}: found a scale of 0')
            return self.in_world(coordinates(mesh), self.matrix)

    def make_cloth(self, depsgraph):
        start = self.garment(depsgraph)
        modelled = self.obj.data
        rest = self.in_world(coordinates(modelled), self.matrix)
        settings, render = self.obj.taut, self.scene.render
        gravity = np.array(self.scene.gravity) * self.scale * self.scene.use_gravity
        keys = {'time.frame_rate': render.fps / render.fps_base,
                'garment.mesh': settings.mesh,
                'solver.max_stretch': settings.max_stretch / 100,
                'gravity.acceleration': turned(gravity)}
        if settings.fabric:
            keys['cloth.fabric'] = fabric_file(settings.fabric)
        cloth = self.call(self.obj.name, self.taut.Cloth, positions=rest, faces=faces_of(modelled),
                          start=None if np.array_equal(rest, start) else start, settings=keys,
                          log=lambda line: print(f'Taut: {self.obj.name}: {line}'))
        cloth.pins = self.pins
        self.targets = start[self.pins]
        return cloth

    def add_body(self, body, depsgraph) -> None:
        with evaluated(body, depsgraph) as (mesh, matrix):
            positions = self.in_world(coordinates(mesh), matrix)
            self.call(f'{self.obj.name}: bodies', self.cloth.add_body, positions, faces_of(mesh), name=body.name)
            self.bodies.append((body, positions))
        self.remark_on_start(body.name)

    def remark_on_start(self, name: str) -> None:
        """Counts what crosses at the start, which may stay so."""
        crossings = self.cloth.info.crossings_at_start
        if crossings > self.crossings:
            self.remarks.append(f'Crossings with {name} at the start, which may stay: {crossings - self.crossings}')
        self.crossings = crossings

    def call(self, what: str, function, *arguments, **named):
        try:
            return function(*arguments, **named)
        except self.taut.Error as error:
            raise Refused(f'{what}: {self.with_places_turned(str(error))}') from error

    def with_places_turned(self, text: str) -> str:
        """Places as Blender shows them, in its unit and z up."""
        def place(found):
            point = turned_back(np.array(found[1].split(', '), float)) / self.scale
            return '[' + ', '.join(f'{coordinate:.5g}' for coordinate in point) + ']'

        number = r'-?[\d.]+(?:e[-+]?\d+)?'
        return re.sub(rf'\[({number}(?:, {number}){{2}})\](?: m\b)?', place, text)

    def lead(self, frame: int, depsgraph) -> None:
        """Moves the pins that have targets of their own in this frame; the others stay."""
        targets = self.garment(depsgraph)[self.pins]
        moving = (targets != self.targets).any(axis=1)
        if moving.any():
            self.cloth.move_pins(self.pins[moving], targets[moving])
        self.targets = targets
        for number, (body, before) in enumerate(self.bodies):
            with evaluated(body, depsgraph) as (mesh, matrix):
                target = self.in_world(coordinates(mesh), matrix)
            if len(target) != len(before):
                raise Refused(f'{body.name}: found {len(target)} vertices at frame {frame} and {len(before)} before')
            if not np.array_equal(target, before):
                self.call(f'{body.name}, frame {frame}', self.cloth.move_body, number, target)
                self.bodies[number] = body, target
        wind = list(self.obj.taut.wind)
        if wind != self.wind:
            self.cloth.set_wind(turned(np.array(wind)))
            self.wind = wind

    def step(self) -> np.ndarray:
        """One frame on; the positions in the space of the object."""
        frame = self.frame + 1
        with self.evaluation(frame) as depsgraph:
            self.lead(frame, depsgraph)
            result = self.call(f'Frame {frame}', self.cloth.step)
        self.largest_stretch = max(self.largest_stretch, result.max_surface_stretch)
        self.frame = frame
        self.positions = self.read_back()
        return self.positions

    def read_back(self) -> np.ndarray:
        world = turned_back(self.cloth.positions()) / self.scale
        return transformed(world, np.linalg.inv(self.matrix))


def pinned(obj) -> np.ndarray:
    """Vertices of the group that is chosen."""
    if obj.type != 'MESH':
        raise Refused(f'{obj.name}: found an object that is no mesh')
    if obj.mode != 'OBJECT':
        raise Refused(f'{obj.name}: found {obj.mode.lower()} mode, expected object mode')
    name = obj.taut.pin_group
    if not name:
        return np.array([], int)
    group = obj.vertex_groups.get(name)
    pins = [] if group is None else [v.index for v in obj.data.vertices
                                     if any(e.group == group.index and e.weight >= 0.5 for e in v.groups)]
    if not pins:
        found = 'no such vertex group' if group is None else 'no vertex of weight 0.5 or more'
        raise Refused(f'{obj.name}: pins: found {found}: {name}')
    return np.array(pins)


def bodies_of(obj) -> list:
    collection = obj.taut.bodies
    found = [body for body in collection.all_objects if body.type == 'MESH' and body != obj] if collection else []
    if collection and not found:
        raise Refused(f'{obj.name}: bodies: found no mesh in {collection.name}')
    for body in found:
        # The eye hides and lets move; the other ways to hide do not.
        if body.hide_viewport or not (body.visible_get() or body.hide_get()):
            raise Refused(f'{body.name}: found it disabled in viewports or left out of the view layer, where '
                          'Blender does not move it')
    return found
