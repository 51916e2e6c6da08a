"""A picture of cloth in Python alone: lit at its vertices, with a depth buffer and a shadow on the ground."""
import math
import struct
import zlib

SIZE, FINE = 640, 2                  # pixels, and samples along each side of one
EYE = (0.45, 0.16)                   # azimuth and elevation in radians
LIGHT = (0.52, 0.72, 0.46)           # towards it, of length 1
OUTSIDE, INSIDE = (0.050, 0.160, 0.392), (0.022, 0.075, 0.200)  # linear
TOP, BOTTOM = (0.93, 0.93, 0.92), (0.62, 0.61, 0.60)


def _minus(a, b):
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def _dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def _cross(a, b):
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def _unit(a):
    length = math.sqrt(_dot(a, a)) or 1.0
    return a[0] / length, a[1] / length, a[2] / length


def _normals(points, triangles):
    sums = [[0.0, 0.0, 0.0] for _ in points]
    for corners in triangles:
        a, b, c = (points[v] for v in corners)
        normal = _cross(_minus(b, a), _minus(c, a))
        for vertex in corners:
            for axis in range(3):
                sums[vertex][axis] += normal[axis]
    return [_unit(normal) for normal in sums]


def _lit(normal, towards_eye):
    """A colour, linear: light of a lamp and of the sky, and the fibres that stand off the cloth."""
    is_outside = _dot(normal, towards_eye) > 0
    n = normal if is_outside else tuple(-x for x in normal)
    lamp = max(_dot(n, LIGHT), 0.0)
    sky = 0.5 + 0.5 * n[1]
    fringe = (1.0 - abs(_dot(n, towards_eye))) ** 3 * (0.25 + 0.75 * sky)
    base = OUTSIDE if is_outside else INSIDE
    return tuple(c * (1.25 * lamp + 0.40 * sky + 0.12) + 0.08 * fringe for c in base)


def _fill(a, b, c, put):
    """Calls put(x, y, weights) at the middle of each sample in a triangle of screen points."""
    area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    if area == 0:
        return
    size = SIZE * FINE
    for y in range(max(math.ceil(min(a[1], b[1], c[1])), 0), min(math.floor(max(a[1], b[1], c[1])), size - 1) + 1):
        ends = [p[0] + (y - p[1]) / (q[1] - p[1]) * (q[0] - p[0]) for p, q in ((a, b), (b, c), (c, a))
                if p[1] != q[1] and min(p[1], q[1]) <= y <= max(p[1], q[1])]
        if not ends:
            continue
        for x in range(max(math.ceil(min(ends)), 0), min(math.floor(max(ends)), size - 1) + 1):
            u = ((x - a[0]) * (c[1] - a[1]) - (y - a[1]) * (c[0] - a[0])) / area
            v = ((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / area
            put(x, y, (1.0 - u - v, u, v))


def draw(points, triangles):
    """Returns the rows of a picture, three bytes a pixel, and its width and height."""
    size = SIZE * FINE
    towards_eye = (math.sin(EYE[0]) * math.cos(EYE[1]), math.sin(EYE[1]), math.cos(EYE[0]) * math.cos(EYE[1]))
    right = _unit(_cross((0.0, 1.0, 0.0), towards_eye))
    up = _cross(towards_eye, right)
    low, high = ([end(p[axis] for p in points) for axis in range(3)] for end in (min, max))
    middle = [(a + b) / 2 for a, b in zip(low, high)]
    ground = low[1] - 0.06
    scale = 0.9 * size / max(high[1] - low[1], math.hypot(high[0] - low[0], high[2] - low[2]))

    def seen(point):
        off = _minus(point, middle)
        return size / 2 + scale * _dot(off, right), size * 0.46 - scale * _dot(off, up), _dot(off, towards_eye)

    dark = bytearray(size * size)

    def darken(x, y, _weights):
        dark[y * size + x] = 1

    shadow = [seen([p[k] - LIGHT[k] * (p[1] - ground) / LIGHT[1] for k in range(3)]) for p in points]
    for corners in triangles:
        _fill(*(shadow[v] for v in corners), darken)

    depth = [-math.inf] * (size * size)
    colour = [None] * (size * size)
    shown = [seen(point) for point in points]
    lights = [_lit(normal, towards_eye) for normal in _normals(points, triangles)]
    for corners in triangles:
        a, b, c = (shown[v] for v in corners)
        of_a, of_b, of_c = (lights[v] for v in corners)

        def put(x, y, weights):
            at = y * size + x
            u, v, w = weights
            near = u * a[2] + v * b[2] + w * c[2]
            if near > depth[at]:
                depth[at] = near
                colour[at] = [u * p + v * q + w * r for p, q, r in zip(of_a, of_b, of_c)]

        _fill(a, b, c, put)
    return _rows(colour, dark), SIZE, SIZE


def _soft(dark, size, reach=10):
    """Sums of the shadow over squares, from sums over all that is above and to the left."""
    sums = [[0] * (size + 1)]
    for y in range(size):
        row, total = [0], 0
        for x, value in enumerate(dark[y * size:(y + 1) * size]):
            total += value
            row.append(total + sums[-1][x + 1])
        sums.append(row)

    def share(x, y):
        left, right, above, below = max(x - reach, 0), min(x + reach, size), max(y - reach, 0), min(y + reach, size)
        inside = sums[below][right] - sums[above][right] - sums[below][left] + sums[above][left]
        return inside / ((right - left) * (below - above))

    return share


def _rows(colour, dark):
    size = SIZE * FINE
    shadow = _soft(dark, size)
    rows = []
    for y in range(SIZE):
        row = bytearray()
        for x in range(SIZE):
            samples = [colour[(y * FINE + j) * size + x * FINE + i] for j in range(FINE) for i in range(FINE)]
            shade = 1.0 - 0.42 * shadow(x * FINE, y * FINE) if None in samples else 1.0
            back = [shade * (t + (b - t) * (y / SIZE) ** 2) for t, b in zip(TOP, BOTTOM)]
            for axis in range(3):
                light = sum(back[axis] if s is None else s[axis] for s in samples) / len(samples)
                row.append(round(255 * min(max(light, 0.0), 1.0) ** (1 / 2.2)))
        rows.append(bytes(row))
    return rows


def write_png(path, rows, width, height):
    def chunk(kind, content):
        return (struct.pack('>I', len(content)) + kind + content + struct.pack('>I', zlib.crc32(kind + content)))

    with open(path, 'wb') as file:
        file.write(b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', struct.pack('>IIBBBBB', width, height, 8, 2, 0, 0, 0)) +
                   chunk(b'IDAT', zlib.compress(b''.join(b'\0' + row for row in rows), 9)) + chunk(b'IEND', b''))
