#pragma once

#include "sim/garment.hpp"

namespace taut::sim {

/// The indices of two triangles that cross.
using TrianglePair = std::array<Index, 2>;

/// The end of an edge that has come through.
enum class WrongEnd { unknown, first, second };

/// An edge that goes through a triangle.
struct Piercing {
  Index edge = 0;
  Index triangle = 0;
  /// The line along which the surfaces cross that it lies on: piercings of pairs of triangles that hang
  /// together have one number.
  Index contour = 0;
  double along = 0.0;              ///< where on the edge, 0 at its first end to 1
  Vec3 weights{0.0};               ///< where in the triangle, in parts of its corners
  Vec3 normal{0.0};                ///< of the triangle, of length 1, to the side of the edge's first end
  bool first_is_in_front = false;  ///< the edge's first end is on the side of the triangle's front
  bool is_opposed = false;         ///< the surface of the edge runs along the triangle and faces the other way
  /// A contour that parts the cloth cuts off the smaller part, as in the flood fill of Baraff, Witkin and
  /// Kass (2003), "Untangling cloth", but only if its triangles agree on the way out: where a tube goes
  /// through a sheet they do around the tube's end, and not around the round piece of the sheet within the
  /// tube.
  WrongEnd wrong = WrongEnd::unknown;
};

/// The segments in which pairs of triangles cross.
struct Contours {
  std::vector<Piercing> piercings;     ///< ordered by contour, edge and triangle
  std::vector<TrianglePair> touching;  ///< pairs of which no edge goes through the other
};

/// `positions_m` has one entry per vertex.
Contours find_contours(const Garment& garment, std::span<const TrianglePair> pairs, std::span<const Vec3> positions_m);

/// Returns whether what contours cut off is more often in front of surfaces that face the other way than
/// behind them: then these are walls whose backs belong together.
bool are_walls(std::span<const Piercing> piercings);

/// Takes ends in front of surfaces that face the other way to be wrong, whatever contours cut off.
void take_sides_of_walls(std::span<Piercing> piercings);

/// A vertex and a triangle, or two edges, that are near each other.
struct Gap {
  std::array<Index, 4> vertices{};
  std::array<double, 4> weights{};  ///< of the vertices where the two are nearest, below 0 for the second thing
  Vec3 apart{0.0};                  ///< from the second thing to the first, of length 1
  double width_m = 0.0;
};

/// Returns all that are narrower than `width_m`, or than `joined_width_m` where an edge joins the two, but
/// for those that touch. `positions_m` has one entry per vertex.
std::vector<Gap> find_gaps(const Garment& garment, double width_m, double joined_width_m,
                           std::span<const Vec3> positions_m);

}  // namespace taut::sim
