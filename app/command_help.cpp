#include "app/command_help.hpp"

#include <unistd.h>

#include "app/base/terminal.hpp"
#include "app/base/words.hpp"

namespace taut::app {
namespace {

/// Groups of options in the order of help.
constexpr std::array groups = {"Garment", "Body", "Picture", "Output", "Run", "Options"};

constexpr std::size_t columns_of_files = 100;
/// Width below which the texts of options begin on lines of their own.
constexpr std::size_t min_columns_for_two = 70;
constexpr std::size_t option_columns = 30;
constexpr std::size_t narrow_option_columns = 4;

constexpr std::size_t max_short_examples = 3;

std::size_t help_columns() { return terminal_columns(STDOUT_FILENO, columns_of_files); }

/// Help of one command: short with the common options, or complete.
class CommandHelp : public CLI::Formatter {
 public:
  std::vector<std::string> common;  ///< names of options; empty: all
  std::string notes;                ///< prose below the options
  std::vector<std::string> examples;

  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override {
    const bool is_within_another = mode == CLI::AppFormatMode::Sub;
    const bool is_short = mode == CLI::AppFormatMode::Normal && !common.empty();
    std::string text = make_description(app) + make_usage(app, is_within_another ? "taut " + app->get_name() : name) +
                       make_positionals(app) + (is_short ? make_common(app) : make_all_groups(app)) +
                       make_subcommands(app, mode);
    if (!notes.empty() && !is_short) text += '\n' + notes + '\n';
    const std::size_t shown = is_short ? std::min(examples.size(), max_short_examples) : examples.size();
    if (shown > 0) text += "\nExamples:\n";
    for (const std::string& example : std::span(examples).first(shown)) text += "  " + example + '\n';
    if (is_short) text += "\nAll options: " + name + " --help-all\n";
    return text;
  }

 private:
  std::string make_common(const CLI::App* app) const {
    const auto is_common = [&](const CLI::Option* option) {
      return std::ranges::find(common, option->get_name()) != common.end();
    };
    return make_group("Options", false, app->get_options(is_common));
  }

  std::string make_all_groups(const CLI::App* app) const {
    std::string text;
    for (const std::string group : groups) {
      const auto is_in_group = [&](const CLI::Option* option) {
        return option->get_group() == group && option->nonpositional();
      };
      const std::vector<const CLI::Option*> options = app->get_options(is_in_group);
      if (!options.empty()) text += make_group(group, false, options);
    }
    return text;
  }
};

/// Replaces a kind in braces, such as "{solvers}", by the list of its names.
std::string fill_in(std::string text, NameLists lists) {
  for (const auto& [kind, names] : lists) {
    const std::size_t at = text.find(kind);
    if (at != std::string::npos) text.replace(at, std::strlen(kind), names);
  }
  return text;
}

std::vector<std::string> read_lines(const toml::table& texts, const std::string& section, const char* key) {
  std::vector<std::string> lines;
  if (const toml::array* const list = texts[section][key].as_array()) {
    for (const toml::node& line : *list) lines.push_back(line.value_or<std::string>(""));
  }
  return lines;
}

/// Returns the name of the list, among those of a table, that holds a text; nothing if none does.
std::optional<std::string> find_list(const toml::table& lists, const std::string& text) {
  for (const auto& [name, list] : lists) {
    for (const toml::node& entry : *list.as_array()) {
      if (entry.value<std::string>() == text) return std::string(name.str());
    }
  }
  return std::nullopt;
}

/// Returns the value of an option as help shows it: its choices or its name, and its default.
std::string value_text(const CLI::Option& option, const std::string& value_name) {
  const std::string type = option.get_type_name();
  const std::size_t choices = type.find('{');
  const std::string text = choices != std::string::npos ? type.substr(choices) : value_name;
  return option.get_default_str().empty() ? text : text + '=' + option.get_default_str();
}

}  // namespace

void add_help(CLI::App& command, const std::string& name, const toml::table& texts, NameLists lists) {
  const auto text_of = [&](const std::string& section, const std::string& key) {
    return texts[section][key].value<std::string>();
  };
  command.description(text_of(name, "about").value_or(""));
  const auto help = std::make_shared<CommandHelp>();
  help->common = read_lines(texts, name, "common");
  help->notes = fill_in(text_of(name, "notes").value_or(""), lists);
  help->examples = read_lines(texts, name, "examples");
  help->column_width(help_columns() < min_columns_for_two ? narrow_option_columns : option_columns);
  command.formatter(help);
  for (CLI::Option* option : command.get_options()) {
    const std::string key = option->get_name();
    const std::optional<std::string> own = text_of(name, key);
    if (const auto text = own ? own : text_of("any", key)) option->description(fill_in(*text, lists));
    const std::optional<std::string> own_value = find_list(*texts["values"].as_table(), name + ' ' + key);
    if (const auto value = own_value ? own_value : find_list(*texts["values"].as_table(), key)) {
      option->type_name(*value)->option_text(value_text(*option, *value));
    }
    if (const auto group = find_list(*texts["groups"].as_table(), key)) option->group(*group);
  }
  for (CLI::App* below : command.get_subcommands([](const CLI::App*) { return true; })) {
    add_help(*below, below->get_name(), texts, lists);
  }
}

void print_help(const std::string& text) { fmt::print("{}", wrap_lines(text, help_columns())); }

}  // namespace taut::app
