#pragma once

#include <string>
#include <vector>

#include "sim/mesh/mesh.hpp"

namespace taut::tailor {

using sim::Vec3;

/// A place where a body is measured: a tape around what the plane cuts there.
struct Tape {
  std::string name;
  std::size_t chain = 0;
  Vec3 point_m = Vec3(0.0);  ///< in the plane and inside of the part
  Vec3 normal = Vec3(0.0, 1.0, 0.0);
  double girth_m = 0.0;  ///< as it shall be
};

/// Returns the length of a tight tape in the plane around the part that holds the point, in metres: of the
/// convex hull of the section's closed curve there. Throws std::runtime_error where the plane cuts nothing
/// around it.
double girth_m(const sim::Mesh& mesh, const Tape& tape);

}  // namespace taut::tailor
