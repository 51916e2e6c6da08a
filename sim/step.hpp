#pragma once

#include <span>
#include <vector>

#include "sim/contact/neighbour_list.hpp"
#include "sim/garment.hpp"
#include "sim/pins.hpp"
#include "sim/state.hpp"
#include "sim/surroundings.hpp"

namespace taut::sim {

/// What a step leaves to the solver: how springs answer, as forces before the prediction or as corrections
/// after it.
class SpringResponse {
 public:
  virtual ~SpringResponse() = default;

  /// Adds the forces of the springs in the current state.
  virtual void add_spring_forces(const Garment& garment, const State& state,
                                 std::span<Vec3> forces_n) const = 0;

  /// Corrects the predicted positions.
  virtual void compensate(const Garment& garment, const Pins& pins, State& state) const = 0;
};

/// What steps hand on to each other besides the state.
struct StepBuffers {
  std::vector<Vec3> forces_n;  ///< one per vertex; all zero when a step begins and when it ends
  NeighbourList layers;
};

/// One time step: Steps 2 and 3 of the paper.
void step(const Garment& garment, const Pins& pins, const Surroundings& surroundings,
          const SpringResponse& springs, double time_step_s, State& state, StepBuffers& buffers);

}  // namespace taut::sim
