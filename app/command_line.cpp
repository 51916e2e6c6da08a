#include "app/command_line.hpp"

#include <toml++/toml.h>

#include <CLI/CLI.hpp>

#include "app/base/errors.hpp"
#include "app/bodies/fit.hpp"
#include "app/caches/frame_sink.hpp"
#include "app/commands/options.hpp"
#include "app/output/run_report.hpp"

namespace taut::app {

extern const char* const help_texts;  ///< assets/texts/help.toml

namespace {

constexpr int largest_side_px = 16384;

struct NamedSize {
  const char* name;
  renderer::Resized size;
};
constexpr std::array<NamedSize, 6> named_sizes = {{{"720p", {1280, 720}},
                                                   {"1080p", {1920, 1080}},
                                                   {"HD", {1920, 1080}},
                                                   {"1440p", {2560, 1440}},
                                                   {"4K", {3840, 2160}},
                                                   {"8K", {7680, 4320}}}};

template <class Names> std::string names_of(const Names& entries) {
  std::vector<std::string> names;
  for (const auto& entry : entries) names.emplace_back(entry.name);
  return joined(names, ", ");
}

// The entry with this name, in small or capital letters; null: none.
template <class Names> auto find_named(const Names& entries, std::string_view text) {
  const auto found = std::ranges::find_if(
      entries, [&](const auto& entry) { return lower_case(entry.name) == lower_case(std::string(text)); });
  return found == entries.end() ? nullptr : &*found;
}

// Where the air goes that comes from this side. Angles go around as those of the camera do.
std::string direction_from(double angle_deg) {
  const double angle_rad = angle_deg * std::numbers::pi / 180.0;
  const auto rounded = [](double component) { return std::round(component * 1e9) / 1e9 + 0.0; };
  return fmt::format("[{}, 0.0, {}]", rounded(-std::sin(angle_rad)), rounded(-std::cos(angle_rad)));
}

/// The text below the options of a command, of assets/texts/help.toml.
std::string footer_of(const std::string& command) {
  static const toml::table footers = toml::parse(help_texts);
  return footers[command].value<std::string>().value();
}

/// Values of `--resolution` and `--size`, for --help.
constexpr const char* size_help = "WIDTHxHEIGHT in pixels, or 720p, 1080p, 1440p, 4K, 8K (default 1280x720)";

/// Reads a size in pixels: "1280x720", "1280,720", or a name such as "1080p" or "4K". Throws UsageError with the
/// option's name in front.
renderer::Resized parse_size(const std::string& text, const std::string& option) {
  if (const NamedSize* named = find_named(named_sizes, text)) return named->size;
  const std::size_t between = text.find_first_of(",xX");
  const bool is_pair = between != std::string::npos;
  const auto width = number_in<int>(std::string_view(text).substr(0, between));
  const auto height = is_pair ? number_in<int>(std::string_view(text).substr(between + 1)) : std::nullopt;
  const auto is_side = [](std::optional<int> side) { return side && *side >= 1 && *side <= largest_side_px; };
  if (!is_side(width) || !is_side(height)) {
    throw UsageError("{} {}: expected WIDTHxHEIGHT in pixels, such as 1280x720, or a name: {}", option, text,
                     names_of(named_sizes));
  }
  return {*width, *height};
}

// Options that stand for keys of the scene, written as a person would say them. Each call adds one to the command;
// `overrides` must live as long as it does.

/// `--resolution SIZE`, as parse_size reads it.
void add_resolution(CLI::App& command, std::vector<Override>& overrides) {
  const auto set = [&overrides](const std::string& text) {
    const renderer::Resized size = parse_size(text, "--resolution");
    overrides.push_back({"picture.width", std::to_string(size.width_px), "--resolution " + text});
    overrides.push_back({"picture.height", std::to_string(size.height_px), "--resolution " + text});
  };
  command.add_option_function<std::string>("--resolution", set, size_help);
}

/// `--view NAME`: from where.
void add_side(CLI::App& command, std::vector<Override>& overrides) {
  const auto set = [&overrides](const std::string& text) {
    const Side* const side = find_named(sides, text);
    if (side == nullptr) throw UsageError("--view " + text + ": expected one of " + names_of(sides));
    for (const char* key : {"camera.box", "camera.eye", "camera.target"}) {
      overrides.push_back({key, "auto", "--view " + text});
    }
    overrides.push_back({"camera.azimuth", fmt::format("{}", side->azimuth_deg), "--view " + text});
    overrides.push_back({"camera.elevation", fmt::format("{}", side->elevation_deg), "--view " + text});
  };
  command.add_option_function<std::string>("--view", set,
                                           "from where, the garment filling the picture: " + names_of(sides));
}

/// `--wind SPEED[@ANGLE]`.
void add_wind(CLI::App& command, std::vector<Override>& overrides) {
  const auto set = [&overrides](const std::string& text) {
    const std::string option = "--wind " + text;
    const std::size_t at = text.find('@');
    const auto angle_deg =
        at == std::string::npos ? std::nullopt : number_in<double>(std::string_view(text).substr(at + 1));
    if (!number_in<double>(text.substr(0, at)) || (at != std::string::npos && !angle_deg)) {
      throw UsageError(option + ": expected SPEED or SPEED@ANGLE, in m/s and degrees, such as 4@90");
    }
    overrides.push_back({"wind.speed", text.substr(0, at), option});
    if (angle_deg) overrides.push_back({"wind.direction", direction_from(*angle_deg), option});
  };
  command.add_option_function<std::string>(
      "--wind", set,
      "SPEED in m/s, or SPEED@ANGLE: from where it blows, in degrees, 0 from the front, 90 from +x, 180 from "
      "behind");
}

using Options = std::shared_ptr<SweepOptions>;

CLI::App* add(CLI::App& sweep, const Options& options, SweepAction action, const std::string& name,
              const std::string& meaning) {
  CLI::App* command = sweep.add_subcommand(name, meaning);
  command->callback([options, action] { options->action = action; });
  if (action != SweepAction::plan) {
    command->add_option("DIR", options->folder, "folder that taut sweep plan made")->required();
  }
  return command;
}

void add_index(CLI::App& command, const Options& options, const std::string& meaning) {
  command.add_option("--index", options->index, meaning)->check(CLI::NonNegativeNumber);
}

void add_plan(CLI::App& sweep, const Options& options) {
  CLI::App* command =
      add(sweep, options, SweepAction::plan, "plan", "Check a study and make the folder in which its runs are made");
  command->add_option("STUDY", options->study, "a TOML file: scene, frames, pictures, and [axes]")->required();
  command->add_option("--output,-o", options->folder, "folder of the sweep")->required();
  command->footer(footer_of("sweep plan"));
}

void add_run(CLI::App& sweep, const Options& options) {
  CLI::App* command = add(sweep, options, SweepAction::run, "run", "Make runs that are not done yet");
  add_index(*command, options, "one run, from 0");
  CLI::Option* all = command->add_flag("--all", options->all, "all runs");
  command->add_option("--jobs", options->jobs, "with --all: so many at a time (default: the processors)")
      ->needs(all)
      ->check(CLI::Range(1, 1024));
  command->footer(footer_of("sweep run"));
}

void add_merge(CLI::App& sweep, const Options& options) {
  CLI::App* command = add(sweep, options, SweepAction::merge, "merge",
                          "Write the table of all results and the sheet of their pictures");
  command->footer(footer_of("sweep merge"));
}

void add_rest(CLI::App& sweep, const Options& options) {
  CLI::App* status = add(sweep, options, SweepAction::status, "status", "Say how many runs are done");
  status->add_flag("--missing", options->missing, "print which are not, as ranges such as sbatch --array takes");
  status->footer(footer_of("sweep status"));

  CLI::App* show = add(sweep, options, SweepAction::show, "show", "Print the scene of a run");
  add_index(*show, options, "the run, from 0");
  show->get_option("--index")->required();
  show->footer(footer_of("sweep show"));
}

/// Call the result after the arguments were parsed, as of all that add a command.
std::function<int()> add_sweep(CLI::App& app) {
  auto options = std::make_shared<SweepOptions>();
  CLI::App* sweep = app.add_subcommand("sweep", "Simulate a scene with every combination of some values");
  sweep->require_subcommand(1);
  add_plan(*sweep, options);
  add_run(*sweep, options);
  add_rest(*sweep, options);
  add_merge(*sweep, options);
  sweep->footer(footer_of("sweep"));
  return [options] { return run(*options); };
}

constexpr const char* scene_help_text = "a scene file (TOML), a built-in scene (see taut scenes), or a garment file";

std::string unit_symbols() {
  std::string text;
  for (const Unit& unit : units) text += std::string(text.empty() ? "" : ", ") + unit.symbol;
  return text;
}

/// The value of a key that is the unit of a model, in m: that of a symbol, or else the text itself.
std::string unit_value(const std::string& text) {
  const auto* const unit = std::ranges::find(units, text, &Unit::symbol);
  return unit != units.end() ? std::to_string(unit->metres) : text;
}

/// An option that stands for a key of the scene.
struct KeyOption {
  const char* option;
  const char* key;
  const char* meaning;
  const char* value = nullptr;  ///< of an option without one
};

constexpr KeyOption untangle_option = {
    "--untangle", "garment.untangle",
    "where the garment crosses itself at the start, move it apart first, such as a thick one whose walls "
    "pierce each other; it keeps its rest shape",
    "true"};
constexpr KeyOption fabric_option = {"--fabric", "cloth.fabric",
                                     "what the garment is made of: a name of taut fabrics, or a file like "
                                     "theirs; sets weight, stiffness and look"};
constexpr KeyOption texture_option = {
    "--texture", "picture.texture",
    "an image to lay on the garment's texture coordinates, such as a print, or none for a model's own too"};

// They take effect in the order in which they are added here.
void add_keys(CLI::App& command, std::vector<Override>& overrides, std::initializer_list<KeyOption> options) {
  for (const KeyOption& o : options) {
    if (o.value != nullptr) {
      command.add_flag_callback(
          o.option,
          [&overrides, o] {
            overrides.push_back({o.key, o.value, o.option});
          },
          o.meaning);
      continue;
    }
    const bool is_unit = std::string_view(o.key).ends_with(".scale");
    const auto set = [&overrides, o, is_unit](const std::string& text) {
      overrides.push_back({o.key, is_unit ? unit_value(text) : text, o.option + (' ' + text)});
    };
    command.add_option_function<std::string>(o.option, set, o.meaning);
  }
}

/// To be added last: it is stronger than options that stand for keys.
void add_set(CLI::App& command, std::vector<Override>& overrides) {
  const std::string meaning = "KEY=VALUE, any key of the scene; can be repeated (taut help scene)";
  const auto set = [&overrides](const std::vector<std::string>& texts) {
    std::ranges::transform(texts, std::back_inserter(overrides), parse_override);
  };
  command.add_option_function<std::vector<std::string>>("--set", set, meaning)->allow_extra_args(false);
}

void add_body(CLI::App& command, std::vector<Override>& overrides) {
  add_keys(
      command, overrides,
      {{"--body", "body.file",
        "a closed 3D model that cloth cannot enter, besides the scene's bodies; glTF, FBX and Collada "
        "may bring joints and animations"},
       {"--body-motion", "body.motion", "how the body moves: a PC2, MDD or BVH file"},
       {"--body-clip", "body.clip", "which of its animations is played, or all at once, or none (default: the first)"},
       {"--body-fps", "body.frame_rate", "frames a second of its motion (default: what the file says, or else 60)"},
       {"--body-loop", "body.loop", "repeat its motion after its last frame (default: it stays there)", "true"},
       {"--body-units", "body.scale", "of the body, as --units"},
       {"--dress", "body.dress",
        "simulate so many frames before frame 0, in which the body grows from its bones to its shape, "
        "into what it wears (default: 90 of a body that is given together with a garment, where it "
        "can); a garment that lies elsewhere is moved to it first"},
       {"--body-up", "body.up", "the body's direction that is up, as --up"}});
}

void add_garment_arguments(CLI::App& command, std::vector<Override>& overrides) {
  const std::string units_help =
      "of the model: " + unit_symbols() + ", or its unit in metres (default: what the file says, or a guess)";
  add_keys(command, overrides,
           {{"--units", "garment.scale", units_help.c_str()},
            {"--up", "garment.up", "the model's direction that is up: x, -x, y, -y, z or -z"},
            fabric_option,
            untangle_option});
  add_body(command, overrides);
}

// Options of render and simulate.
template <class Options> void add_scene_arguments(CLI::App& command, Options& options, const std::string& scenes) {
  command.add_option("SCENE", options.scene, scenes)->required();
  add_garment_arguments(command, options.overrides);
  add_wind(command, options.overrides);
  command.add_option("--stats", options.statistics,
                     "write measurements of every frame to this file, .jsonl or .csv, as they come (taut help stats)");
  command.add_flag("--verify", options.verify,
                   "check every frame, the start included, by a way of its own: no triangle crosses another "
                   "or a body, but for what does so since the start until it is apart, and nothing is longer "
                   "than the bound; else end with exit code 3");
}

void add_backend(CLI::App& command, std::string& backend) {
  std::vector<std::string> names = renderer::context_names();
  names.insert(names.begin(), "auto");
  command.add_option("--backend", backend, "how to get OpenGL: " + joined(names, " or "))
      ->check(CLI::IsMember(names))
      ->capture_default_str();
}

/// Figures that judge the program come with the report, from the build.
std::string drawn_elsewhere(const std::string& figure) {
  if (figure != "fig8" && figure != "truth") return {};
  return figure + " is drawn by build/release/tests/claims/judge_claims --only " + figure;
}

std::function<int()> add_figures(CLI::App& app) {
  auto options = std::make_shared<FiguresOptions>();
  CLI::App* command = app.add_subcommand("figures", "Draw the figures of the paper");
  command->add_option("--only", options->only, "some of them: " + joined(figure_names(), ","))
      ->delimiter(',')
      ->check(CLI::Validator(drawn_elsewhere, "", ""))
      ->check(CLI::IsMember(figure_names()));
  command->add_option("-o,--output", options->output, "folder for the pictures")->capture_default_str();
  command->add_option("--data", options->data,
                      "folder with the tables (CSV) of an earlier run: draw from those instead of simulating "
                      "and measuring anew");
  command->add_option("--scale", options->scale, "pictures this many times as wide and high, 0.1 to 4")
      ->check(CLI::Range(0.1, 4.0))
      ->capture_default_str();
  add_backend(*command, options->backend);
  command->footer(footer_of("figures"));
  return [options] { return run(*options); };
}

std::function<int()> add_render(CLI::App& app, std::span<const char* const> arguments) {
  auto options = std::make_shared<RenderOptions>();
  options->arguments.assign(arguments.begin() + 1, arguments.end());
  CLI::App* command = app.add_subcommand("render", "Simulate a scene and draw pictures of it");
  add_scene_arguments(*command, *options,
                      std::string(scene_help_text) + ", or a picture of taut render, to make it again");
  command->add_option("-o,--output", options->output,
                      "file, or pattern such as frames/frame_{frame:04}.png, or a video, .mp4 (default SCENE.png)");
  command->add_option("--frames", options->frames,
                      std::string("frames to draw: ") + frame_range_help + " (default: last; of a video 0:)");
  command->add_option("--export", options->shapes, export_help);
  add_resolution(*command, options->overrides);
  add_side(*command, options->overrides);
  add_keys(
      *command, options->overrides,
      {{"--background", "picture.background",
        "what is behind: studio (default), none (transparent, with the shadow), or a colour such as "
        "white or #rrggbb"},
       {"--wireframe", "picture.wireframe", "draw the springs over the surface", "true"},
       {"--stretch", "picture.surface", "colour the surface by its stretch", "stretch"},
       texture_option,
       {"--quality", "picture.quality", "draft, normal or high, which is for print (default normal)"},
       {"--samples", "picture.samples", "samples in a pixel, 1 to 16 (default 4)"},
       {"--supersampling", "picture.supersampling", "draw N times as wide and high and average, 1 to 8 (default 1)"}});
  add_set(*command, options->overrides);
  add_backend(*command, options->backend);
  command->footer(footer_of("render"));
  return [options] { return run(*options); };
}

std::function<int()> add_simulate(CLI::App& app) {
  auto options = std::make_shared<SimulateOptions>();
  CLI::App* command = app.add_subcommand("simulate", "Simulate a scene without drawing and print measurements");
  add_scene_arguments(*command, *options, scene_help_text);
  add_set(*command, options->overrides);
  command->add_option("--frames", options->frames,
                      std::string("frames to print and to export, simulated up to the last of them: ") +
                          frame_range_help + " (default: 1:)");
  command->add_option("--export", options->shapes, export_help);
  command->add_flag("--quiet", options->quiet, "print nothing but warnings and errors");
  command->add_flag("--json", options->json,
                    "print what --stats writes as JSON lines, and nothing else; remarks go to standard error");
  command->add_option("--checkpoint", options->checkpoint,
                      "save the run to this file now and then, at its end, and when it is interrupted "
                      "(SIGTERM, SIGINT), which ends it with exit code 75");
  command->add_option("--checkpoint-every", options->checkpoint_every, "save it after so many frames")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  command->add_option("--resume", options->resume,
                      "go on from such a file with the same bits, and save to it where --checkpoint names no "
                      "other; --stats and --export go on where they stopped");
  command->footer(footer_of("simulate"));
  return [options] { return run(*options); };
}

void add_compare(CLI::App& command, std::optional<sim::SolverKind>& compared_with) {
  std::vector<std::string> names;
  for (const sim::SolverKind kind : sim::all_solver_kinds) names.emplace_back(sim::name_of(kind));
  const auto set = [&compared_with, known = joined(names, ", ")](const std::string& text) {
    compared_with = solver_named(text);
    if (!compared_with) throw UsageError("--compare " + text + ": expected one of " + known);
  };
  command.add_option_function<std::string>("--compare", set,
                                           "show the garment a second time, by this solver: " + joined(names, ", "));
}

std::function<int()> add_view(CLI::App& app) {
  auto options = std::make_shared<ViewOptions>();
  CLI::App* command = app.add_subcommand("view", "Open a window: blow at the cloth, pull it, watch its stretch");
  command->add_option("SCENE", options->scene, scene_help_text);
  add_garment_arguments(*command, options->overrides);
  add_wind(*command, options->overrides);
  add_side(*command, options->overrides);
  add_keys(*command, options->overrides, {texture_option});
  add_set(*command, options->overrides);
  command->add_option_function<std::string>(
      "--size", [options](const std::string& text) { options->size = parse_size(text, "--size"); },
      std::string("of the window: ") + size_help);
  add_compare(*command, options->compared_with);
  command->add_option("--keep", options->keep_folder, "folder for screenshots, videos and saved scenes")
      ->capture_default_str();
  command->add_option("--record", options->record, "write all input to this file, for --script");
  command->add_flag("--headless", options->headless, "no window: play a script and end");
  command->add_option("--script", options->script, "input to play: recorded, or written by hand");
  command->add_option("--screenshot", options->screenshot, "a picture of the window after the script");
  command->add_option("--layout", options->layout, "where the panel's parts are after the script, as text");
  add_backend(*command, options->backend);
  command->footer(footer_of("view"));
  return [options] { return run(*options); };
}

std::function<int()> add_inspect(CLI::App& app) {
  auto options = std::make_shared<InspectOptions>();
  CLI::App* command = app.add_subcommand("inspect", "Say what is in a 3D model and how it maps to springs");
  command->add_option("GARMENT", options->garment,
                      "a 3D model: OBJ, PLY, STL, glTF, FBX, Collada, 3MF, ..., or a built-in scene, for its "
                      "garment; without one, the body is inspected");
  add_garment_arguments(*command, options->overrides);
  add_set(*command, options->overrides);
  command->add_flag("--json", options->json, "for programs");
  command->add_option("-o,--output,--picture", options->picture,
                      "PNG file: the garment with its springs by kind, what holds it, its borders and defects");
  add_backend(*command, options->backend);
  command->footer(footer_of("inspect"));
  return [options] { return run(*options); };
}

std::function<int()> add_fit(CLI::App& app) {
  auto options = std::make_shared<FitOptions>();
  CLI::App* command = app.add_subcommand("fit", "Put a garment on a body, and say and draw how it fits");
  command->add_option("GARMENT", options->scene, "a garment file, or a scene in which a body is dressed")->required();
  add_garment_arguments(*command, options->overrides);
  add_set(*command, options->overrides);
  command->add_option("-o,--output", options->output,
                      "PNG file: front and back, coloured by stretch, and a table (default GARMENT-fit.png)");
  command->add_option("--frames", options->frames, "at most so many frames after it was put on")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  command->add_flag("--json", options->json, "for programs");
  add_backend(*command, options->backend);
  std::string footer = footer_of("fit");
  const std::string thresholds = "{thresholds}";
  footer.replace(footer.find(thresholds), thresholds.size(), fit_thresholds());
  command->footer(footer);
  return [options] { return run(*options); };
}

std::function<int()> add_sew(CLI::App& app) {
  auto options = std::make_shared<SewOptions>();
  CLI::App* command = app.add_subcommand("sew", "Sew a pattern on a body, to a garment that is worn");
  command->add_option("PATTERN", options->pattern, "a sewing pattern in the JSON of GarmentCode")->required();
  command->add_option("--over", options->over, "a pattern that is worn over it; can be repeated")
      ->allow_extra_args(false);
  command
      ->add_option("--over-fabric", options->over_fabrics,
                   "what that is made of; as often as --over, in the same order (default: the same fabric)")
      ->allow_extra_args(false);
  add_keys(*command, options->overrides, {fabric_option});
  add_body(*command, options->overrides);
  add_set(*command, options->overrides);
  command->add_option("-o,--output", options->output, "OBJ file of the garment (default PATTERN.obj, here)");
  command->add_option("--picture", options->picture, "PNG file: it worn, from the front and from behind");
  command->add_option("--steps", options->steps, "PNG file: its pattern, placed, half closed and worn, side by side");
  command->add_option("--triangles", options->triangles, "about so many")
      ->check(CLI::Range(100, 200000))
      ->capture_default_str();
  command->add_flag("--exact", options->is_exact, "exactly so many triangles")->excludes("--over");
  command->add_option("--frames", options->frames, "at most so many frames until it rests")
      ->check(CLI::Range(0, 100000))
      ->capture_default_str();
  command->add_flag("--json", options->json, "for programs");
  add_backend(*command, options->backend);
  command->footer(footer_of("sew"));
  return [options] { return run(*options); };
}

std::function<int()> add_import_model(CLI::App& app) {
  auto options = std::make_shared<ImportModelOptions>();
  CLI::App* command = app.add_subcommand("import-model", "Read a model for the program that started this one");
  command->group("");  // not shown: nothing a person could read comes out
  command->add_option("MODEL", options->model)->required();
  command->add_option("--memory", options->limits.memory_mib)->check(CLI::Range(64, 1 << 20));
  command->add_option("--seconds", options->limits.seconds)->check(CLI::Range(1, 86400));
  command->add_option("--parts", options->parts)->check(CLI::Range(0, static_cast<int>(ReadParts::image)));
  return [options] { return run(*options); };
}

std::function<int()> add_scenes(CLI::App& app) {
  auto scene = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("scenes", "List the built-in scenes");
  command->add_option("SCENE", *scene, "print this scene's file, with every key");
  command->footer(footer_of("scenes"));
  return [scene] { return list_scenes(*scene); };
}

std::function<int()> add_fabrics(CLI::App& app) {
  auto fabric = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("fabrics", "List the fabrics that --fabric names");
  command->add_option("FABRIC", *fabric, "print this fabric's file");
  command->footer(footer_of("fabrics"));
  return [fabric] { return list_fabrics(*fabric); };
}

std::function<int()> add_bench(CLI::App& app) {
  auto options = std::make_shared<BenchOptions>();
  CLI::App* command =
      app.add_subcommand("bench", "Measure the time of a frame, its stretch, and whether any frame breaks a promise");
  command->add_flag("--contact", options->contact, "all scenes about contact and being worn: takes an hour");
  command->add_flag("--quick", options->quick,
                    "a shirt that hangs, in winds, in one that is dragged up and back, and on someone who walks, on "
                    "one thread: three minutes at most (default)");
  command->add_option("--scenes", options->scenes, "some of the rows alone")->delimiter(',');
  command
      ->add_option("--bounds", options->bounds,
                   "largest stretches to be kept, such as 0.05,0.01: a row for each (default: as the scene has it)")
      ->delimiter(',')
      ->check(CLI::Range(1e-5, 1.0));
  command
      ->add_option("--runs", options->runs,
                   "so many runs of each scene, each with its start moved at random by a twentieth of the "
                   "cloth's thickness (default: one run of the scene as it is)")
      ->check(CLI::Range(1, 1000));
  command->add_option("--frames", options->frames, "frames of each run (default: as the scene has it)")
      ->check(CLI::Range(1, 1000000));
  command->add_flag("--csv", options->csv, "print a table (CSV) of all runs instead");
  command->add_flag("--quiet", options->quiet, "print neither progress nor the table");
  command->footer(footer_of("bench"));
  return [options] { return run(*options); };
}

// Without those that belong to no group, which are not shown.
std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App* c) { return !c->get_group().empty(); })) {
    names.push_back(command->get_name());
  }
  return names;
}

