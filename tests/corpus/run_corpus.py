#!/usr/bin/env python3
"""Makes models sound and unsound and holds Taut to its word: a report as expected and a simulation within its
bound, or the error as expected; never a crash, a hang or a number that is not finite.

run_corpus.py PROGRAM FOLDER [NAME...]"""
import json
import math
import pathlib
import re
import subprocess
import sys

import models

FRAMES = 6
# Of fitted meshes: finer ones only take longer.
TRIANGLES = ('--set', 'garment.triangles=1500')
LONGEST_S = 60  # an import may take 20


def run(program, *arguments):
    try:
        done = subprocess.run([program, *map(str, arguments)], capture_output=True, timeout=LONGEST_S)
    except subprocess.TimeoutExpired:
        return None, '', 'took more than %d s' % LONGEST_S
    return done.returncode, done.stdout.decode(errors='replace'), done.stderr.decode(errors='replace')


def differs(found, wanted):
    if isinstance(wanted, float):
        return not math.isclose(found, wanted, rel_tol=1e-5)
    return found != wanted


def check_report(program, model, path):
    # Facts of the model, however it is simulated.
    code, out, err = run(program, 'inspect', path, '--json', '--set', 'garment.mesh=model', *model.options)
    if model.error:
        if code != 1 or not re.search(model.error, err) or path.name not in err:
            yield 'inspect: exit code %s, %r; expected 1 and %r' % (code, err.strip(), model.error)
        return
    if code != 0:
        yield 'inspect: exit code %s: %s' % (code, err.strip())
        return
    report = json.loads(out)
    report['parts'] = [(part['hung_by'], part['pins']) for part in report['parts']]
    found = dict(models.flat(report))
    for key, wanted in model.expected.items():
        if differs(found[key], wanted):
            yield 'inspect: %s is %r, expected %r' % (key, found[key], wanted)


def check_run(program, model, path):
    statistics = path.with_suffix('.jsonl')
    statistics.unlink(missing_ok=True)
    code, out, err = run(program, 'simulate', path, '--frames', FRAMES, '--stats', statistics, *TRIANGLES, *model.options,
                       *model.simulate)
    reason = model.refused or model.error
    if reason:
        # A setting on the command line that cannot be is wrong usage.
        wanted = (3,) if 'diverged' in reason else (1, 2) if model.refused else (1,)
        if code not in wanted or not re.search('^taut: error: .*' + reason if model.refused else '^taut: error: ', err) \
                or (re.search('^frame', out, re.M) and 'diverged' not in reason) \
                or (statistics.exists() and 'diverged' not in reason):
            yield 'simulate: exit code %s, statistics %s: %r; expected %r' % (code, statistics.exists(), err.strip(), reason)
        return
    if code != 0:
        yield 'simulate: exit code %s: %s' % (code, err.strip())
        return
    header, *frames, _ = map(json.loads, statistics.read_text().splitlines())
    bound = header['settings']['solver']['max_stretch']
    for frame in frames:
        # Nothing was near: then there is no smallest distance.
        numbers = [value for key, value in frame.items()
                   if not isinstance(value, (str, bool)) and not (key == 'smallest_distance' and value is None)]
        if not all(value is not None and math.isfinite(value) for value in numbers):
            yield 'simulate: frame %d has a number that is not finite' % frame['frame']
        elif not frame['max_stretch'] <= bound + 1e-6:
            yield 'simulate: frame %d is stretched by %g, more than %g' % (frame['frame'], frame['max_stretch'], bound)


def main():
    program, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    chosen = [m for m in models.all_models() if len(sys.argv) < 4 or m.name in sys.argv[3:]]
    failures = 0
    for model in chosen:
        path = folder / model.name
        if callable(model.data):
            model.data(path)
        else:
            path.write_bytes(model.data)
        complaints = [*check_report(program, model, path), *check_run(program, model, path)]
        failures += bool(complaints)
        for complaint in complaints:
            print('%s: %s' % (model.name, complaint))
    formats = {pathlib.Path(model.name).suffix for model in chosen}
    print('%d models in %d formats, %d of them as expected' % (len(chosen), len(formats), len(chosen) - failures))
    return 1 if failures or len({m.name for m in chosen}) < len(chosen) else 0


sys.exit(main())
