#!/usr/bin/env python3
"""SIGTERM and SIGINT end each command within a second, in the middle of a frame that takes minutes, the first time.
    signals.py PROGRAM FOLDER COMMAND"""
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time

program, folder, command = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3]
LONG_FRAME = ['--set', 'solver.substeps=10000', '--set', 'solver.max_substeps=10000', '--set', 'wind.speed=8',
              '--set', 'garment.file="tshirt_10600"', '--set', 'garment.subdivisions=1']
COMMANDS = {
    'simulate': ['simulate', 'tshirt-gravity', *LONG_FRAME],
    'render': ['render', 'tshirt-gravity', '--frames', '0:2', '--resolution', '64,64', '--output', 'a-{frame}.png', *LONG_FRAME],
    'dress': ['simulate', 'tshirt-worn', '--frames', '2', *LONG_FRAME[:4]],
    'figures': ['figures', '--output', 'figures'],
    'bench': ['bench', '--sizes', '84480', '--bounds', '0.001', '--output', 'bench'],
    'view': ['view', '--headless', '--script', 'session.txt', *LONG_FRAME],
}
SESSION = 'taut-session 1\nscene tshirt-gravity\nwindow 320 240 1\nframe 10\n'


def seconds_to_end(number):
    started = subprocess.Popen([program, *COMMANDS[command]], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    time.sleep(4)
    if started.poll() is not None:
        sys.exit('it ended by itself with %d: %s' % (started.returncode, started.stdout.read()[-2000:]))
    sent = time.monotonic()
    started.send_signal(number)
    try:
        said, _ = started.communicate(timeout=60)
    except subprocess.TimeoutExpired:
        started.kill()
        sys.exit('it goes on a minute after %s' % number.name)
    if started.returncode not in (-number, 75):
        sys.exit('it ended with %d, expected %d: %s' % (started.returncode, -number, said[-2000:]))
    return time.monotonic() - sent


shutil.rmtree(folder, ignore_errors=True)
folder.mkdir(parents=True)
(folder / 'session.txt').write_text(SESSION)
took = {number.name: seconds_to_end(number) for number in (signal.SIGTERM, signal.SIGINT)}
print(', '.join('%s: %.2f s' % each for each in took.items()))
# Within a second; a machine that does other things too is slower.
sys.exit(1 if max(took.values()) > 3 else 0)
