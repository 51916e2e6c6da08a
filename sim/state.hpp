#pragma once

#include "sim/garment.hpp"
#include "sim/mesh/types.hpp"

namespace taut::sim {

/// The paper's three arrays of positions, in metres, one entry per vertex. The velocity is not stored: it is the
/// difference of two positions divided by the time step.
struct State {
  std::vector<Vec3> previous;    ///< p(t - dt)
  std::vector<Vec3> current;     ///< p(t)
  std::vector<Vec3> predicted;   ///< p(t + dt), during a step
  double time_s = 0.0;           ///< simulated time t
  double time_step_s = 0.0;      ///< dt from previous to current; 0 before the first step
  std::uint64_t step_count = 0;  ///< number of time steps so far

  int quiet_frames = 0;  ///< number of frames in a row slow enough to fall asleep
  bool asleep = false;   ///< the cloth is at rest: nothing is computed until something changes
};

/// Returns the garment at rest in its modelled shape: p(t + dt) = p(t) = p(t - dt) (Step 1 of the paper).
State make_state(const Garment& garment);

/// Makes the predicted positions the current ones and the current ones the previous ones. Only pointers are
/// swapped; nothing is copied.
void rotate_positions(State& state);

/// Sets the time step and adjusts the previous positions so that no velocity changes.
void set_time_step(State& state, double time_step_s);

/// Returns (p(t) - p(t - dt)) / dt of one vertex, in m/s; zero before the first step.
Vec3 velocity(const State& state, Index vertex);

/// Returns the 64-bit FNV-1a hash of the bytes of the current and the previous positions. Use it to compare
/// states bit for bit.
std::uint64_t hash(const State& state);

}  // namespace taut::sim
