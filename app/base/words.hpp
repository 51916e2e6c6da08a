#pragma once

#include <fmt/core.h>

#include <charconv>

#include "prelude.hpp"

namespace taut::app {

/// The count with its noun: "1 vertex", "2 vertices". `many` is the plural.
template <std::integral Count> std::string counted(Count count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

/// As above, for a plural in s: "1 frame", "2 frames".
template <std::integral Count> std::string counted(Count count, const char* one) {
  return counted(count, one, (std::string(one) + 's').c_str());
}

/// The number that the whole text is; empty: it is none. `base`: none, or that of a whole number.
template <class Number, class... Base> std::optional<Number> number_in(std::string_view text, Base... base) {
  Number number{};
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number, base...);
  return error == std::errc() && stop == end ? std::optional(number) : std::nullopt;
}

/// The text with small letters in the place of capital ones, those of ASCII alone.
std::string lower_case(std::string text);

/// Limit on the bytes that printable() returns of one text.
inline constexpr std::size_t max_printed_bytes = 2000;

/// The text as a terminal may show it: control characters other than line ends as \xNN, and the middle of a text left
/// out that is longer than `max_printed_bytes`. For whatever a file may have said.
std::string printable(std::string_view text);

/// The names with the separator between them: "a, b, c".
std::string joined(std::span<const std::string> names, std::string_view separator = ", ");

/// Returns "; did you mean 'NAME'?" for the nearest name, or an empty text if no name is near.
std::string did_you_mean(std::string_view name, std::span<const std::string> names);

/// The version of the program, such as "0.1.0".
std::string program_version();
/// Name and version of the compiler that built the program.
std::string compiler_version();

}  // namespace taut::app
