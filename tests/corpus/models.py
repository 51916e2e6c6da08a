"""The models, and what Taut has to say of each: fields of `taut inspect --json`, or the error."""
import shapes as s
import writers as w

BOUND = 0.05


class Model:
    def __init__(self, name, data, expected=None, error=None, options=(), simulate=(), refused=None):
        self.name = name
        self.data = data            # bytes, or a function that writes to a path
        self.expected = expected or {}
        self.error = error          # a regular expression
        self.options = list(options)    # of inspect and simulate
        self.simulate = list(simulate)  # of simulate alone
        self.refused = refused      # a regular expression: the error of simulate alone


def flat(nested, prefix=''):
    for key, value in nested.items():
        if isinstance(value, dict):
            yield from flat(value, prefix + key + '.')
        else:
            yield prefix + key, value


def in_every_format():
    """One cloth: every format has to give the same garment."""
    sheet, soup = s.sheet(), s.sheet(quads=False)
    same = {'vertices': 48, 'triangles': 70, 'topology.components': 1, 'topology.boundary_loops': 1,
            'springs.structural': 117, 'placement.up': 'y', 'area_m2': 0.48}
    yield Model('sheet.obj', w.obj(sheet), {**same, 'import.quads': 35, 'repairs.welded_vertices': 0})
    yield Model('sheet.ply', w.ply(sheet), {**same, 'import.quads': 35})
    yield Model('sheet_binary.ply', w.ply_binary(sheet), same)
    yield Model('sheet.stl', w.stl(soup), {**same, 'repairs.welded_vertices': 162})
    yield Model('sheet_binary.stl', w.stl_binary(soup), same)
    yield Model('sheet.gltf', w.gltf(sheet), {**same, 'placement.unit': 'metre, as the file says'})
    yield Model('sheet.glb', w.glb(sheet), same)
    yield Model('sheet.dae', w.dae(sheet), same)
    yield Model('sheet.fbx', w.fbx(sheet.scaled(100)),
                {**same, 'placement.metres_per_unit': 0.01, 'placement.unit': 'centimetre, as the file says'})
    yield Model('sheet.off', w.off(sheet), same)
    yield Model('sheet.3mf', lambda path: w.x3mf(sheet.scaled(1000).with_z_up(), path),
                {**same, 'placement.up': 'z', 'placement.metres_per_unit': 0.001, 'placement.guessed': True})


def units_and_axes():
    sheet, tube = s.sheet(), s.tube()
    for unit, metres in (('mm', 0.001), ('cm', 0.01), ('dm', 0.1), ('m', 1.0)):
        yield Model('tube_%s.obj' % unit, w.obj(tube.scaled(1 / metres)),
                    {'placement.metres_per_unit': metres, 'placement.guessed': unit != 'm'})
    yield Model('tube_asked.obj', w.obj(tube.scaled(30)), {'placement.metres_per_unit': 0.0254},
                options=['--units', 'in'])
    yield Model('inches.fbx', w.fbx(sheet.scaled(1 / 0.0254), 2.54), {'placement.metres_per_unit': 0.0254})
    yield Model('z_up.fbx', w.fbx(sheet.with_z_up().scaled(100), 1.0, 2),
                {'placement.up': 'z', 'placement.up_from': 'z, as the file says'})
    yield Model('z_up.dae', w.dae(sheet.with_z_up().scaled(1000), 0.001, 'Z_UP'), {'area_m2': 0.48})
    yield Model('no_unit.dae', w.dae(sheet.scaled(100), unit=False), {'placement.metres_per_unit': 0.01})
    yield Model('not_metres.glb', w.glb(sheet.scaled(100)),
                {'placement.metres_per_unit': 0.01, 'placement.guessed': True})
    yield Model('z_up.obj', w.obj(sheet.with_z_up()), {'placement.up': 'z', 'placement.guessed': True})
    yield Model('z_up_asked.obj', w.obj(sheet), {'placement.up': '-y'}, options=['--up', '-y'])
    yield Model('mirrored.gltf', w.gltf(sheet, ',"scale":[-1,1,1],"translation":[3,0,0]'), {'area_m2': 0.48})
    yield Model('tiny.obj', w.obj(sheet.scaled(1e-9)), {'placement.guessed': True, 'triangles': 70})
    yield Model('vast.obj', w.obj(sheet.scaled(1e9)), {'placement.guessed': True, 'triangles': 70})
    yield Model('far_away.ply', w.ply(s.sheet(3, 3, 600, 800).moved(1e6, 0, 0)), {'triangles': 8})


