"""The program and its scenes as a script sees them."""

import json
import re
import shutil
import struct
import subprocess
import tomllib
import zlib

from measure import Cloth, grid, read_obj


def judged(folder, found):
    """The exit code of a check, by lists of what it found. Where nothing was found the folder goes too."""
    if any(found):
        return 1
    shutil.rmtree(folder)
    return 0


class Program:
    """Runs in a folder of its own, which it finds empty."""

    def __init__(self, taut, assets, folder):
        self.taut, self.assets, self.folder = taut, assets, folder

    def run(self, *arguments):
        """Returns what it prints. Raises RuntimeError unless it ends well."""
        command = [self.taut, *map(str, arguments)]
        done = subprocess.run(command, cwd=self.folder, capture_output=True, text=True)
        if done.returncode != 0:
            raise RuntimeError(f"{' '.join(map(str, command))}: ended with {done.returncode}: {done.stderr}")
        return done.stdout

    def shirt(self, triangles):
        return self.assets / "garments" / f"tshirt_{triangles}.obj"

    def scenes(self):
        """The names of the built-in scenes, but for those about contact, which stand below an empty line: of these 1.5 s
        take minutes, and what they promise is checked by `taut bench --contact`. Those of garments that are at rest as they
        are cut are left out: their lengths at rest are not in the positions of their files."""
        names = [line.split()[0] for line in self.run("scenes").split("\n\n")[0].splitlines()]
        return [name for name in names if not self.is_cut(self.scene(name)["garment"].get("file"))]

    def is_cut(self, garment):
        landmarks = self.assets / "scenes" / f"{garment}".replace(".obj", ".landmarks.toml")
        return landmarks.exists() and "is_cut = true" in landmarks.read_text(encoding="utf-8")

    def scene(self, name):
        return tomllib.loads((self.assets / "scenes" / f"{name}.toml").read_text(encoding="utf-8"))

    def cloth(self, scene_name):
        """The input of a built-in scene."""
        garment = self.scene(scene_name)["garment"]
        if "grid" in garment:
            return Cloth(*grid(*(garment["grid"][key] for key in ("columns", "rows", "width", "height"))))
        return Cloth(*read_obj(self.assets / "scenes" / garment["file"]))

    def promised(self, scene_name):
        """The bound that a built-in scene promises, or none."""
        solver = self.scene(scene_name)["solver"]
        return solver["max_stretch"] if solver["kind"] == "bounded" else None

    def statistics(self, name):
        """Returns what was measured of every frame; before and after those stand what was run and what came of it."""
        lines = (self.folder / name).read_text(encoding="utf-8").splitlines()
        return [record for record in map(json.loads, lines) if "frame" in record]


def settings(**keys):
    """Arguments of the command line; two underscores stand for the dot of a key."""
    return [word for key, value in keys.items() for word in ("--set", f"{key.replace('__', '.')}={json.dumps(value)}")]


def png_texts(path):
    """Keywords and texts of a PNG."""
    data, at, texts = path.read_bytes(), 8, {}
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        if kind == b"tEXt":
            keyword, _, text = data[at + 8:at + 8 + length].partition(b"\0")
            texts[keyword.decode("latin-1")] = text.decode("latin-1")
        at += length + 12
    return texts


def pdf_text(path):
    """Returns the text on the pages of a PDF as Cairo makes it with Latin letters."""
    text = ""
    for stream in re.findall(rb"/FlateDecode\s*>>\s*stream\n(.*?)\nendstream", path.read_bytes(), re.DOTALL):
        for words in re.findall(rb"\(((?:[^\\()]|\\.)*)\)\s*Tj", zlib.decompress(stream)):
            text += words.decode("latin-1") + "\n"
    return text
