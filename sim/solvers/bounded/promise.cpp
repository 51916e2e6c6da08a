#include "sim/solvers/bounded/promise.hpp"

namespace taut::sim {
namespace {

// Bound on stretch at which the limits below were measured. A higher value promises more than was measured.
constexpr double measured_bound = 1e-3;

/// Largest loads under which the measured bound was kept.
struct PromiseLimits {
  double wind_m_per_s;
  double acceleration_m_per_s2;
  double pull_n;  ///< pull at one vertex
  /// Power by which wider bounds allow more wind. Other loads, and all loads at tighter bounds, go by the square.
  double wind_power;
  double max_bound;  ///< limits stop growing here: wider bounds were not measured
};

/// Limits for springs, from a square pinned by two corners at a distance of its width, which cannot hang without
/// stretching somewhere. The bound was kept for ten seconds; half this bound was kept in a quarter of the wind's speed.
/// T-shirts keep tighter bounds in stronger winds.
constexpr PromiseLimits spring_limits = {200.0, 1e4, 1e6, 2.0, 1e-2};
/// Limits for the surface, from a T-shirt of 10 600 triangles pinned at its shoulders, where a few triangles carry
/// everything. The bound was kept for two thirds of a second, in which the wind sets in. Also kept: 2e-3 in 30 m/s and
/// 1e-2 in 200 m/s; 5e-3 at 2500 m/s^2 and 1e-2 at 1e4; 1e-2 under 1000 N.
constexpr PromiseLimits surface_limits = {15.0, 100.0, 10.0, 1.0, 1.4e-2};

constexpr double tau = 6.283185307179586;

struct Load {
  std::string what;
  const char* unit;
  double amount;
  double measured_amount;  ///< largest amount at the measured bound
  double power;      ///< exponent of the ratio of bounds, for wider ones
};

std::array<Load, 3> list_loads(const Surroundings& surroundings, const PromiseLimits& limits,
                               const PromiseNames& names) {
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
            max_gravity_m_per_s2(forces) + rate * rate * glm::length(motion.amplitude_m), limits.acceleration_m_per_s2,
            2.0},
           {"where a vertex is pulled by", "N", pull_n, limits.pull_n, 2.0}}};
}

double max_load(const Load& load, const PromiseLimits& limits, double bound) {
  const double times = std::min(bound, limits.max_bound) / measured_bound;
  return load.measured_amount * std::pow(times, times > 1.0 ? load.power : 2.0);
}

double min_bound(const Load& load) {
  const double times = load.amount / load.measured_amount;
  return measured_bound * std::pow(times, 1.0 / (times > 1.0 ? load.power : 2.0));
}

/// Writes a number with `count` significant digits.
std::string digits(double number, int count = 6) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.*g", count, number);
  return text.data();
}

/// Returns advice to use the bound that a load needs, rounded up to two digits. Empty if no measured bound is wide
/// enough.
std::string suggest_bound(const Load& load, const PromiseLimits& limits) {
  const double bound = min_bound(load);
  if (bound > limits.max_bound) return "";
  const double digit = std::pow(10.0, std::floor(std::log10(bound)) - 1.0);
  return ", or a bound of at least " + digits(digit * std::ceil(bound / digit));
}

}  // namespace

std::optional<std::string> unpromised_bound_reason(const BoundedSettings& settings, const Surroundings& surroundings,
                                                   const PromiseNames& names) {
  const double bound = settings.max_stretch;
  if (settings.allow_exceeding) return std::nullopt;
  const std::string all_the_same = std::string("; ") + names.allow_exceeding + " tries all the same";
  if (bound < min_promised_bound) {
    return std::string(names.bound) + ": found " + digits(bound) + ", expected at least " + digits(min_promised_bound) +
           ": cloth that may not give at all cannot be kept in every pose" + all_the_same;
  }
  const PromiseLimits& limits = settings.bound == BoundKind::springs ? spring_limits : surface_limits;
  for (const Load& load : list_loads(surroundings, limits, names)) {
    const double max_amount = max_load(load, limits, bound);
    if (!(load.amount <= max_amount)) {
      return std::string(names.bound) + " = " + digits(bound) + " of the " + to_name(settings.bound) +
             " is not promised " + load.what + ' ' + digits(load.amount, 4) + ' ' + load.unit + "; expected at most " +
             digits(max_amount, 3) + ' ' + load.unit + suggest_bound(load, limits) + all_the_same;
    }
  }
  return std::nullopt;
}

std::optional<std::string> missing_contact_reason(const BoundedSettings& settings, const Garment& garment,
                                                  const PromiseNames& names) {
  const double thickness_m = garment.material.thickness_m;
  const double edge_m = mean_edge_m(garment.springs);
  const double thickest_m = max_thickness_per_edge * edge_m;
  if (!settings.contact || (thickness_m >= min_thickness_m && thickness_m <= thickest_m)) {
    return std::nullopt;
  }
  const std::string found_text = std::string(names.thickness) + ": found " + digits(thickness_m, 4) + " m (" +
                                 digits(1e3 * thickness_m, 4) + " mm), ";
  return thickness_m < min_thickness_m
             ? found_text + "expected at least " + digits(1e3 * min_thickness_m) + " mm"
             : found_text + "edges are " + digits(1e3 * edge_m, 3) + " mm long on average; expected at most " +
                   digits(1e3 * thickest_m, 3) + " mm, " + digits(100.0 * max_thickness_per_edge) +
                   " % of that, or a coarser mesh";
}

}  // namespace taut::sim
