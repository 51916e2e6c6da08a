"""Simulates the T-shirt, or another scene, and draws it as `taut render` does: python3 -m taut_cloth [-o FILE] [--wind SPEED]."""
import argparse
import sys
import time

import taut_cloth


def show(line: str) -> None:
    """Replaces the line at the end of a terminal."""
    if sys.stderr.isatty():
        print('\r\033[K' + line, end='', file=sys.stderr, flush=True)


def main() -> None:
    parser = argparse.ArgumentParser(prog='python3 -m taut_cloth', description=__doc__.split(':')[0] + '.')
    parser.add_argument('scene', nargs='?', default='tshirt-gravity', help='one of: ' + ', '.join(taut_cloth.scenes()))
    parser.add_argument('-o', '--output', default='tshirt.png', help='a PNG')
    parser.add_argument('--wind', type=float, metavar='SPEED', help='in m/s, from behind')
    parser.add_argument('--frames', type=int, default=120, help='of 1/60 s each')
    parser.add_argument('--set', action='append', default=[], metavar='KEY=VALUE',
                        help='any key of a scene: picture.quality=high')
    given = parser.parse_args()
    if given.frames < 1:
        parser.error(f'--frames: found {given.frames}, expected at least 1')
    settings = dict(pair.split('=', 1) for pair in given.set)
    if given.wind is not None:
        settings.update({'wind.speed': given.wind, 'wind.direction': [0.3, 0.0, 1.0]})
    began = time.monotonic()
    try:
        with taut_cloth.Cloth(given.scene, settings=settings) as cloth:
            for number in range(1, given.frames + 1):
                frame = cloth.step()
                show(f'frame {number} of {given.frames}, stretch {100 * frame.max_surface_stretch:.2f} %')
            taken = time.monotonic() - began
            show('')
            print(f'{given.frames} frames in {taken:.1f} s: the largest stretch is {100 * frame.max_surface_stretch:.3f} %, '
                  f'{frame.measured_crossings} triangles cross, the state is {frame.state_hash:016x}')
            show('drawing')
            cloth.save_picture(given.output)
    except taut_cloth.Error as error:
        show('')
        parser.exit(1, f'taut_cloth: {error}\n')
    show('')
    print(f'wrote {given.output}')


main()
