"""Whether --verify finds the triangles that cross, and taut inspect counts them:

  check_crossings.py TAUT SOURCE FOLDER SCENE FRAMES cross|apart [KEY=VALUE...]

The last says whether a frame up to FRAMES shall cross. All frames are written without --verify and judged here."""

import json
import pathlib
import re
import shutil
import subprocess
import sys

from crossings import crossing_pairs
from measure import read_obj
from program import Program, judged

# Frames in which most has happened, of which the counts of taut inspect are compared too.
INSPECTED = 3


def verified(program, command):
    """Exit code, what is said of the frame that breaks a promise, and the counts by frame."""
    done = subprocess.run([program.taut, *command, "--verify", "--stats", "verified.jsonl"], cwd=program.folder,
                          capture_output=True, text=True)
    said = re.search(r"frame (\d+), .*?: (\d+) pairs? of triangles cross\w*, the first: triangle (\d+) .* and "
                     r"triangle (\d+) ", done.stderr)
    counts = {record["frame"]: record["crossing_pairs"] for record in program.statistics("verified.jsonl")}
    summary = re.search(r"^verified (\d+) frames: 0 crossing pairs", done.stdout, re.MULTILINE)
    return done.returncode, said and tuple(map(int, said.groups())), counts, summary and int(summary[1])


def complaints(program, scene, frames, wanted, keys):
    command = ["simulate", scene, "--frames", f"0:{frames}", *(word for key in keys for word in ("--set", key))]
    program.run(*command, "--export", "{frame}.obj")
    pairs = {frame: crossing_pairs(*read_obj(program.folder / f"{frame}.obj")) for frame in range(frames + 1)}
    first = next((frame for frame in pairs if pairs[frame]), None)
    print(f"{scene}, {frames + 1} frames: the first that crosses is {first}, pairs at the end: {len(pairs[frames])}")
    if (first is None) != (wanted == "apart"):
        yield f"the first frame that crosses is {first}"
    code, said, counts, summary = verified(program, command)
    if first is None:
        expected = 0, None, {frame: 0 for frame in pairs}, frames + 1
    else:
        expected = (3, (first, len(pairs[first]), *pairs[first][0]),
                    {frame: len(pairs[frame]) for frame in range(first + 1)}, None)
    if (code, said, counts, summary) != expected:
        yield f"--verify: {(code, said, counts, summary)}, expected {expected}"
    for frame in list(pairs)[-INSPECTED:]:
        report = json.loads(program.run("inspect", f"{frame}.obj", "--units", "m", "--up", "y", "--json"))["crossings"]
        found = report["pairs"], tuple(report.get("first", {}).get("triangles", ()))
        if found != (len(pairs[frame]), pairs[frame][0] if pairs[frame] else ()):
            yield f"frame {frame}: inspect counts {report}, expected {len(pairs[frame])}"


def main(taut, source, folder, scene, frames, wanted, *keys):
    if wanted not in ("cross", "apart"):
        raise SystemExit(f"found {wanted}, expected cross or apart")
    taut, source, folder = (pathlib.Path(path).resolve() for path in (taut, source, folder))
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    found = list(complaints(Program(taut, source / "assets", folder), scene, int(frames), wanted, keys))
    print(*found, sep="\n")
    return judged(folder, found)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
