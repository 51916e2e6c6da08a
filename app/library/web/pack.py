"""Packs the engine with the scenes and models of the page into one JavaScript module, as text: a page that is opened from a
file may load scripts and nothing else. Writes pack.js.

usage: pack.py TAUT_IMPORT ASSETS WASM FOLDER
"""
import base64
import gzip
import json
import pathlib
import subprocess
import sys

MODELS = ['garments/tshirt_1028.obj', 'garments/tshirt_2640.obj', 'garments/tshirt_5280.obj', 'garments/tshirt_10600.obj',
          'garments/contact/washing.obj', 'bodies/mannequin_male_40.glb', 'bodies/pole.obj', 'bodies/washing_line.obj']
AS_THEY_ARE = ['scenes/tshirt*.toml', 'scenes/flag.toml', 'scenes/washing-line.toml', 'garments/tshirt_[0-9]*.landmarks.toml',
               'garments/contact/washing.landmarks.toml', 'fabrics/*.toml', 'motions/walk.bvh']


def imported(importer, model):
    """The model as it is read for libtaut: the page has no reader."""
    # Through a pipe: the importer may write no files.
    answer = subprocess.run([importer, 'import-model', '--memory', '4096', '--seconds', '60', '--parts', '0', model],
                            check=True, stdout=subprocess.PIPE).stdout
    if answer[:1] != b'A':
        raise SystemExit(f'pack.py: {model}: {answer[9:].decode()}')
    return answer


def main(importer, assets, wasm, folder):
    assets, folder = pathlib.Path(assets), pathlib.Path(folder)
    files = {'taut.wasm': pathlib.Path(wasm).read_bytes()}
    for name in MODELS:
        files[name] = imported(importer, assets / name)
    for pattern in AS_THEY_ARE:
        for file in sorted(assets.glob(pattern)):
            files[str(file.relative_to(assets))] = file.read_bytes()
    index = json.dumps([[name, len(content)] for name, content in files.items()]).encode()
    packed = gzip.compress(len(index).to_bytes(4, 'little') + index + b''.join(files.values()), 9, mtime=0)
    (folder / 'pack.js').write_text(f"export default '{base64.b64encode(packed).decode()}';\n")


main(*sys.argv[1:])
