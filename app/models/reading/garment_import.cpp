#include "app/models/reading/garment_import.hpp"

#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/base/words.hpp"
#include "sim/mesh/polygons.hpp"

namespace taut::app {
namespace {

bool is_counting_up(const std::vector<sim::Index>& corners) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (corners[i] != i) return false;
  }
  return true;
}

void require_size(const ModelArrays& arrays) {
  if (arrays.faces.empty()) throw std::invalid_argument("it has no faces");
  const std::size_t triangles = arrays.faces.corners.size() - 2 * arrays.faces.corner_counts.size();
  if (triangles > max_triangles) {
    throw std::invalid_argument(
        fmt::format("it has {} triangles, more than the {} that can be simulated", triangles, max_triangles));
  }
}

/// Renumbers the corners of the faces by the file's vertices.
void number_as_in_file(ImportedModel& model) {
  if (model.position_of_vertex.empty()) return;
  std::vector<sim::Index> number(model.positions.size(), 0);
  for (auto v = static_cast<sim::Index>(model.position_of_vertex.size()); v-- > 0;) {
    number[model.position_of_vertex[v]] = v;
  }
  for (sim::Index& corner : model.faces.corners) corner = number[corner];
}

/// Returns advice on how to save a file so that it can be read: without compression, or as a model if it is none.
std::string expectation(const std::string& reason, const std::filesystem::path& path) {
  std::error_code error;
  const bool is_searched = std::filesystem::file_size(path, error) <= max_text_bytes && !error;
  const std::string bytes = is_searched ? read_text_file(path) : "";
  const auto contains = [&](const char* name) { return bytes.find(name) != std::string::npos; };
  const char* const compression = contains("KHR_draco_mesh_compression") ? "Draco"
                                  : contains("EXT_meshopt_compression")  ? "EXT_meshopt_compression"
                                                                         : nullptr;
  if (compression != nullptr) {
    return fmt::format("; its meshes are compressed with {} in a way that is not read; save it without compression",
                       compression);
  }
  const bool is_no_model =
      reason.find("no reader knows") != std::string::npos || reason.find("has no faces") != std::string::npos;
  return is_no_model ? "; expected a 3D model with faces, such as OBJ, PLY, STL, glTF, FBX or Collada" : "";
}

}  // namespace

ImportedModel to_model(ModelArrays arrays) {
  ImportedModel model{std::move(arrays), {}};
  const std::vector<std::uint32_t>& corner_counts = model.faces.corner_counts;
  const std::vector<sim::Index>& corners = model.faces.corners;
  for (const std::uint32_t count : corner_counts) {
    ++(count == 3 ? model.file_triangles : count == 4 ? model.file_quads : model.file_polygons);
  }
  model.triangles = sim::cut_into_triangles({model.positions, corner_counts, corners});
  model.faces.corner_uv = model.colours.corner_uv;
  model.colours = cut_colours(std::move(model.colours), corner_counts, corners, model.triangles);
  model.shares_vertices = corner_counts.size() == 1 || !is_counting_up(corners);
  number_as_in_file(model);
  return model;
}

ImportedModel to_model(std::vector<sim::Vec3> positions_m, std::vector<std::uint32_t> corner_counts,
                       std::vector<sim::Index> corners) {
  ModelArrays arrays;
  arrays.positions = std::move(positions_m);
  arrays.faces.corner_counts = std::move(corner_counts);
  arrays.faces.corners = std::move(corners);
  arrays.metres_per_unit = 1.0;
  arrays.up = ModelAxis::y;
  number_by_first_use(arrays);
  return to_model(std::move(arrays));
}

ImportedModel import_garment(const std::filesystem::path& path, const ImportLimits& limits, ReadParts parts) {
  require_file(path);
  try {
    ModelArrays arrays = read_model_in_process(path, limits, parts);
    require_size(arrays);
    return to_model(std::move(arrays));
  } catch (const Interrupted&) {
    throw;
  } catch (const std::exception& error) {
    throw InputError("cannot read a model from '" + path.string() + "': " + error.what() +
                     expectation(error.what(), path));
  }
}

}  // namespace taut::app
