#!/usr/bin/env python3
"""Draws print.png, a print on the T-shirts' chest: make_print.py FOLDER. Needs nothing but Python."""

import pathlib
import struct
import sys
import zlib

SIDE_PX = 3000
METRES_PER_UV = 1.5  # as the shirts' landmarks say
FOLD_U, NECK_V_M = 0.25, 1.45  # where the front's fold is, and the origin of its plane
SAMPLES = 4  # along each side of a pixel
CREAM, YELLOW, RED = (0xF6, 0xF2, 0xE8), (0xF2, 0xB1, 0x34), (0xE2, 0x4E, 0x2A)
COLOURS = [CREAM, YELLOW, RED]
LEVELS = SAMPLES * SAMPLES

# In millimetres on the front: x from the fold to the wearer's left, y down from the origin of its
# plane, a centimetre above the shoulder.
MIDDLE_Y, RADIUS, RING = 285.0, 105.0, 6.0
BARS = [(10.0, 22.0), (32.0, 42.0), (52.0, 60.0), (70.0, 76.0)]  # below the middle
LETTERS_Y, LETTER_HEIGHT, STROKE = 410.0, 40.0, 7.0
LETTERS = {
    "T": [((-15, 0), (15, 0)), ((0, 0), (0, 40))],
    "A": [((-16, 40), (0, 0)), ((16, 40), (0, 0)), ((-10.5, 27), (10.5, 27))],
    "U": [((-14, 0), (-14, 30)), ((-14, 30), (-11, 37)), ((-11, 37), (-4, 40)), ((-4, 40), (4, 40)), ((4, 40), (11, 37)),
          ((11, 37), (14, 30)), ((14, 30), (14, 0))],
}
STROKES = [(LETTERS_Y, x, stroke) for letter, x in zip("TAUT", (-72, -24, 24, 72)) for stroke in LETTERS[letter]]


def distance_to(x, y, stroke):
    """From a line between two points."""
    (ax, ay), (bx, by) = stroke
    dx, dy = bx - ax, by - ay
    share = max(0.0, min(1.0, ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy)))
    return ((x - ax - share * dx) ** 2 + (y - ay - share * dy) ** 2) ** 0.5


def colour_at(x, y):
    """The number of a colour at a place in millimetres, or none."""
    down = y - MIDDLE_Y
    from_middle = (x * x + down * down) ** 0.5
    if abs(from_middle - RADIUS) <= RING / 2:
        return 0
    if from_middle <= RADIUS - 2.5 * RING:
        if down <= 0.0:
            return 1
        return 2 if any(top <= down <= bottom for top, bottom in BARS) else None
    if LETTERS_Y - STROKE <= y <= LETTERS_Y + LETTER_HEIGHT + STROKE:
        if any(distance_to(x - at, y - top, stroke) <= STROKE / 2 for top, at, stroke in STROKES):
            return 0
    return None


def index_at(column, row):
    """The pixel's entry in the palette: the colour that most of it has, as opaque as what is covered."""
    counts = [0] * len(COLOURS)
    for k in range(LEVELS):
        u = (column + (k % SAMPLES + 0.5) / SAMPLES) / SIDE_PX
        v = 1.0 - (row + (k // SAMPLES + 0.5) / SAMPLES) / SIDE_PX
        colour = colour_at(1000.0 * METRES_PER_UV * (u - FOLD_U), 1000.0 * (NECK_V_M - METRES_PER_UV * v))
        if colour is not None:
            counts[colour] += 1
    covered = sum(counts)
    return 1 + counts.index(max(counts)) * LEVELS + covered - 1 if covered else 0


def chunk(kind, content):
    return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))


def png(rows):
    palette, alphas = bytearray(3), bytearray(1)
    for colour in COLOURS:
        for level in range(1, LEVELS + 1):
            palette += bytes(colour)
            alphas.append(round(255 * level / LEVELS))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", SIDE_PX, SIDE_PX, 8, 3, 0, 0, 0))
            + chunk(b"PLTE", bytes(palette)) + chunk(b"tRNS", bytes(alphas))
            + chunk(b"IDAT", zlib.compress(b"".join(b"\0" + row for row in rows), 9)) + chunk(b"IEND", b""))


def main():
    rows = [bytearray(SIDE_PX) for _ in range(SIDE_PX)]
    px_per_mm = SIDE_PX / (1000.0 * METRES_PER_UV)
    for row in range(round(SIDE_PX * 0.1), round(SIDE_PX * 0.4)):
        for column in range(round(SIDE_PX * FOLD_U - 120 * px_per_mm), round(SIDE_PX * FOLD_U + 120 * px_per_mm)):
            rows[row][column] = index_at(column, row)
    (pathlib.Path(sys.argv[1]) / "print.png").write_bytes(png(rows))


if __name__ == "__main__":
    main()
