"""The ways in which positions leave the program: each is a command and a reader of what it wrote and said.

A way is one entry of WAYS, a function of the program that yields shapes. To add one, write such a function."""

import csv
import re
from functools import partial

from measure import MEASURES, Cloth, Printed, Shape, read_obj
from program import pdf_text, png_texts, settings

BOUNDS = {"5_percent": 0.05, "1_percent": 0.01, "0.1_percent": 0.001}
BOUNDED = {"solver__kind": "bounded", "solver__substeps": 0}
NECKLINE = {"pins__at": ["front_neckline", "back_neckline"]}
LITERAL = {"solver__kind": "strong", "solver__substeps": 60, "solver__iterations": 1, "solver__compression": 1,
           "solver__flexural": 1}
SHAKEN = {"pins__motion__amplitude": [0.1, 0, 0], "pins__motion__frequency": 1}
WIND = {"wind__speed": 10, "wind__direction": [0.3, 0, 1]}


def exported(scene, cloth, bound, frames, keys, program):
    """Every frame of a run as OBJ, beside the statistics and what is printed meanwhile."""
    said = program.run("simulate", scene, "--export", "{frame}.obj", "--stats", "run.jsonl",
                       *settings(time__frames=frames, **keys))
    lines = dict(re.findall(r"^frame +(\d+) .* max stretch +([-\d.]+) %", said, re.MULTILINE))
    records = program.statistics("run.jsonl")
    if [record["frame"] for record in records] != list(range(1, frames + 1)):
        raise RuntimeError(f"run.jsonl has not the frames 1 to {frames}")
    for record in records:
        frame = record["frame"]
        printed = Printed.all_of("run.jsonl", record)
        if str(frame) in lines:
            printed.append(Printed.percent("a line of the run", lines[str(frame)]))
        yield Shape(f"frame {frame}", cloth, *read_obj(program.folder / f"{frame}.obj"), printed, bound)


def exported_scene(scene, bound, frames, program):
    keys = BOUNDED | {"solver__max_stretch": bound}
    return exported(scene, program.cloth(scene), bound, frames, keys, program)


def exported_shirt(triangles, bound, frames, keys, program):
    """A garment file of the program, given as a user gives one."""
    file = program.shirt(triangles)
    return exported(file, Cloth(*read_obj(file)), bound, frames, NECKLINE | keys, program)


def exported_model(bound, frames, program):
    """A model as other programs write them: millimetres, z up, every face with vertices of its own."""
    points, faces = read_obj(program.shirt(1028))
    apart = [(1e3 * x, -1e3 * z, 1e3 * y) for x, y, z in (points[i] for face in faces for i in face)]
    with open(program.folder / "model.obj", "w", encoding="utf-8") as file:
        file.writelines(f"v {x} {y} {z}\n" for x, y, z in apart)
        file.writelines(f"f {i} {i + 1} {i + 2}\n" for i in range(1, 3 * len(faces), 3))
    keys = BOUNDED | {"solver__max_stretch": bound, "garment__scale": 0.001, "garment__up": "z"}
    cloth = Cloth(*read_obj(program.folder / "model.obj"), metres_per_unit=0.001)
    return exported("model.obj", cloth, bound, frames, keys, program)


def table(path):
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def percents(where, texts):
    """Returns the percents in a text of the program, by the names of the measures; an empty one says nothing."""
    return [Printed.percent(where, texts[name], name) for name in MEASURES if texts.get(name)]


def captions(path):
    """Returns the text of a figure below each panel that shows a shape; below others it may say more of the same shapes."""
    text = pdf_text(path)
    said = [percents("its caption", {"max_stretch": springs, "max_surface_stretch": surface}) for springs, surface
            in re.findall(r"\bstretch(?:: springs)? ([-\d.]+) %(?:, surface ([-\d.]+) %)?", text)]
    more = re.findall(r"99 of 100 springs up to ([-\d.]+) %, triangles up to ([-\d.]+) %", text)
    for printed, (springs, triangles) in zip(said, more):
        printed += percents("its second caption", {"p99_stretch": springs, "p99_surface_stretch": triangles})
    return said


