"""What each tuned number of the solver `bounded`, and each of its parts, is worth: a table in Markdown.

Each variant has one number times a factor, or one setting of a scene. Variants take turns with the solver as it is, and
a frame counts with its fastest run, so that a busy machine hinders all alike.

    cmake --preset ablation && cmake --build build/ablation --target taut
    python3 tests/study/ablation.py build/ablation/app/taut                       all numbers, halved and doubled: two hours
    python3 tests/study/ablation.py build/ablation/app/taut --numbers region_travel_per_edge --factors 0.5,0.75,1.4,2
    python3 tests/study/ablation.py build/ablation/app/taut --settings solver.tethers=false 'solver.bound="springs"'
"""
import argparse
import csv
import os
import pathlib
import re
import subprocess
import sys
import tempfile

FOLDER = pathlib.Path(__file__).resolve().parents[2]
TUNING = FOLDER / "sim" / "solvers" / "bounded" / "tuning.hpp"
# Name, built-in scene, its changes.
SCENES = {
    "hanging": ("tshirt-gravity", ["garment.file=tshirt_5280"]),
    "wind": ("tshirt-wind-10", ["garment.file=tshirt_5280"]),
    "storm": ("tshirt-wind-10", ["garment.file=tshirt_1028", "wind.speed=20"]),
    "pulled": ("table-cloth-2", []),
}


def read_numbers():
    found = re.findall(r"^inline constexpr \S+ (\w+) = ([^;]+);", TUNING.read_text(), re.M)
    return {name: eval(value.replace("F", ""), {}) for name, value in found}  # "1.0 / 15.0" is one


def run(taut, scene, frames, environment, settings):
    """Returns the frames' rows of statistics; none if the run ended early."""
    name, changes = SCENES[scene]
    with tempfile.TemporaryDirectory() as folder:
        stats = pathlib.Path(folder) / "stats.csv"
        words = [taut, "simulate", name, "--frames", str(frames), "--stats", stats, "--quiet"]
        for change in [*changes, "solver.threads=1", "solver.allow_exceeding=true", *settings]:
            words += ["--set", change]
        done = subprocess.run(words, env={**os.environ, **environment}, capture_output=True, text=True)
        if done.returncode != 0 or not stats.exists():
            return []
        with open(stats, newline="") as file:
            return list(csv.DictReader(file))


class Variant:
    """Fastest time of each frame over all runs, and broken promises."""

    def __init__(self, name, environment, settings):
        self.name, self.environment, self.settings = name, environment, settings
        self.times_ms, self.long_frames, self.crossings, self.hashes, self.is_lost = [], 0, 0, set(), False

    def measure(self, taut, scene, frames):
        rows = run(taut, scene, frames, self.environment, self.settings)
        self.is_lost = self.is_lost or not rows
        if self.is_lost:
            return
        times_ms = [float(row["sim_ms"]) for row in rows]
        self.times_ms = [min(pair) for pair in zip(self.times_ms, times_ms)] if self.times_ms else times_ms
        self.long_frames = sum(row["bound_kept"] == "false" for row in rows)
        self.crossings = int(rows[-1]["measured_crossings"] or 0)
        self.hashes.add(rows[-1]["state_hash"])

    def cell(self, plain):
        if self.is_lost:
            return "refused"
        if self.environment and self.hashes == plain.hashes:
            return "same bits"
        text = f"{sum(self.times_ms) / sum(plain.times_ms):.2f}"
        text += f"; {self.long_frames} too long" if self.long_frames else ""
        return text + (f"; {self.crossings} cross" if self.crossings else "")


def variants_of(options):
    numbers = read_numbers()
    unknown = [name for name in options.numbers or [] if name not in numbers]
    if unknown:
        sys.exit(f"ablation: found no number '{unknown[0]}' in {TUNING}")
    names = [] if options.settings and not options.numbers else options.numbers or list(numbers)
    made = [(f"{name} = {numbers[name] * factor:g} ({numbers[name]:g})", {name: repr(numbers[name] * factor)}, [])
            for name in names for factor in options.factors]
    return made + [(setting, {}, [setting]) for setting in options.settings]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("taut", help="the program, built by the preset ablation")
    parser.add_argument("--numbers", nargs="+", metavar="NAME", help="some of tuning.hpp (default: all)")
    parser.add_argument("--factors", type=lambda text: [float(word) for word in text.split(",")], default=[0.5, 2.0])
    parser.add_argument("--settings", nargs="+", metavar="KEY=VALUE", default=[], help="changes of the scenes")
    parser.add_argument("--scenes", nargs="+", choices=SCENES, default=list(SCENES))
    parser.add_argument("--frames", type=int, default=60)
    parser.add_argument("--runs", type=int, default=2)
    options = parser.parse_args()
    if b"region_travel_per_edge" not in pathlib.Path(options.taut).read_bytes():
        sys.exit(f"ablation: found in {options.taut} no numbers that can be set; expected the program of the preset ablation")
    print("| variant | " + " | ".join(options.scenes) + " |")
    print("|---" * (len(options.scenes) + 1) + "|")
    for variant in variants_of(options):
        cells = []
        for scene in options.scenes:
            plain, changed = Variant("", {}, []), Variant(*variant)
            for _ in range(options.runs):
                plain.measure(options.taut, scene, options.frames)
                changed.measure(options.taut, scene, options.frames)
            if plain.is_lost:
                sys.exit(f"ablation: {options.taut} does not run the scene {SCENES[scene][0]}")
            cells.append(changed.cell(plain))
        print(f"| {variant[0]} | " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    main()
