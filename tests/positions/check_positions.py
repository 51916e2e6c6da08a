"""Whether what leaves the program is what it says:

  check_positions.py --list
  check_positions.py TAUT SOURCE FOLDER WAY

SOURCE is the project's folder; FOLDER is emptied, and removed where all holds; WAY is one of the list, or `all`.
Exit code 0: every shape that was written is stretched as much as is said beside it, and no more than promised."""

import pathlib
import shutil
import sys

from measure import complaints
from program import Program
from ways_out import ways_out


def check(program, way):
    """The number of shapes, and what does not hold of them."""
    shutil.rmtree(program.folder, ignore_errors=True)
    program.folder.mkdir(parents=True)
    count, found = 0, []
    try:
        for shape in way(program):
            count += 1
            found += complaints(shape)
    except RuntimeError as error:
        found.append(str(error))
    if count == 0:
        found.append("no shape was written")
    if not found:
        shutil.rmtree(program.folder)
    return count, found


def main(taut, source, folder, wanted):
    taut, source, folder = (pathlib.Path(path).resolve() for path in (taut, source, folder))
    program = Program(taut, source / "assets", folder)
    ways = ways_out(source)
    failed = False
    for name in ways if wanted == "all" else [wanted]:
        count, found = check(program, ways[name])
        print(f"{name}: {count} shapes, {len(found)} complaints", *found[:20], sep="\n  ", flush=True)
        failed |= bool(found)
    return 1 if failed else 0


if __name__ == "__main__":
    if sys.argv[1:] == ["--list"]:
        print(*ways_out(pathlib.Path()), sep="\n")
    else:
        sys.exit(main(*sys.argv[1:]))
