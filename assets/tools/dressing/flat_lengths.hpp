#pragma once

#include <utility>
#include <vector>

#include "sim/garment.hpp"
#include "tailor/sewing/shirt.hpp"

namespace taut::tailor {

/// How much the edges of the fitted shirt differ from the flat pieces: length / flat length - 1. It covers
/// all edges of all pieces; an edge of a seam counts once for each piece.
struct Strain {
  double root_mean_square = 0.0;
  double worst = 0.0;  ///< the largest magnitude
};

/// Measures it for positions in metres, per vertex of the shirt.
Strain measure_strain(const Shirt& shirt, const std::vector<Vec3>& positions);

/// The shirt as a garment of the simulation that is at rest when its pieces lie flat. A structural spring is
/// as long as the edge on the piece, or the mean of two at a seam. There is a flexural spring across every
/// interior edge, as long as with both triangles in one plane.
sim::Garment make_flat_garment(const Shirt& shirt, const std::vector<Vec3>& positions);

}  // namespace taut::tailor
