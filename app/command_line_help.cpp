
#include <CLI/CLI.hpp>

#include "app/base/errors.hpp"
#include "app/base/suggest.hpp"
#include "app/command_line_parts.hpp"
#include "app/drawing/drawn_scene.hpp"
#include "app/output/run_report.hpp"

namespace taut::app {
namespace {

// Without those that belong to no group, which are not shown.
std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command :
       app.get_subcommands([](const CLI::App* c) { return !c->get_group().empty(); })) {
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
  if (std::find(topics.begin(), topics.end(), topic) == topics.end()) {
    topics.insert(topics.end(), {"scene", "stats"});
    throw UsageError("there is no help about '" + topic + '\'' + did_you_mean(topic, topics) +
                     " (topics: " + joined(topics) + ')');
  }
  return app.get_subcommand(topic)->help(app.get_name());
}

}  // namespace

std::function<int()> add_help(CLI::App& app) {
  auto topic = std::make_shared<std::string>();
  CLI::App* command =
      app.add_subcommand("help", "Explain a command, the keys of scene files or the statistics");
  command->add_option("TOPIC", *topic, "a command, scene or stats (default: what commands there are)");
  command->footer("Examples:\n  taut help render\n  taut help scene\n  taut help stats\n");
  return [&app, topic] {
    fmt::print("{}", help_about(app, *topic));
    return 0;
  };
}

void require_command(const CLI::App& app, std::span<const char* const> arguments) {
  const std::string first = arguments.size() > 1 ? arguments[1] : "";
  const std::vector<std::string> names = command_names(app);
  const auto is_asked_for = [&](const CLI::App* command) { return command->get_name() == first; };
  if (first.starts_with('-') || !app.get_subcommands(is_asked_for).empty()) return;
  throw UsageError((first.empty() ? "expected a command" : "there is no command '" + first + '\'') +
                   did_you_mean(first, names) + " (commands: " + joined(names) + "; taut help says more)");
}

}  // namespace taut::app
