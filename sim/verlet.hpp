#pragma once

#include <span>

#include "sim/mesh/types.hpp"

namespace taut::sim {

/// Eq. (1): p(t + dt) = 2 p(t) - p(t - dt) + a(t) dt^2, with a = f / m. One entry per vertex in every span;
/// a pinned vertex (inverse mass 0) is predicted to stay where it is.
void predict_positions(std::span<const Vec3> previous, std::span<const Vec3> current,
                       std::span<const Vec3> forces_n, std::span<const double> inverse_masses_per_kg,
                       double time_step_s, std::span<Vec3> predicted);

}  // namespace taut::sim
