"""What each tuned number of garments and models is worth: the outcomes that change when it is halved and doubled.

    cmake --preset ablation && cmake --build build/ablation --target taut
    python3 tests/study/garment_numbers.py build/ablation/app/taut        all numbers: two hours
    python3 tests/study/garment_numbers.py build/ablation/app/taut dressing pull_m_per_s2
    python3 tests/study/garment_numbers.py build/ablation/app/taut sewing --all

Commands run until one changes its outcome; --all runs all. A number that changes none is idle. Outcomes are the exit
code, what is said, and its numbers within a tolerance, as any change moves cloth by some micrometres. Of sewn garments
the number of seams, rest, the size and the length of cloth around it count too. TAUT_PATTERNS names a folder with more
patterns, TAUT_GARMENTS one with more models.
"""
import json
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile

FOLDER = pathlib.Path(__file__).resolve().parents[2]
ASSETS = FOLDER / "assets"
ROOMS = {"fitting": "app/garments", "mending": "app/models", "hanging": "app/models", "dressing": "app/garments",
         "sewing": "app/garments"}
WARDROBE, OUTFIT = ASSETS / "patterns" / "wardrobe", ASSETS / "patterns" / "outfit"
BODIES = {name: ASSETS / "bodies" / f"mannequin_{name}.glb" for name in ("female_34", "female_42", "male_40")}
TUTORIAL = FOLDER / "app" / "garments" / "sewing" / "tutorial.md"
# Numbers that act in `taut sew --exact` alone.
EXACT = {"max_meshes", "spacing_growth", "max_point_growth", "exact_jitter", "exact_shortened"}
NUMBER = re.compile(r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?")


def sew(pattern, body=None, fabric="cotton", triangles=250, frames=40, more=()):
    worn = [] if body is None else ["--body", BODIES[body]]
    return ["sew", pattern, "--fabric", fabric, *worn, "--triangles", str(triangles), "--frames", str(frames), *more]


def table(garment, body, *more):
    """Prints the table of fit, and ends before cloth moves."""
    return ["table", ASSETS / "garments" / f"{garment}.obj", "--body", body, *more]


def walls(file, thickness):
    """Returns an OBJ with a second wall at this distance inside the first, and a ball beside both that is no cloth."""
    lines = [line.split() for line in file.read_text().splitlines()]
    at = [[float(word) for word in line[1:4]] for line in lines if line[:1] == ["v"]]
    faces = [[int(word.split("/")[0]) - 1 for word in line[1:4]] for line in lines if line[:1] == ["f"]]
    normals = [[0.0] * 3 for _ in at]
    for a, b, c in faces:
        u, v = ([at[k][i] - at[a][i] for i in range(3)] for k in (b, c))
        for i in range(3):
            for k in (a, b, c):
                normals[k][i] += u[(i + 1) % 3] * v[(i + 2) % 3] - u[(i + 2) % 3] * v[(i + 1) % 3]
    inner = [[p[i] - thickness * n[i] / max(math.hypot(*n), 1e-30) for i in range(3)] for p, n in zip(at, normals)]
    ball = [[0.3 * math.cos(t) * math.cos(p), 0.3 * math.sin(t), 0.3 * math.cos(t) * math.sin(p)]
            for t in (math.pi * (k / 12 - 0.5) for k in range(13)) for p in (2 * math.pi * k / 24 for k in range(24))]
    count = len(at)
    faces += [[c + count, b + count, a + count] for a, b, c in faces]
    for t in range(12):
        for p in range(24):
            a, b = 2 * count + 24 * t + p, 2 * count + 24 * t + (p + 1) % 24
            faces += [[a, a + 24, b + 24], [a, b + 24, b]]
    return "".join("v %.6f %.6f %.6f\n" % tuple(p) for p in at + inner + ball) + \
           "".join("f %d %d %d\n" % tuple(v + 1 for v in face) for face in faces)


def of_models(folder):
    """Returns the commands of models, the cheapest first."""
    (folder / "walls.obj").write_text(walls(ASSETS / "garments/dress.obj", 0.003))
    files = {"walls": (folder / "walls.obj", "--set", "garment.triangles=1500")}
    for name in ("skirt", "trousers", "hooded_top", "tshirt_1028", "dress"):
        files[name] = (ASSETS / f"garments/{name}.obj", "--set", "garment.mesh=fitted", "--set", "garment.triangles=1200")
    for more in sorted(pathlib.Path(os.environ["TAUT_GARMENTS"]).iterdir(), key=lambda file: file.stat().st_size) \
            if "TAUT_GARMENTS" in os.environ else []:
        files[more.stem] = (more,)
    return ({name: ["inspect", *words, "--json"] for name, words in files.items()},
            {f"{name} moves": ["simulate", *words, "--frames", "3"] for name, words in files.items()})


def without_joints(file):
    """Returns the bytes of a GLB file without its skins, as a scan."""
    data = file.read_bytes()
    begin = 20 + int.from_bytes(data[12:16], "little")
    model = json.loads(data[20:begin])
    model.pop("skins")
    for node in model["nodes"]:
        node.pop("skin", None)
    for primitive in (primitive for mesh in model["meshes"] for primitive in mesh["primitives"]):
        for name in [name for name in primitive["attributes"] if name[:6] in ("JOINTS", "WEIGHT")]:
            primitive["attributes"].pop(name)
    text = json.dumps(model).encode()
    text += b" " * (-len(text) % 4)
    sizes = [20 + len(text) + len(data) - begin, len(text)]
    return data[:8] + sizes[0].to_bytes(4, "little") + sizes[1].to_bytes(4, "little") + data[16:20] + text + data[begin:]


def commands(folder):
    """Returns the commands of each room, the cheapest first."""
    for name, text in re.findall(r"`(\w+\.json)`:\n\n```json\n(.*?)```", TUTORIAL.read_text(), re.S):
        (folder / name).write_text(text)
    tiny = json.loads((folder / "cushion.json").read_text())
    tiny["properties"] = {"units_in_meter": 1000}
    (folder / "tiny.json").write_text(json.dumps(tiny))
    scan = folder / "scan.glb"
    scan.write_bytes(without_joints(BODIES["female_34"]))
    tshirt = folder / "tshirt.json"
    tshirt.write_bytes(subprocess.run([sys.executable, "-B", ASSETS / "patterns/tshirt/as_json.py",
                                       ASSETS / "patterns/tshirt/teagan.toml"], capture_output=True, check=True).stdout)
    others = sorted(pathlib.Path(os.environ["TAUT_PATTERNS"]).glob("*.json")) if "TAUT_PATTERNS" in os.environ else []
    inspected, moved = of_models(folder)
    return {
        "fitting": moved, "mending": moved, "hanging": inspected,
        "exact": {"exact": sew(folder / "cushion.json", triangles=500, frames=1, more=["--exact"]),
                  "exact skirt": sew(WARDROBE / "skirt.json", triangles=900, frames=1, more=["--exact"])},
        "sewing": {
            "tiny": sew(folder / "tiny.json", triangles=300),
            "coarse": sew(WARDROBE / "long_shirt.json", triangles=100, frames=1),
            "cushion": sew(folder / "cushion.json", triangles=100, frames=120),
            "skirt": sew(WARDROBE / "skirt.json", "female_34"),
            "bag": sew(folder / "tote.json", triangles=400),
            "tshirt": sew(tshirt, "male_40", "jersey"),
            "dress": sew(WARDROBE / "dress.json", "female_34", "jersey"),
            "trousers": sew(WARDROBE / "trousers.json", "female_34", "denim", frames=120),
            "hood": sew(WARDROBE / "hooded_top.json", "male_40", "jersey"),
            "shirt": sew(WARDROBE / "long_shirt.json", "female_42", frames=120),
            "free trousers": sew(WARDROBE / "trousers.json", frames=80),
            "too small": sew(WARDROBE / "skirt.json", "female_42"),
            "outfit": sew(OUTFIT / "shirt.json", "male_40", triangles=500,
                          more=["--over", OUTFIT / "jacket.json", "--over-fabric", "denim"]),
            **{file.stem: sew(file, "male_40", "jersey") for file in others}},
        "dressing": {
            **{name: ["inspect", "--body", file, "--json"] for name, file in BODIES.items()},
            "scan": ["inspect", "--body", scan, "--json"],
            **{f"{garment} on {body}": table(garment, BODIES[body]) for garment, body in (
                ("skirt", "female_34"), ("dress", "male_40"), ("trousers", "female_42"), ("tshirt_1028", "male_40"),
                ("hooded_top", "male_40"), ("tshirt_1028", "female_34"), ("long_sleeves", "female_42"))},
            "on a scan": table("tshirt_1028", scan),
            "refused": ["simulate", ASSETS / "garments/tshirt_1028.obj", "--body", BODIES["male_40"], "--set",
                        "garment.scale=0.8", "--dress", "20", "--frames", "2"],
            "raised": table("tshirt_1028", BODIES["male_40"], "--body-motion", ASSETS / "motions/raise_arms.bvh"),
            "grown": ["simulate", ASSETS / "garments/tshirt_1028.obj", "--body", BODIES["male_40"], "--body-motion",
                      ASSETS / "motions/walk.bvh", "--dress", "20", "--frames", "2"],
            "outfit": ["simulate", ASSETS / "garments/outfits/outfit.obj", "--fabric", "cotton", "--body",
                       BODIES["male_40"], "--dress", "20", "--frames", "2"],
            "too small": ["simulate", ASSETS / "garments/tshirt_1028.obj", "--body", BODIES["male_40"], "--set",
                          "garment.scale=0.93", "--set", "solver.max_substeps=20", "--dress", "20", "--frames", "2"],
            "drawn": ["fit", ASSETS / "garments/tshirt_1028.obj", "--body", BODIES["male_40"], "--dress", "20",
                      "--frames", "1"]}}


def shape(file):
    """Returns the box of a sewn garment and the length of its borders, in cm."""
    if not file.exists():
        return []
    lines = [line.split() for line in file.read_text().splitlines()]
    at = [tuple(float(word) for word in line[1:4]) for line in lines if line[:1] == ["v"]]
    faces = [[int(word.split("/")[0]) - 1 for word in line[1:]] for line in lines if line[:1] == ["f"]]
    edges = {(a, b) for face in faces for a, b in zip(face, face[1:] + face[:1])}
    border = sum(math.dist(at[a], at[b]) for a, b in edges if (b, a) not in edges)
    return [100 * limit(p[k] for p in at) for k in range(3) for limit in (min, max)] + [20 * border]


class Taut:
    def __init__(self, program, folder):
        self.program, self.folder = program, folder

    def outcome(self, words, environment):
        """Returns what is compared exactly, and numbers with their tolerances."""
        file = self.folder / "sewn.obj"
        file.unlink(missing_ok=True)
        of_sewing = words[0] == "sew"
        more = ["-o", file] if of_sewing else ["-o", self.folder / "fit.png"] if words[0] in ("fit", "table") else []
        command = [self.program, "fit" if words[0] == "table" else words[0], *words[1:], *more]
        # Progress, which depends on time, goes to standard error as well.
        errors = open(self.folder / "errors.txt", "w+", encoding="utf-8")
        # Some numbers let a loop run for ever.
        limited = ["timeout", "-k", "1", "120", *command]
        process = subprocess.Popen(limited, env={**os.environ, **environment}, stdout=subprocess.PIPE, stderr=errors,
                                   text=True, cwd=self.folder)
        said = ""
        for line in process.stdout:
            said += line
            if words[0] == "table" and re.match("(leg )?hem ", line):
                process.terminate()
                break
        code = process.wait() if words[0] != "table" else 0
        errors.seek(0)
        said += "".join(line for line in errors if "error" in line and words[0] != "table")
        errors.close()
        said = re.sub(r"[\d.]+ s of processor time|wrote .*|'[^']*\.png'|.*\d ms.*", "", said)
        said = said.replace(str(self.folder), "").replace(str(FOLDER), "")
        # Where sewn cloth is tightest is chance.
        said = re.sub(r"; it is tightest.*|position of vertex.*|in frame .*|first is frame.*", "", said)
        exactly = words[0] in ("inspect", "table")
        numbers = [(float(number), 1e-3 if exactly else 0.03) for number in NUMBER.findall(said)]
        return ((code, NUMBER.sub("#", said)),
                numbers + [(cm / 100, 0.01) for cm in (shape(file) if of_sewing else [])])


def differ(now, usual):
    return now[0] != usual[0] or len(now[1]) != len(usual[1]) or any(
        abs(a - b) > tolerance * max(1.0, abs(b)) for (a, _), (b, tolerance) in zip(now[1], usual[1]))


def main():
    program, wanted = str(pathlib.Path(sys.argv[1]).resolve()), [word for word in sys.argv[2:] if word != "--all"]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        taut = Taut(program, folder)
        of_rooms = commands(folder)
        usual = {}
        for room, place in ROOMS.items():
            tuning = FOLDER / place / room / "tuning.hpp"
            for number, value in re.findall(r"^inline constexpr \S+ (\w+) = ([^;]+);", tuning.read_text(), re.M):
                if wanted and number not in wanted and room not in wanted:
                    continue
                changed = []
                of_room = of_rooms["exact" if number in EXACT else room]
                for factor in (0.5, 2.0):
                    environment = {number: repr(eval(value, {}) * factor)}
                    for command, words in of_room.items():
                        if changed and "--all" not in sys.argv:
                            break
                        if command not in usual:
                            usual[command] = taut.outcome(words, {})
                        now = taut.outcome(words, environment)
                        if differ(now, usual[command]):
                            ends = f" ends with {now[0][0]}" if now[0][0] != usual[command][0][0] else ""
                            changed.append(f"{command} x{factor:g}{ends}")
                print(f"{room} {number}: {', '.join(changed) or 'idle'}" + (" (--exact)" if number in EXACT else ""),
                      flush=True)


main()
