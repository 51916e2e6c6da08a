#pragma once

#include "sim/garment.hpp"

namespace taut::sim::bounded {

/// A flexural spring a-b and the middle of the cloth below it. That is the point where the line from a to b
/// crosses the line from a vertex v to one of its neighbours c. In flat cloth the point lies on the spring.
/// In bent cloth it is away from the spring by the deflection
///   delta = (1 - s) x_a + s x_b - (1 - t) x_v - t x_c,   energy = 1/2 B k |delta|^2,
/// with the bending rigidity B. delta is linear in the positions and zero in every flat shape. So bending
/// does not resist shear and does not depend on how fine the mesh is (similar to Bergou, Wardetzky, Harmon,
/// Zorin and Grinspun 2006).
struct FlexuralElement {
  std::array<Index, 4> vertices;  ///< a, b, v, c
  std::array<double, 4> weights;  ///< 1 - s, s, -(1 - t), -t
  double stiffness_per_rigidity;  ///< k, in 1/m^2
};

/// Returns one element per flexural spring; a spring without cloth below it has none. Under a curvature kappa
/// the middle is kappa s (1 - s) l^2 / 2 away from a line of length l. Each element stands for a share of the
/// cloth's area. The shares are scaled so that a sheet of any mesh resists cylindrical bending with B per
/// unit width, averaged over all directions.
std::vector<FlexuralElement> flexural_elements(const Garment& garment);

}  // namespace taut::sim::bounded
