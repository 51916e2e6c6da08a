#!/usr/bin/env python3
"""Makes the T-shirts of a pattern anew and compares them with those that are committed: check_shirts.py TAUT ASSETS PATTERN NAME...

Triangles, texture coordinates and landmarks are the same; positions, which change with how cloth moves, nearly."""
import math
import subprocess
import sys
import tempfile
from pathlib import Path

NEAR_M = 0.06


def parts(file):
    """Positions, and all other lines."""
    lines = file.read_text(encoding='utf-8').splitlines()
    return ([tuple(map(float, line.split()[1:])) for line in lines if line.startswith('v ')],
            [line for line in lines if not line.startswith('v ')])


def main():
    taut, assets, pattern, *names = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([sys.executable, '-B', f'{assets}/tools/make_tshirt.py', taut, pattern, folder], check=True)
        for name in names:
            made, committed = Path(folder) / name, Path(assets) / 'garments' / name
            found_m, found = parts(made.with_suffix('.obj'))
            expected_m, expected = parts(committed.with_suffix('.obj'))
            if found != expected or parts(made.with_suffix('.landmarks.toml')) != parts(committed.with_suffix('.landmarks.toml')):
                sys.exit(f'{name}: its triangles, texture coordinates or landmarks are not those that are committed. If that is '
                         f'meant: make it anew, look at it, copy it to {committed.parent} and bring assets/README.md up to date.')
            furthest_m = max(math.dist(a, b) for a, b in zip(found_m, expected_m))
            print(f'{name}: {1e3 * furthest_m:.3f} mm from what is committed')
            if furthest_m > NEAR_M:
                sys.exit(f'{name}: found a vertex {1e3 * furthest_m:.1f} mm from where it is committed, expected at most {1e3 * NEAR_M:g} mm')


if __name__ == '__main__':
    main()
