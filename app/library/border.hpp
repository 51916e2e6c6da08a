#pragma once

#include <atomic>
#include <cfenv>
#include <mutex>

#include "app/base/errors.hpp"
#include "app/library/session.hpp"

namespace taut::library {

/// An argument of a call cannot be used.
struct ArgumentError : app::Formatted<std::invalid_argument> {
  using Formatted::Formatted;
};

/// Throws ArgumentError with the message, unless it holds.
void require(bool holds, const char* message);
/// The same unless the array is there, of the length expected.
void require_room(const void* array, std::size_t found, std::size_t expected);
/// Returns the text. Throws ArgumentError with the message on null.
std::string text_of(const char* text, const char* message);

/// Returns the points as doubles, `expected` of them. Throws ArgumentError on null, on another count, type or
/// stride, and on numbers that are not finite.
std::vector<sim::Vec3> points_from(const TautPoints* points, std::size_t expected);
/// The same for as many as there are; more than can be simulated are refused.
std::vector<sim::Vec3> points_from(const TautPoints* points);

/// Fills an array with the points. Throws ArgumentError as points_from() does.
void put_points(std::span<const sim::Vec3> points, const TautPointsOut* out);

/// Fills in the size, and the bytes where there is a buffer. Throws ArgumentError if they do not fit.
void put_bytes(std::string_view bytes, char* buffer, std::size_t capacity, std::size_t* size);

/// Returns the vector. Throws ArgumentError if a number is not finite.
sim::Vec3 vector_of(double x, double y, double z);

/// Returns the numbers, each below `limit`. Throws ArgumentError.
std::vector<sim::Index> vertices_from(const std::uint32_t* vertices, std::size_t count, std::size_t limit);

/// Returns the mesh as one that is read from a file, cut into triangles but not repaired. Throws
/// ArgumentError on arrays that cannot be used.
app::ImportedModel model_from(const TautMesh* mesh);

/// The least that a struct of a caller has, whatever version it was compiled with.
template <class T> inline constexpr std::size_t smallest_size = sizeof(T);
// When a struct grows, its size before stands here.
template <> inline constexpr std::size_t smallest_size<TautOptions> = offsetof(TautOptions, bodies);
template <> inline constexpr std::size_t smallest_size<TautBody> = offsetof(TautBody, dress);
template <> inline constexpr std::size_t smallest_size<TautFrame> = offsetof(TautFrame, measured_crossings);
template <> inline constexpr std::size_t smallest_size<TautInfo> = offsetof(TautInfo, crossings_at_start);

/// The largest size that a later version could have.
inline constexpr std::size_t largest_struct = 1 << 16;

/// Throws ArgumentError on null and on a size that no version of the struct has.
template <class T> void require_struct(const T* given, std::size_t size) {
  require(given != nullptr, "found NULL, expected a struct");
  require(size >= smallest_size<T> && size <= largest_struct,
          "found a struct with a struct_size that no version has; its taut_*_init() sets it");
}

template <class T> void init_struct(T* target, std::size_t struct_size) {
  require_struct(target, struct_size);
  std::memset(static_cast<void*>(target), 0, struct_size);
  target->struct_size = static_cast<std::uint32_t>(struct_size);
}

/// Returns a copy, with zeros where an older caller has nothing. Throws ArgumentError on null, on a size that
/// no version has, and if a newer caller asks for what this version does not know.
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

/// Fills in as much as the caller knows of. Throws ArgumentError as read_struct() does.
template <class T> void put_struct(T value, T* target) {
  const std::size_t size = target != nullptr ? target->struct_size : 0;
  require_struct(target, size);
  value.struct_size = target->struct_size;
  std::memcpy(static_cast<void*>(target), &value, std::min(size, sizeof(T)));
}

/// Within a catch block: the result that stands for the exception, with its text, cut where it does not fit,
/// and a zero behind it. Throws nothing.
TautResult describe_failure(std::span<char> text) noexcept;

/// Writes a text, cut where it does not fit, and a zero behind it.
void put_text(const char* from, std::span<char> text) noexcept;

/// A cloth that a caller has.
struct Held {
  explicit Held(Session&& made) : session(std::move(made)) {}

  Session session;
  std::atomic<bool> is_busy = false;
  std::mutex error_mutex;  ///< as another thread may ask while this one fails
  char error[sizeof(TautError::text)] = {};
};

// The cloths that there are, by their numbers. It is the one thing that all cloths of a process share: a
// handle without it would be a pointer, and to follow one that is stale or made up is a crash. Numbers are
// never used twice.

/// Returns the number of the cloth from now on, never 0.
std::uint64_t keep(std::shared_ptr<Held> held);
/// Returns the cloth; null if there is none of this number.
std::shared_ptr<Held> find(std::uint64_t id);
/// The same, and forgets it.
std::shared_ptr<Held> release(std::uint64_t id);

/// Rounding as the bits of a run need it, whatever the caller's program has chosen for itself.
class UsualRounding {
 public:
  UsualRounding() noexcept {
    std::fegetenv(&callers_);
    std::fesetenv(FE_DFL_ENV);
  }
  ~UsualRounding() { std::fesetenv(&callers_); }
  UsualRounding(const UsualRounding&) = delete;
  UsualRounding& operator=(const UsualRounding&) = delete;

 private:
  std::fenv_t callers_{};
};

/// Keeps a cloth to itself for a call.
class Turn {
 public:
  explicit Turn(Held& held) noexcept : held_(held), is_mine_(!held.is_busy.exchange(true)) {}
  ~Turn() {
    if (is_mine_) held_.is_busy = false;
  }
  Turn(const Turn&) = delete;
  Turn& operator=(const Turn&) = delete;

  bool is_mine() const { return is_mine_; }

 private:
  Held& held_;
  bool is_mine_;
};

/// The border: does it with the cloth, and makes a result of whatever is thrown.
template <class Work> TautResult with(TautCloth cloth, const Work& work) noexcept {
  const std::shared_ptr<Held> held = find(cloth.id);
  if (!held) return TAUT_ERROR_HANDLE;
  const Turn turn(*held);
  if (!turn.is_mine()) return TAUT_ERROR_BUSY;
  const UsualRounding rounding;
  try {
    work(held->session);
    return TAUT_OK;
  } catch (...) {
    const std::lock_guard lock(held->error_mutex);
    return describe_failure(held->error);
  }
}

/// The same for calls without a cloth.
template <class Work> TautResult guarded(const Work& work) noexcept {
  char text[sizeof(TautError::text)];
  try {
    work();
    return TAUT_OK;
  } catch (...) {
    return describe_failure(text);
  }
}

}  // namespace taut::library
