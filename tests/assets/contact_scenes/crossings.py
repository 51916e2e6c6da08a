"""Which triangles have points in common that they should not have. Coordinates are whole numbers (micrometres, as OBJ
files of six decimals have them), so that every answer is exact."""

from collections import defaultdict


def minus(p, q):
    return p[0] - q[0], p[1] - q[1], p[2] - q[2]


def cross(u, v):
    return u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]


def dot(u, v):
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]


def sides_differ(numbers):
    return min(numbers) < 0 < max(numbers)


def turn(p, q, r):
    """In a plane: positive where q, r go counter-clockwise about p."""
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])


def segments_meet(p, q, r, s):
    """Of two segments in a plane, ends included."""
    of_pq, of_rs = (turn(p, q, r), turn(p, q, s)), (turn(r, s, p), turn(r, s, q))
    if any(of_pq) or any(of_rs):
        return min(of_pq) <= 0 <= max(of_pq) and min(of_rs) <= 0 <= max(of_rs)
    return all(min(p[k], q[k]) <= max(r[k], s[k]) and min(r[k], s[k]) <= max(p[k], q[k]) for k in (0, 1))


def segment_meets_triangle(p, q, triangle):
    """Both with their borders."""
    a, b, c = triangle
    normal = cross(minus(b, a), minus(c, a))
    if not any(normal):
        raise ValueError(f"a triangle without area at {a} um")
    height_p, height_q = dot(normal, minus(p, a)), dot(normal, minus(q, a))
    if (height_p > 0 and height_q > 0) or (height_p < 0 and height_q < 0):
        return False
    if height_p or height_q:
        along = minus(q, p)
        return not sides_differ([dot(along, cross(minus(s, p), minus(e, p))) for s, e in ((a, b), (b, c), (c, a))])
    steepest = max(range(3), key=lambda k: abs(normal[k]))
    p, q, a, b, c = ([v[k] for k in range(3) if k != steepest] for v in (p, q, a, b, c))
    return (not sides_differ([turn(a, b, p), turn(b, c, p), turn(c, a, p)])
            or any(segments_meet(p, q, s, e) for s, e in ((a, b), (b, c), (c, a))))


def is_folded_flat(points, first, second, shared):
    """Of two triangles with a common side: whether they lie on each other."""
    a, b = (points[v] for v in shared)
    c, d = (points[(set(t) - shared).pop()] for t in (first, second))
    one, other = cross(minus(b, a), minus(c, a)), cross(minus(b, a), minus(d, a))
    return dot(one, minus(d, a)) == 0 and dot(one, other) > 0


def triangles_meet(points, first, second):
    """In more than the vertices they share."""
    shared = set(first) & set(second)
    if len(shared) == 2:
        return is_folded_flat(points, first, second, shared)
    for one, other in ((first, second), (second, first)):
        corners = [points[v] for v in other]
        for k in range(3):
            a, b = one[k], one[(k + 1) % 3]
            # A side that ends in a shared vertex meets the other triangle there; the side across from it tells.
            if not shared & {a, b} and segment_meets_triangle(points[a], points[b], corners):
                return True
    return False


def box_of(points, triangle):
    corners = [points[v] for v in triangle]
    return tuple(map(min, *corners)), tuple(map(max, *corners))


def near_pairs(points, first, second=None, cell=20000):
    """Numbers of triangles (i, j) whose boxes overlap: i < j in one list, or i in the first and j in the second."""
    in_one_list = second is None
    boxes = [[box_of(points, t) for t in triangles] for triangles in (first, first if in_one_list else second)]
    cells = defaultdict(list)
    for j, (low, high) in enumerate(boxes[1]):
        for key in cells_of(low, high, cell):
            cells[key].append(j)
    for i, (low, high) in enumerate(boxes[0]):
        found = {j for key in cells_of(low, high, cell) for j in cells.get(key, ()) if not in_one_list or i < j}
        for j in sorted(found):
            other_low, other_high = boxes[1][j]
            if all(low[k] <= other_high[k] and other_low[k] <= high[k] for k in range(3)):
                yield i, j


def cells_of(low, high, cell):
    ranges = [range(a // cell, b // cell + 1) for a, b in zip(low, high)]
    return ((x, y, z) for x in ranges[0] for y in ranges[1] for z in ranges[2])


def crossing_pairs(points, first, second=None):
    """All of them, as near_pairs numbers them. Two lists of triangles number their vertices alike and share none."""
    return [(i, j) for i, j in near_pairs(points, first, second)
            if triangles_meet(points, first[i], (first if second is None else second)[j])]
