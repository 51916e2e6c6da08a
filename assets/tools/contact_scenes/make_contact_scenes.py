"""Usage: make_contact_scenes.py [FOLDER]

Makes the cloths and bodies of the scenes about contact and writes them to FOLDER/garments/contact and FOLDER/bodies:
OBJ files in metres, y up, the same bytes in every run. Without FOLDER: to the assets of this repository."""

import pathlib
import sys

from bodies import funnel, needle_bed, plate
from cloths import cloth_on_needles, stack, table_cloth, tube
from knot import reef_knot, ribbons
from mesh import numbered_as_used, write_mesh
from washing import line, pole, washing

ASSETS = pathlib.Path(__file__).resolve().parents[2]

# By name: how it is made, and what the file says it is.
GARMENTS = {
    "tube": (lambda: tube(88, 58, 0.25, 1.0, seed=1), "A tube of cloth about the x axis"),
    "ribbons": (ribbons, "The two ribbons of reef_knot.obj, flat: their shape at rest"),
    "reef_knot": (reef_knot, "Two ribbons in a loose reef knot; ribbons.obj is their shape at rest"),
    "funnel_sheets": (lambda: stack(3, 50, 1.0, 0.02, 0.02, 17.0), "Three sheets above funnel.obj"),
    "layers": (lambda: stack(5, 45, 1.0, 0.27, 0.02, 6.0), "Five sheets, turned against each other"),
    "table_cloth": (table_cloth, "A cloth and two stacks of three napkins on table.obj"),
    "washing": (lambda: washing(ASSETS), "Two T-shirts and a towel on washing_line.obj"),
    "needle_cloth": (cloth_on_needles, "A sheet on the tips of needles.obj"),
}
BODIES = {
    "funnel": (funnel, "A funnel"),
    "needles": (lambda: needle_bed().turned(4.0), "A bed of 10 x 10 needles, tips at y = 0"),
    "pole": (pole, "The pole of a flag"),
    "washing_line": (line, "A washing line with pegs, between two posts"),
    "table": (lambda: plate((0.4, 0.02, 0.4), 0.015, top_m=0.0), "A table's plate, top at y = 0"),
}


def main(arguments):
    if len(arguments) > 1 or arguments[:1] in (["--help"], ["-h"]):
        print(__doc__, file=sys.stdout if len(arguments) == 1 else sys.stderr)
        return 0 if len(arguments) == 1 else 2
    assets = pathlib.Path(arguments[0]) if arguments else ASSETS
    for folder, meshes in (("garments/contact", GARMENTS), ("bodies", BODIES)):
        (assets / folder).mkdir(parents=True, exist_ok=True)
        for name, (make, title) in meshes.items():
            mesh = numbered_as_used(make())
            write_mesh(assets / folder / f"{name}.obj", mesh, title)
            print(f"{folder}/{name}.obj: {len(mesh.points)} vertices, {len(mesh.triangles)} triangles")
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except OSError as error:
        sys.exit(f"make_contact_scenes: {error}")
