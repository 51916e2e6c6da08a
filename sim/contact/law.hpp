#pragma once

#include "sim/contact/bodies.hpp"

namespace taut::sim {

/// Returns Coulomb's coefficient between a body and cloth; `cloth_friction` is the default.
inline double friction_against(const Body& body, double cloth_friction) {
  return body.friction.value_or(cloth_friction);
}

/// Returns the fraction of a slip that friction stops, 0 to 1. `parted` is the separation along the normal and `slid`
/// the slip in the same step, both in m (Coulomb's law on displacements: Mueller and others 2007, section 4.2).
/// Requires a slip of at least 0.
template <typename Real> [[nodiscard]] Real stopped_share(Real friction, Real parted, Real slid) {
  return slid > Real(0) ? std::min(Real(1), friction * parted / slid) : Real(0);
}

}  // namespace taut::sim
