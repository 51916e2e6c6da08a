#pragma once

#include <vector>

#include "sim/garment.hpp"

namespace taut::sim {

/// What a garment is held by.
struct Pins {
  std::vector<Index> vertices;                ///< ascending, each once
  std::vector<double> inverse_masses_per_kg;  ///< by vertex; 0 where pinned: a pinned end has infinite mass
};

/// Holds the garment by these vertices, in any order.
/// Throws std::invalid_argument on one that is no vertex of the garment.
Pins make_pins(const Garment& garment, std::vector<Index> vertices);

}  // namespace taut::sim
