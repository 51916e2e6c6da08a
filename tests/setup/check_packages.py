#!/usr/bin/env python3
"""Everything that the build, the program and the tests use of this machine has to come from a package that setup.sh
names, from one that those depend on, or from a bare Debian: what was installed by hand is not on a fresh machine.
    check_packages.py SOURCES BUILD [PACKAGE that setup.sh shall not have named...]"""
import os
import pathlib
import shutil
import sys

import packages
import uses


def used(sources, build):
    """Each file or program in use, and what uses it."""
    files, programs = {}, {}
    for folder in uses.builds_in(build):
        of_build, run_by_build = uses.built_from(folder)
        files.update(dict.fromkeys(of_build, 'the build'))
        programs.update((os.path.basename(path), 'the build') for path in run_by_build if outside(path, sources))
    executables = [path for path in build.rglob('*') if path.is_file() and os.access(path, os.X_OK) and is_elf(path)]
    files.update(dict.fromkeys(uses.loaded_by(executables), 'a program that was built'))
    files.update(dict.fromkeys(uses.loaded_while_drawing(build / 'app/taut'), 'taut render'))
    programs.update((name, str(script)) for name, script in uses.programs_of(uses.scripts_in(sources)).items())
    for made in executables:
        programs.pop(made.name, None)  # the machine may have an older one installed
    return {path: user for path, user in files.items() if outside(path, sources)}, programs


def outside(path, sources):
    return os.path.isabs(path) and not path.startswith(str(sources) + os.sep)


def is_elf(path):
    with path.open('rb') as file:
        return file.read(4) == b'\x7fELF'


def main():
    sources, build, *left_out = sys.argv[1:]
    sources, build = pathlib.Path(sources), pathlib.Path(build)
    if shutil.which('dpkg-query') is None or not (build / 'build.ninja').exists():
        print('SKIPPED: this asks dpkg-query and ninja, and one of them did not make this machine or build')
        return 77
    named = [name for name in packages.named_in(sources / 'setup.sh') if name not in left_out]
    brought = packages.Files(packages.Installed().brought_by(named))
    files, programs = used(sources, build)
    in_use = {**files, **programs}
    missing = [path for path in in_use
               if not (brought.have(path) if os.path.isabs(path) else brought.have_program(path))]
    owners = packages.owners_of(missing) if missing else {}
    for owner in sorted(set(owners.values())):
        path, *others = sorted(path for path in missing if owners[path] == owner)
        print('%s: %s%s, used by %s; expected a package that setup.sh brings' %
              (owner, path, ' and %d more' % len(others) if others else '', in_use[path]))
    print('%d files and %d programs in use, %d packages named' % (len(files), len(programs), len(named)))
    return 1 if missing else 0


sys.exit(main())
