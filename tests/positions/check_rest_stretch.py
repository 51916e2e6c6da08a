"""Whether a shirt of a fabric rests alike at any frame rate and at any size: check_rest_stretch.py TAUT SOURCE FOLDER

Where lengths are SIZE times as large, times are by its root, and stiffness so that strains are the same."""

import pathlib
import sys

from measure import read_obj
from program import Program, judged, settings

SECONDS = 6
COTTON = {"tensile_warp": 12000, "tensile_weft": 8000, "shear": 48}
# Folds of a shirt that hangs lie one way or another by the last bit of what blows, and a few triangles beside its pins are
# stretched by them. The mean of the others over winds that differ by a thousandth is what rates and sizes have in common.
# In half a metre per second: the hem flutters in a whole one.
WINDS = (0.4995, 0.49995, 0.5, 0.50005, 0.5005)
# Absolute; and of the mean height, in m. Folds lie elsewhere.
STRETCH = 0.002
HEIGHT = 0.003


def keys(size, rate_hz, wind, law):
    root = size ** 0.5
    return {"garment__scale": size, "garment__weld": 0, "time__frame_rate": rate_hz / root, "time__frames": round(SECONDS * rate_hz),
            "wind__speed": wind * root, "wind__pressure": 1.2 / size, "wind__friction": 0.05 / size, "air__drag": 2 / root,
            "rest__speed": 0, "solver__max_stretch": 0.05, "solver__contact": False,
            "cloth__bending_rigidity": 5e-6 * size ** 3, "cloth__compression_stiffness": 30 * size,
            **{f"cloth__{name}": value * size for name, value in law.items()}}


def mean(values):
    return sum(values) / len(values)


def rested(program, name, size=1, rate_hz=60, **law):
    """The largest stretch of its surface, but for a hundredth of it, and its mean height, as if it were of size 1, over all winds."""
    found = []
    for wind in WINDS:
        program.run("simulate", "tshirt-wind-1", "--quiet", "--stats", f"{name}.jsonl", "--export", f"{name}.obj",
                    *settings(garment__file=str(program.shirt(5280)), **keys(size, rate_hz, wind, law)))
        points = read_obj(program.folder / f"{name}.obj")[0]
        found.append((program.statistics(f"{name}.jsonl")[-1]["p99_surface_stretch"], mean([y for _, y, _ in points]) / size))
    return tuple(map(mean, zip(*found, strict=True)))


def complaints(name, found, expected):
    print(f"{name}: stretch {100 * found[0]:.2f} %, for {100 * expected[0]:.2f} %; at {found[1]:.4f} m, "
          f"for {expected[1]:.4f} m", flush=True)
    return [name] * any(abs(a - b) > most for a, b, most in zip(found, expected, (STRETCH, HEIGHT), strict=True))


def main(taut, source, folder):
    taut, source, folder = (pathlib.Path(path).resolve() for path in (taut, source, folder))
    program = Program(taut, source / "assets", folder)
    folder.mkdir(parents=True, exist_ok=True)
    found = []
    for fabric, law in {"none": {}, "cotton": COTTON}.items():
        expected = rested(program, fabric, **law)
        for rate_hz in (24, 240):
            found += complaints(f"{fabric}, {rate_hz} Hz", rested(program, fabric, 1, rate_hz, **law), expected)
        # Without a law the time step says how far cloth gives.
        for size in (0.1, 10) if law else ():
            found += complaints(f"{fabric}, {size} times as large", rested(program, fabric, size, **law), expected)
    return judged(folder, [found])


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