def faces():
    yield Model('triangle.obj', w.obj(s.triangle()), {'vertices': 3, 'springs.structural': 3, 'springs.flexural': 0})
    yield Model('two_triangles.ply', w.ply(s.two_triangles()), {'vertices': 4, 'springs.structural': 5})
    yield Model('star.obj', w.obj(s.star()), {'import.polygons': 1, 'triangles': 16, 'topology.components': 1})
    yield Model('star.fbx', w.fbx(s.star().scaled(100)), {'import.polygons': 1, 'triangles': 16})
    yield Model('star.off', w.off(s.star(4)), {'import.polygons': 1, 'triangles': 6})
    ngon = s.Shape([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0.5, 1, 0), (0, 1, 0)], [(0, 1, 2, 3, 4)])
    yield Model('collinear_corner.ply', w.ply(ngon), {'triangles': 3, 'repairs.degenerate_triangles': 0})
    lines = s.Shape(s.sheet().points, s.sheet().faces, lines=[(0, 1), (3, 9)], lone_points=[5])
    yield Model('lines_and_points.obj', w.obj(lines), {'import.ignored_lines': 2, 'import.ignored_points': 1})
    unused = s.Shape(s.triangle().points + [(5, 5, 5)], s.triangle().faces)
    yield Model('unused_vertex.ply', w.ply(unused), {'repairs.unused_vertices': 1, 'vertices': 3})
    yield Model('needles.obj', w.obj(s.needles()), {'triangles': 38})
    yield Model('hung_by_a_thread.obj', w.obj(s.hung_by_a_thread()), {'topology.components': 1})
    yield Model('crumpled.ply', w.ply_binary(s.crumpled()), {'topology.components': 1})


def repairs():
    sheet = s.sheet(quads=False)
    yield Model('soup.fbx', w.fbx(sheet.soup().scaled(100)),
                {'vertices': 48, 'repairs.welded_vertices': 162, 'topology.components': 1})
    yield Model('soup.glb', w.glb(sheet.soup()), {'vertices': 48})
    yield Model('twice.ply', w.ply(s.joined(sheet, sheet)),
                {'vertices': 48, 'repairs.duplicate_triangles': 70, 'topology.non_manifold_edges': 0})
    quads = s.sheet()
    both_sides = s.joined(quads, quads.with_faces([face[::-1] for face in quads.faces]))
    for make, kind in ((w.obj, 'obj'), (w.fbx, 'fbx')):
        yield Model('both_sides.' + kind, make(both_sides),
                    {'vertices': 48, 'repairs.duplicate_triangles': 70, 'topology.non_manifold_edges': 0})
    collapsed = sheet.with_faces(sheet.faces + [(0, 1, 1), (2, 2, 2), (0, 1, 2)])
    yield Model('zero_area.ply', w.ply(collapsed), {'repairs.degenerate_triangles': 3, 'triangles': 70})
    for make, kind in ((w.obj, 'obj'), (w.ply, 'ply'), (w.dae, 'dae')):
        yield Model('turned.' + kind, make(s.turned_some(sheet)),
                    {'repairs.turned_triangles': 14, 'topology.misoriented_edges': 0})
    yield Model('moebius.obj', w.obj(s.moebius()), {'topology.boundary_loops': 1, 'topology.euler_characteristic': 0})
    yield Model('fin.ply', w.ply(s.fin()), {'topology.non_manifold_edges': 1, 'springs.structural': 7})
    yield Model('fin.stl', w.stl(s.fin()), {'topology.non_manifold_edges': 1, 'springs.structural': 7})
    for make, kind in ((w.obj, 'obj'), (w.ply, 'ply'), (w.stl, 'stl')):
        yield Model('touching_layers.' + kind, make(s.touching_layers()),
                    {'vertices': 10, 'repairs.parted_vertices': 1, 'topology.components': 2})
    seam = s.joined(s.sheet(4, 4, 0.3, 0.3), s.sheet(4, 4, 0.3, 0.3).moved(0.3004, 0, 0))
    yield Model('open_seam.obj', w.obj(seam), {'topology.components': 2}, options=['--set', 'garment.weld=0'])
    yield Model('seam.obj', w.obj(seam), {'topology.components': 1, 'repairs.sewn_vertices': 4})
    yield Model('sewn_seam.obj', w.obj(seam), {'topology.components': 1, 'repairs.near_vertices': 4},
                options=['--set', 'garment.weld=0.001'])


