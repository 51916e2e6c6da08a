"""Whether every T-shirt in still air is asleep within 8 s: check_still_air.py TAUT SOURCE FOLDER TRIANGLES

Also that the speed said of a frame is the one with which the written positions moved since the frame before."""

import math
import pathlib
import shutil
import sys

from measure import read_obj
from program import Program, settings

SCENES = ("tshirt", "tshirt-gravity", "tshirt-wind-1", "tshirt-wind-10")
SECONDS = 8
ROUNDING_M_PER_S = 1e-9


def rms_speed(before, after, frame_rate):
    """In m/s, of the vertices of two frames."""
    squares = sum(math.dist(a, b) ** 2 for a, b in zip(before, after, strict=True))
    return frame_rate * math.sqrt(squares / len(before))


def speed_complaints(program, records, frame_rate):
    """Of the frames that were written."""
    shapes = {int(file.stem): file for file in program.folder.glob("*.obj")}
    before, found = None, []
    for record in records:
        frame = record["frame"]
        after = read_obj(shapes[frame])[0]
        if before is not None:
            speed = rms_speed(before, after, frame_rate)
            if not abs(speed - record["rms_speed"]) <= 1e-6 * speed + ROUNDING_M_PER_S:
                said = record["rms_speed"]
                found.append(f"frame {frame}: moves at {speed:.9f} m/s, but run.json says {said:.9f} m/s")
        before = after
    return found


def check(program, scene, triangles, export):
    shutil.rmtree(program.folder, ignore_errors=True)
    program.folder.mkdir(parents=True)
    frame_rate = program.scene(scene)["time"].get("frame_rate", 60)
    program.run("simulate", scene, "--frames", SECONDS * frame_rate, "--stats", "run.json", *export,
                *settings(wind__speed=0, garment__file=str(program.shirt(triangles))))
    records = program.statistics("run.json")
    found = speed_complaints(program, records, frame_rate) if export else []
    if not records[-1]["asleep"]:
        found.append(f"awake after {SECONDS} s, at {records[-1]['rms_speed']:.9f} m/s")
    awake = sum(not record["asleep"] for record in records)
    print(f"{scene}, {triangles} triangles: awake for {awake / frame_rate:.2f} s, {len(found)} complaints", *found[:20],
          sep="\n  ", flush=True)
    return found


def main(taut, source, folder, triangles):
    taut, source, folder = (pathlib.Path(path).resolve() for path in (taut, source, folder))
    program = Program(taut, source / "assets", folder)
    # Hundreds of files are written where they are small.
    export = ("--export", "{frame}.obj") if triangles == "1028" else ()
    failed = [scene for scene in SCENES if check(program, scene, triangles, export)]
    if failed:
        return 1
    shutil.rmtree(folder)
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
