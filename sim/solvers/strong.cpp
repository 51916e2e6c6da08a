#include "sim/solvers/strong.hpp"

namespace taut::sim {

void StrongConstraint::compensate(const Garment& garment, State& state) const {
  for (int iteration = 0; iteration < iterations_; ++iteration) {
    compensate_springs(garment.springs, garment.inverse_masses_per_kg, rigidity_, state.predicted);
  }
}

}  // namespace taut::sim
