#pragma once

// Parts of the standard library that emscripten's libc++ 13 lacks, as the standard defines them. Every source of the
// engine is compiled with this header in front, so no source needs to change.

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <iterator>
#include <string>
#include <system_error>

namespace std {

template <class To, class From> constexpr To bit_cast(const From& from) noexcept {
  return __builtin_bit_cast(To, from);
}

// Accepts only the number syntax of model files: strtod would also read hexadecimal numbers and names.
template <class Real>
requires is_floating_point_v<Real> from_chars_result from_chars(const char* first, const char* last, Real& value) {
  const char* end = std::find_if(first, last, [](char c) { return std::strchr("+-.0123456789eE", c) == nullptr; });
  const std::string text(first, end);
  char* stopped = nullptr;
  const double read = *first == '+' ? 0.0 : std::strtod(text.c_str(), &stopped);
  if (stopped == nullptr || stopped == text.c_str()) return {first, errc::invalid_argument};
  value = static_cast<Real>(sizeof(Real) == sizeof(float) ? std::strtof(text.c_str(), &stopped) : read);
  const bool is_far_out = std::isinf(static_cast<double>(value));
  return {first + (stopped - text.c_str()), is_far_out ? errc::result_out_of_range : errc{}};
}

namespace ranges {

/// Returns a comparison of two items by their projections.
template <class Compare, class Projection> auto projected_by(Compare compare, Projection projection) {
  return [compare, projection](const auto& a, const auto& b) {
    return std::invoke(compare, std::invoke(projection, a), std::invoke(projection, b));
  };
}

#define TAUT_OF_ORDER(name)                                                                  \
  template <class Range, class Compare = std::less<>, class Projection = std::identity>      \
  auto name(Range&& range, Compare compare = {}, Projection projection = {}) {               \
    return std::name(std::begin(range), std::end(range), projected_by(compare, projection)); \
  }
TAUT_OF_ORDER(sort)
TAUT_OF_ORDER(stable_sort)
TAUT_OF_ORDER(max_element)
TAUT_OF_ORDER(min_element)
#undef TAUT_OF_ORDER

#define TAUT_OF_PREDICATE(name)                                                                                   \
  template <class Range, class Predicate, class Projection = std::identity>                                       \
  auto name(Range&& range, Predicate predicate, Projection projection = {}) {                                     \
    return std::name(std::begin(range), std::end(range),                                                          \
                     [&](auto&& item) -> bool { return std::invoke(predicate, std::invoke(projection, item)); }); \
  }
TAUT_OF_PREDICATE(all_of)
TAUT_OF_PREDICATE(any_of)
TAUT_OF_PREDICATE(none_of)
TAUT_OF_PREDICATE(find_if)
TAUT_OF_PREDICATE(count_if)
#undef TAUT_OF_PREDICATE

template <class Range, class Value, class Projection = std::identity>
auto find(Range&& range, const Value& value, Projection projection = {}) {
  return ranges::find_if(range, [&](const auto& item) { return std::invoke(projection, item) == value; });
}
template <class Range, class Value> auto count(Range&& range, const Value& value) {
  return std::count(std::begin(range), std::end(range), value);
}
template <class Range> auto adjacent_find(Range&& range) {
  return std::adjacent_find(std::begin(range), std::end(range));
}
template <class Range, class Value> bool binary_search(Range&& range, const Value& value) {
  return std::binary_search(std::begin(range), std::end(range), value);
}
template <class Range> void reverse(Range&& range) { std::reverse(std::begin(range), std::end(range)); }
template <class Range, class Value> void replace(Range&& range, const Value& from, const Value& to) {
  std::replace(std::begin(range), std::end(range), from, to);
}
template <class Range, class Out> void copy(Range&& range, Out out) {
  std::copy(std::begin(range), std::end(range), out);
}
template <class Range, class Out, class Predicate> void copy_if(Range&& range, Out out, Predicate predicate) {
  std::copy_if(std::begin(range), std::end(range), out, predicate);
}

template <class Range, class Value> void fill(Range&& range, const Value& value) {
  std::fill(std::begin(range), std::end(range), value);
}
template <class Range, class Out, class Change> void transform(Range&& range, Out out, Change change) {
  std::transform(std::begin(range), std::end(range), out, change);
}
template <class Range, class Value> auto lower_bound(Range&& range, const Value& value) {
  return std::lower_bound(std::begin(range), std::end(range), value);
}

template <class Iterator> struct min_max { Iterator min, max; };
template <class Range, class Compare> auto minmax_element(Range&& range, Compare compare) {
  const auto [least, most] = std::minmax_element(std::begin(range), std::end(range), compare);
  return min_max<decltype(std::begin(range))>{least, most};
}

}  // namespace ranges
}  // namespace std
