"""A square of silk swings down from two of its corners; plots its largest stretch against time."""
import numpy as np
import taut

side = 21
z, x = np.mgrid[0:side, 0:side] * 0.05
v = np.arange(side * side).reshape(side, side)
faces = np.stack([v[:-1, :-1], v[1:, :-1], v[1:, 1:], v[:-1, 1:]], axis=-1).reshape(-1, 4)
cloth = taut.Cloth(positions=np.stack([x, 0 * x, z], axis=-1).reshape(-1, 3), faces=faces,
                   settings={'cloth.fabric': 'silk', 'solver.max_stretch': 0.01})
cloth.pins = [0, side - 1]
for k in range(12):
    frame = cloth.step(5)
    print(f'{frame.time_s:.2f} s {100 * frame.max_surface_stretch:.3f} %', '#' * round(5000 * frame.max_surface_stretch))
