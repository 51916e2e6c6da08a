"""A reef knot of two ribbons, loose enough that nothing touches."""

from mesh import joined
from ribbon import evenly, ribbon_along, ribbon_mesh, spline

WIDTH_M = 0.03
SPACING_M = 0.006
CELLS_ACROSS = 5

# Half of the left ribbon's bight: controls of a spline from its upper end, at the left, to the right, in the plane of
# the picture and towards the viewer. Against the other ribbon it goes under, over, under. The other half mirrors it at
# y = 0, and the right ribbon is both of it, turned by half a turn about the y axis. The numbers come from a search that
# moved the controls at random and kept what stretches the ribbon less and leaves 30 mm between layers.
CONTROLS = [(-0.990, 0.039, 0.000), (-0.935, 0.039, 0.000), (-0.682, 0.039, 0.000), (-0.607, 0.040, -0.027),
            (-0.394, 0.030, -0.015), (-0.345, 0.027, -0.012), (-0.226, 0.050, -0.092), (-0.157, 0.061, -0.102),
            (-0.071, 0.053, 0.029), (-0.037, 0.060, 0.050), (0.078, 0.112, 0.016), (0.172, 0.157, -0.031),
            (0.217, 0.156, -0.085), (0.267, 0.064, -0.187)]


def bight():
    """The middle of the left ribbon, at even distances, and that distance in metres."""
    mirrored = [(x, -y, z) for x, y, z in reversed(CONTROLS)]
    return evenly(spline(CONTROLS + mirrored, 40), SPACING_M)


def reef_knot():
    """Both ribbons, the left one first. Its two ends are at the left, the other's at the right."""
    line, spacing_m = bight()
    points = ribbon_along(line, spacing_m, (0.0, 1.0, 0.0), WIDTH_M, CELLS_ACROSS)
    left = ribbon_mesh(points, CELLS_ACROSS)
    return joined(left, left.turned(180.0))


def ribbons():
    """The same two ribbons flat, one above the other, with `left_ends` and `right_ends`."""
    line, spacing_m = bight()
    columns = CELLS_ACROSS + 1
    flat = ribbon_mesh([(spacing_m * (r - 0.5 * (len(line) - 1)), WIDTH_M * (c / CELLS_ACROSS - 0.5), 0.0)
                        for r in range(len(line)) for c in range(columns)], CELLS_ACROSS)
    ends = [*range(columns), *range(len(flat.points) - columns, len(flat.points))]
    both = []
    for name, y in (("left_ends", WIDTH_M), ("right_ends", -WIDTH_M)):
        both.append(flat.moved(0.0, y, 0.0))
        both[-1].landmarks = {name: ends}
    return joined(*both)
