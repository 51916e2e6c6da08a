#include "app/models/pins.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

#include "app/base/errors.hpp"
#include "app/base/suggest.hpp"

namespace taut::app {
namespace {

// Height of "top-band" as a fraction of the garment's height.
constexpr double top_band_fraction = 0.03;

struct NamedVertices {
  const char* name;
  std::vector<sim::Index> vertices;
};

std::vector<NamedVertices> grid_parts(const sim::GridSettings& grid) {
  const sim::Index columns = grid.columns;
  const sim::Index last_row = (grid.rows - 1) * columns;
  std::vector<sim::Index> top, bottom;
  for (sim::Index c = 0; c < columns; ++c) {
    top.push_back(c);
    bottom.push_back(last_row + c);
  }
  return {{"top-left", {0}},           {"top-right", {columns - 1}},
          {"bottom-left", {last_row}}, {"bottom-right", {last_row + columns - 1}},
          {"top-edge", top},           {"bottom-edge", bottom}};
}

std::vector<sim::Index> top_band(const sim::Mesh& mesh) {
  const auto by_height = [](const sim::Vec3& a, const sim::Vec3& b) { return a.y < b.y; };
  const auto [lowest, highest] = std::minmax_element(mesh.positions.begin(), mesh.positions.end(), by_height);
  const double limit_m = highest->y - top_band_fraction * (highest->y - lowest->y);
  std::vector<sim::Index> band;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (mesh.positions[v].y >= limit_m) {
      band.push_back(static_cast<sim::Index>(v));
    }
  }
  return band;
}

struct Selection {
  const PinTargets& targets;

  std::vector<sim::Index> operator()(const std::string& name) const {
    for (const auto& [landmark, vertices] : targets.landmarks) {
      if (landmark == name) {
        return vertices;
      }
    }
    for (const NamedVertices& part :
         targets.grid != nullptr ? grid_parts(*targets.grid) : std::vector<NamedVertices>{}) {
      if (part.name == name) {
        return part.vertices;
      }
    }
    if (name == "top-band") {
      return top_band(targets.mesh);
    }
    const std::vector<std::string> names = pin_names(targets);
    throw InputError(std::string(targets.key) + ": the garment has no part named '" + name + '\'' +
                     did_you_mean(name, names) + " (it has: " + joined(names) + ')');
  }

  std::vector<sim::Index> operator()(sim::Index number) const {
    const std::optional<sim::Index> vertex = targets.file_vertices.find(number);
    if (!vertex) {
      throw InputError(std::string(targets.key) + ": " + targets.file_vertices.why_missing(number));
    }
    return {*vertex};
  }

  std::vector<sim::Index> operator()(const NearestTo& nearest) const {
    return {nearest_vertex(targets.mesh.positions, nearest.point_m).vertex};
  }
};

}  // namespace

NearestVertex nearest_vertex(std::span<const sim::Vec3> positions, const sim::Vec3& point_m) {
  NearestVertex best{0, std::numeric_limits<double>::infinity()};
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const double distance_m = glm::distance(positions[v], point_m);
    if (distance_m < best.distance_m) {
      best = {static_cast<sim::Index>(v), distance_m};
    }
  }
  return best;
}

std::vector<std::string> pin_names(const PinTargets& targets) {
  std::vector<std::string> names;
  for (const auto& [landmark, vertices] : targets.landmarks) {
    names.push_back(landmark);
  }
  if (targets.grid != nullptr) {
    for (const NamedVertices& part : grid_parts(*targets.grid)) {
      names.emplace_back(part.name);
    }
  }
  names.emplace_back("top-band");
  if (targets.grid == nullptr) {
    names.emplace_back("hanger");
  }
  return names;
}

std::vector<sim::Index> select_pins(const std::optional<std::vector<PinSelector>>& pins,
                                    const PinTargets& targets) {
  const std::vector<PinSelector> top = {std::string(targets.grid != nullptr ? "top-edge" : "top-band")};
  std::vector<sim::Index> selected;
  for (const PinSelector& pin : pins.value_or(top)) {
    const std::vector<sim::Index> vertices = std::visit(Selection{targets}, pin);
    selected.insert(selected.end(), vertices.begin(), vertices.end());
  }
  return selected;
}

}  // namespace taut::app
