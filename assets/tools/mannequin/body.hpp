#pragma once

#include "tailor/mannequin/recipe.hpp"
#include "tailor/mannequin/tape.hpp"

namespace taut::tailor {

/// A joint of a body's skeleton. Its parent stands before it.
struct Joint {
  std::string name;
  int parent = -1;  ///< index, -1 for the root
  Vec3 place_m = Vec3(0.0);
  JointRecipe recipe;
  std::size_t chain = 0;
  bool is_right = false;  ///< the mirror image of a joint on the left
};

/// A body of one size: its solid, where it is measured, and its skeleton.
struct Body {
  Shape shape;
  std::vector<Tape> tapes;
  Vec3 shoulder_tip_m = Vec3(0.0);  ///< the surface's highest point at this x shall be at this y
  std::vector<Joint> joints;
};

/// Returns the body of these measurements, whose girths are only about right. Throws std::runtime_error that
/// names a measurement that is missing, or a chain or a parent that is unknown.
Body make_body(const ShapeRecipe& recipe, const Measurements& reference, const Measurements& sized);

/// The result of a fit.
struct FittedBody {
  sim::Mesh half;   ///< the left half of the surface
  sim::Mesh whole;  ///< its first vertices are those of the half
  double worst_error_m = 0.0;
};

/// Meshes the body and scales its sections until every tape finds its girth on the mesh and the shoulders are
/// at their height, to 0.2 mm. Throws std::runtime_error if that fails.
FittedBody fit(Body& body);

}  // namespace taut::tailor
