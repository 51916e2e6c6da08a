#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>

#include "app/library/arrays.hpp"
#include "app/library/taut.h"

namespace taut::library {

/// The least that a struct of a caller has, whatever version it was compiled with.
template <class T>
inline constexpr std::size_t smallest_size = sizeof(T);
// When a struct grows, its size before stands here.
template <>
inline constexpr std::size_t smallest_size<TautOptions> = offsetof(TautOptions, bodies);
template <>
inline constexpr std::size_t smallest_size<TautBody> = offsetof(TautBody, dress);
template <>
inline constexpr std::size_t smallest_size<TautFrame> = offsetof(TautFrame, measured_crossings);
template <>
inline constexpr std::size_t smallest_size<TautInfo> = offsetof(TautInfo, crossings_at_start);

/// The largest size that a later version could have.
inline constexpr std::size_t largest_struct = 1 << 16;

template <class T>
void init_struct(T* target, std::size_t struct_size) {
  require(target != nullptr, "found NULL, expected a struct");
  require(struct_size >= smallest_size<T> && struct_size <= largest_struct,
          "found a size that no version has");
  std::memset(static_cast<void*>(target), 0, struct_size);
  target->struct_size = static_cast<std::uint32_t>(struct_size);
}

/// Returns a copy, with zeros where an older caller has nothing. Throws ArgumentError on null, on a size that
/// no version has, and if a newer caller asks for what this version does not know.
template <class T>
T read_struct(const T* source) {
  require(source != nullptr, "found NULL, expected a struct");
  const std::size_t size = source->struct_size;
  require(size >= smallest_size<T> && size <= largest_struct,
          "found a struct with a struct_size that no version has; its taut_*_init() sets it");
  const char* bytes = reinterpret_cast<const char*>(source);
  require(std::all_of(bytes + std::min(size, sizeof(T)), bytes + size, [](char byte) { return byte == 0; }),
          "found a struct with members that this version does not know");
  T read{};
  std::memcpy(static_cast<void*>(&read), source, std::min(size, sizeof(T)));
  return read;
}

/// Fills in as much as the caller knows of. Throws ArgumentError as read_struct() does.
template <class T>
void put_struct(T value, T* target) {
  require(target != nullptr, "found NULL, expected a struct");
  const std::size_t size = target->struct_size;
  require(size >= smallest_size<T> && size <= largest_struct,
          "found a struct with a struct_size that no version has; its taut_*_init() sets it");
  value.struct_size = target->struct_size;
  std::memcpy(static_cast<void*>(target), &value, std::min(size, sizeof(T)));
}

}  // namespace taut::library
