#include "app/library/border.hpp"

#include <unistd.h>

namespace taut::library {
namespace {

using app::is_any;

TautResult to_result(const std::exception& error) {
  if (is_any<app::UsageError, std::invalid_argument>(error)) return TAUT_ERROR_ARGUMENT;
  if (is_any<app::InputError, sim::BadBytes>(error)) return TAUT_ERROR_INPUT;
  if (is_any<app::PromiseBroken, sim::ContactBlocked>(error)) return TAUT_ERROR_PROMISE;
  if (is_any<sim::Diverged>(error)) return TAUT_ERROR_DIVERGED;
  return is_any<std::bad_alloc, std::length_error>(error) ? TAUT_ERROR_MEMORY : TAUT_ERROR_INTERNAL;
}

struct Table {
  const pid_t process;  ///< process that made the table
  std::atomic<std::uint64_t> handle_count;
  std::mutex mutex = {};
  std::map<std::uint64_t, std::shared_ptr<CallerCloth>> cloths = {};
};

/// Returns the table of handles. It is never destroyed, because other threads may still use cloths when the program
/// ends. A child after fork gets a table of its own: the threads of its parent's cloths do not exist there, and one of
/// them may have locked the mutex.
Table& table() {
  static std::atomic<Table*> newest = new Table{::getpid(), 0};
  Table* all = newest;
  if (all->process != ::getpid()) {
    std::unique_ptr<Table> own(new Table{::getpid(), all->handle_count.load()});
    if (newest.compare_exchange_strong(all, own.get())) all = own.release();
  }
  return *all;
}

/// Maps each number but 0 to another number that is far from its neighbours, so that invented handles hardly ever hit
/// one (Steele, Lea and Flood 2014).
std::uint64_t scramble(std::uint64_t number) {
  number = (number ^ (number >> 30U)) * 0xBF58476D1CE4E5B9U;
  number = (number ^ (number >> 27U)) * 0x94D049BB133111EBU;
  return number ^ (number >> 31U);
}

constexpr std::size_t max_vertices = 3 * app::max_triangles;

std::size_t number_size(std::int32_t type) {
  require(type == TAUT_FLOAT || type == TAUT_DOUBLE,
          "found an unknown type of numbers, expected TAUT_FLOAT or TAUT_DOUBLE");
  return type == TAUT_FLOAT ? sizeof(float) : sizeof(double);
}

template <class Points> void require_array(const Points* points, std::size_t count) {
  require(points != nullptr, "found NULL, expected points");
  if (points->count != count) throw ArgumentError("found {} points, expected {}", points->count, count);
  const std::size_t smallest = 3 * number_size(points->type);
  if (points->stride < smallest || points->stride > std::numeric_limits<std::size_t>::max() / 2 / max_vertices) {
    throw ArgumentError("found a stride of {} bytes, expected at least {}", points->stride, smallest);
  }
  require(points->data != nullptr || count == 0, "found points with data of NULL");
}

template <class Number> sim::Vec3 read_point(const char* at) {
  Number numbers[3];
  std::memcpy(numbers, at, sizeof(numbers));
  return {numbers[0], numbers[1], numbers[2]};
}

template <class Number> void write_point(const sim::Vec3& point, char* at) {
  const Number numbers[3] = {static_cast<Number>(point.x), static_cast<Number>(point.y), static_cast<Number>(point.z)};
  std::memcpy(at, numbers, sizeof(numbers));
}

/// Largest magnitude of a caller's number; its third power is finite.
constexpr double max_number = 1e30;

bool is_number(const sim::Vec3& point) {
  return std::abs(point.x) <= max_number && std::abs(point.y) <= max_number && std::abs(point.z) <= max_number;
}

/// Returns the corner count of each face.
std::vector<std::uint32_t> corner_counts(const TautMesh& mesh) {
  if (mesh.corners_per_face == nullptr) {
    require(mesh.face_count == 0, "found a face_count without corners_per_face");
    require(mesh.corner_count % 3 == 0, "found a corner_count that is no multiple of 3, expected triangles");
    return std::vector<std::uint32_t>(mesh.corner_count / 3, 3);
  }
  require(mesh.face_count <= mesh.corner_count / 3, "found more faces than corners make, three for each");
  return {mesh.corners_per_face, mesh.corners_per_face + mesh.face_count};
}

}  // namespace

void put_text(const char* from, std::span<char> text) noexcept {
  const std::size_t length = std::min(std::strlen(from), text.size() - 1);
  std::memcpy(text.data(), from, length);
  text[length] = '\0';
}

TautResult describe_failure(std::span<char> text) noexcept {
  try {
    throw;
  } catch (const std::exception& error) {
    put_text(error.what(), text);
    return to_result(error);
  } catch (...) {
    put_text("something was thrown that is no error", text);
    return TAUT_ERROR_INTERNAL;
  }
}

std::uint64_t add_cloth(std::shared_ptr<CallerCloth> held) {
  Table& all = table();
  const std::lock_guard lock(all.mutex);
  const std::uint64_t id = scramble(++all.handle_count);
  all.cloths.emplace(id, std::move(held));
  return id;
}

std::shared_ptr<CallerCloth> find(std::uint64_t id) {
  Table& all = table();
  const std::lock_guard lock(all.mutex);
  const auto found = all.cloths.find(id);
  return found == all.cloths.end() ? nullptr : found->second;
}

std::shared_ptr<CallerCloth> remove_cloth(std::uint64_t id) {
  Table& all = table();
  const std::lock_guard lock(all.mutex);
  const auto found = all.cloths.find(id);
  if (found == all.cloths.end()) return nullptr;
  std::shared_ptr<CallerCloth> slot = std::move(found->second);
  all.cloths.erase(found);
  return slot;
}

void require(bool holds, const char* message) {
  if (!holds) throw ArgumentError(message);
}

void require_array_length(const void* array, std::size_t found, std::size_t expected) {
  require(array != nullptr || expected == 0, "found an array of NULL");
  if (found != expected) {
    throw ArgumentError("found an array of " + std::to_string(found) + ", expected " + std::to_string(expected));
  }
}

std::string require_text(const char* text, const char* message) {
  require(text != nullptr, message);
  return text;
}

std::vector<sim::Vec3> points_from(const TautPoints* points, std::size_t expected) {
  require_array(points, expected);
  std::vector<sim::Vec3> read;
  read.reserve(expected);
  for (std::size_t k = 0; k < expected; ++k) {
    const char* at = static_cast<const char*>(points->data) + k * points->stride;
    read.push_back(points->type == TAUT_FLOAT ? read_point<float>(at) : read_point<double>(at));
    if (!is_number(read.back())) {
      throw ArgumentError("found point {} with a number that is not finite or beyond {:g}", k, max_number);
    }
  }
  return read;
}

std::vector<sim::Vec3> points_from(const TautPoints* points) {
  require(points != nullptr, "found NULL, expected points");
  if (points->count > max_vertices) {
    throw ArgumentError("found {} points, expected at most {}", points->count, max_vertices);
  }
  return points_from(points, points->count);
}

void put_points(std::span<const sim::Vec3> points, const TautPointsOut* out) {
  require_array(out, points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    char* at = static_cast<char*>(out->data) + k * out->stride;
    out->type == TAUT_FLOAT ? write_point<float>(points[k], at) : write_point<double>(points[k], at);
  }
}

void put_bytes(std::string_view bytes, char* buffer, std::size_t capacity, std::size_t* size) {
  require(size != nullptr, "found a size of NULL");
  *size = bytes.size();
  if (buffer != nullptr) {
    require(capacity >= bytes.size(), "found a buffer that is too small");
    std::ranges::copy(bytes, buffer);
  }
}

sim::Vec3 to_vector(double x, double y, double z) {
  const sim::Vec3 vector(x, y, z);
  require(is_number(vector), "found a number that is not finite or beyond 1e30");
  return vector;
}

std::vector<sim::Index> vertices_from(const std::uint32_t* vertices, std::size_t count, std::size_t limit) {
  require(vertices != nullptr || count == 0, "found vertices of NULL");
  require(count <= max_vertices, "found more vertices than can be simulated");
  for (std::size_t k = 0; k < count; ++k) {
    if (vertices[k] >= limit) {
      throw ArgumentError("found vertex {} at place {}, expected one below {}", vertices[k], k, limit);
    }
  }
  return {vertices, vertices + count};
}

app::ImportedModel model_from(const TautMesh* given) {
  const TautMesh mesh = read_struct(given);
  if (mesh.corner_count > max_vertices) {
    throw ArgumentError("found {} corners of faces, expected at most {}", mesh.corner_count, max_vertices);
  }
  std::vector<sim::Vec3> positions_m = points_from(&mesh.positions);
  std::vector<sim::Index> corners = vertices_from(mesh.corners, mesh.corner_count, positions_m.size());
  require(!corners.empty(), "found a mesh without faces");
  return app::to_model(std::move(positions_m), corner_counts(mesh), std::move(corners));
}

}  // namespace taut::library
