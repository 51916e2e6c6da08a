#pragma once

#include <fmt/core.h>

#include <charconv>

#include "prelude.hpp"

namespace taut::app {

/// Returns the count with its noun: "1 vertex", "2 vertices". `many` is the plural.
template <std::integral Count> std::string count_text(Count count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

/// Returns the count with a noun whose plural ends in s: "1 frame", "2 frames".
template <std::integral Count> std::string count_text(Count count, const char* one) {
  return count_text(count, one, (std::string(one) + 's').c_str());
}

/// Returns the number if it is the whole text. `base`: base of an integer.
template <class Number, class... Base> std::optional<Number> number_in(std::string_view text, Base... base) {
  Number number{};
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number, base...);
  return error == std::errc() && stop == end ? std::optional(number) : std::nullopt;
}

/// Replaces capital letters of ASCII by small ones.
std::string lower_case(std::string text);

/// Limit on the bytes that printable() returns of one text.
inline constexpr std::size_t max_printed_bytes = 2000;

/// Returns text from a file as a terminal may show it: control characters other than line ends become \xNN, and a text
/// longer than `max_printed_bytes` loses its middle.
std::string printable(std::string_view text);

/// Returns the function or the member `of` of each item.
template <class Result, class Items, class Of> std::vector<Result> collect(const Items& items, const Of& of) {
  std::vector<Result> results;
  for (const auto& item : items) results.emplace_back(std::invoke(of, item));
  return results;
}

/// Joins the names: "a, b, c".
std::string join(std::span<const std::string> names, std::string_view separator = ", ");

/// Returns "; did you mean 'NAME'?" for the nearest name, or an empty text if no name is near.
std::string did_you_mean(std::string_view name, std::span<const std::string> names);

/// Returns "[0.10000, 0.20000, 0.30000] m".
std::string describe_place(const glm::dvec3& place_m);

/// Returns "[0.1, 0.2, 0.3]", to six digits, for places in the unit of a file.
std::string describe_point(const glm::dvec3& point);

/// Version of the program, such as "0.1.0".
std::string program_version();
/// Name and version of the compiler that built the program.
std::string compiler_version();

}  // namespace taut::app
