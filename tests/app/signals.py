#!/usr/bin/env python3
"""SIGTERM and SIGINT end each command within a second, in the middle of a frame that takes minutes, the first time.
    signals.py PROGRAM FOLDER COMMAND"""
import os
import pathlib
import resource
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
    'render': ['render', 'tshirt-gravity', '--frames', '0:60', '--resolution', '64,64', '--output', 'a-{frame}.png', *LONG_FRAME],
    'dress': ['simulate', 'tshirt-worn', '--frames', '2', *LONG_FRAME[:4]],
    'figures': ['figures', '--output', 'figures'],
    'bench': ['bench', '--contact', '--scenes', 'fine-wind-10'],
    'view': ['view', '--headless', '--script', 'session.txt', *LONG_FRAME],
}
SESSION = '["taut-session", 2]\n["scene", "tshirt-gravity"]\n["window", 320, 240, 1]\n["frame", 10]\n'


def seconds_of(process):
    fields = pathlib.Path('/proc/%d/stat' % process).read_text().rsplit(')', 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf('SC_CLK_TCK')


# In processor time, as the machine may do other things too; it runs on up to two threads.
def seconds_to_end(number):
    ended_before = resource.getrusage(resource.RUSAGE_CHILDREN)
    started = subprocess.Popen([program, *COMMANDS[command]], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    time.sleep(4)
    if started.poll() is not None:
        sys.exit('it ended by itself with %d: %s' % (started.returncode, started.stdout.read()[-2000:]))
    used = seconds_of(started.pid)
    started.send_signal(number)
    try:
        said, _ = started.communicate(timeout=60)
    except subprocess.TimeoutExpired:
        started.kill()
        sys.exit('it goes on a minute after %s' % number.name)
    if started.returncode not in (-number, 75):
        sys.exit('it ended with %d, expected %d: %s' % (started.returncode, -number, said[-2000:]))
    ended = resource.getrusage(resource.RUSAGE_CHILDREN)
    return ended.ru_utime + ended.ru_stime - ended_before.ru_utime - ended_before.ru_stime - used


shutil.rmtree(folder, ignore_errors=True)
folder.mkdir(parents=True)
(folder / 'session.txt').write_text(SESSION)
took = {number.name: seconds_to_end(number) for number in (signal.SIGTERM, signal.SIGINT)}
print(', '.join('%s: %.2f s' % each for each in took.items()))
sys.exit(1 if max(took.values()) > 2 else 0)
