#pragma once

#include <fmt/core.h>

#include <concepts>
#include <string>

namespace taut::app {

/// The count with its noun: "1 vertex", "2 vertices". `many` is the plural.
template <std::integral Count>
std::string counted(Count count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

/// As above, for a plural in s: "1 frame", "2 frames".
template <std::integral Count>
std::string counted(Count count, const char* one) {
  return counted(count, one, (std::string(one) + 's').c_str());
}

}  // namespace taut::app
