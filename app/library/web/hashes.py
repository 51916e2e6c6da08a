"""The program's hashes of the states that the page begins with, for the page to compare: of the first frame and of each second.

usage: hashes.py TAUT OUT
"""
import json
import pathlib
import subprocess
import sys
import tempfile

SECONDS = {1028: 20, 2640: 20, 5280: 10, 10600: 5}
SCENES = {'hang': 'tshirt-gravity', 'walk': 'tshirt-walk', 'flag': 'flag', 'line': 'washing-line'}
# Those of a T-shirt of any size, and their winds in m/s; the others blow as their scenes say.
WINDS = {'hang': [0, 1, 10], 'walk': [0, 1]}
OTHERS = {'flag': (6, 10), 'line': (3, 5)}  # wind in m/s, seconds
SHIRT_WIND = ['wind.direction=[0.3, 0.0, 1.0]', 'wind.gust_amplitude=0.5', 'wind.gust_period=2', 'wind.gust_turn=0.2']


def hashes(taut, scene, size, wind, frames, folder):
    stats = pathlib.Path(folder) / 'stats.jsonl'
    settings = [f'garment.file=tshirt_{size}', f'wind.speed={wind}', *SHIRT_WIND] if scene in WINDS else []
    sets = [part for setting in settings for part in ('--set', setting)]
    subprocess.run([taut, 'simulate', SCENES[scene], *sets, '--frames', str(frames), '--stats', stats],
                   check=True, stdout=subprocess.DEVNULL)
    rows = map(json.loads, stats.read_text().splitlines())
    return {row['frame']: row['state_hash'] for row in rows
            if 'frame' in row and row['frame'] > 0 and (row['frame'] == 1 or row['frame'] % 60 == 0)}


def main(taut, out):
    with tempfile.TemporaryDirectory() as folder:
        table = {f'{scene}-{size}-{wind}': hashes(taut, scene, size, wind, 60 * seconds, folder)
                 for scene, winds in WINDS.items() for wind in winds for size, seconds in SECONDS.items()}
        table |= {f'{scene}-0-{wind}': hashes(taut, scene, 0, wind, 60 * seconds, folder)
                  for scene, (wind, seconds) in OTHERS.items()}
    pathlib.Path(out).write_text(json.dumps(table, indent=1) + '\n')


main(*sys.argv[1:])
