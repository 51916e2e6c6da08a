#include "app/scene/promise.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace taut::app {
namespace {

// Measured on the cloth that is hardest to keep: a square that hangs by two corners, as far apart as it is
// wide, so that nothing of it may give. T-shirts keep tighter bounds in stronger winds.
constexpr double measured_bound = 1e-3;
/// At the measured bound, for ten seconds; half as wide a bound was kept in a quarter of the wind.
constexpr double strongest_wind_m_per_s = 200.0;
constexpr double strongest_acceleration_m_per_s2 = 1e4;
constexpr double strongest_pull_n = 1e6;  ///< at one vertex
/// From this bound on nothing more was measured.
constexpr double widest_measured_bound = 1e-2;

constexpr double tau = 6.283185307179586;

struct Load {
  const char* what;
  const char* unit;
  double amount;
  double strongest;  ///< at the measured bound
};

std::array<Load, 3> loads_on(const Scene& scene) {
  const sim::ExternalForces& forces = scene.surroundings.forces;
  const sim::PinMotion& motion = scene.surroundings.pin_motion;
  const double rate = tau * motion.frequency_hz;
  double pull_n = 0.0;
  for (const sim::PointForce& force : forces.artificial_forces) {
    pull_n = std::max(pull_n, glm::length(force.force_n));
  }
  return {{{"in gusts (wind.speed, wind.gust_amplitude) of", "m/s",
            forces.wind.speed_m_per_s * (1.0 + forces.wind.gust_amplitude), strongest_wind_m_per_s},
           {"where gravity and the pins' motion amount to", "m/s2",
            glm::length(forces.gravity_m_per_s2) + rate * rate * glm::length(motion.amplitude_m),
            strongest_acceleration_m_per_s2},
           {"where a vertex is pulled by", "N", pull_n, strongest_pull_n}}};
}

double growth(double bound) {
  const double times = std::min(bound, widest_measured_bound) / measured_bound;
  return times * times;
}

double bound_for(double load, double strongest) {
  return measured_bound * std::sqrt(load / strongest);
}

/// The bound a load needs, rounded up to two digits, or nothing where none is wide enough.
std::string wider_bound(double load, double strongest) {
  const double bound = bound_for(load, strongest);
  if (bound > widest_measured_bound) {
    return "";
  }
  const double digit = std::pow(10.0, std::floor(std::log10(bound)) - 1.0);
  return fmt::format(", or a bound of at least {:g}", digit * std::ceil(bound / digit));
}

}  // namespace

std::optional<std::string> beyond_promise(const Scene& scene) {
  const double bound = scene.simulation.solver.max_stretch;
  if (scene.simulation.solver.kind != sim::SolverKind::bounded || scene.allow_exceeding_bound) {
    return std::nullopt;
  }
  constexpr const char* all_the_same = "; solver.allow_exceeding = true tries all the same";
  if (bound < smallest_bound) {
    return fmt::format(
        "solver.max_stretch: found {:g}, expected at least {:g}: cloth that may not give at all cannot be "
        "kept in every pose{}",
        bound, smallest_bound, all_the_same);
  }
  for (const Load& load : loads_on(scene)) {
    const double most = load.strongest * growth(bound);
    if (!(load.amount <= most)) {
      return fmt::format(
          "solver.max_stretch = {:g} is not promised {} {:.4g} {}; expected at most {:.3g} {}{}{}", bound,
          load.what, load.amount, load.unit, most, load.unit, wider_bound(load.amount, load.strongest),
          all_the_same);
    }
  }
  return std::nullopt;
}

std::optional<double> stretch_bound(const Scene& scene) {
  const sim::SolverSettings& solver = scene.simulation.solver;
  const bool keeps_bound = solver.kind != sim::SolverKind::ideal && solver.kind != sim::SolverKind::strong;
  return keeps_bound ? std::optional(solver.max_stretch) : std::nullopt;
}

const char* bound_word(const Scene& scene) {
  return scene.simulation.solver.kind == sim::SolverKind::bounded ? "bound" : "threshold";
}

}  // namespace taut::app
