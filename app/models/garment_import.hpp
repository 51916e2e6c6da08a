#pragma once

#include "app/models/import_process.hpp"

namespace taut::app {

/// A model file as triangles too. Its faces have the file's numbers of vertices and their texture coordinates, and its
/// colours are those of the triangles.
struct ImportedModel : ModelArrays {
  std::vector<sim::Triangle> triangles;
  bool shares_vertices = false;    ///< false: each corner of a face has its own position
  std::size_t file_triangles = 0;  ///< faces with three corners
  std::size_t file_quads = 0;      ///< faces with four corners; each was cut in two
  std::size_t file_polygons = 0;   ///< faces with more corners, which were cut into triangles
};

/// Limit on the triangles of a model. More would not fit into memory with their springs.
inline constexpr std::size_t most_triangles = 4'000'000;

/// Reads a model in a child process (import_process.hpp) and cuts its faces into triangles. Takes OBJ and
/// every format of the assimp library. Throws InputError that names the file and the reason; Interrupted.
ImportedModel import_garment(const std::filesystem::path& path, const ImportLimits& limits = {},
                             ReadParts parts = ReadParts::shape);

/// The model of arrays whose faces have three corners and more, which are cut. Throws std::invalid_argument
/// as sim::cut_into_triangles() does.
ImportedModel model_of(ModelArrays arrays);

/// The same of a mesh that no file holds, in metres with y up, as if it were read from an OBJ.
ImportedModel model_of(std::vector<sim::Vec3> positions_m, std::vector<std::uint32_t> corner_counts,
                       std::vector<sim::Index> corners);

}  // namespace taut::app
