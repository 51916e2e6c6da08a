#pragma once

#include <array>
#include <vector>

#include "sim/garment.hpp"

namespace taut::sim::bounded {

/// A flexural spring a-b and the middle of the cloth beneath it: the point where the straight line from a to
/// b crosses the line from a vertex v to one of its neighbours c. In flat cloth that point lies on the
/// spring; where the cloth is bent it leaves it by the deflection
///   delta = (1 - s) x_a + s x_b - (1 - t) x_v - t x_c,   energy = 1/2 B k |delta|^2,
/// with B the bending rigidity. delta is linear in the positions and vanishes for every flat shape, so that
/// bending neither resists shear nor feels how finely the cloth is meshed (in the manner of Bergou,
/// Wardetzky, Harmon, Zorin and Grinspun 2006).
struct FlexuralElement {
  std::array<Index, 4> vertices;  ///< a, b, v, c
  std::array<double, 4> weights;  ///< 1 - s, s, -(1 - t), -t
  double stiffness_per_rigidity;  ///< k, in 1/m^2
};

/// One element for each flexural spring; a spring with nothing beneath it is left out. Over a curvature kappa
/// the line of length l leaves the cloth by kappa s (1 - s) l^2 / 2. Each element stands for its share of the
/// area, and the shares are scaled so that a sheet of any mesh resists cylindrical bending, averaged over its
/// directions, with B per unit width.
std::vector<FlexuralElement> flexural_elements(const Garment& garment);

}  // namespace taut::sim::bounded
