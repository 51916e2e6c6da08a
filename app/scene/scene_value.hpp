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

/// A value of a scene file, independent of the library that read it. std::monostate means that the key has no
/// value.
struct Value {
  std::variant<std::monostate, bool, std::int64_t, double, std::string, ValueList, ValueTable> data;
  int line = 0;  ///< line in the file; 0: not from a file

  const ValueTable* table() const { return std::get_if<ValueTable>(&data); }
  const ValueList* list() const { return std::get_if<ValueList>(&data); }
  const std::string* text() const { return std::get_if<std::string>(&data); }
};

/// A key and its value. It is not a std::pair, because Clang 14 requires a pair's types to be complete where
/// such vectors are members of a variant.
struct ValueEntry {
  std::string key;
  Value value;
};

/// Where a value comes from, for messages.
struct Source {
  std::string name;  ///< a file, or an option with its argument
  bool is_command_line = false;
};

/// False for std::monostate.
bool is_set(const Value& value);

/// The value as in a scene file. Tables are in braces.
std::string to_text(const Value& value);

/// Throws `message` with the source and the line in front: UsageError for the command line, InputError for a
/// file.
[[noreturn]] void fail(const Source& source, int line, const std::string& message);

}  // namespace taut::app
