"""A washing line with two T-shirts and a towel, and its pegs and posts."""

import math

from cloths import sheet
from mesh import Mesh, joined, read_mesh

# The line from post to post, in metres: it sags by the weight of what hangs on it, and hardly between two pegs.
LINE = [(-1.65, 1.975), (-1.21, 1.933), (-0.84, 1.911), (-0.27, 1.900), (0.27, 1.900), (0.84, 1.911), (1.21, 1.933),
        (1.65, 1.975)]
PEGGED_M = 0.008  # below the line's middle
LINE_RADIUS_M, POST_RADIUS_M = 0.003, 0.025
PEG_HALF_M = (0.005, 0.028, 0.003)


def washing(assets):
    """Two shirts that hang by their hems, at the side seams, and a towel by its corners, held along `pegs`."""
    shirt = read_mesh(assets / "garments" / "tshirt_1028.obj")
    left, right = hung_shirt(shirt, LINE[1], LINE[2]), hung_shirt(shirt, LINE[5], LINE[6])
    towel = sheet(24, 39, LINE[4][0] - LINE[3][0], 0.9, seed=51).mapped(
        lambda p: (p[0], LINE[3][1] - PEGGED_M - 0.45 - p[2], 0.0))
    towel.landmarks["towel"] = [0, 1, 22, 23]
    mesh = joined(left.named("left"), right.named("right"), towel)
    pegs = [v for name in ("left", "right", "towel") for v in mesh.landmarks[name]]
    return Mesh(mesh.points, mesh.triangles, {"pegs": sorted(pegs)})


def hung_shirt(shirt, start, end):
    """Turned upside down, with its side seams' ends below two points of the line."""
    seams = [shirt.landmarks[f"{side}_side_seam"][0] for side in ("left", "right")]
    first, second = (shirt.points[v] for v in seams)
    middle = [(a + b) / 2.0 for a, b in zip(first, second)]
    # Upside down about the z axis, then as steep as the line.
    angle = math.pi + math.atan2(end[1] - start[1], end[0] - start[0]) - math.atan2(first[1] - second[1],
                                                                                    first[0] - second[0])
    cosine, sine = math.cos(angle), math.sin(angle)

    def hang(point):
        x, y, z = (c - m for c, m in zip(point, middle))
        return ((start[0] + end[0]) / 2.0 + cosine * x - sine * y,
                (start[1] + end[1]) / 2.0 - PEGGED_M + sine * x + cosine * y, z)

    hung = shirt.mapped(hang)
    hung.landmarks["pegs"] = seams
    return hung


def line():
    """Posts, line and pegs."""
    parts = [rod([(x, 0.0, 0.0), (x, y + 0.05, 0.0)], POST_RADIUS_M, 12) for x, y in (LINE[0], LINE[-1])]
    inside = POST_RADIUS_M + 0.001
    ends = (LINE[0][0] + inside, LINE[0][1]), (LINE[-1][0] - inside, LINE[-1][1])
    parts.append(rod([(x, y, 0.0) for x, y in (ends[0], *LINE[1:-1], ends[1])], LINE_RADIUS_M, 6))
    # Beside a shirt, which is round where it is held, and on the towel's corners.
    beside = PEG_HALF_M[0] + 0.002
    places = [x + way * beside for (x, _), way in zip(LINE[1:-1], (-1, 1, 0, 0, -1, 1))]
    parts += [peg(x, y + 0.012, side) for x, (_, y) in zip(places, LINE[1:-1]) for side in (1.0, -1.0)]
    return joined(*parts)


def pole():
    """Of a flag: about the y axis, 2.5 m high."""
    return rod([(0.0, 0.0, 0.0), (0.0, 2.5, 0.0)], 0.02, 16)


def peg(x, top_m, side):
    """Half of a peg, before or behind the cloth."""
    half = PEG_HALF_M
    corners = [(x + sx * half[0], top_m - half[1] + sy * half[1], side * 0.0075 + sz * half[2])
               for sx in (-1, 1) for sy in (-1, 1) for sz in (-1, 1)]
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return Mesh(corners, [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))])


def rod(places, radius_m, sides):
    """A round bar through places in the plane z = 0, closed at both ends."""
    points, triangles = [], []
    for k, (x, y, _) in enumerate(places):
        before, after = places[max(k - 1, 0)], places[min(k + 1, len(places) - 1)]
        angle = math.atan2(after[1] - before[1], after[0] - before[0])
        for side in range(sides):
            turn = 2.0 * math.pi * side / sides
            off = radius_m * math.cos(turn)
            points.append((x - off * math.sin(angle), y + off * math.cos(angle), radius_m * math.sin(turn)))
    for k in range(len(places) - 1):
        for side in range(sides):
            a, b = k * sides + side, k * sides + (side + 1) % sides
            triangles += [(a, a + sides, b + sides), (a, b + sides, b)]
    last = len(points) - sides
    for side in range(1, sides - 1):
        triangles += [(0, side, side + 1), (last, last + side + 1, last + side)]
    return Mesh(points, [t[::-1] for t in triangles])
