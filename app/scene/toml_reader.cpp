#include "app/scene/toml_reader.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <sstream>

#include "app/base/files.hpp"

namespace taut::app {
namespace {

Value convert(const toml::node& node);

Value convert_array(const toml::array& array) {
  ValueList list;
  for (const toml::node& item : array) {
    list.push_back(convert(item));
  }
  return {std::move(list)};
}

// toml++ sorts keys; a message should speak of the first mistake in the file.
Value convert_table(const toml::table& source) {
  ValueTable table;
  for (const auto& [key, node] : source) {
    table.push_back({std::string(key.str()), convert(node)});
  }
  std::stable_sort(table.begin(), table.end(),
                   [](const auto& a, const auto& b) { return a.value.line < b.value.line; });
  return {std::move(table)};
}

std::string date_text(const toml::node& node) {
  std::ostringstream text;
  node.visit([&text](const auto& typed) { text << typed; });
  return text.str();
}

Value convert_untraced(const toml::node& node) {
  if (const auto* table = node.as_table()) {
    return convert_table(*table);
  }
  if (const auto* array = node.as_array()) {
    return convert_array(*array);
  }
  if (const auto* text = node.as_string()) {
    return {text->get()};
  }
  if (const auto* integer = node.as_integer()) {
    return {integer->get()};
  }
  if (const auto* number = node.as_floating_point()) {
    return {number->get()};
  }
  if (const auto* boolean = node.as_boolean()) {
    return {boolean->get()};
  }
  return {date_text(node)};
}

Value convert(const toml::node& node) {
  Value value = convert_untraced(node);
  value.line = static_cast<int>(node.source().begin.line);
  return value;
}

}  // namespace

Value read_toml(const std::filesystem::path& path) {
  return read_toml_text(read_text_file(path), path.string());
}

Value read_toml_text(const std::string& text, const std::string& name) {
  try {
    return convert_table(toml::parse(text, name));
  } catch (const toml::parse_error& error) {
    fail({name}, static_cast<int>(error.source().begin.line),
         "this is not TOML: " + std::string(error.description()));
  }
}

Value read_toml_value(const std::string& text) {
  try {
    Value value = convert(*toml::parse("value = " + text).get("value"));
    return value;
  } catch (const toml::parse_error&) {
    return {text};
  }
}

}  // namespace taut::app
