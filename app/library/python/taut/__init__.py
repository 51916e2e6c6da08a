"""Taut: cloth that keeps a bound on its stretch and crosses nothing, simulated frame by frame.

    import taut
    cloth = taut.Cloth(scene='tshirt')
    print(cloth.step().max_surface_stretch)

Units: metres, kilograms, seconds, newtons; y is up. Arrays are numpy's; those of 32 or 64 bit floats are handed over
without a copy, whatever their strides. A cloth belongs to the process that made it: after os.fork(), and in workers of
multiprocessing that fork, a child makes its own. Everything that fails raises taut.Error with a text that says why. taut.h says what
each call does. The library is $TAUT_LIBRARY if that is set, else the installed one beside this package,
else libtaut of the system.
"""
from __future__ import annotations

import ctypes
import os
import pathlib
import struct
import zlib
from ctypes import POINTER, byref, c_char, c_char_p, c_double, c_int32, c_int64, c_size_t, c_uint32, c_uint64, c_void_p
from typing import Callable, NamedTuple, Optional, Sequence

try:
    import numpy as np
except ImportError:
    class _NoNumpy:
        """Scenes, settings, steps, saved states and Cloth.shape() do without."""

        def __getattr__(self, _name):
            raise Error(3, 'arrays need numpy, which is not installed')

    np = _NoNumpy()

__all__ = ['ABI_VERSION', 'Body', 'Cloth', 'Error', 'Frame', 'fabrics', 'scenes']

ABI_VERSION = 1


class Error(RuntimeError):
    """A call failed; `result` is its number in taut.h."""

    def __init__(self, result: int, text: str):
        super().__init__(text)
        self.result = result


class Frame(NamedTuple):
    """The measurements of a frame: TautFrame of taut.h."""
    frame: int
    time_s: float
    max_edge_stretch: float
    max_surface_stretch: float
    smallest_distance_m: float
    crossing_pairs: int
    state_hash: int
    substeps: int
    is_bound_kept: bool
    is_contact_kept: bool
    is_asleep: bool
    measured_crossings: int
    left_out_share: float
    wind_force_n: float
    wind_power_w: float


def _struct(**fields):
    def text(self):
        values = [f'{name}={getattr(self, name)!r}' for name in fields if name != 'struct_size']
        return f'{type(self).__name__}({", ".join(values)})'

    return type('Struct', (ctypes.Structure,), {'_fields_': list(fields.items()), '__repr__': text})


_Points = _struct(data=c_void_p, count=c_size_t, stride=c_size_t, type=c_int32)
_Mesh = _struct(struct_size=c_uint32, positions=_Points, corners=c_void_p, corner_count=c_size_t,
                corners_per_face=c_void_p, face_count=c_size_t)
_Body = _struct(struct_size=c_uint32, has_friction=c_int32, name=c_char_p, mesh=POINTER(_Mesh),
                plane_point=c_double * 3, plane_normal=c_double * 3, friction=c_double, dress=c_int32)
_Log = ctypes.CFUNCTYPE(None, c_void_p, c_char_p)
_Options = _struct(struct_size=c_uint32, threads=c_int32, scene=c_char_p, scene_text=c_char_p, mesh=POINTER(_Mesh),
                   start=POINTER(_Points), settings=POINTER(c_char_p), setting_count=c_size_t, importer=c_char_p,
                   log=_Log, log_user=c_void_p, counts_crossings=c_int32, bodies=POINTER(POINTER(_Body)),
                   body_count=c_size_t)
_Frame = _struct(struct_size=c_uint32, frame=c_int32, time_s=c_double, max_edge_stretch=c_double,
                 max_surface_stretch=c_double, smallest_distance_m=c_double, crossing_pairs=c_int64,
                 state_hash=c_uint64, substeps=c_int32, is_bound_kept=c_int32, is_contact_kept=c_int32,
                 is_asleep=c_int32, measured_crossings=c_uint64, left_out_share=c_double,
                 wind_force_n=c_double, wind_power_w=c_double)
_Info = _struct(struct_size=c_uint32, frame=c_int32, time_s=c_double, frame_rate_hz=c_double, max_stretch=c_double,
                vertex_count=c_size_t, triangle_count=c_size_t, edge_count=c_size_t, pin_count=c_size_t,
                body_count=c_size_t, crossings_at_start=c_size_t)
