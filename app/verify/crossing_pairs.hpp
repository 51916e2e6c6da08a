#pragma once

#include "sim/mesh/types.hpp"

namespace taut::app {

/// A surface as it is now: positions per vertex, in metres, and triangles.
struct Surface {
  std::span<const sim::Vec3> positions_m;
  std::span<const sim::Triangle> triangles;
};

/// Two triangles that cross.
struct CrossingPair {
  sim::Index first = 0;                ///< index of a triangle of the cloth
  sim::Index second = 0;               ///< of the cloth, then above `first`; or of the body
  sim::Vec3 place_m = sim::Vec3(0.0);  ///< a point that both have, rounded
};

/// Returns all pairs of triangles of the cloth that cross each other (triangle_crossing.hpp), ordered by
/// their indices. Vertices are shared if their indices are equal, wherever they are. Positions must be
/// finite.
std::vector<CrossingPair> crossing_pairs(const Surface& cloth);

/// Returns all pairs of a triangle of the cloth and one of the body that have a point in common, in the same
/// order.
std::vector<CrossingPair> crossing_pairs(const Surface& cloth, const Surface& body);

/// Returns "triangle 7 (vertices 1, 2, 3)".
std::string describe_triangle(const Surface& surface, sim::Index triangle);

/// Returns "2 pairs of triangles cross, the first: triangle 7 (vertices 1, 2, 3) and triangle 9 (vertices 4,
/// 5, 6) at [0.10000, 0.20000, 0.30000] m". The pairs must be of the cloth itself, at least one.
std::string describe(const Surface& cloth, std::span<const CrossingPair> pairs);

/// Returns "[0.10000, 0.20000, 0.30000] m".
std::string describe_place(const sim::Vec3& place_m);

/// Returns "[0.1, 0.2, 0.3]", to six digits, for places in the unit of a file.
std::string describe_point(const sim::Vec3& point);

}  // namespace taut::app
