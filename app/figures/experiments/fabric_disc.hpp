#pragma once

#include <cstdint>
#include <vector>

#include "sim/mesh/mesh.hpp"

namespace taut::app {

/// How a disc of cloth is divided into triangles: irregularly, and otherwise with another seed.
struct DiscMesh {
  double edge_m = 0.0;  ///< about; above 0
  std::uint64_t seed = 0;
};

/// A level disc around the origin, its outside up. Vertices lie at `edge_m` around two circles: that of
/// `inner_radius_m`, along which it is clamped, and its border. Between them they are scattered, and joined
/// as Delaunay has it (Bowyer 1981; Watson 1981).
sim::Mesh make_disc(double inner_radius_m, double radius_m, const DiscMesh& mesh);

}  // namespace taut::app