_Error = _struct(struct_size=c_uint32, result=c_int32, text=c_char * 1016)
_Cloth = _struct(id=c_uint64)
_Info.__name__ = 'Info'


def _load() -> ctypes.CDLL:
    above = pathlib.Path(__file__).resolve().parents
    # The library of a wheel, and the one that was installed with this file.
    beside = [above[0] / 'lib' / f'libtaut.so.{ABI_VERSION}', *([above[3] / 'libtaut.so'] if len(above) > 3 else [])]
    names = [os.environ.get('TAUT_LIBRARY', ''), *(str(file) for file in beside if file.exists()),
             f'libtaut.so.{ABI_VERSION}']
    library = ctypes.CDLL(next(filter(None, names)))
    library.taut_abi_version.restype = c_uint32
    if library.taut_abi_version() != ABI_VERSION:
        raise ImportError(f'libtaut has the interface {library.taut_abi_version()}, expected {ABI_VERSION}')
    for name in ('taut_version', 'taut_build_info', 'taut_last_error'):
        getattr(library, name).restype = c_char_p
    library.taut_last_error.argtypes = [_Cloth]
    library.taut_list.argtypes = [c_int32, c_char_p, c_size_t, POINTER(c_size_t)]
    vector = [c_double, c_double, c_double]
    points = POINTER(_Points)
    arguments = {
        'destroy': [], 'get_info': [POINTER(_Info)], 'step': [POINTER(_Frame)], 'set': [c_char_p, c_char_p],
        'set_wind': vector, 'set_gravity': vector, 'set_forces': [c_void_p, points],
        'set_pins': [c_void_p, c_size_t], 'get_pins': [c_void_p, c_size_t], 'move_pins': [c_void_p, points],
        'add_body': [POINTER(_Body), POINTER(c_int32)], 'move_body': [c_int32, points],
        'place_body': [c_int32, points], 'get_positions': [points], 'set_positions': [points],
        'get_stretch': [c_void_p, c_size_t], 'get_triangles': [c_void_p, c_size_t],
        'get_edges': [c_void_p, c_void_p, c_size_t], 'draw': [c_int32, c_int32, c_char_p, c_size_t], 'state_hash': [POINTER(c_uint64)],
        'save': [c_void_p, c_size_t, POINTER(c_size_t)], 'restore': [c_char_p, c_size_t], 'save_file': [c_char_p],
        'restore_file': [c_char_p]}
    for name, types in arguments.items():
        getattr(library, 'taut_' + name).argtypes = [_Cloth, *types]
    return library


_library = _load()
version: str = _library.taut_version().decode()
build_info: str = _library.taut_build_info().decode()


def _made(struct):
    return struct(struct_size=ctypes.sizeof(struct))


def _text(text) -> Optional[bytes]:
    return None if text is None else os.fspath(text).encode()


def _vertices(numbers) -> np.ndarray:
    return np.ascontiguousarray(numbers, dtype=np.uint32)


def _points(array, kept: list) -> _Points:
    """A view of an array of points, which lives as long as `kept`."""
    array = np.asarray(array)
    if array.dtype not in (np.float32, np.float64):
        array = array.astype(np.float64)
    if array.size == 0:
        array = np.zeros((0, 3))
    if array.ndim != 2 or array.shape[1] != 3:
        raise Error(3, f'found an array of shape {array.shape}, expected one of (count, 3)')
    if array.strides[1] != array.itemsize or array.strides[0] < 3 * array.itemsize:
        array = np.ascontiguousarray(array)
    kept.append(array)
    return _Points(array.ctypes.data, len(array), max(array.strides[0], 3 * array.itemsize),
                   int(array.dtype == np.float64))


def _mesh(positions, faces, kept: list) -> _Mesh:
    """`faces` is an array of (count, corners), or a list of lists of vertices."""
    mesh = _made(_Mesh)
    mesh.positions = _points(positions, kept)
    sizes = _vertices([len(face) for face in faces])
    corners = _vertices(np.concatenate([np.asarray(face) for face in faces]) if len(faces) else [])
    kept += [corners, sizes, mesh]
    mesh.corners, mesh.corner_count = corners.ctypes.data, len(corners)
    mesh.corners_per_face, mesh.face_count = sizes.ctypes.data, len(sizes)
    return mesh


