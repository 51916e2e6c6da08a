#pragma once

#include <vector>

#include "tailor/dressing/body.hpp"
#include "tailor/sewing/shirt.hpp"

namespace taut::tailor {

/// How long and how stiffly the shirt relaxes on the body.
struct FitPhase {
  int frames;             ///< of 1/60 s
  double flexural;        ///< share of their error that flexural springs correct: more is smoother
  double air_drag_per_s;  ///< more settles sooner
};

/// Lets the shirt find its shape on the body, without gravity: folds are the business of a scene. Vertices
/// move from `positions` by the simulation's Verlet steps, rigid springs and colliders.
std::vector<Vec3> relax_on_body(const Shirt& shirt, const std::vector<Vec3>& positions, const Stance& stance,
                                const std::vector<FitPhase>& phases);

}  // namespace taut::tailor
