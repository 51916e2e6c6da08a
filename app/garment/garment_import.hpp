#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/types.hpp"

namespace taut::app {

/// What a model file holds, as flat arrays: all its meshes, where its nodes put them.
struct ImportedModel {
  std::vector<sim::Vec3> positions;  ///< in the file's unit
  std::vector<sim::Triangle> triangles;
  std::string format;  ///< the reader's name for it
  std::size_t meshes = 0;
  std::size_t file_triangles = 0;  ///< faces with three corners
  std::size_t file_quads = 0;      ///< with four, cut in two
  std::size_t file_polygons = 0;   ///< with more, cut in as many as they need
  std::size_t ignored_lines = 0;
  std::size_t ignored_points = 0;
};

/// Reads any model the assimp library can. Throws InputError naming the file and the reason.
ImportedModel import_garment(const std::filesystem::path& path);

}  // namespace taut::app
