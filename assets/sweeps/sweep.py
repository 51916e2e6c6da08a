"""Reads a study, makes one of its runs, and writes the table of all. The Snakefile beside it calls it.

sweep.py run TAUT STUDY FOLDER RUN   makes a run, or goes on with it where it was stopped
sweep.py table TAUT STUDY FOLDER     writes FOLDER/table.csv, also while runs are missing
"""
import csv
import hashlib
import itertools
import json
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tomllib

ENDS = {0: "done", 3: "broken"}  # by the exit code of taut; a broken promise is a result


class StudyError(Exception):
    """A study cannot be used. The message names file and key."""


class Study:
    """Every combination of the values of a study's axes."""

    def __init__(self, file, taut):
        if not file:
            raise StudyError("expected a study: --config study=FILE.toml")
        self.file, program = pathlib.Path(file), shutil.which(taut)
        if program is None:
            raise StudyError(f"there is no program '{taut}'; expected --config taut=PATH")
        self.taut = pathlib.Path(program).resolve()
        study = self._read(self.file)
        for key in study.keys() - {"scene", "frames", "axes"}:
            raise StudyError(f"{file}: {key}: unknown key, expected scene, frames or [axes]")
        if not isinstance(study.get("scene"), str):
            raise StudyError(f"{file}: scene: expected a scene or a garment file")
        if not isinstance(study.get("axes"), dict):
            raise StudyError(f'{file}: axes: expected a table, such as [axes] with "wind.speed" = [0, 1, 10]')
        self.scene, self._digests = study["scene"], {}
        axes = {"time.frames": [study["frames"]]} if "frames" in study else {}
        axes.update(self._axes(study["axes"]))
        combinations = (dict(zip(axes, values)) for values in itertools.product(*axes.values()))
        # Settings of each run, by its name. A name stands for all that the run depends on.
        self.runs = {self._name(settings): settings for settings in combinations}

    @staticmethod
    def _read(file):
        try:
            return tomllib.loads(file.read_text())
        except (OSError, ValueError) as error:
            raise StudyError(f"{file}: {error}")

    def _axes(self, table):
        help_text = subprocess.run([self.taut, "help", "scene"], capture_output=True, text=True, check=True).stdout
        known = set(re.findall(r"^  ([a-z_.]+) = ", help_text.partition("\nEach ")[0], re.MULTILINE))
        axes = dict(flatten(table))
        for key, values in axes.items():
            if key not in known and not key.startswith("body."):
                raise StudyError(f"{self.file}: {key}: unknown key; taut help scene lists those that there are")
            if not isinstance(values, list) or not values:
                raise StudyError(f"{self.file}: {key}: found {to_toml(values)}, expected a list of values")
        return axes

    def _name(self, settings):
        files = [self.taut, *self._named_files([self.scene, settings], self.file.parent)]
        parts = [self.scene, to_toml(settings), *map(self._digest, files)]
        return hashlib.sha256("\n".join(parts).encode()).hexdigest()[:12]

    def _digest(self, file):
        if file not in self._digests:
            self._digests[file] = hashlib.sha256(file.read_bytes()).hexdigest()
        return self._digests[file]

    def _named_files(self, value, folder):
        """Lists the files that a value names, what belongs to these, and the files that a scene file names in turn."""
        if isinstance(value, (dict, list)):
            values = value.values() if isinstance(value, dict) else value
            return [file for inner in values for file in self._named_files(inner, folder)]
        if not isinstance(value, str) or not (file := folder / value).is_file():
            return []
        beside = [file.with_suffix(ending) for ending in (".landmarks.toml", ".mtl", ".bin")]
        inner = self._named_files(self._read(file), file.parent) if file.suffix == ".toml" else []
        return [file, *filter(pathlib.Path.is_file, beside), *inner]

    def _resolve(self, value):
        """Returns the value with the full paths of files, which a study names from its own folder."""
        if isinstance(value, dict):
            return {key: self._resolve(inner) for key, inner in value.items()}
        if isinstance(value, list):
            return [self._resolve(inner) for inner in value]
        file = self.file.resolve().parent / str(value)
        return str(file) if isinstance(value, str) and file.is_file() else value

    def make_run(self, run, folder):
        """Makes a run in its folder, or goes on with it. Returns the exit code of taut, 0 also for a broken promise."""
        if run not in self.runs:
            raise StudyError(f"{self.file}: there is no run {run}: the study, taut or a model has changed")
        folder = pathlib.Path(folder, run).resolve()
        folder.mkdir(parents=True, exist_ok=True)
        log, frames, checkpoint = folder / "log.txt", folder / "frames.jsonl", folder / "checkpoint"
        command = [self.taut, "simulate", self._resolve(self.scene), "--quiet", "--stats", frames]
        command += ["--resume" if checkpoint.exists() else "--checkpoint", checkpoint]
        for key, value in self.runs[run].items():
            command += ["--set", f"{key}={to_toml(self._resolve(value))}"]
        if not checkpoint.exists():
            frames.unlink(missing_ok=True)
        for number in (signal.SIGINT, signal.SIGTERM):
            signal.signal(number, lambda *_: None)  # taut receives it too, saves the run and ends
        with open(log, "w") as output:
            code = subprocess.run(command, cwd=folder, stdout=output, stderr=output).returncode
        if code not in ENDS:
            print(f"run {run} ended with exit code {code}:\n{log.read_text()}", file=sys.stderr)
            return code
        result = folder / "result.json.part"
        result.write_text(json.dumps(read_result(ENDS[code], log, frames)))
        result.rename(folder / "result.json")
        checkpoint.unlink(missing_ok=True)
        return 0

    def write_table(self, folder):
        """Writes a row for each run, of which those without a result are missing."""
        rows = []
        for run, settings in self.runs.items():
            file = pathlib.Path(folder, run, "result.json")
            result = json.loads(file.read_text()) if file.exists() else {"end": "missing"}
            cells = {key: value if isinstance(value, str) else to_toml(value) for key, value in settings.items()}
            rows.append({"run": run, **cells, **result})
        with open(pathlib.Path(folder, "table.csv"), "w", newline="") as output:
            table = csv.DictWriter(output, dict.fromkeys(itertools.chain(*rows)), lineterminator="\n")
            table.writeheader()
            table.writerows(rows)


