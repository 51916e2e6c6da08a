#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/models/import_process.hpp"
#include "app/models/model_arrays.hpp"
#include "sim/mesh/types.hpp"

namespace taut::app {

/// What a model file holds, as flat arrays: all its meshes, where its nodes put them.
struct ImportedModel {
  std::vector<sim::Vec3> positions;  ///< in the file's unit, along its axes
  std::vector<sim::Triangle> triangles;
  std::vector<sim::Index> position_of_vertex;  ///< as in ModelArrays
  bool shares_vertices = false;                ///< false: every corner of a face has a position of its own
  std::string format;                          ///< the reader's name for it
  std::size_t meshes = 0;
  std::size_t file_triangles = 0;  ///< faces with three corners
  std::size_t file_quads = 0;      ///< with four, cut in two
  std::size_t file_polygons = 0;   ///< with more, cut in as many as they need
  std::size_t ignored_lines = 0;
  std::size_t ignored_points = 0;
  std::optional<double> metres_per_unit;  ///< where the file or its format says
  std::optional<ModelAxis> up;            ///< where the file or its format says
};

/// A model with more triangles would not fit into memory with its springs.
inline constexpr std::size_t most_triangles = 4'000'000;

/// Reads any model the assimp library can, in a process of its own, and cuts its faces into triangles.
/// Throws InputError naming the file and the reason; Interrupted.
ImportedModel import_garment(const std::filesystem::path& path, const ImportLimits& limits = {});

}  // namespace taut::app
