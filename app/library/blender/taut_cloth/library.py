"""Finds libtaut: the extension carries it, beside the add-on alone it is installed apart."""
import importlib
import os
import pathlib
import shutil
import sys

import bpy

MODULE = __package__ + '.taut'
FABRICS = pathlib.Path(__file__).parent / 'fabrics'


class Refused(Exception):
    """An error that a person can mend; the text says how."""


def fabric_file(name: str) -> str:
    """Returns the file of a fabric of the list, or the user's own file of this name."""
    along = FABRICS / (name + '.toml')
    return str(along) if along.exists() else bpy.path.abspath(name)


def forget() -> None:
    """The next load() looks again."""
    sys.modules.pop(MODULE, None)


def places() -> list:
    """Files to try, in this order; the last, an empty text, is the system's library."""
    addon = bpy.context.preferences.addons.get(__package__)
    if addon and addon.preferences.library:
        return [bpy.path.abspath(addon.preferences.library)]
    if os.environ.get('TAUT_LIBRARY'):
        return [os.environ['TAUT_LIBRARY']]
    carried = pathlib.Path(__file__).parent / 'lib' / 'libtaut.so.1'
    if carried.exists():
        return [str(carried)]
    program = shutil.which('taut')
    prefixes = [pathlib.Path(program).resolve().parent.parent] if program else []
    prefixes += [pathlib.Path.home() / '.local', pathlib.Path('/usr/local')]
    return [str(prefix / 'lib' / 'libtaut.so') for prefix in prefixes] + ['']


def load():
    """The Python package of the library. Raises Refused where there is none."""
    if MODULE in sys.modules:
        return sys.modules[MODULE]
    tried = []
    before = os.environ.get('TAUT_LIBRARY')
    for place in places():
        os.environ['TAUT_LIBRARY'] = place
        try:
            return importlib.import_module(MODULE)
        except (OSError, ImportError, AttributeError) as error:
            tried.append(place or 'the system')
            reason = str(error)
        finally:
            os.environ.pop('TAUT_LIBRARY')
            if before is not None:
                os.environ['TAUT_LIBRARY'] = before
    raise Refused(f'libtaut was not found in {", ".join(tried)} ({reason}). Install Taut, or name the file in '
                  'Edit > Preferences > Add-ons > Taut Cloth')
