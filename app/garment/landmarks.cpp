#include "app/garment/landmarks.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <sstream>

#include "app/output/files.hpp"
#include "app/scene/pins.hpp"
#include "app/scene/scene_key.hpp"
#include "app/scene/toml_reader.hpp"

namespace taut::app {
namespace {

// Files hold about six digits, so equal points can differ in the last; neighbours are millimetres apart.
constexpr double same_point_m = 1e-5;

std::vector<sim::Vec3> obj_vertices(const std::filesystem::path& path) {
  std::vector<sim::Vec3> vertices;
  std::istringstream lines(read_text_file(path));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string kind;
    sim::Vec3 p(0.0);
    if (words >> kind && kind == "v" && words >> p.x >> p.y >> p.z) {
      vertices.push_back(p);
    }
  }
  return vertices;
}

// Everything one landmark needs to be found.
struct Search {
  Source source;
  std::span<const sim::Vec3> positions;
  const std::vector<sim::Vec3>& obj_vertices;
  const Placement& placement;
};

std::optional<sim::Vec3> point_of(const Value& value, const Search& search) {
  if (const auto numbers = three_numbers(value)) {
    return sim::Vec3((*numbers)[0], (*numbers)[1], (*numbers)[2]);
  }
  const auto index = whole_number(value);
  const bool is_vertex =
      index && *index >= 0 && static_cast<std::size_t>(*index) < search.obj_vertices.size();
  return is_vertex ? std::optional(search.obj_vertices[static_cast<std::size_t>(*index)]) : std::nullopt;
}

sim::Index find_vertex(const std::string& name, const Value& value, const Search& search) {
  const auto point = point_of(value, search);
  if (!point) {
    fail(search.source, value.line,
         fmt::format("landmark {}: found {}, expected a point [x, y, z]{}", name, to_text(value),
                     search.obj_vertices.empty()
                         ? ""
                         : fmt::format(" or a vertex from 0 to {}", search.obj_vertices.size() - 1)));
  }
  const sim::Vec3 scaled = search.placement(*point);
  const auto [vertex, distance_m] = nearest_vertex(search.positions, scaled);
  if (!(distance_m <= same_point_m)) {
    fail(search.source, value.line,
         fmt::format("landmark {}: the garment has no vertex at [{:.6g}, {:.6g}, {:.6g}] m; the nearest is "
                     "{:.3g} m away",
                     name, scaled.x, scaled.y, scaled.z, distance_m));
  }
  return vertex;
}

std::vector<sim::Index> find_vertices(const std::string& name, const ValueList& list, const Search& search) {
  std::vector<sim::Index> found;
  for (const Value& value : list) {
    found.push_back(find_vertex(name, value, search));
  }
  return found;
}

// Landmarks may stand in tables, whose names do not matter.
void collect(const ValueTable& table, const Search& search, Landmarks& landmarks) {
  for (const auto& [name, value] : table) {
    if (value.table() != nullptr) {
      collect(*value.table(), search, landmarks);
    } else if (value.list() != nullptr) {
      landmarks.emplace_back(name, find_vertices(name, *value.list(), search));
    }
  }
}

}  // namespace

std::filesystem::path landmarks_path(const std::filesystem::path& garment) {
  std::filesystem::path path = garment;
  return path.replace_extension(".landmarks.toml");
}

Landmarks read_landmarks(const std::filesystem::path& garment, const Placement& placement,
                         const sim::Mesh& mesh) {
  const std::filesystem::path path = landmarks_path(garment);
  Landmarks landmarks;
  std::error_code error;
  if (!std::filesystem::exists(path, error)) {
    return landmarks;
  }
  const Value file = read_toml(path);
  const bool is_obj = garment.extension() == ".obj" || garment.extension() == ".OBJ";
  const std::vector<sim::Vec3> vertices = is_obj ? obj_vertices(garment) : std::vector<sim::Vec3>{};
  collect(*file.table(), {{path.string(), false}, mesh.positions, vertices, placement}, landmarks);
  return landmarks;
}

}  // namespace taut::app