std::string help_about(CLI::App& app, const std::string& topic) {
  // Else it would be the help of the command that was asked for, which is help.
  app.clear();
  if (topic.empty()) return app.help();
  if (topic == "scene") return scene_help();
  if (topic == "stats") return statistics_help();
  std::vector<std::string> topics = command_names(app);
  if (std::ranges::find(topics, topic) == topics.end()) {
    topics.insert(topics.end(), {"scene", "stats"});
    throw UsageError("there is no help about '" + topic + '\'' + did_you_mean(topic, topics) +
                     " (topics: " + joined(topics) + ')');
  }
  return app.get_subcommand(topic)->help(app.get_name());
}

std::function<int()> add_help(CLI::App& app) {
  auto topic = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand("help", "Explain a command, the keys of scene files or the statistics");
  command->add_option("TOPIC", *topic, "a command, scene or stats (default: what commands there are)");
  command->footer(footer_of("help"));
  return [&app, topic] {
    fmt::print("{}", help_about(app, *topic));
    return 0;
  };
}

/// Throws UsageError, with a list of the commands, if the arguments begin neither with a command nor with an
/// option.
void require_command(const CLI::App& app, std::span<const char* const> arguments) {
  const std::string first = arguments.size() > 1 ? arguments[1] : "";
  const std::vector<std::string> names = command_names(app);
  const auto is_asked_for = [&](const CLI::App* command) { return command->get_name() == first; };
  if (first.starts_with('-') || !app.get_subcommands(is_asked_for).empty()) return;
  throw UsageError((first.empty() ? "expected a command" : "there is no command '" + first + '\'') +
                   did_you_mean(first, names) + " (commands: " + joined(names) + "; taut help says more)");
}

