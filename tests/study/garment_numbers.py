"""What each tuned number of sewing is worth: the outcomes that change when it is halved and doubled.

    cmake --preset ablation && cmake --build build/ablation --target taut
    python3 tests/study/garment_numbers.py build/ablation/app/taut        all numbers: half an hour
    python3 tests/study/garment_numbers.py build/ablation/app/taut pull_m_per_s2 slack_m

A number that changes no garment is idle.
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

FOLDER = pathlib.Path(__file__).resolve().parents[2]
TUNING = FOLDER / "app" / "garments" / "sewing" / "tuning.hpp"
WARDROBE = FOLDER / "assets" / "patterns" / "wardrobe"
OUTFIT = FOLDER / "assets" / "patterns" / "outfit"
BODIES = FOLDER / "assets" / "bodies"
GARMENTS = {
    "free trousers": [WARDROBE / "trousers.json"],
    "dress": [WARDROBE / "dress.json", "--fabric", "jersey", "--body", BODIES / "mannequin_female_34.glb"],
    "trousers": [WARDROBE / "trousers.json", "--fabric", "denim", "--body", BODIES / "mannequin_female_34.glb"],
    "too small": [WARDROBE / "skirt.json", "--fabric", "cotton", "--body", BODIES / "mannequin_female_42.glb"],
    "outfit": [OUTFIT / "shirt.json", "--fabric", "cotton", "--over", OUTFIT / "jacket.json", "--over-fabric", "denim",
               "--body", BODIES / "mannequin_male_40.glb"],
}


def outcome(taut, words, environment):
    """Returns the exit code and what was said of the garment."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "sewn.obj"
        command = [taut, "sew", *words, "--triangles", "500", "--frames", "30", "-o", file]
        done = subprocess.run(command, env={**os.environ, **environment}, capture_output=True, text=True, cwd=folder)
        said = re.findall(r"seams closed.*(?=;)|error: .*", (done.stdout + done.stderr).replace(folder, ""))
        return done.returncode, said


def main():
    taut = str(pathlib.Path(sys.argv[1]).resolve())
    found = re.findall(r"^inline constexpr \S+ (\w+) = ([^;]+);", TUNING.read_text(), re.M)
    usual = {name: outcome(taut, words, {}) for name, words in GARMENTS.items()}
    for number, value in found:
        if sys.argv[2:] and number not in sys.argv[2:]:
            continue
        changed = []
        for factor in (0.5, 2.0):
            environment = {number: repr(eval(value, {}) * factor)}
            for name, words in GARMENTS.items():
                now = outcome(taut, words, environment)
                if now != usual[name]:
                    changed.append(f"{name} x{factor:g}" + (f" ends with {now[0]}" if now[0] != usual[name][0] else ""))
        print(f"{number}: {', '.join(changed) or 'idle'}", flush=True)


main()
