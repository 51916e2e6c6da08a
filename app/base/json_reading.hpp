#pragma once

#include <nlohmann/json.hpp>

#include "app/base/errors.hpp"

namespace taut::app {

/// Maximum nesting depth of JSON. Printing, copying and comparing values recurses as deep on the stack.
inline constexpr int max_json_depth = 100;

/// Returns the reason without the library's name of the error and without the last bytes that it read.
inline std::string plain_reason(const nlohmann::json::exception& error) {
  const std::string what = error.what();
  const std::size_t name_end = what.starts_with("[json.exception") ? what.find("] ") : std::string::npos;
  const std::string reason = name_end == std::string::npos ? what : what.substr(name_end + 2);
  return reason.substr(0, reason.find("; last read"));
}

/// Parses JSON. Throws InputError that begins with `where` if the text is not JSON or is nested too deeply.
template <class Json>
Json parse_json(const std::string& text, const std::string& where, const std::string& expected,
                bool may_have_comments = false) {
  const auto limit_depth = [&](int depth, typename Json::parse_event_t, const Json&) {
    if (depth > max_json_depth) {
      throw InputError("{}: found lists and objects nested more than {} deep, expected {}", where, max_json_depth,
                       expected);
    }
    return true;
  };
  try {
    return Json::parse(text, limit_depth, true, may_have_comments);
  } catch (const nlohmann::json::exception& error) {
    throw InputError("{}: {}; expected {}", where, plain_reason(error), expected);
  }
}

}  // namespace taut::app