class Body(NamedTuple):
    """A body that cloth stays out of: a closed mesh of positions and faces, or without them the plane. A mesh that the cloth is
    to be put on grows into it in `dress` frames before the first."""
    positions: Optional[np.ndarray] = None
    faces: Optional[Sequence] = None
    name: Optional[str] = None
    friction: Optional[float] = None
    point: Sequence[float] = (0, 0, 0)
    normal: Sequence[float] = (0, 1, 0)
    dress: int = 0


def _body(given: Body, kept: list) -> _Body:
    body = _made(_Body)
    if given.positions is not None:
        body.mesh = ctypes.pointer(_mesh(given.positions, given.faces if given.faces is not None else [], kept))
    body.name, body.dress = _text(given.name), given.dress
    body.has_friction, body.friction = given.friction is not None, given.friction or 0.0
    body.plane_point[:], body.plane_normal[:] = given.point, given.normal
    return body


def _names(kind: int) -> list[str]:
    size = c_size_t()
    if _library.taut_list(kind, None, 0, byref(size)) != 0:
        raise Error(4, 'found no scenes and fabrics; expected those of share/taut, or of $TAUT_ASSETS')
    buffer = ctypes.create_string_buffer(size.value)
    _library.taut_list(kind, buffer, size, byref(size))
    return buffer.value.decode().splitlines()


def scenes() -> list[str]:
    """The scenes that come with Taut, for Cloth(scene)."""
    return _names(0)


def fabrics() -> list[str]:
    """The fabrics that come with Taut, for set('cloth.fabric', name)."""
    return _names(1)


