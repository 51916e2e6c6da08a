#pragma once

#include <fmt/core.h>

#include <concepts>
#include <string>

namespace taut::app {

/// "1 vertex", "2 vertices".
template <std::integral Count>
std::string counted(Count count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

/// "1 frame", "2 frames".
template <std::integral Count>
std::string counted(Count count, const char* one) {
  return counted(count, one, (std::string(one) + 's').c_str());
}

}  // namespace taut::app
