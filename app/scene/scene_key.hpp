#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/base/words.hpp"

namespace taut::app {

/// A value to write. Keys keep the order in which they were inserted; null means not set.
using Json = nlohmann::ordered_json;

/// Source of a value, for messages.
struct Source {
  std::string name;  ///< file, or option with its argument
  bool is_command_line = false;
};

/// Throws `message` after the source and the line (0: none): UsageError for the command line, InputError for a file.
[[noreturn]] void fail(const Source& source, int line, const std::string& message);

/// Returns the line of the value in its file; 0: not from a file.
int line_number(const toml::node& value);

/// Parses a TOML text. `name` is used in messages. Throws InputError with the name, the line and the reason.
toml::table read_toml_text(const std::string& text, const std::string& name);

/// Parses the value of KEY=VALUE on the command line. Returns a table with the one key `value`. A value that is not
/// TOML becomes a text, so that a shell user need not quote twice.
toml::table read_toml_value(const std::string& text);

/// Returns the text of a value; a date counts as text. Empty for other values.
std::optional<std::string> text_in(const toml::node& value);

/// Returns the entries of a table in the order of their lines, so that a message names the first mistake of the file;
/// toml++ sorts them by name. Valid as long as the table.
std::vector<std::pair<std::string, const toml::node*>> list_entries(const toml::table& table);

/// Returns the path of a file that a scene names: relative to the scene file, or to the working folder for a command
/// line. If there is no such file, returns the built-in garment, body or motion (find_asset).
std::filesystem::path find_beside(const Source& source, const std::filesystem::path& file);

/// Returns the pointer to a key with its sections, such as "solver.substeps", in a nested value.
Json::json_pointer pointer_to(std::string key);

/// Converts a value for writing; a date becomes text.
Json to_json_value(const toml::node& value);

/// Returns the value for messages: numbers with six digits, texts in quotes, tables in braces, "not set" for null.
std::string to_text(const Json& value);
std::string to_text(const toml::node& value);

/// Returns the value as one line of TOML in ASCII that reads back with the same bits. In file names, bytes that are not
/// UTF-8 become U+FFFD.
std::string toml_text(const Json& value);

/// Returns the line of assets/texts/keys.toml about a key, or an empty text. A key of a list's entry follows the list's
/// name: "forces.vertex".
std::string key_meaning(const std::string& key);

/// A key of a scene file, which sets a part of a T.
template <class T> struct Key {
  std::string name;      ///< name with its section: "solver.substeps"
  std::string unit;      ///< empty: no unit
  std::string expected;  ///< description of valid values: "a whole number from 1 to 1000"
  /// Stores a value. Returns false if it is not valid. May also throw by `fail`, with a message of its own.
  std::function<bool(const toml::node&, const Source&, T&)> read;
  std::function<Json(const T&)> write;  ///< returns the stored value; also used to print defaults
};

/// Interval of numbers.
struct Range {
  double lowest = -std::numeric_limits<double>::infinity();
  double highest = std::numeric_limits<double>::infinity();
  bool above_lowest = false;  ///< excludes `lowest`

