#include "sim/state.hpp"

#include <bit>
#include <utility>

namespace taut::sim {
namespace {

std::uint64_t hash_onto(std::uint64_t hash, const std::vector<Vec3>& positions) {
  constexpr std::uint64_t fnv_prime = 0x100000001B3ULL;
  for (const Vec3& p : positions) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto bits = std::bit_cast<std::uint64_t>(p[axis]);
      for (int shift = 0; shift < 64; shift += 8) {
        hash = (hash ^ ((bits >> shift) & 0xFF)) * fnv_prime;
      }
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
  if (state.time_step_s > 0.0 && state.time_step_s != time_step_s) {
    const double ratio = time_step_s / state.time_step_s;
    for (std::size_t v = 0; v < state.current.size(); ++v) {
      state.previous[v] = state.current[v] - (state.current[v] - state.previous[v]) * ratio;
    }
  }
  state.time_step_s = time_step_s;
}

Vec3 velocity(const State& state, Index vertex) {
  if (!(state.time_step_s > 0.0)) {
    return Vec3(0.0);
  }
  return (state.current[vertex] - state.previous[vertex]) / state.time_step_s;
}

std::uint64_t hash(const State& state) {
  constexpr std::uint64_t fnv_offset_basis = 0xCBF29CE484222325ULL;
  return hash_onto(hash_onto(fnv_offset_basis, state.current), state.previous);
}

}  // namespace taut::sim
