#include "app/models/hanging/landmarks.hpp"

#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/base/words.hpp"
#include "app/models/hanging/tuning.hpp"
#include "app/scene/scene_format.hpp"
#include "sim/mesh/extent.hpp"

namespace taut::app {

using namespace hanging;

namespace {

/// Keys of the file beside a garment.
std::vector<Key<GarmentFacts>> keys_of_facts(bool has_scale) {
  using F = GarmentFacts;
  const auto read_cut = [has_scale](const toml::node& value, const Source&, F& facts) {
    return has_scale && store(value.value_exact<bool>(), facts.is_cut);
  };
  const auto read_fabrics = [](const toml::node& value, const Source& source, F& facts) {
    if (!value.is_table()) return false;
    for (const auto& [group, name] : list_entries(*value.as_table())) {
      const std::optional<std::string> text = text_in(*name);
      if (!text)
        fail(source, line_number(*name), "fabrics." + group + ": found " + to_text(*name) + ", expected a text");
      facts.fabrics.emplace_back(group, *text);
    }
    return true;
  };
  return {number_key<F>("metres_per_unit", "m", positive, MEMBER(metres_per_unit)),
          up_key<F>("up", MEMBER(up)),
          number_key<F>("metres_per_uv", "", positive, MEMBER(metres_per_uv)),
          {"is_cut", "", "true or false, and metres_per_uv beside it", read_cut, {}},
          whole_key<F>("layers", {1, 8}, MEMBER(layers)),
          {"fabrics", "", "a table of groups = fabric", read_fabrics, {}}};
}

// Data for finding the vertices of a landmark.
struct LandmarkSearch {
  Source source;
  std::span<const sim::Vec3> positions;
  const FileVertices& file_vertices;
  const Placement& placement;
};

sim::Index vertex_at(const std::string& name, const toml::node& value, const sim::Vec3& point,
                     const LandmarkSearch& search) {
  const sim::Vec3 scaled = search.placement(point);
  const auto [vertex, distance_m] = nearest_vertex(search.positions, scaled);
  if (!(distance_m <= max_landmark_distance_m)) {
    fail(search.source, line_number(value),
         fmt::format("landmark {}: the garment has no vertex at {} m; the nearest is {:.3g} m away", name,
                     describe_point(scaled), distance_m));
  }
  return vertex;
}

sim::Index find_vertex(const std::string& name, const toml::node& value, const LandmarkSearch& search) {
  if (const auto point = numbers_in<3>(value)) {
    return vertex_at(name, value, {(*point)[0], (*point)[1], (*point)[2]}, search);
  }
  const std::optional<std::int64_t> number = whole_number(value);
  if (!number || *number < 0) {
    fail(search.source, line_number(value),
         fmt::format("landmark {}: found {}, expected a point [x, y, z] or one of the {}", name, to_text(value),
                     search.file_vertices.describe()));
  }
  const auto index = static_cast<std::size_t>(*number);
  const std::optional<sim::Index> vertex = search.file_vertices.find(index);
  if (!vertex) {
    fail(search.source, line_number(value), "landmark " + name + ": " + search.file_vertices.why_missing(index));
  }
  return *vertex;
}

// Landmarks may be in tables, whose names do not matter.
void collect(const toml::table& table, const LandmarkSearch& search, Landmarks& landmarks) {
  for (const auto& [name, value] : list_entries(table)) {
    if (value->is_table()) {
      collect(*value->as_table(), search, landmarks);
    } else if (value->is_array()) {
      std::vector<sim::Index>& found = landmarks.emplace_back(name, std::vector<sim::Index>{}).second;
      for (const toml::node& item : *value->as_array()) found.push_back(find_vertex(name, item, search));
    }
  }
}

Landmarks grid_parts(const sim::GridSettings& grid) {
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
  const sim::Extent box = sim::compute_extent(mesh.positions);
  const double limit_m = box.upper.y - pinned_band_fraction * box.size().y;
  std::vector<sim::Index> band;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (mesh.positions[v].y >= limit_m) band.push_back(static_cast<sim::Index>(v));
  }
  return band;
}

/// Returns the parts that a scene can pin by their names: landmarks, corners and edges of a grid, and "top-band" (the
/// upper 3 % of the height).
Landmarks named_parts(const PinTargets& targets) {
  Landmarks parts = targets.landmarks;
  const Landmarks of_grid = targets.grid != nullptr ? grid_parts(*targets.grid) : Landmarks{};
  parts.insert(parts.end(), of_grid.begin(), of_grid.end());
  parts.emplace_back("top-band", top_band(targets.mesh));
  return parts;
}

struct Selection {
  const PinTargets& targets;

  std::vector<sim::Index> operator()(const std::string& name) const {
    std::vector<std::string> names;
    for (const auto& [known, vertices] : named_parts(targets)) {
      if (known == name) return vertices;
      names.push_back(known);
    }
    // The name "hanger" stands alone, and for a model only (hanger.hpp).
    if (targets.grid == nullptr) names.emplace_back("hanger");
    throw InputError(std::string(targets.key) + ": the garment has no part named '" + name + '\'' +
                     did_you_mean(name, names) + " (it has: " + join(names) + ')');
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

Landmarks read_landmarks(const std::filesystem::path& garment, const Placement& placement, const sim::Mesh& mesh,
                         const FileVertices& file_vertices) {
  Landmarks landmarks;
  collect(read_landmarks_file(garment),
          {{landmarks_path(garment).string(), false}, mesh.positions, file_vertices, placement}, landmarks);
  return landmarks;
}

GarmentFacts read_garment_facts(const std::filesystem::path& garment) {
  GarmentFacts facts;
  const toml::table file = garment.empty() ? toml::table() : read_landmarks_file(garment);
  const Source source{landmarks_path(garment).string(), false};
  const std::vector<Key<GarmentFacts>> keys = keys_of_facts(file.contains("metres_per_uv"));
  KeyReader reader(keys, source, facts);
  for (const Key<GarmentFacts>& key : keys) {
    if (const toml::node* value = file.get(key.name)) reader.read_value(key.name, *value);
  }
  return facts;
}

NearestVertex nearest_vertex(std::span<const sim::Vec3> positions, const sim::Vec3& point_m) {
  NearestVertex best{0, std::numeric_limits<double>::infinity()};
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const double distance_m = glm::distance(positions[v], point_m);
    if (distance_m < best.distance_m) best = {static_cast<sim::Index>(v), distance_m};
  }
  return best;
}

std::vector<sim::Index> select_pins(const std::optional<std::vector<PinSelector>>& pins, const PinTargets& targets) {
  const std::vector<PinSelector> top = {std::string(targets.grid != nullptr ? "top-edge" : "top-band")};
  std::vector<sim::Index> selected;
  for (const PinSelector& pin : pins.value_or(top)) {
    const std::vector<sim::Index> vertices = std::visit(Selection{targets}, pin);
    selected.insert(selected.end(), vertices.begin(), vertices.end());
  }
  return selected;
}

}  // namespace taut::app
