#include "sim/solvers/strong.hpp"

namespace taut::sim {

void StrongConstraint::compensate(const Garment& garment, const Pins& pins, State& state) const {
  for (int iteration = 0; iteration < settings_.iterations; ++iteration) {
    compensate_springs(garment.springs, pins.inverse_masses_per_kg, settings_.rigidity, state.predicted);
  }
}

}  // namespace taut::sim
