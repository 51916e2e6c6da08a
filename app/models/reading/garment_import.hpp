#pragma once

#include "app/models/reading/import_process.hpp"

namespace taut::app {

/// A model file with its triangles. Its faces have the file's numbers of vertices and their texture coordinates; its
/// colours are per triangle.
struct ImportedModel : ModelArrays {
  std::vector<sim::Triangle> triangles;
  bool shares_vertices = false;    ///< false if each corner of a face has its own position
  std::size_t file_triangles = 0;  ///< faces with three corners
  std::size_t file_quads = 0;      ///< faces with four corners; each was cut in two
  std::size_t file_polygons = 0;   ///< faces with more corners, which were cut into triangles
};

/// Limit on the triangles of a model. More of them would not fit into memory with their springs.
inline constexpr std::size_t max_triangles = 4'000'000;

/// Reads a model in a child process (import_process.hpp) and cuts its faces into triangles. Takes OBJ and
/// every format of the assimp library. Throws InputError that names the file and the reason; Interrupted.
ImportedModel import_garment(const std::filesystem::path& path, const ImportLimits& limits = {},
                             ReadParts parts = ReadParts::shape);

/// Returns the model of arrays whose faces have at least three corners, and cuts its faces into triangles. Throws
/// std::invalid_argument as sim::cut_into_triangles() does.
ImportedModel to_model(ModelArrays arrays);

/// Returns the model of a mesh without a file, in metres with y up, as if it were read from an OBJ.
ImportedModel to_model(std::vector<sim::Vec3> positions_m, std::vector<std::uint32_t> corner_counts,
                       std::vector<sim::Index> corners);

}  // namespace taut::app