def garments():
    skirt = s.tube(flare=0.25)
    yield Model('skirt.obj', w.obj(skirt), {'topology.boundary_loops': 2, 'parts': [('top opening', 12)]})
    yield Model('skirt.fbx', w.fbx(skirt.scaled(100)), {'parts': [('top opening', 12)]})
    yield Model('shell.ply', w.ply(s.shell()), {'topology.boundary_edges': 0, 'parts': [('highest points', 24)]})
    yield Model('closed.glb', w.glb(s.tube(closed=True)), {'topology.boundary_loops': 0})
    layered = s.joined(s.tube(), s.tube(radius=0.22), s.tube(radius=0.24, height=0.4))
    yield Model('layered.obj', w.obj(layered), {'topology.components': 3, 'parts': [('top opening', 12)] * 3})
    pieces = s.joined(s.sheet(), s.sheet().moved(1, 0, 0), s.sheet(4, 4, 0.3, 0.3).moved(0, 1.2, 0))
    yield Model('pieces.dae', w.dae(pieces), {'topology.components': 3})
    yield Model('lying.ply', w.ply(s.sheet().mapped(lambda x, y, z: (x, 0, -y))), {'parts': [('back edge', 6)]},
                options=['--up', 'y'])
    many = s.joined(*[s.triangle().scaled(0.1).moved(0.1 * (k % 10), 0.1 * (k // 10), 0) for k in range(100)])
    yield Model('many_parts.stl', w.stl(many), {'triangles': 100})


def errors():
    yield Model('nothing.obj', b'', error='is empty')
    yield Model('prose.obj', b'Once upon a time there was a dress.\n', error='cannot read a model')
    yield Model('points.obj', w.obj(s.Shape(s.sheet().points, [])), error='cannot read a model')
    yield Model('damaged.obj', w.obj(s.sheet()).replace(b'-0.3 0 0', b'-0.3 zero 0', 1),
                error="line 1: found 'zero', expected a coordinate")
    yield Model('wrong_index.obj', w.obj(s.triangle()).replace(b'f 1 2 3', b'f 1 2 9'),
                error='line 4: a face uses vertex 9 of a model that has 3')
    yield Model('line.obj', b'v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2\nl 2 3\n', error='it has no faces')
    yield Model('flat_to_a_line.obj', w.obj(s.sheet().mapped(lambda x, y, z: (x, 0, 0))), error='no triangle with an area')
    yield Model('one_place.ply', w.ply(s.sheet().scaled(0)), error='no triangle with an area')
    yield Model('not_a_number.ply', w.ply(s.sheet()).replace(b'-0.3 0 0', b'nan 0 0', 1), error='not finite')
    yield Model('wrong_index.ply', w.ply(s.triangle()).replace(b'3 0 1 2', b'3 0 1 9'), error='cannot read a model')
    yield Model('cut_off.glb', w.glb(s.sheet())[:300], error='cannot read a model')
    yield Model('cut_off.stl', w.stl_binary(s.sheet())[:200], error='cannot read a model')
    yield Model('cut_off.3mf', b'PK\x03\x04' + b'\0' * 40, error='cannot read a model')
    yield Model('cut_off.dae', w.dae(s.sheet())[:500], error='cannot read a model')
    yield Model('vast_count.stl', b'cloth'.ljust(80, b' ') + b'\xff\xff\xff\x7f' + b'\0' * 50, error='cannot read a model')
    yield Model('picture.png', b'\x89PNG\r\n\x1a\n' + b'\0' * 64, error="cannot read a model|no PNG picture")
    yield Model('one_vertex_far_away.obj', w.obj(s.sheet()).replace(b'v -0.3 0 0', b'v -1e30 0 0', 1),
                error='reaches over 1e.30 of its units, but half of its edges')
    yield Model('far_too_far.ply', w.ply(s.sheet().moved(1e9, 0, 0)), error='no triangle with an area')


def runs():
    """Settings at their ends, on a cloth that is sound."""
    def run(name, *settings, shape=None, refused=None):
        options = [word for setting in settings for word in ('--set', setting)]
        return Model(name + '.obj', w.obj(shape or s.sheet()), simulate=options, refused=refused)
    yield run('run_no_pin', 'pins.at="none"')
    yield run('run_every_pin', 'pins.at=[%s]' % ','.join(str(v) for v in range(48)))
    yield run('run_no_gravity', 'gravity.acceleration=[0,0,0]')
    yield run('run_wind', 'wind.speed=200')
    yield run('run_long_step', 'time.frame_rate=1')
    yield run('run_hardly_any_stretch', 'solver.max_stretch=1e-4', 'solver.bound="springs"')
    yield run('run_hardly_any_stretch_of_the_surface', 'solver.max_stretch=1e-4',
              refused='not promised where gravity .* amount to 9.81 m/s2; .* or a bound of at least 0.00032')
    yield run('run_no_stretch', 'solver.max_stretch=0', refused='solver.max_stretch: found 0, expected at least 0.0001')
    yield run('run_gale', 'solver.max_stretch=1e-4', 'solver.bound="springs"', 'wind.speed=50',
              refused='not promised in gusts .* of 50 m/s; expected at most 2 m/s, or a bound of at least 0.0005')
    yield run('run_shaken', 'pins.motion.amplitude=[10,0,0]', 'pins.motion.frequency=1000',
              refused='not promised where gravity and the pins. motion amount to 3.9')
    yield run('run_torn', 'forces=[{vertex=3,force=[0,0,1e6]}]', 'solver.max_stretch=1e-4', 'solver.bound="springs"',
              refused='not promised where a vertex is pulled by 1e.06 N; expected at most 1e.04 N')
    yield run('run_wind_of_1000', 'wind.speed=1000', refused='found 1000, expected a number from 0 to 200')
    yield run('run_gravity_without_end', 'gravity.acceleration=[0,-1e30,0]', refused='expected three numbers')
    yield run('run_diverges', 'solver.kind="ideal"', 'solver.substeps=1', 'solver.stiffness.structural=1e300',
              refused='the simulation diverged')
    yield run('run_heavy_gravity', 'gravity.acceleration=[0,-1e4,0]')
    yield run('run_too_many', 'garment.subdivisions=5', shape=s.sheet(60, 40), refused='more than the 4000000')
    yield run('run_too_small', 'garment.scale=1e-30', refused='e-31 m large; expected 0.0001 m to 10000 m')
    yield run('run_heavy', 'garment.areal_density=1000')
    yield run('run_light', 'garment.areal_density=1e-6')
    yield run('run_one_triangle', shape=s.triangle())
    yield run('run_falling_part', 'pins.at=[0]', shape=s.joined(s.sheet(), s.sheet().moved(1, 0, 0)))


def all_models():
    for group in (in_every_format, units_and_axes, faces, repairs, garments, errors, runs):
        yield from group()