std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

/// For a command line that cannot be understood.
std::string what_is_wrong(const CLI::App& app, const CLI::ParseError& error, std::span<const char* const> arguments) {
  const CLI::App* command = &app;
  std::string help = "taut";
  while (!command->get_subcommands().empty()) {
    command = command->get_subcommands().front();
    help += ' ' + command->get_name();
  }
  help += " --help";
  // A misspelt option comes before what is missing, which may be all that it stands for.
  const std::vector<std::string> unknown = app.remaining(true);
  const bool is_value = dynamic_cast<const CLI::RequiredError*>(&error) == nullptr &&
                        dynamic_cast<const CLI::ExtrasError*>(&error) == nullptr;
  if (is_value || unknown.empty()) return std::string(error.what()) + "; see " + help;
  const std::vector<std::string> options = option_names(*command);
  // In the order of the command line; the first option is wrong, or else what follows it.
  const auto is_unknown = [&](const char* argument) { return std::ranges::find(unknown, argument) != unknown.end(); };
  const auto is_option = [&](const char* argument) { return *argument == '-' && is_unknown(argument); };
  auto wrong = std::find_if(arguments.begin() + 1, arguments.end(), is_option);
  wrong = wrong != arguments.end() ? wrong : std::find_if(arguments.begin() + 1, arguments.end(), is_unknown);
  const std::string name = wrong != arguments.end() ? *wrong : unknown.back();
  const std::string option = name.substr(0, name.find('='));
  std::vector<std::string> others;
  for (const CLI::App* other : app.get_subcommands([](const CLI::App* c) { return !c->get_group().empty(); })) {
    const std::vector<std::string> theirs = option_names(*other);
    if (std::ranges::find(theirs, option) != theirs.end()) others.push_back("taut " + other->get_name());
  }
  const std::string meant = did_you_mean(option, options);
  return "not expected: " + name + (meant.empty() && !others.empty() ? ", an option of " + joined(others) : meant) +
         "; see " + help;
}

