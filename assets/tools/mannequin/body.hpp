#pragma once

#include "tailor/mannequin/recipe.hpp"
#include "tailor/mannequin/tape.hpp"

namespace taut::tailor {

/// Joint of a body's skeleton. Its parent comes before it.
struct Joint {
  std::string name;
  int parent = -1;  ///< parent's index; -1: the root
  Vec3 place_m = Vec3(0.0);
  JointRecipe recipe;
  std::size_t chain = 0;
  bool is_right = false;  ///< mirror image of a joint on the left
};

/// A body of one size: its solid, its tapes and its skeleton.
struct Body {
  Shape shape;
  std::vector<Tape> tapes;
  Vec3 shoulder_tip_m = Vec3(0.0);  ///< target for the surface's highest point at this x
  std::vector<Joint> joints;
};

/// Returns the body of these measurements, whose girths are only approximate. Throws std::runtime_error that names a
/// missing measurement, or an unknown chain or parent.
Body make_body(const ShapeRecipe& recipe, const Measurements& reference, const Measurements& sized);

/// Result of a fit.
struct FittedBody {
  sim::Mesh half;   ///< left half of the surface
  sim::Mesh whole;  ///< begins with the vertices of the half
  double worst_error_m = 0.0;
};

/// Meshes the body and scales its sections until all girths of the mesh and the height of the shoulders are right to
/// 0.2 mm. Throws std::runtime_error if that fails.
FittedBody fit(Body& body);

}  // namespace taut::tailor
