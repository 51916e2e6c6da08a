#pragma once

#include <cstdint>
#include <vector>

#include "sim/garment.hpp"
#include "sim/mesh/types.hpp"

namespace taut::sim {

/// Where the cloth is: the paper's three position arrays. No velocity is stored; it is the difference of two
/// positions over the time step. Positions in metres, one per vertex.
struct State {
  std::vector<Vec3> previous;   ///< p(t - dt)
  std::vector<Vec3> current;    ///< p(t)
  std::vector<Vec3> predicted;  ///< p(t + dt) while a step is under way
  double time_s = 0.0;
  double time_step_s = 0.0;  ///< the dt between previous and current; 0 before the first step
  std::uint64_t step_count = 0;

  int quiet_frames = 0;  ///< of those in which rest is judged
  bool asleep = false;   ///< at rest: nothing is computed until something changes
};

/// The garment at rest where it was modelled: p(t + dt) = p(t) = p(t - dt) (Step 1 of the paper).
State make_state(const Garment& garment);

/// The predicted positions become the current ones; three pointers change places and nothing is copied.
void rotate_positions(State& state);

/// Keeps every vertex's velocity where the time step changes from one step to the next.
void set_time_step(State& state, double time_step_s);

/// p(t) - p(t - dt) over dt, in m/s; zero before the first step.
Vec3 velocity(const State& state, Index vertex);

/// 64-bit FNV-1a over the bytes of the current and the previous positions: equal hashes mean the same
/// state, bit for bit.
std::uint64_t hash(const State& state);

}  // namespace taut::sim
