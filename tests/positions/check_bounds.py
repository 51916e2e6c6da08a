"""Whether no frame of the built-in scenes is stretched by more than a bound of either kind:

  check_bounds.py TAUT SOURCE FOLDER HELD CHECKED [SCENE...]

HELD is what the solver is asked to hold, CHECKED what the frames are judged by: springs or surface. Without scenes,
all that the program lists but for those about contact. Every scene runs for SECONDS; for its own time where TAUT_WHOLE_SCENES is set."""

import os
import pathlib
import shutil
import sys

from measure import complaints
from program import Program, judged
from ways_out import BOUNDED, exported

BOUND = 0.01
SECONDS = 0.5


def frames_of(time):
    """How many to run of a scene with such a table of times."""
    if os.environ.get("TAUT_WHOLE_SCENES"):
        return time["frames"]
    return round(SECONDS * time.get("frame_rate", 60))


def check(program, scene, frames, held, checked):
    """Returns what does not hold of a scene's frames. Prints how many there were."""
    shutil.rmtree(program.folder, ignore_errors=True)
    program.folder.mkdir(parents=True)
    cloth, count, found = program.cloth(scene), 0, []
    keys = BOUNDED | {"solver__max_stretch": BOUND, "solver__bound": held}
    try:
        for shape in exported(scene, cloth, BOUND, frames, keys, program):
            shape.bound_kind = checked
            count += 1
            found += complaints(shape)
    except RuntimeError as error:
        found.append(str(error))
    print(f"{scene}, {held} held, {checked} checked: {count} frames, {cloth.needles} needles, {len(found)} complaints",
          *found[:20], sep="\n  ", flush=True)
    return found


def main(taut, source, folder, held, checked, *scenes):
    for kind in (held, checked):
        if kind not in ("springs", "surface"):
            raise SystemExit(f"found the kind of bound {kind}, expected springs or surface")
    taut, source, folder = (pathlib.Path(path).resolve() for path in (taut, source, folder))
    folder.mkdir(parents=True, exist_ok=True)
    program = Program(taut, source / "assets", folder)
    return judged(folder, [check(program, scene, frames_of(program.scene(scene)["time"]), held, checked)
                           for scene in scenes or program.scenes()])


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