def tabled(figure, program):
    """The tables of a figure and its captions."""
    program.run("figures", "--only", figure, "--scale", 0.25, "--output", "made")
    folder = program.folder / "made"
    points = {}
    for row in table(folder / f"{figure}_shapes.csv"):
        points.setdefault(row["panel"], []).append(tuple(float(row[axis]) for axis in ("x_m", "y_m", "z_m")))
    moments = table(folder / f"{figure}.csv")
    said = captions(folder / f"{figure}.pdf")
    if len(said) != len(moments) or points.keys() != {moment["panel"] for moment in moments}:
        raise RuntimeError(f"{folder}: {len(moments)} moments, {len(said)} captions, {len(points)} shapes")
    cloths = {scene: program.cloth(scene) for scene in {moment["scene"] for moment in moments}}
    for moment, printed in zip(moments, said):
        cloth = cloths[moment["scene"]]
        yield Shape(f"{folder.name}, panel {moment['panel']}", cloth, points[moment["panel"]], cloth.faces,
                    printed + Printed.all_of(f"{figure}.csv", moment), program.promised(moment["scene"]))


def remade(scene, frame, program):
    """A picture, the same made again from itself, and the shape of the scene that it carries."""
    program.run("render", scene, "--frames", frame, "--resolution", "64,64", "--output", "first.png", "--stats",
                "1.jsonl")
    program.run("render", "first.png", "--output", "again.png", "--stats", "2.jsonl")
    texts = png_texts(program.folder / "first.png")
    (program.folder / "recorded.toml").write_text(texts["Taut Scene"], encoding="utf-8")
    garment = (program.assets / "scenes" / program.scene(scene)["garment"]["file"]).resolve()
    program.run("simulate", "recorded.toml", "--frames", texts["Taut Frame"], "--export", "{frame}.obj",
                *settings(garment__file=str(garment)))
    printed = [Printed(name, float(png_texts(program.folder / name)["Taut Stretch"]))
               for name in ("first.png", "again.png")]
    for name in ("1.jsonl", "2.jsonl"):
        printed += Printed.all_of(name, program.statistics(name)[-1])
    yield Shape(f"frame {frame}", program.cloth(scene), *read_obj(program.folder / f"{frame}.obj"), printed,
                program.promised(scene))


def saved(scene, session, program):
    """A scene that was saved in the window, at the moment that was shown there last."""
    said = program.run("view", "--headless", "--script", session)
    frame, stretch = re.search(r"^frame (\d+) .* largest stretch ([-\d.]+) %", said, re.MULTILINE).groups()
    program.run("simulate", f"{scene}-1.toml", "--frames", frame, "--export", "{frame}.obj")
    yield Shape(f"frame {frame}", program.cloth(scene), *read_obj(program.folder / f"{frame}.obj"),
                [Printed.percent("the window", stretch)], program.promised(scene))


def ways_out(source):
    """By name, of the project in the folder SOURCE."""
    sessions = source / "tests" / "golden" / "sessions"
    ways = {
        "export_literal": partial(exported_shirt, 1028, 0.01, 120, LITERAL),
        "export_shaken": partial(exported_shirt, 1028, 0.001, 180, BOUNDED | SHAKEN | {"solver__max_stretch": 0.001}),
        "export_wind": partial(exported_shirt, 5280, 0.05, 90, BOUNDED | WIND | {"solver__max_stretch": 0.05}),
        "figure2": partial(tabled, "fig2"),
        "figure4": partial(tabled, "fig4"),
        "figure5": partial(tabled, "fig5"),
        "remade_picture": partial(remade, "tshirt-wind-10", 20),
        "saved_scene": partial(saved, "cloth-fall", sessions / "save_scene.txt"),
        "saved_shirt": partial(saved, "tshirt-wind-10", sessions / "save_shirt.txt"),
    }
    for percent, bound in BOUNDS.items():
        ways[f"export_tshirt_{percent}"] = partial(exported_scene, "tshirt-gravity", bound, 30)
        ways[f"export_grid_{percent}"] = partial(exported_scene, "pinned-9x9-5", bound, 120)
        ways[f"export_model_{percent}"] = partial(exported_model, bound, 60)
    return ways
