#pragma once

#include "sim/garment.hpp"

namespace taut::sim {

/// Vertices that do not move freely.
struct Pins {
  std::vector<Index> vertices;                ///< ascending, each once
  std::vector<double> inverse_masses_per_kg;  ///< per vertex; 0 at a pin, whose mass is infinite
};

/// Pins the garment at `vertices`, which may be in any order and may repeat. Throws std::invalid_argument if
/// one of them is not a vertex of the garment.
Pins make_pins(const Garment& garment, std::vector<Index> vertices);

}  // namespace taut::sim
