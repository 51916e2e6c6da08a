#include "app/command_line.hpp"

#include "app/base/errors.hpp"
#include "app/caches/frame_sink.hpp"
#include "app/command_help.hpp"
#include "app/commands/options.hpp"
#include "app/garments/dressing/fit.hpp"
#include "app/output/run_report.hpp"
#include "app/scene_options.hpp"

namespace taut::app {

extern const char* const help_texts;  ///< assets/texts/help.toml

namespace {

// Options of render and simulate.
template <class Options> void add_scene_arguments(CLI::App& command, Options& options) {
  command.add_option("SCENE", options.scene)->required();
  add_garment_arguments(command, options.overrides);
  add_wind(command, options.overrides);
  command.add_option("--stats", options.statistics);
  command.add_flag("--verify", options.verify);
}

std::vector<std::string> backends() {
  std::vector<std::string> names = renderer::context_names();
  names.insert(names.begin(), "auto");
  return names;
}

void add_backend(CLI::App& command, std::string& backend) {
  command.add_option("--backend", backend)->check(CLI::IsMember(backends()))->capture_default_str();
}

void define_figures(CLI::App& command, FiguresOptions& options) {
  command.add_option("--only", options.selected_names)->delimiter(',')->check(CLI::IsMember(figure_names()));
  command.add_option("-o,--output", options.output)->capture_default_str();
  command.add_option("--scale", options.scale)->check(CLI::Range(0.1, 4.0))->capture_default_str();
  add_backend(command, options.backend);
}

void define_render(CLI::App& command, RenderOptions& options) {
  add_scene_arguments(command, options);
  command.add_option("-o,--output", options.output);
  command.add_flag("--trust", options.is_trusted);
  command.add_option("--frames", options.frames);
  command.add_option("--export", options.shapes);
  add_resolution(command, options.overrides);
  add_side(command, options.overrides);
  add_keys(command, options.overrides,
           {{"--background", "picture.background"},
            {"--wireframe", "picture.wireframe", "true"},
            {"--stretch", "picture.surface", "stretch"},
            {"--texture", "picture.texture"},
            {"--quality", "picture.quality"},
            {"--passes", "picture.passes"},
            {"--samples", "picture.samples"},
            {"--supersampling", "picture.supersampling"}});
  add_set(command, options.overrides);
  add_backend(command, options.backend);
}

void define_simulate(CLI::App& command, SimulateOptions& options) {
  add_scene_arguments(command, options);
  add_set(command, options.overrides);
  command.add_option("--frames", options.frames);
  command.add_option("--export", options.shapes);
  command.add_flag("--quiet", options.quiet);
  command.add_flag("--json", options.json);
  command.add_option("--checkpoint", options.checkpoint);
  command.add_option("--checkpoint-every", options.checkpoint_every)
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  command.add_option("--resume", options.resume);
}

std::vector<std::string> solvers() {
  return collect<std::string>(sim::all_solver_kinds, [](sim::SolverKind kind) { return sim::to_name(kind); });
}

void add_compare(CLI::App& command, std::optional<sim::SolverKind>& compared_with) {
  command.add_option_function<std::string>("--compare", [&compared_with](const std::string& text) {
    compared_with = solver_named(text);
    if (!compared_with) throw UsageError("--compare " + text + ": expected one of " + join(solvers()));
  });
}

void define_view(CLI::App& command, ViewOptions& options) {
  command.add_option("SCENE", options.scene);
  add_garment_arguments(command, options.overrides);
  add_wind(command, options.overrides);
  add_side(command, options.overrides);
  add_keys(command, options.overrides, {{"--texture", "picture.texture"}});
  add_set(command, options.overrides);
  command.add_option_function<std::string>(
      "--size", [&options](const std::string& text) { options.size = parse_size(text, "--size"); });
  add_compare(command, options.compared_with);
  command.add_option("--keep", options.keep_folder)->capture_default_str();
  command.add_option("--record", options.record);
  command.add_flag("--headless", options.headless);
  command.add_option("--script", options.script);
  command.add_option("--screenshot", options.screenshot);
  command.add_option("--layout", options.layout);
  add_backend(command, options.backend);
}

void define_inspect(CLI::App& command, InspectOptions& options) {
  command.add_option("GARMENT", options.garment);
  add_garment_arguments(command, options.overrides);
  add_set(command, options.overrides);
  command.add_flag("--json", options.json);
  command.add_option("-o,--output,--picture", options.picture);
  add_backend(command, options.backend);
}

void define_fit(CLI::App& command, FitOptions& options) {
  command.add_option("GARMENT", options.scene)->required();
  add_garment_arguments(command, options.overrides);
  add_set(command, options.overrides);
  command.add_option("-o,--output", options.output);
  command.add_option("--frames", options.frames)->check(CLI::Range(1, 100000))->capture_default_str();
  command.add_flag("--json", options.json);
  add_backend(command, options.backend);
}

void define_sew(CLI::App& command, SewOptions& options) {
  command.add_option("PATTERN", options.pattern)->required();
  command.add_option("--over", options.outer_patterns)->allow_extra_args(false);
  command.add_option("--over-fabric", options.outer_fabrics)->allow_extra_args(false);
  add_keys(command, options.overrides, {{"--fabric", "cloth.fabric"}});
  add_body(command, options.overrides);
  add_set(command, options.overrides);
  command.add_option("-o,--output", options.output);
  command.add_option("--picture", options.picture);
  command.add_option("--steps", options.steps);
  command.add_option("--triangles", options.triangles)->check(CLI::Range(100, 200000))->capture_default_str();
  command.add_flag("--exact", options.is_exact)->excludes("--over");
  command.add_option("--frames", options.frames)->check(CLI::Range(0, 100000))->capture_default_str();
  command.add_flag("--json", options.json);
  add_backend(command, options.backend);
}

void define_import_model(CLI::App& command, ImportModelOptions& options) {
  command.group("");  // hidden: its output is for the program alone
  command.add_option("MODEL", options.model)->required();
  command.add_option("--memory", options.limits.memory_mib)->check(CLI::Range(64, 1 << 20));
  command.add_option("--seconds", options.limits.seconds)->check(CLI::Range(1, 86400));
  command.add_option("--parts", options.parts)->check(CLI::Range(0, static_cast<int>(ReadParts::image)));
}

/// Adds a command and returns a function that runs it with its options.
template <class Options>
std::function<int()> add_command(CLI::App& app, const char* name, void (*define)(CLI::App&, Options&),
                                 const Options& asked = {}) {
  const auto options = std::make_shared<Options>(asked);
  define(*app.add_subcommand(name), *options);
  return [options] { return run(*options); };
}

/// Adds a command that lists the built-in data of one kind, or prints the named entry.
std::function<int()> add_list(CLI::App& app, const char* command, const char* name,
                              const std::function<int(const std::string&)>& list) {
  auto asked = std::make_shared<std::string>();
  app.add_subcommand(command)->add_option(name, *asked);
  return [asked, list] { return list(*asked); };
}

void define_bench(CLI::App& command, BenchOptions& options) {
  command.add_flag("--contact", options.contact);
  command.add_flag("--quick", options.quick);
  command.add_option("--scenes", options.scenes)->delimiter(',');
  command.add_option("--runs", options.runs)->check(CLI::Range(1, 1000));
  command.add_option("--frames", options.frames)->check(CLI::Range(1, 1000000));
  command.add_option("--threads", options.threads)->check(CLI::Range(1, 256));
  command.add_flag("--csv", options.csv);
  command.add_flag("--quiet", options.quiet);
}

// Returns the names of the commands that help shows. Hidden commands belong to no group.
std::vector<std::string> command_names(const CLI::App& app) {
  const auto is_shown = [](const CLI::App* command) { return !command->get_group().empty(); };
  return collect<std::string>(app.get_subcommands(is_shown), &CLI::App::get_name);
}

std::string help_about(CLI::App& app, const std::string& topic) {
  // Forgets the parsed `help` command; its own help would be shown otherwise.
  app.clear();
  if (topic.empty()) return app.help();
  if (topic == "scene") return scene_help();
  if (topic == "stats") return statistics_help();
  std::vector<std::string> topics = command_names(app);
  if (std::ranges::find(topics, topic) == topics.end()) {
    topics.insert(topics.end(), {"scene", "stats"});
    throw UsageError("there is no help about '" + topic + '\'' + did_you_mean(topic, topics) +
                     " (topics: " + join(topics) + ')');
  }
  return app.get_subcommand(topic)->help(app.get_name(), CLI::AppFormatMode::All);
}

/// Throws UsageError, with a list of the commands, unless the first argument is a command or an option.
void require_command(const CLI::App& app, std::span<const char* const> arguments) {
  const std::string first = arguments.size() > 1 ? arguments[1] : "";
  const std::vector<std::string> names = command_names(app);
  const auto is_asked_for = [&](const CLI::App* command) { return command->get_name() == first; };
  if (first.starts_with('-') || !app.get_subcommands(is_asked_for).empty()) return;
  throw UsageError((first.empty() ? "expected a command" : "there is no command '" + first + '\'') +
                   did_you_mean(first, names) + " (commands: " + join(names) + "; taut help says more)");
}

std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

/// Returns the message for a command line that cannot be parsed.
std::string parse_error_text(const CLI::App& app, const CLI::ParseError& error,
                             std::span<const char* const> arguments) {
  const bool has_command = !app.get_subcommands().empty();
  const CLI::App& command = has_command ? *app.get_subcommands().front() : app;
  const std::string help = (has_command ? "taut " + command.get_name() : "taut") + " --help";
  // A misspelt option is reported before a missing one, because the misspelt one may be the missing one.
  const std::vector<std::string> unknown = app.remaining(true);
  const bool is_value = dynamic_cast<const CLI::RequiredError*>(&error) == nullptr &&
                        dynamic_cast<const CLI::ExtrasError*>(&error) == nullptr;
  if (is_value || unknown.empty()) return std::string(error.what()) + "; see " + help;
  const std::vector<std::string> options = option_names(command);
  // Reports the first unknown option of the command line, or else its first unknown argument.
  const auto is_unknown = [&](const char* argument) { return std::ranges::find(unknown, argument) != unknown.end(); };
  const auto is_option = [&](const char* argument) { return *argument == '-' && is_unknown(argument); };
  auto wrong = std::find_if(arguments.begin() + 1, arguments.end(), is_option);
  wrong = wrong != arguments.end() ? wrong : std::find_if(arguments.begin() + 1, arguments.end(), is_unknown);
  const std::string name = wrong != arguments.end() ? *wrong : unknown.back();
  const std::string option = name.substr(0, name.find('='));
  return "not expected: " + name + did_you_mean(option, options) + "; see " + help;
}

/// Returns the names of each kind that help texts have in braces.
std::array<std::pair<const char*, std::string>, 4> name_lists() {
  return {{{"{solvers}", join(solvers())},
           {"{sides}", side_names()},
           {"{units}", join(collect<std::string>(units, &Unit::symbol))},
           {"{thresholds}", fit_thresholds()}}};
}

// Shows help immediately when the user asks for it, before any value is checked: a bad value may be the reason to ask.
void show_help_first(CLI::App& app) {
  for (CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    command->get_help_ptr()->each([](const auto&) { throw CLI::CallForHelp(); })->trigger_on_parse();
    command->get_option("--help-all")->each([](const auto&) { throw CLI::CallForAllHelp(); })->trigger_on_parse();
  }
}

}  // namespace

int run_command_line(std::span<const char* const> arguments) {
  CLI::App app("", "taut");
  app.set_help_flag("-h,--help", "print common options and examples");
  app.set_help_all_flag("--help-all", "print all options");
  app.set_version_flag("-V,--version", "taut " + program_version(), "print the version");
  app.require_subcommand(1);
  RenderOptions rendering;
  rendering.arguments.assign(arguments.begin() + 1, arguments.end());
  const std::vector<std::function<int()>> commands = {add_command(app, "figures", define_figures),
                                                      add_command(app, "render", define_render, rendering),
                                                      add_command(app, "simulate", define_simulate),
                                                      add_command(app, "view", define_view),
                                                      add_command(app, "inspect", define_inspect),
                                                      add_command(app, "fit", define_fit),
                                                      add_command(app, "sew", define_sew),
                                                      add_command(app, "bench", define_bench),
                                                      add_list(app, "scenes", "SCENE", list_scenes),
                                                      add_list(app, "fabrics", "FABRIC", list_fabrics),
                                                      add_command(app, "import-model", define_import_model),
                                                      add_list(app, "help", "TOPIC", [&app](const auto& topic) {
                                                        print_help(help_about(app, topic));
                                                        return 0;
                                                      })};
  add_help(app, "taut", toml::parse(help_texts), name_lists());
  show_help_first(app);
  require_command(app, arguments);
  try {
    app.parse(static_cast<int>(arguments.size()), arguments.data());
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {
      std::ostringstream text;
      app.exit(error, text);
      print_help(text.str());
      return 0;
    }
    throw UsageError(parse_error_text(app, error, arguments));
  }
  const std::vector<CLI::App*> all = app.get_subcommands([](const CLI::App*) { return true; });
  const auto asked = std::ranges::find_if(all, [](const CLI::App* command) { return command->parsed(); });
  return asked != all.end() ? commands[static_cast<std::size_t>(asked - all.begin())]() : 0;
}

}  // namespace taut::app
