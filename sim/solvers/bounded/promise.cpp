#include "sim/solvers/bounded/promise.hpp"

namespace taut::sim {
namespace {

// The limits hold at this bound, which has no unit. Raising one promises more than was measured.
constexpr double measured_bound = 1e-3;

/// The strongest loads under which the measured bound was kept.
struct Limits {
  double wind_m_per_s;
  double acceleration_m_per_s2;
  double pull_n;  ///< at one vertex
  /// Wider bounds allow more wind by this power; others by the square, and so do tighter ones.
  double wind_power;
  double widest_bound;  ///< limits stop growing here: wider ones were not measured
};

/// Springs: a square that hangs by two corners, as far apart as it is wide, so that no part may stretch.
/// T-shirts keep tighter bounds in stronger winds. It was kept for ten seconds; half this bound was kept in a
/// quarter of the wind's speed.
constexpr Limits limits_of_springs = {200.0, 1e4, 1e6, 2.0, 1e-2};
/// Surface: a T-shirt of 10 600 triangles that hangs by its shoulders, where a few triangles carry it all. It
/// was kept for two thirds of a second, in which the wind sets in. Kept too: 2e-3 in 30 m/s and 1e-2 in 200
/// m/s; 5e-3 at 2500 m/s^2 and 1e-2 at 1e4; 1e-2 under 1000 N.
constexpr Limits limits_of_surface = {15.0, 100.0, 10.0, 1.0, 1.4e-2};

constexpr double tau = 6.283185307179586;

struct Load {
  std::string what;
  const char* unit;
  double amount;
  double strongest;  ///< at the measured bound
  double power;      ///< of the bound, for wider ones
};

std::array<Load, 3> loads_of(const Surroundings& surroundings, const Limits& limits, const PromiseNames& names) {
  const ExternalForces& forces = surroundings.forces;
  const PinMotion& motion = surroundings.pin_motion;
  const double rate = tau * motion.frequency_hz;
  double pull_n = 0.0;
  for (const PointForce& force : forces.artificial_forces) {
    pull_n = std::max(pull_n, glm::length(force.force_n));
  }
  return {{{std::string("in ") + names.gusts + " of", "m/s",
            forces.wind.speed_m_per_s * (1.0 + forces.wind.gust_amplitude), limits.wind_m_per_s, limits.wind_power},
           {"where gravity and the pins' motion amount to", "m/s2",
            largest_gravity_m_per_s2(forces) + rate * rate * glm::length(motion.amplitude_m),
            limits.acceleration_m_per_s2, 2.0},
           {"where a vertex is pulled by", "N", pull_n, limits.pull_n, 2.0}}};
}

double most_for(const Load& load, const Limits& limits, double bound) {
  const double times = std::min(bound, limits.widest_bound) / measured_bound;
  return load.strongest * std::pow(times, times > 1.0 ? load.power : 2.0);
}

double bound_for(const Load& load) {
  const double times = load.amount / load.strongest;
  return measured_bound * std::pow(times, 1.0 / (times > 1.0 ? load.power : 2.0));
}

/// Writes a number with `count` significant digits.
std::string digits(double number, int count = 6) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.*g", count, number);
  return text.data();
}

/// Returns the advice to take the bound that a load needs, rounded up to two digits. Empty if no measured
/// bound is wide enough.
std::string wider_bound(const Load& load, const Limits& limits) {
  const double bound = bound_for(load);
  if (bound > limits.widest_bound) return "";
  const double digit = std::pow(10.0, std::floor(std::log10(bound)) - 1.0);
  return ", or a bound of at least " + digits(digit * std::ceil(bound / digit));
}

}  // namespace

std::optional<std::string> beyond_promise(const BoundedSettings& settings, const Surroundings& surroundings,
                                          const PromiseNames& names) {
  const double bound = settings.max_stretch;
  if (settings.allow_exceeding) return std::nullopt;
  const std::string all_the_same = std::string("; ") + names.allow_exceeding + " tries all the same";
  if (bound < smallest_promised_bound) {
    return std::string(names.bound) + ": found " + digits(bound) + ", expected at least " +
           digits(smallest_promised_bound) + ": cloth that may not give at all cannot be kept in every pose" +
           all_the_same;
  }
  const Limits& limits = settings.bound == BoundKind::springs ? limits_of_springs : limits_of_surface;
  for (const Load& load : loads_of(surroundings, limits, names)) {
    const double most = most_for(load, limits, bound);
    if (!(load.amount <= most)) {
      return std::string(names.bound) + " = " + digits(bound) + " of the " + name_of(settings.bound) +
             " is not promised " + load.what + ' ' + digits(load.amount, 4) + ' ' + load.unit + "; expected at most " +
             digits(most, 3) + ' ' + load.unit + wider_bound(load, limits) + all_the_same;
    }
  }
  return std::nullopt;
}

std::optional<std::string> beyond_contact(const BoundedSettings& settings, const Garment& garment,
                                          const PromiseNames& names) {
  const double thickness_m = garment.material.thickness_m;
  const double edge_m = mean_edge_m(garment.springs);
  const double thickest_m = thickest_part_of_edge * edge_m;
  if (!settings.contact || (thickness_m >= least_thickness_m && thickness_m <= thickest_m)) {
    return std::nullopt;
  }
  const std::string found = std::string(names.thickness) + ": found " + digits(thickness_m, 4) + " m (" +
                            digits(1e3 * thickness_m, 4) + " mm), ";
  return thickness_m < least_thickness_m
             ? found + "expected at least " + digits(1e3 * least_thickness_m) + " mm"
             : found + "edges are " + digits(1e3 * edge_m, 3) + " mm long on average; expected at most " +
                   digits(1e3 * thickest_m, 3) + " mm, " + digits(100.0 * thickest_part_of_edge) +
                   " % of that, or a coarser mesh";
}

}  // namespace taut::sim
