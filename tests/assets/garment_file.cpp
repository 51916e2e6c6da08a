#include "garment_file.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <stdexcept>

#include "app/base/files.hpp"
#include "app/models/reading/model_arrays.hpp"

namespace taut::test {

sim::Mesh read_obj(const std::filesystem::path& file) {
  const app::ModelArrays model = app::read_obj(app::read_text_file(file)).value();
  sim::Mesh mesh;
  mesh.positions = model.positions;
  for (std::size_t c = 0; c + 2 < model.faces.corners.size(); c += 3) {
    mesh.triangles.push_back({model.faces.corners[c], model.faces.corners[c + 1], model.faces.corners[c + 2]});
  }
  const bool triangles_alone = mesh.triangles.size() == model.faces.corner_counts.size() &&
                               model.faces.corners.size() == 3 * mesh.triangles.size() &&
                               model.ignored_lines + model.ignored_points == 0;
  if (!triangles_alone || !std::is_sorted(model.position_of_vertex.begin(), model.position_of_vertex.end())) {
    throw std::runtime_error(file.string() + ": expected triangles, their vertices in the order of first use");
  }
  return mesh;
}

std::vector<glm::vec2> read_corner_uv(const std::filesystem::path& file) {
  return app::read_obj(app::read_text_file(file)).value().colours.corner_uv;
}

std::map<std::string, std::vector<sim::Index>> read_landmarks(const std::filesystem::path& file) {
  std::map<std::string, std::vector<sim::Index>> landmarks;
  for (const auto& [name, value] : toml::parse_file(file.string())) {
    const toml::array none;
    for (const toml::node& vertex : name == "metres_per_uv" ? none : *value.as_array()) {
      landmarks[std::string(name.str())].push_back(static_cast<sim::Index>(vertex.value<std::int64_t>().value()));
    }
  }
  return landmarks;
}

}  // namespace taut::test
