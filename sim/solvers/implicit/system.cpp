#include "sim/solvers/implicit/system.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

namespace taut::sim::implicit {

void add_inertia(std::span<const double> masses_kg, std::span<const Vec3> forces_n, double air_drag_per_s,
                 const System& system) {
  const double h = system.time_step_s;
  for (Index v = 0; v < masses_kg.size(); ++v) {
    system.matrix.at(v, v) += Mat3(masses_kg[v] * (1.0 + h * air_drag_per_s));
    system.right_side[v] += h * forces_n[v];
  }
}

void add_condition(const Condition& condition, const Stiffness& stiffness, const System& system) {
  const double h = system.time_step_s;
  const double k = stiffness.k;
  const double d = stiffness.damping_s * k;
  double rate = 0.0;       // dC/dt
  Vec3 weighted_sum(0.0);  // of velocities
  const auto count = static_cast<std::size_t>(condition.count);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3& velocity = system.velocities_m_per_s[condition.vertices[i]];
    rate += glm::dot(condition.gradients[i], velocity);
    weighted_sum += condition.weights[i] * velocity;
  }
  const double tension = k * condition.value + d * rate;
  const Mat3 curvature = std::max(tension, 0.0) * condition.curvature;
  const Vec3 bent = curvature * weighted_sum;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3& gradient = condition.gradients[i];
    const Vec3 force = -tension * gradient;
    const Vec3 force_change = -k * rate * gradient - condition.weights[i] * bent;  // df/dx v
    system.right_side[condition.vertices[i]] += h * (force + h * force_change);
    for (std::size_t j = 0; j < count; ++j) {
      system.matrix.at(condition.vertices[i], condition.vertices[j]) +=
          (h * d + h * h * k) * glm::outerProduct(gradient, condition.gradients[j]) +
          (h * h * condition.weights[i] * condition.weights[j]) * curvature;
    }
  }
}

}  // namespace taut::sim::implicit
