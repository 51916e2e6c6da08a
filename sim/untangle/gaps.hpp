#pragma once

#include <array>
#include <span>
#include <vector>

#include "sim/garment.hpp"

namespace taut::sim {

/// A vertex and a triangle, or two edges, that are near each other.
struct Gap {
  std::array<Index, 4> vertices{};
  std::array<double, 4>
      weights{};    ///< of the vertices where the two are nearest, below 0 for the second thing
  Vec3 apart{0.0};  ///< from the second thing to the first, of length 1
  double width_m = 0.0;
};

/// Returns all that are narrower than `width_m`, or than `joined_width_m` where an edge joins the two, but
/// for those that touch. `positions_m` has one entry per vertex.
std::vector<Gap> find_gaps(const Garment& garment, double width_m, double joined_width_m,
                           std::span<const Vec3> positions_m);

}  // namespace taut::sim
