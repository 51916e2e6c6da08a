"""The npm package under node, by test_package.mjs; ends with 77 where node is not there.

usage: test_package.py FOLDER    FOLDER is build/web, as the target `web` makes it.
"""
import pathlib
import shutil
import subprocess
import sys

node = shutil.which('node')
if node is None:
    print('skipped: there is no node; ./setup.sh --web brings it')
    sys.exit(77)
sys.exit(subprocess.run([node, pathlib.Path(__file__).with_suffix('.mjs'), sys.argv[1]]).returncode)
