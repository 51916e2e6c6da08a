"""A flat ribbon bent along a curve in space so that it hardly stretches."""

import math

from mesh import Mesh, quads_as_triangles

# How much twist is worth in curvature within the ribbon's surface. Curvature costs more: it lengthens one border by as
# much as it shortens the other, and twist lengthens both by the square of a small angle.
TWIST_WEIGHT = 0.1


def plus(u, v, factor=1.0):
    return tuple(a + factor * b for a, b in zip(u, v))


def dot(u, v):
    return sum(a * b for a, b in zip(u, v))


def cross(u, v):
    return u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]


def unit(v):
    return tuple(c / math.hypot(*v) for c in v)


def spline(controls, pieces):
    """Points of the uniform cubic B-spline of these controls, so many between two knots."""
    points = []
    for i in range(len(controls) - 3):
        for k in range(pieces):
            t = k / pieces
            weights = ((1 - t) ** 3 / 6, (3 * t ** 3 - 6 * t * t + 4) / 6,
                       (-3 * t ** 3 + 3 * t * t + 3 * t + 1) / 6, t ** 3 / 6)
            points.append(tuple(dot(weights, column) for column in zip(*controls[i:i + 4])))
    return points


def evenly(points, spacing_m):
    """Points along a line of points at about this distance from each other, and their exact distance along the line."""
    reached = [0.0]
    for p, q in zip(points, points[1:]):
        reached.append(reached[-1] + math.dist(p, q))
    count = round(reached[-1] / spacing_m)
    even, k = [], 0
    for i in range(count + 1):
        wanted = reached[-1] * i / count
        while k + 2 < len(points) and reached[k + 1] < wanted:
            k += 1
        part = (wanted - reached[k]) / (reached[k + 1] - reached[k])
        even.append(plus(points[k], plus(points[k + 1], points[k], -1.0), part))
    return even, reached[-1] / count


def parallel_frames(line, first_across):
    """Two unit vectors across the line at each of its points, which do not turn about it (R. Bishop 1975)."""
    frames, across = [], first_across
    for i in range(len(line)):
        tangent = unit(plus(line[min(i + 1, len(line) - 1)], line[max(i - 1, 0)], -1.0))
        across = unit(plus(across, tangent, -dot(across, tangent)))
        frames.append((across, cross(tangent, across)))
    return frames


def ribbon_angles(curvatures, spacing_m):
    """By how much to turn each frame so that the line curves within the ribbon, and the ribbon twists, as little as can
    be: the least sum of (x cos a + y sin a)^2 + TWIST_WEIGHT (da/ds)^2, where (x, y) is the line's curvature along the
    frame's vectors. 0 at both ends. Gauss-Newton; each step solves a tridiagonal system (L. Thomas 1949)."""
    count, tie = len(curvatures), TWIST_WEIGHT / spacing_m ** 2
    angles = [0.0] * count
    largest_step = 1.0
    while largest_step > 1e-9:
        upper, right = [0.0] * count, [0.0] * count
        for i in range(1, count - 1):
            x, y = curvatures[i]
            cosine, sine = math.cos(angles[i]), math.sin(angles[i])
            within, change = x * cosine + y * sine, y * cosine - x * sine
            force = within * change + tie * (2.0 * angles[i] - angles[i - 1] - angles[i + 1])
            pivot = change * change + 2.0 * tie + tie * upper[i - 1]
            upper[i], right[i] = -tie / pivot, (tie * right[i - 1] - force) / pivot
        step = largest_step = 0.0
        for i in range(count - 2, 0, -1):
            step = right[i] - upper[i] * step
            # Farther than this the system, which knows slopes only, is no guide.
            angles[i] += max(-0.5, min(0.5, step))
            largest_step = max(largest_step, abs(step))
    return angles


def ribbon_along(line, spacing_m, first_across, width_m, cells_across):
    """Points of a ribbon, row by row, whose middle follows the line."""
    frames = parallel_frames(line, first_across)
    curvatures = [(0.0, 0.0)] * len(line)
    for i in range(1, len(line) - 1):
        bend = plus(plus(line[i + 1], line[i - 1]), line[i], -2.0)
        curvatures[i] = tuple(dot(bend, vector) / spacing_m ** 2 for vector in frames[i])
    points = []
    for middle, (u, v), angle in zip(line, frames, ribbon_angles(curvatures, spacing_m)):
        across = plus(tuple(math.cos(angle) * c for c in u), v, math.sin(angle))
        points += [plus(middle, across, width_m * (j / cells_across - 0.5)) for j in range(cells_across + 1)]
    return points


def ribbon_mesh(points, cells_across):
    """Triangles for the points of a ribbon, row by row."""
    columns = cells_across + 1
    corners = [(r + c, r * columns + c) for r in range(len(points) // columns - 1) for c in range(cells_across)]
    return Mesh(points, quads_as_triangles((k, (a, a + 1, a + columns + 1, a + columns)) for k, a in corners))
