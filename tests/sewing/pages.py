"""Sews each pattern of a page with the command of the page, or checks patterns against the schema."""
import json
import pathlib
import re
import shlex
import subprocess
import sys


def blocks(page, language):
    return re.findall(rf"```{language}\n(.*?)```", page, re.S)


def sew_all(taut, project, page):
    text = pathlib.Path(page).read_text()
    named = re.findall(r"`(\w+\.json)`:\n\n```json\n(.*?)```", text, re.S)
    for name, pattern in named:
        pathlib.Path(name).write_text(pattern)
    commands = [line for block in blocks(text, "sh") for line in block.splitlines() if line.startswith("taut sew ")]
    assert len(commands) == len(named) >= 3, (commands, [name for name, _ in named])
    for command in commands:
        words = [taut] + [word.replace("assets/", f"{project}/assets/") for word in shlex.split(command)[1:]]
        stem = pathlib.Path(words[2]).stem
        done = subprocess.run(words + ["-o", f"{stem}.obj"], capture_output=True, text=True)
        print(done.stdout, done.stderr)
        assert done.returncode == 0 and "at rest, no crossing" in done.stdout, command


def check_schema(project, page):
    import jsonschema
    schema = json.loads((pathlib.Path(project) / "app/garments/sewing/pattern.schema.json").read_text())
    jsonschema.Draft7Validator.check_schema(schema)
    validator = jsonschema.Draft7Validator(schema)
    patterns = [json.loads(file.read_text()) for file in sorted(pathlib.Path(project).glob("assets/patterns/*/*.json"))
                if file.name != "package.json"]
    of_page = [json.loads(text) for text in blocks(pathlib.Path(page).read_text(), "json")][:-1]
    assert len(patterns) >= 8 and len(of_page) >= 3
    for pattern in patterns + of_page:
        validator.validate(pattern)
    skirt = of_page[0]

    def broken(change):
        copy = json.loads(json.dumps(skirt))
        change(copy)
        return list(validator.iter_errors(copy))

    front = lambda pattern: pattern["pattern"]["panels"]["front"]
    changes = {
        "no stitches": lambda p: p["pattern"].pop("stitches"),
        "no panel": lambda p: p["pattern"].update(panels={}),
        "no edges": lambda p: front(p).pop("edges"),
        "a corner of three numbers": lambda p: front(p)["vertices"][0].append(0),
        "an edge of one end": lambda p: front(p)["edges"][0].update(endpoints=[0]),
        "an unknown curve": lambda p: front(p)["edges"][1].update(curvature={"type": "spline", "params": [[0, 0]]}),
        "an arc without a radius": lambda p: front(p)["edges"][1].update(curvature={"type": "circle", "params": [0, 1]}),
        "a text for an edge": lambda p: p["pattern"]["stitches"][0][0].update(edge="0"),
        "one side": lambda p: p["pattern"]["stitches"][0].pop(),
        "a unit of nothing": lambda p: p.update(properties={"units_in_meter": 0}),
        "a joint that is a number": lambda p: p.update(properties={"joint": 1}),
    }
    for name, change in changes.items():
        assert broken(change), f"the schema takes a pattern with {name}"


if sys.argv[1] == "sew":
    sew_all(*sys.argv[2:])
else:
    check_schema(*sys.argv[2:])
