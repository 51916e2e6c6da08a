#include <Eigen/SparseCholesky>
#include <cmath>

#include "tests/study/reference/incremental_potential.hpp"

namespace reference {
namespace {

double mean_weight_n(const Potential& potential) {
  double sum_kg = 0.0;
  std::size_t count = 0;
  for (const double mass_kg : potential.masses_kg()) {
    sum_kg += mass_kg;
    count += mass_kg > 0.0 ? 1 : 0;
  }
  return sum_kg / static_cast<double>(count) * potential.cloth().gravity_m_per_s2;
}

double max_component(const Vector& all) {
  double largest = 0.0;
  for (Eigen::Index k = 0; k < all.size(); k += 3) largest = std::max(largest, all.segment<3>(k).norm());
  return largest;
}

/// Computes Newton's direction with `shift` times the masses added. Returns false unless the sum is positive definite.
bool solve(Matrix hessian, const Potential& potential, double shift, const Vector& gradient, Vector& direction) {
  for (Eigen::Index k = 0; k < gradient.size(); ++k) hessian.coeffRef(k, k) += shift * potential.masses_kg()[k / 3];
  const Eigen::SimplicialLLT<Matrix> factor(hessian);
  if (factor.info() != Eigen::Success) return false;
  direction = factor.solve(-gradient);
  return direction.allFinite() && direction.dot(gradient) < 0.0;
}

/// Returns the first of 1, 1/2, 1/4 ... times the step that lowers the energy enough; 0: none.
double search_line(const Potential& potential, const Vector& x, const Vector& direction, double slope, double step) {
  const double before = potential.energies(x).sum();
  for (int halvings = 0; halvings < 40; ++halvings, step *= 0.5) {
    const double after = potential.energies(x + step * direction).sum();
    if (after <= before + 1e-4 * step * slope) return step;
  }
  return 0.0;
}

}  // namespace

double max_force(const Potential& potential, const Vector& x) {
  return max_component(potential.gradient(x)) / mean_weight_n(potential);
}

Rest minimise(const Potential& potential, Vector x, const Descent& descent) {
  const double unit_n = mean_weight_n(potential);
  double shift = 0.0;
  Rest rest;
  for (;; ++rest.steps) {
    const Vector gradient = potential.gradient(x);
    rest.max_force = max_component(gradient) / unit_n;
    if (rest.max_force <= descent.max_force || rest.steps == descent.max_steps) break;
    Vector direction;
    if (!solve(potential.hessian(x, false), potential, shift, gradient, direction) &&
        !solve(potential.hessian(x, true), potential, std::max(shift, 1.0), gradient, direction)) {
      break;
    }
    direction *= std::min(1.0, descent.max_move_m / max_component(direction));
    const double free = potential.max_step(x, direction);
    const double step = search_line(potential, x, direction, gradient.dot(direction), free);
    if (step == 0.0) {
      // The energy's change is below rounding here, so the gradient decides.
      const Vector next = x + free * direction;
      if (max_component(potential.gradient(next)) >= max_component(gradient)) break;
      x = next;
      continue;
    }
    x += step * direction;
    shift = step < 0.2 * free ? std::max(10.0, 4.0 * shift) : 0.3 * shift;
    if (shift < 1e-3) shift = 0.0;
  }
  const Eigen::SimplicialLLT<Matrix> factor(potential.hessian(x, false));
  rest.is_stable = factor.info() == Eigen::Success;
  rest.x = std::move(x);
  return rest;
}

}  // namespace reference