class Cloth:
    """A cloth: of a scene or a garment file, of the text of a scene, or of positions (vertices, 3) and faces. `settings`
    are keys of scenes, {'solver.max_stretch': 0.01}; `start` is the shape it begins in; `bodies` are there from the
    start, numbered behind those of the scene; `log` is called with lines about what was guessed, and what crosses."""

    def __init__(self, scene=None, *, text: Optional[str] = None, positions=None, faces=None, start=None,
                 bodies: Sequence[Body] = (), settings: Optional[dict] = None, threads: int = 0, counts_crossings: bool = False, importer=None,
                 log: Optional[Callable[[str], None]] = None):
        """Makes the cloth, in its first frame. Exactly one of `scene`, `text` and `positions` says which; `threads` 0: as many
        as the machine has. Raises Error with what was found and expected."""
        self._cloth = _Cloth(0)
        if sum(given is not None for given in (scene, text, positions)) != 1:
            raise Error(3, 'expected exactly one of scene, text and positions')
        kept: list = []
        options = _made(_Options)
        options.threads, options.counts_crossings = threads, counts_crossings
        options.scene, options.scene_text, options.importer = _text(scene), _text(text), _text(importer)
        if positions is not None:
            options.mesh = ctypes.pointer(_mesh(positions, faces if faces is not None else [], kept))
        if start is not None:
            options.start = ctypes.pointer(_points(start, kept))
        pointers = [ctypes.pointer(_body(body, kept)) for body in bodies]
        options.bodies, options.body_count = (POINTER(_Body) * len(pointers))(*pointers), len(pointers)
        lines = [f'{key} = {_value(value)}'.encode() for key, value in (settings or {}).items()]
        options.settings, options.setting_count = (c_char_p * len(lines))(*lines), len(lines)
        if log is not None:
            options.log = self._log = _Log(lambda _user, line: log(line.decode()))
        error = _made(_Error)
        result = _library.taut_create(byref(options), byref(self._cloth), byref(error))
        if result != 0:
            raise Error(result, error.text.decode(errors='replace'))

    def __repr__(self) -> str:
        return f'Cloth(frame {self.info.frame}, {self.info.triangle_count} triangles)' if self._cloth.id else 'Cloth(closed)'

    def close(self) -> None:
        """Ends the cloth; every later call raises."""
        if self._cloth.id != 0:
            _library.taut_destroy(self._cloth)
            self._cloth = _Cloth(0)
            self._log = None

    def __enter__(self) -> 'Cloth':
        return self

    def __exit__(self, *_) -> None:
        self.close()

    def __del__(self) -> None:
        if '_cloth' in self.__dict__ and _library is not None:
            self.close()

    def _call(self, name: str, *arguments) -> None:
        result = getattr(_library, 'taut_' + name)(self._cloth, *arguments)
        if result != 0:
            raise Error(result, _library.taut_last_error(self._cloth).decode(errors='replace'))

    @property
    def info(self) -> _Info:
        """TautInfo of taut.h: frame, time_s, frame_rate_hz, max_stretch, vertex_count, triangle_count, ..."""
        info = _made(_Info)
        self._call('get_info', byref(info))
        return info

    def step(self, frames: int = 1) -> Frame:
        """Goes on by so many frames, at least 1, and returns the measurements of the last."""
        if frames < 1:
            raise Error(3, f'found {frames} frames, expected at least 1')
        frame = _made(_Frame)
        for _ in range(frames):
            self._call('step', byref(frame))
        values = ((name, getattr(frame, name)) for name in Frame._fields)
        return Frame(*(bool(value) if name.startswith('is_') else value for name, value in values))

    def set(self, key: str, value) -> None:
        """Changes a setting while the cloth moves: set('cloth.fabric', 'silk')."""
        self._call('set', _text(key), _value(value).encode())

    def set_wind(self, velocity: Sequence[float]) -> None:
        """The velocity of the air in m/s."""
        self._call('set_wind', *velocity)

    def set_gravity(self, gravity: Sequence[float]) -> None:
        """In m/s^2."""
        self._call('set_gravity', *gravity)

    def _call_at(self, name: str, vertices, points) -> None:
        kept = [_vertices(vertices)]
        view = _points(points, kept)
        if len(kept[0]) != view.count:
            raise Error(3, f'found {view.count} points for {len(kept[0])} vertices')
        self._call(name, kept[0].ctypes.data, byref(view))

    def set_forces(self, vertices, forces) -> None:
        """Forces in N, (count, 3), on these vertices until the next call."""
        self._call_at('set_forces', vertices, forces)

    @property
    def pins(self) -> np.ndarray:
        """The vertices that are pinned, ascending; may be set."""
        pins = np.empty(self.info.pin_count, np.uint32)
        self._call('get_pins', pins.ctypes.data, len(pins))
        return pins

    @pins.setter
    def pins(self, vertices) -> None:
        kept = _vertices(vertices)
        self._call('set_pins', kept.ctypes.data, len(kept))

    def move_pins(self, vertices, targets) -> None:
        """Where these pins are at the end of the next frame, (count, 3)."""
        self._call_at('move_pins', vertices, targets)

    def add_body(self, positions, faces, *, name: Optional[str] = None, friction: Optional[float] = None) -> int:
        """Adds a closed mesh that the cloth stays out of. Returns its number. Cloth that crosses it may stay so: this is logged, and
        counted in info.crossings_at_start."""
        return self._add_body(Body(positions, faces, name, friction))

    def add_plane(self, point=(0, 0, 0), normal=(0, 1, 0), *, friction: Optional[float] = None) -> int:
        """Adds a plane, the ground unless it is said otherwise. Returns its number."""
        return self._add_body(Body(friction=friction, point=point, normal=normal))

    def _add_body(self, given: Body) -> int:
        kept: list = []
        number = c_int32()
        self._call('add_body', byref(_body(given, kept)), byref(number))
        return number.value

    def move_body(self, number: int, positions) -> None:
        """Where the vertices of a body are at the end of the next frame."""
        kept: list = []
        self._call('move_body', number, byref(_points(positions, kept)))

    def place_body(self, number: int, positions) -> None:
        """Puts a body somewhere at once."""
        kept: list = []
        self._call('place_body', number, byref(_points(positions, kept)))

    def positions(self, out: Optional[np.ndarray] = None) -> np.ndarray:
        """The positions (vertices, 3); filled into `out` where that is given, an array of floats whose rows are three
        numbers side by side."""
        if out is None:
            out = np.empty((self.info.vertex_count, 3))
        kept: list = []
        view = _points(out, kept)
        if kept[0] is not out or not out.flags.writeable:
            raise Error(3, 'found an array that cannot be filled: expected 32 or 64 bit floats, rows in one piece')
        self._call('get_positions', byref(view))
        return out

    def set_positions(self, positions) -> None:
        """Goes on from this shape, at rest."""
        kept: list = []
        self._call('set_positions', byref(_points(positions, kept)))

    def shape(self) -> tuple[list, list]:
        """The positions and the triangles as lists of three numbers each, which need no numpy."""
        info = self.info
        numbers = (c_double * (3 * info.vertex_count))()
        self._call('get_positions', byref(_Points(ctypes.addressof(numbers), info.vertex_count, 24, 1)))
        corners = (c_uint32 * (3 * info.triangle_count))()
        self._call('get_triangles', corners, len(corners))
        return list(zip(*[iter(numbers)] * 3)), list(zip(*[iter(corners)] * 3))

    @property
    def stretch(self) -> np.ndarray:
        """At each vertex the largest surface stretch of its triangles."""
        stretch = np.empty(self.info.vertex_count)
        self._call('get_stretch', stretch.ctypes.data, len(stretch))
        return stretch

    @property
    def triangles(self) -> np.ndarray:
        """The triangles that are simulated, (count, 3)."""
        triangles = np.empty((self.info.triangle_count, 3), np.uint32)
        self._call('get_triangles', triangles.ctypes.data, triangles.size)
        return triangles

    @property
    def edges(self) -> tuple[np.ndarray, np.ndarray]:
        """The vertices (count, 2) and the lengths at rest of all edges."""
        edges = np.empty((self.info.edge_count, 2), np.uint32)
        lengths = np.empty(len(edges))
        self._call('get_edges', edges.ctypes.data, lengths.ctypes.data, len(edges))
        return edges, lengths

    def draw(self, width: int = 640, height: int = 640) -> bytes:
        """The picture that `taut render` draws of this frame: red, green and blue of each pixel, row by row from above. Keys of
        pictures set its look. Needs Mesa's libOSMesa.so.8 (apt install libosmesa6) or EGL."""
        picture = ctypes.create_string_buffer(max(3 * width * height, 1))
        self._call('draw', width, height, picture, len(picture))
        return picture.raw

    def save_picture(self, path, width: int = 640, height: int = 640) -> None:
        """Draws this frame to a PNG file."""
        picture = self.draw(width, height)
        rows = b''.join(b'\0' + picture[at:at + 3 * width] for at in range(0, len(picture), 3 * width))
        size = struct.pack('>IIBBBBB', width, height, 8, 2, 0, 0, 0)
        with open(path, 'wb') as file:
            file.write(b'\x89PNG\r\n\x1a\n')
            for kind, content in ((b'IHDR', size), (b'IDAT', zlib.compress(rows, 9)), (b'IEND', b'')):
                checksum = zlib.crc32(kind + content)
                file.write(struct.pack('>I', len(content)) + kind + content + struct.pack('>I', checksum))

    @property
    def state_hash(self) -> int:
        """Of all bits of positions and velocities."""
        value = c_uint64()
        self._call('state_hash', byref(value))
        return value.value

    def save(self) -> bytes:
        """All that has to be kept to go on with the same bits."""
        size = c_size_t()
        self._call('save', None, 0, byref(size))
        buffer = ctypes.create_string_buffer(size.value)
        self._call('save', buffer, size, byref(size))
        return buffer.raw

    def restore(self, state: bytes) -> None:
        """Goes on from what save() returned."""
        self._call('restore', state, len(state))

    def save_file(self, path) -> None:
        """Saves to a file, which is written whole or not at all."""
        self._call('save_file', _text(path))

    def restore_file(self, path) -> None:
        """Goes on from a file of save_file() or of `taut simulate --checkpoint`."""
        self._call('restore_file', _text(path))


def _value(value) -> str:
    """As TOML; texts stay as they are."""
    value = value.tolist() if hasattr(value, 'tolist') else value  # of numpy
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, (list, tuple)):
        return '[' + ', '.join(repr(v) if isinstance(v, str) else _value(v) for v in value) + ']'
    return str(value)
