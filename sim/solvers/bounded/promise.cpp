#include "sim/solvers/bounded/promise.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>

namespace taut::sim {
namespace {

// Measured on the cloth that is hardest to keep within a bound: a square that hangs by two corners, as far
// apart as it is wide, so that no part may stretch. T-shirts keep tighter bounds in stronger winds. Raising a
// limit promises more than was measured. The limits hold at this bound, which has no unit:
constexpr double measured_bound = 1e-3;
/// The bound was kept in this wind for ten seconds. Half this bound was kept in a quarter of the wind's
/// speed.
constexpr double strongest_wind_m_per_s = 200.0;
constexpr double strongest_acceleration_m_per_s2 = 1e4;
constexpr double strongest_pull_n = 1e6;  ///< at one vertex
/// Wider bounds were not measured: limits stop growing here.
constexpr double widest_measured_bound = 1e-2;

constexpr double tau = 6.283185307179586;

struct Load {
  std::string what;
  const char* unit;
  double amount;
  double strongest;  ///< at the measured bound
};

std::array<Load, 3> loads_of(const Surroundings& surroundings, const PromiseNames& names) {
  const ExternalForces& forces = surroundings.forces;
  const PinMotion& motion = surroundings.pin_motion;
  const double rate = tau * motion.frequency_hz;
  double pull_n = 0.0;
  for (const PointForce& force : forces.artificial_forces) {
    pull_n = std::max(pull_n, glm::length(force.force_n));
  }
  return {{{std::string("in ") + names.gusts + " of", "m/s",
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

double bound_for(const Load& load) {
  return measured_bound * std::sqrt(load.amount / load.strongest);
}

/// Writes a number with `count` significant digits.
std::string digits(double number, int count = 6) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.*g", count, number);
  return text.data();
}

/// Returns the advice to take the bound that a load needs, rounded up to two digits. Empty if no measured
/// bound is wide enough.
std::string wider_bound(const Load& load) {
  const double bound = bound_for(load);
  if (bound > widest_measured_bound) {
    return "";
  }
  const double digit = std::pow(10.0, std::floor(std::log10(bound)) - 1.0);
  return ", or a bound of at least " + digits(digit * std::ceil(bound / digit));
}

}  // namespace

std::optional<std::string> beyond_promise(const BoundedSettings& settings, const Surroundings& surroundings,
                                          const PromiseNames& names) {
  const double bound = settings.max_stretch;
  if (settings.allow_exceeding) {
    return std::nullopt;
  }
  const std::string all_the_same = std::string("; ") + names.allow_exceeding + " tries all the same";
  if (bound < smallest_promised_bound) {
    return std::string(names.bound) + ": found " + digits(bound) + ", expected at least " +
           digits(smallest_promised_bound) + ": cloth that may not give at all cannot be kept in every pose" +
           all_the_same;
  }
  for (const Load& load : loads_of(surroundings, names)) {
    const double most = load.strongest * growth(bound);
    if (!(load.amount <= most)) {
      return std::string(names.bound) + " = " + digits(bound) + " is not promised " + load.what + ' ' +
             digits(load.amount, 4) + ' ' + load.unit + "; expected at most " + digits(most, 3) + ' ' +
             load.unit + wider_bound(load) + all_the_same;
    }
  }
  return std::nullopt;
}

}  // namespace taut::sim
