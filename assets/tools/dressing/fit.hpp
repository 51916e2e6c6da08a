#pragma once

#include <vector>

#include "tailor/dressing/body.hpp"
#include "tailor/sewing/shirt.hpp"

namespace taut::tailor {

/// One phase in which the shirt relaxes on the body.
struct FitPhase {
  int frames;       ///< of 1/60 s
  double flexural;  ///< Fraction of their error that flexural springs correct. More gives a smoother shirt.
  double air_drag_per_s;  ///< more lets the shirt settle sooner
};

/// Lets the shirt find its shape on the body, without gravity, so that it has no folds. Starts at `positions`
/// and uses the simulation's Verlet steps, rigid springs and bodies. Positions are in metres, per vertex
/// of the shirt.
std::vector<Vec3> relax_on_body(const Shirt& shirt, const std::vector<Vec3>& positions, const Stance& stance,
                                const std::vector<FitPhase>& phases);

}  // namespace taut::tailor
