"""The tuned numbers of `bounded` stand in tuning.hpp, and say what trades against what."""
import pathlib
import re
import sys

# Numbers beside their code: laws, geometry, rounding, what a machine takes at once, reports.
LAWS = {"rest_distance_fraction", "flag_drag", "gravity_m_per_s2", "cylinder_factor", "grid_factor", "rings", "pi"}
GEOMETRY = {"max_cluster_vertices", "max_flatness_error", "max_aspect", "min_squared_sine", "distance_weight", "max_alternations", "max_shortening"}
ROUNDING = {"rounding", "rounding_s", "min_resolved_fraction", "min_resolved_m",
            "min_rest_distance_m", "min_initial_strain", "max_findable_m", "size_margin_factor", "power_iterations",
            "max_updates_per_frame", "min_mobility", "min_radius", "min_divisor",
            "min_doubled_area_m2", "min_air_speed_m_per_s", "unreachable_squared_m2", "grid_numbers", "min_grid_size_m", "max_grid_number"}
MACHINE = {"min_blocks", "min_pairs", "max_block_pairs", "max_polls", "chunks_per_thread", "one_loop", "closed",
           "triangles_worth_threads", "max_default_threads", "min_trial_gap_frames", "max_trial_gap_frames",
           "block_size", "blocks_ahead", "entries_ahead", "rows_sorted_together", "sweep_overhead", "sampled_every",
           "word_bits"}
REPORTS = {"max_short_fraction"}
BESIDE_THEIR_CODE = LAWS | GEOMETRY | ROUNDING | MACHINE | REPORTS

NUMBER = r"(?<![\w.])\d+(?:\.\d+)?(?:e-?\d+)?F?(?![\w.])"
# Fractions that formulas have, and twice pi; anything else is a choice.
OF_FORMULAS = {"0.0", "0.5", "0.25", "1.0", "2.0", "3.0", "4.0", "6.0", "6.283185307179586"}
# Settings and promises are no tuning, and of rounding errors each term is derived.
LEFT_ALONE = {"settings.hpp", "promise.hpp", "promise.cpp", "plane_gap.hpp"}


def stripped(text):
    text = re.sub(r"/\*.*?\*/", "", text, flags=re.S)
    return re.sub(r'"[^"\n]*"', '""', re.sub(r"//[^\n]*", "", text))


def errors_of_header(path):
    lines = path.read_text().splitlines()
    names = []
    for at, line in enumerate(lines):
        found = re.match(r"inline constexpr [\w:]+ (\w+) = (.*);", line)
        if "constexpr" in line and not found:
            yield f"{path}:{at + 1}: found '{line}', expected one number in one line"
        if found:
            names.append(found[1])
            if not re.match(r"///|inline constexpr", lines[at - 1]):
                yield f"{path}:{at + 1}: {found[1]} has no comment that says what trades against what"
            if re.search(r"_(m|mm|frames)$", found[1]):
                yield f"{path}:{at + 1}: {found[1]} is in metres or frames, expected edges, thicknesses or seconds"
    if not names:
        yield f"{path}: found no numbers, expected some"
    folder = path.parent
    used = " ".join(stripped(file.read_text()) for file in sources_of(folder) if file != path)
    for name in names:
        if not re.search(rf"tuning::{name}\b", used):
            yield f"{path}: nothing uses {name}"


def sources_of(folder):
    return sorted(f for f in folder.rglob("*") if f.suffix in (".cpp", ".hpp"))


def errors_of_source(path):
    for at, line in enumerate(stripped(path.read_text()).splitlines()):
        named = re.search(r"constexpr [\w:]+ (\w+) = (.*)", line.replace("~Index{0}", ""))
        if named and re.search(NUMBER, named[2]) and "tuning::" not in line:
            if named[1] not in BESIDE_THEIR_CODE:
                yield f"{path}:{at + 1}: found the number {named[1]}, expected it in tuning.hpp, or named in {__file__}"
        elif not named:
            for number in re.findall(NUMBER, line):
                if "." in number and number.rstrip("F") not in OF_FORMULAS:
                    yield f"{path}:{at + 1}: found {number} without a name, expected it in tuning.hpp"


def main():
    folder = pathlib.Path(sys.argv[1]) / "sim" / "solvers" / "bounded"
    errors = list(errors_of_header(folder / "tuning.hpp"))
    for path in sources_of(folder):
        if path.name not in LEFT_ALONE | {"tuning.hpp"}:
            errors += errors_of_source(path)
    print("\n".join(errors))
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main())
