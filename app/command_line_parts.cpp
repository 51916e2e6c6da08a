#include "app/command_line_parts.hpp"

#include <toml++/toml.h>

#include <CLI/CLI.hpp>

#include "app/base/errors.hpp"

namespace taut::app {
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

}  // namespace

std::string footer_of(const std::string& command) {
  static const toml::table footers = toml::parse(help_texts);
  return footers[command].value<std::string>().value();
}

const char* const size_help = "WIDTHxHEIGHT in pixels, or 720p, 1080p, 1440p, 4K, 8K (default 1280x720)";

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

void add_resolution(CLI::App& command, std::vector<Override>& overrides) {
  const auto set = [&overrides](const std::string& text) {
    const renderer::Resized size = parse_size(text, "--resolution");
    overrides.push_back({"picture.width", std::to_string(size.width_px), "--resolution " + text});
    overrides.push_back({"picture.height", std::to_string(size.height_px), "--resolution " + text});
  };
  command.add_option_function<std::string>("--resolution", set, size_help);
}

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

}  // namespace taut::app
