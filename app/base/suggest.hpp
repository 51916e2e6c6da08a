#pragma once

#include "prelude.hpp"

namespace taut::app {

/// Returns the first of `names` that begins with `name`, which has three characters or more, or else the one that is
/// nearest to it, or an empty text. Nearest means the smallest edit distance (Levenshtein 1966), which may be at most a
/// third of the length of `name`.
std::string nearest_name(std::string_view name, std::span<const std::string> names);

/// The names with the separator between them: "a, b, c".
std::string joined(std::span<const std::string> names, std::string_view separator = ", ");

/// Returns "; did you mean 'NAME'?" for the nearest name, or an empty text if no name is near.
std::string did_you_mean(std::string_view name, std::span<const std::string> names);

}  // namespace taut::app
