#include "app/models/landmarks.hpp"

#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/scene/scene_file.hpp"
#include "app/scene/scene_key.hpp"
#include "app/verify/crossing_pairs.hpp"

namespace taut::app {
namespace {

// Points closer than this are the same. Files have about six digits, so equal points may differ in the last
// one. A larger value could take a neighbouring vertex, which is millimetres away.
constexpr double same_point_m = 1e-5;

constexpr int most_layers = 8;

// Everything one landmark needs to be found.
struct Search {
  Source source;
  std::span<const sim::Vec3> positions;
  const FileVertices& file_vertices;
  const Placement& placement;
};

sim::Index vertex_at(const std::string& name, const toml::node& value, const sim::Vec3& point, const Search& search) {
  const sim::Vec3 scaled = search.placement(point);
  const auto [vertex, distance_m] = nearest_vertex(search.positions, scaled);
  if (!(distance_m <= same_point_m)) {
    fail(search.source, line_of(value),
         fmt::format("landmark {}: the garment has no vertex at {} m; the nearest is {:.3g} m away", name,
                     describe_point(scaled), distance_m));
  }
  return vertex;
}

sim::Index find_vertex(const std::string& name, const toml::node& value, const Search& search) {
  if (const auto point = three_numbers(value)) {
    return vertex_at(name, value, {(*point)[0], (*point)[1], (*point)[2]}, search);
  }
  const std::optional<std::int64_t> number = whole_number(value);
  if (!number || *number < 0) {
    fail(search.source, line_of(value),
         fmt::format("landmark {}: found {}, expected a point [x, y, z] or one of the {}", name, to_text(value),
                     search.file_vertices.describe()));
  }
  const auto index = static_cast<std::size_t>(*number);
  const std::optional<sim::Index> vertex = search.file_vertices.find(index);
  if (!vertex) {
    fail(search.source, line_of(value), "landmark " + name + ": " + search.file_vertices.why_missing(index));
  }
  return *vertex;
}

std::vector<sim::Index> find_vertices(const std::string& name, const toml::array& list, const Search& search) {
  std::vector<sim::Index> found;
  for (const toml::node& value : list) found.push_back(find_vertex(name, value, search));
  return found;
}

// Landmarks may stand in tables, whose names do not matter.
void collect(const toml::table& table, const Search& search, Landmarks& landmarks) {
  for (const auto& [name, value] : entries_of(table)) {
    if (value->is_table()) {
      collect(*value->as_table(), search, landmarks);
    } else if (value->is_array()) {
      landmarks.emplace_back(name, find_vertices(name, *value->as_array(), search));
    }
  }
}

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
  const auto [lowest, highest] = std::ranges::minmax_element(mesh.positions, by_height);
  const double limit_m = highest->y - top_band_fraction * (highest->y - lowest->y);
  std::vector<sim::Index> band;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (mesh.positions[v].y >= limit_m) band.push_back(static_cast<sim::Index>(v));
  }
  return band;
}

/// The names that a scene can pin: landmarks, corners and edges of a grid, "top-band" (the upper 3 % of
/// the height) and, alone and for a model, "hanger" (hanger.hpp).
std::vector<std::string> pin_names(const PinTargets& targets) {
  std::vector<std::string> names;
  for (const auto& [landmark, vertices] : targets.landmarks) names.push_back(landmark);
  if (targets.grid != nullptr) {
    for (const NamedVertices& part : grid_parts(*targets.grid)) names.emplace_back(part.name);
  }
  names.emplace_back("top-band");
  if (targets.grid == nullptr) names.emplace_back("hanger");
  return names;
}

struct Selection {
  const PinTargets& targets;

  std::vector<sim::Index> operator()(const std::string& name) const {
    for (const auto& [landmark, vertices] : targets.landmarks) {
      if (landmark == name) return vertices;
    }
    for (const NamedVertices& part :
         targets.grid != nullptr ? grid_parts(*targets.grid) : std::vector<NamedVertices>{}) {
      if (part.name == name) return part.vertices;
    }
    if (name == "top-band") return top_band(targets.mesh);
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

Landmarks read_landmarks(const std::filesystem::path& garment, const Placement& placement, const sim::Mesh& mesh,
                         const FileVertices& file_vertices) {
  const std::filesystem::path path = landmarks_path(garment);
  Landmarks landmarks;
  collect(read_landmarks_file(garment), {{path.string(), false}, mesh.positions, file_vertices, placement}, landmarks);
  return landmarks;
}

std::optional<double> known_metres_per_uv(const std::filesystem::path& garment) {
  const std::filesystem::path path = landmarks_path(garment);
  const toml::table file = read_landmarks_file(garment);
  const toml::node* value = file.get("metres_per_uv");
  if (value == nullptr) return std::nullopt;
  const std::optional<double> metres = finite_number(*value);
  if (!metres || !(*metres > 0.0)) {
    fail({path.string(), false}, line_of(*value),
         "metres_per_uv: found " + to_text(*value) + ", expected a number above 0");
  }
  return metres;
}

bool is_at_rest_as_cut(const std::filesystem::path& garment) {
  const std::filesystem::path path = landmarks_path(garment);
  const toml::table file = read_landmarks_file(garment);
  const toml::node* value = file.get("is_cut");
  if (value != nullptr && (!value->is_boolean() || !file.contains("metres_per_uv"))) {
    fail({path.string(), false}, line_of(*value),
         "is_cut: found " + to_text(*value) + ", expected true or false, and metres_per_uv beside it");
  }
  return value != nullptr && value->value_or(false);
}

int garments_worn(const std::filesystem::path& garment) {
  const std::filesystem::path path = landmarks_path(garment);
  const toml::table file = garment.empty() ? toml::table() : read_landmarks_file(garment);
  const toml::node* value = file.get("layers");
  const std::optional<std::int64_t> layers = value == nullptr ? std::optional<std::int64_t>(1) : whole_number(*value);
  if (!layers || *layers < 1 || *layers > most_layers) {
    fail({path.string(), false}, line_of(*value),
         fmt::format("layers: found {}, expected a whole number from 1 to {}", to_text(*value), most_layers));
  }
  return static_cast<int>(*layers);
}

std::vector<std::pair<std::string, std::string>> fabrics_of_layers(const std::filesystem::path& garment) {
  const std::filesystem::path path = landmarks_path(garment);
  const toml::table file = read_landmarks_file(garment);
  const toml::node* value = file.get("fabrics");
  std::vector<std::pair<std::string, std::string>> fabrics;
  if (value == nullptr) return fabrics;
  const Source source = {path.string(), false};
  if (!value->is_table()) fail(source, line_of(*value), "fabrics: expected a table of groups = fabric");
  for (const auto& [group, name] : entries_of(*value->as_table())) {
    const std::optional<std::string> text = text_in(*name);
    if (!text) fail(source, line_of(*name), "fabrics." + group + ": found " + to_text(*name) + ", expected a text");
    fabrics.emplace_back(group, *text);
  }
  return fabrics;
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
