#pragma once

#include <string>
#include <vector>

#include "sim/mesh/mesh.hpp"

namespace taut::tailor {

using sim::Vec3;

/// A measurement of a body: a tape around its section with a plane.
struct Tape {
  std::string name;
  std::size_t chain = 0;
  Vec3 point_m = Vec3(0.0);  ///< point in the plane and inside the part
  Vec3 normal = Vec3(0.0, 1.0, 0.0);
  double girth_m = 0.0;  ///< target
};

/// Returns the length in metres of a tight tape in the plane around the part that contains the point: the convex hull
/// of the section's closed curve there. Throws std::runtime_error if the plane cuts nothing around the point.
double girth_m(const sim::Mesh& mesh, const Tape& tape);

}  // namespace taut::tailor
