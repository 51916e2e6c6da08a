#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/scene/model_units.hpp"
#include "sim/mesh/types.hpp"

namespace taut::app {

/// A model file as flat arrays: the faces of all its meshes, where its nodes put them.
struct ModelArrays {
  std::vector<sim::Vec3> positions;          ///< in the file's unit, along its axes
  std::vector<std::uint32_t> corner_counts;  ///< of every face, at least 3
  std::vector<sim::Index> corners;           ///< of face after face, positions by number
  /// For each vertex of the file its place in `positions`, where these are in another order; else empty.
  std::vector<sim::Index> position_of_vertex;
  std::string format;  ///< the reader's name for it
  std::size_t meshes = 0;
  std::size_t ignored_lines = 0;
  std::size_t ignored_points = 0;
  std::optional<double> metres_per_unit;  ///< where the file or its format says
  std::optional<ModelAxis> up;            ///< where the file or its format says
};

/// As bytes for another process of this program.
std::string encode(const ModelArrays& model);

/// Throws std::runtime_error where the bytes are not what `encode` makes: every length is compared with what
/// is there, so that no bytes whatsoever can do harm.
ModelArrays decode(const std::string& bytes);

}  // namespace taut::app