def flatten(table, section=""):
    """Keys with their sections. They may stand in quotes, "wind.speed", or without, as TOML's tables in tables."""
    for key, value in table.items():
        if isinstance(value, dict):
            yield from flatten(value, f"{section}{key}.")
        else:
            yield section + key, value


def to_toml(value):
    """The value as TOML, on one line."""
    if isinstance(value, dict):
        return "{" + ", ".join(f"{json.dumps(key)} = {to_toml(inner)}" for key, inner in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(to_toml, value)) + "]"
    return json.dumps(value, ensure_ascii=False) if isinstance(value, (str, bool)) else str(value)


def read_result(end, log, frames):
    """Returns the result of a run that has ended: the summary of its statistics, or what its last frame allows."""
    lines = [json.loads(line) for line in frames.read_text().splitlines()] if frames.exists() else []
    garment = lines[0]["garment"] if lines else {}
    states = [line for line in lines if "state_hash" in line]
    summary = {"frames": len(states)}
    for measure in ("max_stretch", "max_surface_stretch"):
        summary[measure] = max((state[measure] for state in states), default=None)
    return {"end": end, "reason": log.read_text().strip().rpartition("\n")[2] if end == "broken" else "",
            "vertices": garment.get("vertices"), "triangles": garment.get("triangles"),
            "state_hash": states[-1]["state_hash"] if states else None,
            **(lines[-1].get("summary", summary) if lines else summary)}


def main(action, taut, study, folder, *runs):
    try:
        if action == "run":
            return Study(study, taut).make_run(*runs, folder)
        return Study(study, taut).write_table(folder)
    except StudyError as error:
        return str(error)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
