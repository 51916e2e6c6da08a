#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sim/mesh/types.hpp"

namespace taut::sim {

/// Faces with three or more corners.
struct Polygons {
  std::span<const Vec3> positions;
  std::span<const std::uint32_t> corner_counts;  ///< of every face
  std::span<const Index> corners;                ///< of face after face
};

/// A face with more corners than this is no cloth, and cutting it would take minutes.
inline constexpr std::uint32_t most_corners = 5000;

/// Cuts every face into triangles of its own orientation, two fewer than it has corners: concave ones inside
/// their outline, of several ways the one with the fullest triangles. Works on the face's mean plane
/// (Newell), by ears (Meisters 1975). Throws std::invalid_argument on a face of fewer than three or more than
/// `most_corners` corners, on corners that are missing or left over and on a corner that is no position.
std::vector<Triangle> cut_into_triangles(const Polygons& polygons);

}  // namespace taut::sim
