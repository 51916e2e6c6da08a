"""Whether T-shirts in still air are asleep within 9 s: check_still_air.py TAUT SOURCE FOLDER TRIANGLES

Folds are chaotic: each scene is run in air of three drags, of which one may stay awake. Also that what is said of a
frame's motion is how the written positions moved since the frame before."""

import math
import pathlib
import shutil
import sys

from measure import read_obj
from program import Program, judged, settings

# Without its wind a scene of the wind is that of gravity. BARE: the garment's file itself, hung as any model is.
BARE = "the bare file"
SCENES = ("tshirt", "tshirt-gravity", BARE)
SECONDS = 9
DRAGS_PER_S = (1.8, 2.0, 2.2)
MAX_AWAKE = 1
AREAL_DENSITY_KG_PER_M2 = 0.15
# A share of the number; cloth that is nearly at rest has few digits.
ROUNDING = 1e-6
LEAST = 1e-12


def masses_kg(points, faces):
    """A third of every triangle's mass to each of its corners."""
    masses = [0.0] * len(points)
    for face in faces:
        a, b, c = (math.dist(points[face[i]], points[face[i - 1]]) for i in range(3))
        half = (a + b + c) / 2.0
        area = math.sqrt(half * (half - a) * (half - b) * (half - c))
        for corner in face:
            masses[corner] += AREAL_DENSITY_KG_PER_M2 * area / 3.0
    return masses


def motion(before, after, masses, frame_rate):
    """Between two frames, by the names of the statistics."""
    moved = [math.dist(a, b) for a, b in zip(before, after, strict=True)]
    return {"rms_speed": frame_rate * math.sqrt(sum(m * m for m in moved) / len(moved)),
            "convergence": max(moved),
            "kinetic_energy": sum(0.5 * mass * (frame_rate * m) ** 2 for mass, m in zip(masses, moved, strict=True))}


def motion_complaints(program, records, frame_rate, garment):
    """Of the frames that were written."""
    points, faces = read_obj(garment)
    masses, found = masses_kg(points, faces), []
    for record in records:
        frame = record["frame"]
        before, points = points, read_obj(program.folder / f"{frame}.obj")[0]
        if frame > 1:
            found += [f"frame {frame}: the {name} is {value:.6g}, but run.jsonl says {record[name]:.6g}"
                      for name, value in motion(before, points, masses, frame_rate).items()
                      if not abs(value - record[name]) <= ROUNDING * value + LEAST]
    return found


def run(program, scene, garment, drag, frame_rate, export):
    shutil.rmtree(program.folder, ignore_errors=True)
    program.folder.mkdir(parents=True)
    program.run("simulate", garment if scene == BARE else scene, "--stats", "run.jsonl", *export,
                *settings(wind__speed=0, air__drag=drag, garment__file=str(garment), time__frames=SECONDS * frame_rate))
    return program.statistics("run.jsonl")


def check(program, scene, triangles, export):
    garment = program.shirt(triangles)
    frame_rate = 60 if scene == BARE else program.scene(scene)["time"].get("frame_rate", 60)
    found, awake = [], []
    for drag in DRAGS_PER_S:
        records = run(program, scene, garment, drag, frame_rate, export)
        found += motion_complaints(program, records, frame_rate, garment) if export else []
        if not records[-1]["asleep"]:
            awake.append(f"awake after {SECONDS} s in a drag of {drag} / s, at {records[-1]['rms_speed']:.9f} m/s")
        seconds = sum(not record["asleep"] for record in records) / frame_rate
        print(f"{scene}, {triangles} triangles, drag {drag}: awake for {seconds:.2f} s", flush=True)
    found += awake if len(awake) > MAX_AWAKE else []
    print(f"{scene}: {len(found)} complaints", *found[:20], sep="\n  ", flush=True)
    return found


def main(taut, source, folder, triangles):
    taut, source, folder = (pathlib.Path(path).resolve() for path in (taut, source, folder))
    program = Program(taut, source / "assets", folder)
    # Hundreds of files are written where they are small.
    export = ("--export", "{frame}.obj") if triangles == "1028" else ()
    return judged(folder, [check(program, scene, triangles, export) for scene in SCENES])


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
