#pragma once

#include <span>
#include <string>
#include <string_view>

namespace taut::app {

/// The name most like the one given (Levenshtein distance, at most a third of its length), or nothing.
std::string nearest_name(std::string_view name, std::span<const std::string> names);

/// "a, b, c".
std::string joined(std::span<const std::string> names, std::string_view separator = ", ");

/// "; did you mean 'NAME'?" where there is a near name, or nothing.
std::string did_you_mean(std::string_view name, std::span<const std::string> names);

}  // namespace taut::app
