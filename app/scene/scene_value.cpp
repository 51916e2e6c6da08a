#include "app/scene/scene_value.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <sstream>

#include "app/base/errors.hpp"
#include "app/scene/scene_file.hpp"

namespace taut::app {
namespace {

std::string message_word(const Json& value) {
  if (value.is_null()) {
    return "not set";
  }
  if (value.is_string()) {
    return '"' + value.get<std::string>() + '"';
  }
  return value.is_number_float() ? fmt::format("{:.6g}", value.get<double>()) : value.dump();
}

std::string toml_word(const Json& value) {
  if (value.is_string()) {
    const Json readable = Json::parse(value.dump(-1, ' ', false, Json::error_handler_t::replace));
    std::ostringstream text;
    text << toml::toml_formatter(toml::value(readable.get<std::string>()), toml::format_flags::none);
    return text.str();
  }
  if (!value.is_number_float()) {
    return value.dump();
  }
  // The fewest digits that read back as the same bits; with a point, or TOML takes -0 for a whole 0.
  const std::string text = fmt::format("{}", value.get<double>());
  return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}

std::string joined_words(const Json& value, std::string (*word)(const Json&)) {
  if (!value.is_structured()) {
    return word(value);
  }
  std::string text;
  for (const auto& [key, item] : value.items()) {
    text += (text.empty() ? "" : ", ") + (value.is_object() ? key + " = " : "") + joined_words(item, word);
  }
  return value.is_object() ? "{ " + text + " }" : '[' + text + ']';
}

}  // namespace

Json json_of(const toml::node& node) {
  return node.visit([](const auto& value) -> Json {
    using Type = decltype(value);
    if constexpr (toml::is_table<Type>) {
      Json object = Json::object();
      for (const auto& [key, item] : entries_of(value)) {
        object[key] = json_of(*item);
      }
      return object;
    } else if constexpr (toml::is_array<Type>) {
      Json list = Json::array();
      for (const toml::node& item : value) {
        list.push_back(json_of(item));
      }
      return list;
    } else if constexpr (toml::is_chronological<Type>) {
      return *text_in(value);
    } else {
      return value.get();
    }
  });
}

void fail(const Source& source, int line, const std::string& message) {
  if (source.is_command_line) {
    throw UsageError(source.name + ": " + message);
  }
  throw InputError(line > 0 ? fmt::format("{}:{}: {}", source.name, line, message)
                            : fmt::format("{}: {}", source.name, message));
}

int line_of(const toml::node& value) {
  return static_cast<int>(value.source().begin.line);
}

toml::table read_toml_text(const std::string& text, const std::string& name) {
  try {
    return toml::parse(text, name);
  } catch (const toml::parse_error& error) {
    fail({name}, static_cast<int>(error.source().begin.line),
         "this is not TOML: " + std::string(error.description()));
  }
}

toml::table read_toml_value(const std::string& text) {
  try {
    return toml::parse("value = " + text);
  } catch (const toml::parse_error&) {
    return toml::table{{"value", text}};
  }
}

std::optional<std::string> text_in(const toml::node& value) {
  if (value.is_date() || value.is_time() || value.is_date_time()) {
    std::ostringstream text;
    text << toml::node_view(value);
    return text.str();
  }
  return value.value_exact<std::string>();
}

std::vector<std::pair<std::string, const toml::node*>> entries_of(const toml::table& table) {
  std::vector<std::pair<std::string, const toml::node*>> entries;
  for (const auto& [key, value] : table) {
    entries.emplace_back(key.str(), &value);
  }
  std::stable_sort(entries.begin(), entries.end(),
                   [](const auto& a, const auto& b) { return line_of(*a.second) < line_of(*b.second); });
  return entries;
}

std::filesystem::path beside(const Source& source, const std::filesystem::path& file) {
  const auto folder =
      source.is_command_line ? std::filesystem::path() : std::filesystem::path(source.name).parent_path();
  const std::filesystem::path named = (folder / file).lexically_normal();
  std::error_code ignored;
  return std::filesystem::exists(named, ignored) ? named : find_asset(file).value_or(named);
}

Json::json_pointer pointer_to(std::string key) {
  std::replace(key.begin(), key.end(), '.', '/');
  return Json::json_pointer('/' + key);
}

std::string to_text(const Json& value) {
  return joined_words(value, message_word);
}

std::string to_text(const toml::node& value) {
  return to_text(json_of(value));
}

std::string toml_text(const Json& value) {
  return joined_words(value, toml_word);
}

}  // namespace taut::app
