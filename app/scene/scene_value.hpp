#pragma once

#include <toml++/toml.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
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

/// The line of its file that the value stands in; 0: in no file.
int line_of(const toml::node& value);

/// The table in a TOML text; `name` is for messages. Throws InputError naming it, the line and the reason.
toml::table read_toml_text(const std::string& text, const std::string& name);

/// The key `value` with what stands behind `key=` on the command line: a TOML value, or else plain text, so
/// that a shell user need not quote twice.
toml::table read_toml_value(const std::string& text);

/// A text as it stands there; a date is one too. Nothing of other values.
std::optional<std::string> text_in(const toml::node& value);

/// The entries in the order of their lines: a message should speak of the first mistake in the file, and
/// toml++ sorts by name. Valid as long as the table.
std::vector<std::pair<std::string, const toml::node*>> entries_of(const toml::table& table);

/// For messages: numbers with six digits, texts between quotes, tables in braces, "not set" for null.
std::string to_text(const Json& value);
std::string to_text(const toml::node& value);

/// As TOML that reads back bit for bit, on one line. ASCII only; bytes that are no UTF-8, which file names
/// can hold, become U+FFFD.
std::string toml_text(const Json& value);

}  // namespace taut::app
