#pragma once

#include <atomic>
#include <cfenv>
#include <mutex>

#include "app/base/errors.hpp"
#include "app/library/session.hpp"

namespace taut::library {

/// An argument of a call is not valid.
struct ArgumentError : app::Formatted<std::invalid_argument> {
  using Formatted::Formatted;
};

/// Throws ArgumentError with the message unless `holds`.
void require(bool holds, const char* message);
/// Throws ArgumentError unless the array exists and has the expected length.
void require_array_length(const void* array, std::size_t found, std::size_t expected);
/// Returns the text. Throws ArgumentError with the message if it is null.
std::string require_text(const char* text, const char* message);

/// Returns `expected` points as doubles. Throws ArgumentError for null, for another count, type or stride, and for
/// numbers that are not finite.
std::vector<sim::Vec3> points_from(const TautPoints* points, std::size_t expected);
/// Returns all points. Throws ArgumentError also if they are more than can be simulated.
std::vector<sim::Vec3> points_from(const TautPoints* points);

/// Fills an array with the points. Throws ArgumentError as points_from() does.
void put_points(std::span<const sim::Vec3> points, const TautPointsOut* out);

/// Sets the size and, if there is a buffer, copies the bytes. Throws ArgumentError if they do not fit.
void put_bytes(std::string_view bytes, char* buffer, std::size_t capacity, std::size_t* size);

/// Returns the vector. Throws ArgumentError if a number is not finite or beyond 1e30.
sim::Vec3 to_vector(double x, double y, double z);

/// Returns the vertices. Throws ArgumentError unless all are below `limit`.
std::vector<sim::Index> vertices_from(const std::uint32_t* vertices, std::size_t count, std::size_t limit);

/// Returns the mesh as a reader of files returns it: cut into triangles but not repaired. Throws ArgumentError for
/// arrays that are not valid.
app::ImportedModel model_from(const TautMesh* mesh);

/// Size of the struct's first version, the smallest that a caller may have.
template <class T> inline constexpr std::size_t min_struct_size = sizeof(T);
// A struct that grew has its first version's size here.
template <> inline constexpr std::size_t min_struct_size<TautOptions> = offsetof(TautOptions, bodies);
template <> inline constexpr std::size_t min_struct_size<TautBody> = offsetof(TautBody, dress);
template <> inline constexpr std::size_t min_struct_size<TautFrame> = offsetof(TautFrame, measured_crossings);
template <> inline constexpr std::size_t min_struct_size<TautInfo> = offsetof(TautInfo, crossings_at_start);

/// Largest size that a later version could have.
inline constexpr std::size_t max_struct_size = 1 << 16;

/// Throws ArgumentError for null and for a size that no version of the struct has.
template <class T> void require_struct(const T* given, std::size_t size) {
  require(given != nullptr, "found NULL, expected a struct");
  require(size >= min_struct_size<T> && size <= max_struct_size,
          "found a struct with a struct_size that no version has; its taut_*_init() sets it");
}

template <class T> void init_struct(T* target, std::size_t struct_size) {
  require_struct(target, struct_size);
  std::memset(static_cast<void*>(target), 0, struct_size);
  target->struct_size = static_cast<std::uint32_t>(struct_size);
}

/// Returns a copy with zeros for members that an older caller does not have. Throws ArgumentError for null, for a size
/// that no version has, and if a newer caller sets members that this version does not know.
template <class T> T read_struct(const T* source) {
  const std::size_t size = source != nullptr ? source->struct_size : 0;
  require_struct(source, size);
  const char* bytes = reinterpret_cast<const char*>(source);
  require(std::all_of(bytes + std::min(size, sizeof(T)), bytes + size, [](char byte) { return byte == 0; }),
          "found a struct with members that this version does not know");
  T read{};
  std::memcpy(static_cast<void*>(&read), source, std::min(size, sizeof(T)));
  return read;
}

/// Fills in the members that the caller's version has. Throws ArgumentError as read_struct() does.
template <class T> void put_struct(T value, T* target) {
  const std::size_t size = target != nullptr ? target->struct_size : 0;
  require_struct(target, size);
  value.struct_size = target->struct_size;
  std::memcpy(static_cast<void*>(target), &value, std::min(size, sizeof(T)));
}

/// Returns the result for the exception of the current catch block and writes its text, truncated to fit, with a zero
/// at the end. Throws nothing.
TautResult describe_failure(std::span<char> text) noexcept;

/// Writes a text, truncated to fit, with a zero at the end.
void put_text(const char* from, std::span<char> text) noexcept;

/// A caller's cloth.
struct CallerCloth {
  explicit CallerCloth(Session&& made) : session(std::move(made)) {}

  Session session;
  std::atomic<bool> is_busy = false;
  std::mutex error_mutex;  ///< needed because a thread may ask while another one's call fails
  char error[sizeof(TautError::text)] = {};
};

// Table of all cloths by number, the only data that the cloths of a process share. Without it a handle would be a
// pointer, and using a destroyed or invented one would crash. Numbers are never used twice.

/// Adds a cloth and returns its number, which is never 0.
std::uint64_t add_cloth(std::shared_ptr<CallerCloth> held);
/// Returns the cloth of this number, or null.
std::shared_ptr<CallerCloth> find(std::uint64_t id);
/// Removes the cloth of this number and returns it, or null.
std::shared_ptr<CallerCloth> remove_cloth(std::uint64_t id);

/// Sets the default rounding mode, on which the bits of a run depend, and restores the caller's mode at its end.
class DefaultRounding {
 public:
  DefaultRounding() noexcept {
    std::fegetenv(&callers_);
    std::fesetenv(FE_DFL_ENV);
  }
  ~DefaultRounding() { std::fesetenv(&callers_); }
  DefaultRounding(const DefaultRounding&) = delete;
  DefaultRounding& operator=(const DefaultRounding&) = delete;

 private:
  std::fenv_t callers_{};
};

/// Locks a cloth for one call.
class ClothLock {
 public:
  explicit ClothLock(CallerCloth& held) noexcept : held_(held), is_mine_(!held.is_busy.exchange(true)) {}
  ~ClothLock() {
    if (is_mine_) held_.is_busy = false;
  }
  ClothLock(const ClothLock&) = delete;
  ClothLock& operator=(const ClothLock&) = delete;

  bool is_mine() const { return is_mine_; }

 private:
  CallerCloth& held_;
  bool is_mine_;
};

/// Calls `work` with the cloth and turns exceptions into results.
template <class Work> TautResult with(TautCloth cloth, const Work& work) noexcept {
  const std::shared_ptr<CallerCloth> slot = find(cloth.id);
  if (!slot) return TAUT_ERROR_HANDLE;
  const ClothLock turn(*slot);
  if (!turn.is_mine()) return TAUT_ERROR_BUSY;
  const DefaultRounding rounding;
  try {
    work(slot->session);
    return TAUT_OK;
  } catch (...) {
    const std::lock_guard lock(slot->error_mutex);
    return describe_failure(slot->error);
  }
}

/// Calls `work` without a cloth and turns exceptions into results.
template <class Work> TautResult guard(const Work& work) noexcept {
  char text[sizeof(TautError::text)];
  try {
    work();
    return TAUT_OK;
  } catch (...) {
    return describe_failure(text);
  }
}

}  // namespace taut::library
