#pragma once

#include "sim/mesh/types.hpp"

namespace taut::sim {

/// Faces with three or more corners.
struct Polygons {
  /// Positions in metres, one per vertex.
  std::span<const Vec3> positions;
  std::span<const std::uint32_t> corner_counts;  ///< one per face
  std::span<const Index> corners;                ///< vertices; the corners of face 0, then of face 1, ...
};

/// Largest number of corners of a face: cutting a larger one would take minutes.
inline constexpr std::uint32_t max_face_corners = 5000;

/// Cuts every face into triangles of the same orientation, two fewer than its corners. Concave faces are cut inside
/// their outline. Nearly equilateral triangles are preferred. Ears are cut off (Meisters 1975) in the face's mean plane
/// (Newell, see Sutherland, Sproull and Schumacker 1974). Throws std::invalid_argument on a face with fewer than three
/// or more than `max_face_corners` corners, on missing or surplus corners and on a corner that is not a position.
std::vector<Triangle> cut_into_triangles(const Polygons& polygons);

}  // namespace taut::sim