// At once where it is asked for, before values are read: what is wrong with them may be why help is needed.
void show_help_first(CLI::App& app) {
  const auto show = [](const std::string&) { throw CLI::CallForHelp(); };
  for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    command->get_help_ptr()->each(show)->trigger_on_parse();
    show_help_first(*command);
  }
}

}  // namespace

int run_command_line(std::span<const char* const> arguments) {
  CLI::App app("Taut simulates garments that do not over-stretch and draws them.", "taut");
  app.set_version_flag("--version", "taut " + program_version());
  app.require_subcommand(1);
  app.footer(footer_of("taut"));
  const std::vector<std::function<int()>> commands = {add_figures(app),  add_render(app, arguments),
                                                      add_simulate(app), add_view(app),
                                                      add_inspect(app),  add_fit(app),
                                                      add_sew(app),      add_bench(app),
                                                      add_scenes(app),   add_fabrics(app),
                                                      add_sweep(app),    add_import_model(app),
                                                      add_help(app)};
  show_help_first(app);
  require_command(app, arguments);
  try {
    app.parse(static_cast<int>(arguments.size()), arguments.data());
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    throw UsageError(what_is_wrong(app, error, arguments));
  }
  const std::vector<CLI::App*> all = app.get_subcommands([](const CLI::App*) { return true; });
  const auto asked = std::ranges::find_if(all, [](const CLI::App* command) { return command->parsed(); });
  return asked != all.end() ? commands[static_cast<std::size_t>(asked - all.begin())]() : 0;
}

}  // namespace taut::app
