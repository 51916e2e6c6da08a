#include "app/models/garment_import.hpp"

#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/base/words.hpp"
#include "sim/mesh/polygons.hpp"

namespace taut::app {
namespace {

void count_faces(const ModelArrays& arrays, ImportedModel& model) {
  for (const std::uint32_t corners : arrays.corner_counts) {
    ++(corners == 3 ? model.file_triangles : corners == 4 ? model.file_quads : model.file_polygons);
  }
}

bool is_counting_up(const std::vector<sim::Index>& corners) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (corners[i] != i) return false;
  }
  return true;
}

void require_size(const ModelArrays& arrays) {
  if (arrays.corner_counts.empty()) throw std::invalid_argument("it has no faces");
  const std::size_t triangles = arrays.corners.size() - 2 * arrays.corner_counts.size();
  if (triangles > most_triangles) {
    throw std::invalid_argument(
        fmt::format("it has {} triangles, more than the {} that can be simulated", triangles, most_triangles));
  }
}

/// The faces with the file's numbers of vertices.
FileFaces faces_in_file(ModelArrays& arrays) {
  if (!arrays.position_of_vertex.empty()) {
    std::vector<sim::Index> number(arrays.positions.size(), 0);
    for (auto v = static_cast<sim::Index>(arrays.position_of_vertex.size()); v-- > 0;) {
      number[arrays.position_of_vertex[v]] = v;
    }
    for (sim::Index& corner : arrays.corners) corner = number[corner];
  }
  return {
      std::move(arrays.corner_counts), std::move(arrays.corners), {}, std::move(arrays.sections), arrays.has_normals};
}

/// Other readable formats: for those who chose another kind of file. To others it would say nothing.
std::string expectation(const std::string& reason) {
  const bool is_no_model =
      reason.find("no reader knows") != std::string::npos || reason.find("has no faces") != std::string::npos;
  return is_no_model ? "; expected a 3D model with faces, such as OBJ, PLY, STL, glTF, FBX or Collada" : "";
}

}  // namespace

ImportedModel model_of(ModelArrays arrays) {
  ImportedModel model;
  count_faces(arrays, model);
  model.triangles = sim::cut_into_triangles({arrays.positions, arrays.corner_counts, arrays.corners});
  std::vector<glm::vec2> corner_uv = arrays.colours.corner_uv;
  model.colours = cut_colours(std::move(arrays.colours), arrays.corner_counts, arrays.corners, model.triangles);
  model.shares_vertices = arrays.corner_counts.size() == 1 || !is_counting_up(arrays.corners);
  model.faces = faces_in_file(arrays);
  model.faces.corner_uv = std::move(corner_uv);
  model.positions = std::move(arrays.positions);
  model.position_of_vertex = std::move(arrays.position_of_vertex);
  model.format = std::move(arrays.format);
  model.meshes = arrays.meshes;
  model.ignored_lines = arrays.ignored_lines;
  model.ignored_points = arrays.ignored_points;
  model.metres_per_unit = arrays.metres_per_unit;
  model.up = arrays.up;
  model.rig = std::move(arrays.rig);
  return model;
}

ImportedModel model_of(std::vector<sim::Vec3> positions_m, std::vector<std::uint32_t> corner_counts,
                       std::vector<sim::Index> corners) {
  ModelArrays arrays;
  arrays.positions = std::move(positions_m);
  arrays.corner_counts = std::move(corner_counts);
  arrays.corners = std::move(corners);
  arrays.metres_per_unit = 1.0;
  arrays.up = ModelAxis::y;
  number_by_first_use(arrays);
  return model_of(std::move(arrays));
}

ImportedModel import_garment(const std::filesystem::path& path, const ImportLimits& limits, ReadParts parts) {
  require_file(path);
  try {
    ModelArrays arrays = read_model_in_process(path, limits, parts);
    require_size(arrays);
    return model_of(std::move(arrays));
  } catch (const Interrupted&) {
    throw;
  } catch (const std::exception& error) {
    const std::string cause = why_unreadable(path);
    throw InputError("cannot read a model from '" + path.string() +
                     "': " + (cause.empty() ? error.what() + expectation(error.what()) : cause));
  }
}

}  // namespace taut::app
