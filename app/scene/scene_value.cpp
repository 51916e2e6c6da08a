#include "app/scene/scene_value.hpp"

#include <algorithm>
#include <fmt/core.h>

#include "app/base/errors.hpp"

namespace taut::app {
namespace {

struct Writer {
  std::string operator()(std::monostate) const { return "not set"; }
  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(std::int64_t value) const { return fmt::format("{}", value); }
  std::string operator()(double value) const { return fmt::format("{:.6g}", value); }
  std::string operator()(const std::string& value) const { return '"' + value + '"'; }
  std::string operator()(const ValueList& values) const {
    std::string text;
    for (const Value& value : values) {
      text += (text.empty() ? "" : ", ") + to_text(value);
    }
    return '[' + text + ']';
  }
  std::string operator()(const ValueTable& table) const {
    std::string text;
    for (const auto& [key, value] : table) {
      text += (text.empty() ? "" : ", ") + key + " = " + to_text(value);
    }
    return "{ " + text + " }";
  }
};

}  // namespace

bool is_set(const Value& value) {
  if (const ValueTable* table = value.table()) {
    return std::any_of(table->begin(), table->end(), [](const auto& entry) { return is_set(entry.value); });
  }
  return !std::holds_alternative<std::monostate>(value.data);
}

std::string to_text(const Value& value) {
  return std::visit(Writer{}, value.data);
}

void fail(const Source& source, int line, const std::string& message) {
  if (source.is_command_line) {
    throw UsageError(source.name + ": " + message);
  }
  throw InputError(line > 0 ? fmt::format("{}:{}: {}", source.name, line, message)
                            : fmt::format("{}: {}", source.name, message));
}

}  // namespace taut::app
