#pragma once

#include <utility>
#include <vector>

#include "sim/garment.hpp"
#include "tailor/sewing/shirt.hpp"

namespace taut::tailor {

/// How far the fitted shirt is from the flat cloth, over all edges of all pieces (a seam edge counts once for
/// each piece): length / flat length - 1.
struct Strain {
  double root_mean_square = 0.0;
  double worst = 0.0;  ///< the largest magnitude
};

Strain measure_strain(const Shirt& shirt, const std::vector<Vec3>& positions);

/// The shirt as a garment of the simulation whose springs are at rest where the pieces lie flat: structural
/// springs as long as on the pieces (the mean of two at a seam), flexural springs across every interior edge
/// as long as when its two triangles are unfolded.
sim::Garment make_flat_garment(const Shirt& shirt, const std::vector<Vec3>& positions);

}  // namespace taut::tailor
