#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace taut::app {

struct Value;
struct ValueEntry;
using ValueList = std::vector<Value>;
using ValueTable = std::vector<ValueEntry>;

/// A value of a scene file, whichever library read it. Nothing (std::monostate) is a key without a value.
struct Value {
  std::variant<std::monostate, bool, std::int64_t, double, std::string, ValueList, ValueTable> data;
  int line = 0;  ///< where it stands in its file; 0: nowhere

  const ValueTable* table() const { return std::get_if<ValueTable>(&data); }
  const ValueList* list() const { return std::get_if<ValueList>(&data); }
  const std::string* text() const { return std::get_if<std::string>(&data); }
};

/// Not a std::pair: Clang 14 wants to know all of a pair's members where a variant of such vectors is
/// declared.
struct ValueEntry {
  std::string key;
  Value value;
};

/// Where values come from, for messages.
struct Source {
  std::string name;  ///< a file, or an option with what was written behind it
  bool is_command_line = false;
};

bool is_set(const Value& value);

/// As it would be written in a scene file; tables in braces.
std::string to_text(const Value& value);

/// Throws UsageError for a source on the command line and InputError for a file, in front of the message the
/// file and the line.
[[noreturn]] void fail(const Source& source, int line, const std::string& message);

}  // namespace taut::app
