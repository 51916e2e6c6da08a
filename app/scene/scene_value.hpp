#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace taut::app {

/// A value to be written. Keys stay in the order in which they were inserted; null means not set.
using Json = nlohmann::ordered_json;

/// Where a value comes from, for messages.
struct Source {
  std::string name;  ///< a file, or an option with its argument
  bool is_command_line = false;
};

/// Throws `message` with the source and the line in front: UsageError for the command line, InputError for a
/// file. 0: no line.
[[noreturn]] void fail(const Source& source, int line, const std::string& message);

/// Line of the value in its file; 0: not from a file.
int line_of(const toml::node& value);

/// Parses a TOML text. `name` is for messages. Throws InputError with the name, the line and the reason.
toml::table read_toml_text(const std::string& text, const std::string& name);

/// Parses the argument after `key=` on the command line. Returns a table with the one key `value`. What is
/// not TOML becomes a text, so that a shell user need not quote twice.
toml::table read_toml_value(const std::string& text);

/// The text that a value holds; a date counts as text. Empty for anything else.
std::optional<std::string> text_in(const toml::node& value);

/// The entries of a table, in the order of their lines. toml++ sorts them by name, but a message should name
/// the first mistake of the file. Valid as long as the table.
std::vector<std::pair<std::string, const toml::node*>> entries_of(const toml::table& table);

/// The path of a file that a scene names: relative to the scene file, or where the command line runs; if
/// there is none, that of a garment, a body or a motion that comes with the program (find_asset).
std::filesystem::path beside(const Source& source, const std::filesystem::path& file);

/// The place of a key with its sections, such as "solver.substeps", in a nested value.
Json::json_pointer pointer_to(std::string key);

/// The value as it is written; a date becomes text.
Json json_of(const toml::node& value);

/// The value for messages: numbers with six digits, texts in quotes, tables in braces, "not set" for null.
std::string to_text(const Json& value);
std::string to_text(const toml::node& value);

/// The value as TOML, on one line. Reading it gives the same bits. ASCII only. File names can hold bytes that
/// are not UTF-8; these become U+FFFD.
std::string toml_text(const Json& value);

}  // namespace taut::app
