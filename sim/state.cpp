#include "sim/state.hpp"

#include "sim/bytes.hpp"

namespace taut::sim {
namespace {

std::uint64_t hash_onto(std::uint64_t hash, const std::vector<Vec3>& positions) {
  for (const Vec3& p : positions) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto bytes = little_endian(p[axis]);
      hash = fnv1a(hash, {bytes.data(), bytes.size()});
    }
  }
  return hash;
}

}  // namespace

State make_state(const Garment& garment) {
  State state;
  state.previous = state.current = state.predicted = garment.mesh.positions;
  return state;
}

void rotate_positions(State& state) {
  std::swap(state.previous, state.current);
  std::swap(state.current, state.predicted);
}

void set_time_step(State& state, double time_step_s) {
  assert(time_step_s > 0.0);
  if (state.time_step_s > 0.0 && state.time_step_s != time_step_s) {
    const double ratio = time_step_s / state.time_step_s;
    for (std::size_t v = 0; v < state.current.size(); ++v) {
      state.previous[v] = state.current[v] - (state.current[v] - state.previous[v]) * ratio;
    }
  }
  state.time_step_s = time_step_s;
}

Vec3 velocity(const State& state, Index vertex) {
  assert(vertex < state.current.size());
  if (!(state.time_step_s > 0.0)) return Vec3(0.0);
  return (state.current[vertex] - state.previous[vertex]) / state.time_step_s;
}

std::uint64_t hash(const State& state) { return hash_onto(hash_onto(fnv1a_of_nothing, state.current), state.previous); }

}  // namespace taut::sim