  bool contains(double value) const { return value <= highest && (above_lowest ? value > lowest : value >= lowest); }
};

inline constexpr Range not_negative = {.lowest = 0.0};                    ///< 0 and above
inline constexpr Range positive = {.lowest = 0.0, .above_lowest = true};  ///< above 0

/// Describes the range: "a whole number from 1 to 1000". `what` is "a number" or "a whole number".
std::string describe(const std::string& what, const Range& range);

/// Return a finite number, a whole number, a list of N finite numbers; empty if the value is anything else.
std::optional<double> finite_number(const toml::node& value);
std::optional<std::int64_t> whole_number(const toml::node& value);
template <std::size_t N> std::optional<std::array<double, N>> numbers_in(const toml::node& value) {
  const toml::array* list = value.as_array();
  std::array<double, N> numbers{};
  for (std::size_t i = 0; i < N; ++i) {
    const auto number = list != nullptr && list->size() == N ? finite_number((*list)[i]) : std::nullopt;
    if (!number) return std::nullopt;
    numbers[i] = *number;
  }
  return numbers;
}

/// Returns red, green and blue, 0 to 1, of a text "#rrggbb"; empty if the value is anything else.
std::optional<glm::vec3> colour_value(const toml::node& value);
/// Returns the colour as "#rrggbb".
std::string colour_text(const glm::vec3& colour);

/// Accessor of a member for a key, const or not.
#define MEMBER(path) \
  [](auto& s) -> auto& { return s.path; }

// Stores a number; 0 in a file means no value for an optional member.
template <class Number> void store(double number, Number& member) { member = static_cast<Number>(number); }
template <class Number> void store(double number, std::optional<Number>& member) {
  member = number != 0.0 ? std::optional(static_cast<Number>(number)) : std::nullopt;
}
template <class Member> double to_stored(const Member& member) {
  return static_cast<double>(std::optional(member).value_or(0));
}

// Stores a value if there is one. Returns false if there is none.
template <class Found, class Member> bool store(const std::optional<Found>& found, Member& member) {
  if (found) member = *found;
  return found.has_value();
}

// Makers of keys. `access` returns a reference to the member of a T, const or not.

/// `read(value, member)` or `read(value, source, member)` stores a value and returns false if it is not valid.
/// `write(member)` returns the member as JSON.
template <class T, class Access, class Read, class Write>
Key<T> member_key(std::string name, std::string unit, std::string expected, Access access, Read read, Write write) {
  auto read_member = [=](const toml::node& value, const Source& source, T& target) -> bool {
    if constexpr (std::is_invocable_v<Read, const toml::node&, const Source&, decltype(access(target))>) {
      return read(value, source, access(target));
    } else {
      return read(value, access(target));
    }
  };
  auto write_member = [=](const T& target) -> Json { return write(access(target)); };
  return {std::move(name), std::move(unit), std::move(expected), read_member, write_member};
}

/// Makes a key for a number, which is stored times `factor`: degrees in files, radians in code.
template <class T, class Access>
Key<T> number_key(std::string name, std::string unit, const Range& range, Access access, double factor = 1.0) {
  auto read = [=](const toml::node& value, auto& member) {
    const std::optional<double> number = finite_number(value);
    const bool is_within = number && range.contains(*number);
    if (is_within) store(*number * factor, member);
    return is_within;
  };
  return member_key<T>(std::move(name), unit, describe("a number", range), access, read,
                       [=](const auto& member) { return to_stored(member) / factor; });
}

template <class T, class Access>
Key<T> whole_key(std::string name, const Range& range, Access access, std::string unit = "") {
  auto read = [=](const toml::node& value, auto& member) {
    const std::optional<std::int64_t> number = whole_number(value);
    const bool is_within = number && range.contains(static_cast<double>(*number));
    if (is_within) store(static_cast<double>(*number), member);
    return is_within;
  };
  return member_key<T>(std::move(name), std::move(unit), describe("a whole number", range), access, read,
                       [](const auto& member) { return static_cast<std::int64_t>(to_stored(member)); });
}

template <class T, class Access> Key<T> switch_key(std::string name, Access access) {
  return member_key<T>(
      std::move(name), "", "true or false", access,
      [](const toml::node& value, bool& member) { return store(value.value_exact<bool>(), member); },
      [](bool member) { return member; });
}

template <class T, class Access> Key<T> text_key(std::string name, Access access, std::string expected = "a text") {
  return member_key<T>(
      std::move(name), "", std::move(expected), access,
      [](const toml::node& value, std::string& member) { return store(text_in(value), member); },
      [](const std::string& member) { return member; });
}

/// Makes a key for a path, which is empty if no file is named.
template <class T, class Access> Key<T> file_key(std::string name, Access access, bool may_be_empty = false) {
  auto read = [=](const toml::node& value, const Source& source, std::filesystem::path& member) {
    const std::optional<std::string> text = text_in(value);
    if (!text || (text->empty() && !may_be_empty)) return false;
    member = text->empty() ? std::filesystem::path() : find_beside(source, *text);
    return true;
  };
  return member_key<T>(std::move(name), "", "a file name", access, read, [](const std::filesystem::path& member) {
    return member.empty() ? Json() : Json(member.string());
  });
}

/// Largest magnitude of a coordinate: far more than any garment needs, and too small for overflow.
inline constexpr double max_coordinate = 1e6;

/// Makes a key for a point: a vector type with members x, y and z.
template <class T, class Access>
Key<T> vector_key(std::string name, std::string unit, Access access, bool may_be_zero = true) {
  auto read = [=](const toml::node& value, auto& member) {
    const auto numbers = numbers_in<3>(value);
    double size = 0.0;
    for (const double number : numbers.value_or(std::array<double, 3>{})) size = std::max(size, std::abs(number));
    const bool is_allowed = numbers && size <= max_coordinate && (may_be_zero || size > 0.0);
    if (is_allowed) member = {(*numbers)[0], (*numbers)[1], (*numbers)[2]};
    return is_allowed;
  };
  auto expected = fmt::format("three numbers [x, y, z] from {:g} to {:g}{}", -max_coordinate, max_coordinate,
                              may_be_zero ? "" : ", not all zero");
  return member_key<T>(std::move(name), unit, std::move(expected), access, read, [](const auto& v) {
    return Json::array({v.x, v.y, v.z});
  });
}

/// Makes a key for a direction: a vector that is not 0.
template <class T, class Access> Key<T> direction_key(std::string name, Access access) {
  return vector_key<T>(std::move(name), "", access, false);
}

/// Makes a key for a colour, or for an optional colour.
template <class T, class Access> Key<T> colour_key(std::string name, Access access) {
  return member_key<T>(
      std::move(name), "", "a colour, \"#rrggbb\"", access,
      [](const toml::node& value, auto& member) { return store(colour_value(value), member); },
      [](const std::optional<glm::vec3>& colour) { return colour ? Json(colour_text(*colour)) : Json(); });
}

/// Returns all choices with their names, for choice_key.
template <class Choices> auto make_choices(const Choices& all) {
  std::vector<std::pair<std::string, typename Choices::value_type>> choices;
  for (const auto choice : all) choices.emplace_back(to_name(choice), choice);
  return choices;
}

/// Makes a key whose value is one of several names.
template <class T, class Choice, class Access>
Key<T> choice_key(std::string name, std::vector<std::pair<std::string, Choice>> choices, Access access) {
  std::string expected;
  for (const auto& [text, choice] : choices) expected += (expected.empty() ? "\"" : " or \"") + text + '"';
  auto read = [=](const toml::node& value, Choice& member) {
    const auto found = text_in(value);
    const auto chosen = std::ranges::find_if(choices, [&](const auto& c) { return c.first == found; });
    member = chosen != choices.end() ? chosen->second : member;
    return chosen != choices.end();
  };
  auto write = [=](const Choice& member) {
    const auto chosen = std::ranges::find_if(choices, [&](const auto& c) { return c.second == member; });
    return chosen != choices.end() ? Json(chosen->first) : Json();
  };
  return member_key<T>(std::move(name), "", std::move(expected), access, read, write);
}

/// Makes the key be written only if `is_used` returns true.
template <class T, class IsUsed> Key<T> written_if(Key<T> key, IsUsed is_used) {
  key.write = [write = std::move(key.write), is_used](const T& entry) {
    return is_used(entry) ? write(entry) : Json();
  };
  return key;
}

/// Reads a list of tables. `read` converts each into an entry.
template <class Read> bool read_list(const toml::node& value, const Read& read) {
  const toml::array* list = value.as_array();
  if (list == nullptr || !(list->empty() || list->is_homogeneous<toml::table>())) return false;
  for (const toml::node& item : *list) read(*item.as_table());
  return true;
}

/// Returns the values of a list's entry, nested as in a file, without those that are not set.
template <class T> Json write_entry(const std::vector<Key<T>>& keys, const T& entry) {
  Json table = Json::object();
  for (const Key<T>& key : keys) {
    Json value = key.write(entry);
    if (!value.is_null()) table[pointer_to(key.name)] = std::move(value);
  }
  return table;
}

/// Reads a table of a scene file into a T. Every error message names the wrong key and, for an unknown key, similar
/// ones.
template <class T> class KeyReader {
 public:
  KeyReader(const std::vector<Key<T>>& keys, const Source& source, T& target)
      : keys_(keys), source_(source), target_(target) {}

  /// Reads all values of the table. Throws by `fail` at the first that is not valid.
  void read(const toml::table& table, const std::string& section = "") {
    for (const auto& [key, value] : list_entries(table)) {
      read_value(section.empty() ? key : section + '.' + key, *value);
    }
  }

  /// Reads the value of one key or section. Throws by `fail`.
  void read_value(const std::string& name, const toml::node& value) {
    const auto key = std::ranges::find(keys_, name, &Key<T>::name);
    if (key == keys_.end() && !is_section(name)) fail_unknown(name, line_number(value));
    const auto fail_unless = [&](bool is_right, const std::string& expected) {
      if (!is_right) fail(source_, line_number(value), name + ": found " + to_text(value) + ", expected " + expected);
    };
    if (key == keys_.end()) {
      fail_unless(value.is_table(), "a table with the keys " + keys_of(name));
      read(*value.as_table(), name);
    } else {
      fail_unless(key->read(value, source_, target_),
                  key->expected + (key->unit.empty() ? "" : " (" + key->unit + ')'));
    }
  }

 private:
  bool is_section(const std::string& name) const {
    return std::ranges::any_of(keys_, [&](const Key<T>& key) { return key.name.starts_with(name + '.'); });
  }

  /// Returns the names of keys and sections directly in this section.
  std::string keys_of(const std::string& section) const {
    const std::string prefix = section.empty() ? "" : section + '.';
    std::vector<std::string> names;
    for (const Key<T>& key : keys_) {
      if (key.name.starts_with(prefix)) {
        const std::string rest = key.name.substr(prefix.size());
        const std::string name = rest.substr(0, rest.find('.'));
        if (names.empty() || names.back() != name) names.push_back(name);
      }
    }
    return join(names);
  }

  [[noreturn]] void fail_unknown(const std::string& name, int line) const {
    std::vector<std::string> known;
    for (const Key<T>& key : keys_) {
      known.push_back(key.name);
      for (std::size_t dot = key.name.find('.'); dot != std::string::npos; dot = key.name.find('.', dot + 1)) {
        known.push_back(key.name.substr(0, dot));
      }
    }
    const std::size_t dot = name.rfind('.');
    const std::string section = dot == std::string::npos ? "" : name.substr(0, dot);
    const std::string there = section.empty() || !is_section(section) ? "" : section;
    fail(source_, line,
         "unknown key '" + name + '\'' + did_you_mean(name, known) +
             (there.empty() ? " (keys: " : " (keys of " + there + ": ") + keys_of(there) + ')');
  }

  const std::vector<Key<T>>& keys_;
  const Source& source_;
  T& target_;
};

}  // namespace taut::app
