#pragma once

#include "sim/hand.hpp"

namespace taut::sim {

/// The formula of add_hand_forces for one vertex, in N; `held_s` is how long the force acts before it is
/// evaluated again.
Vec3 hand_force(const HeldVertex& held, double mass_kg, const Vec3& position_m, const Vec3& velocity_m_per_s,
                double held_s);

}  // namespace taut::sim
