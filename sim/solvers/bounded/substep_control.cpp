#include "sim/solvers/bounded/substep_control.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace taut::sim::bounded {
namespace {

/// The certificate should cost about this part of the substeps; between the two nothing is changed, so that
/// hanging cloth keeps its step and comes to rest.
constexpr double costly_certificate = 0.25;
constexpr double cheap_certificate = 0.06;
/// A certificate comes in rounds of about this many sweeps; one round is never too many.
constexpr double one_round = 8.0;
/// Doubled every time fewer steps prove too few, halved when they do not: cloth about to rest is not kept
/// awake by steps that change for ever.
constexpr int fewest_calm_frames = 6;
constexpr int most_calm_frames = 192;
constexpr double fewer = 0.94;
constexpr double more = 1.12;
constexpr double many_more = 1.4;

/// Measured on hanging T-shirts and sheets.
constexpr double load_factor = 6.0;
/// The certificate copes with raw stretch of about this many times the bound.
constexpr double raw_per_bound = 6.0;
constexpr double smallest_bound = 1e-4;

double acceleration(const Surroundings& surroundings) {
  const PinMotion& motion = surroundings.pin_motion;
  const double rate = 6.283185307179586 * motion.frequency_hz;
  return glm::length(surroundings.forces.gravity_m_per_s2) + rate * rate * glm::length(motion.amplitude_m);
}

}  // namespace

SubstepControl::SubstepControl(int first, int least, int most)
    : least_(std::min(least, most)),
      most_(most),
      substeps_(std::clamp(first, least_, most)),
      calm_frames_needed_(fewest_calm_frames) {}

void SubstepControl::frame_kept(double certify_cost) {
  calm_frames_ = certify_cost < cheap_certificate * substeps_ ? calm_frames_ + 1 : 0;
  double wanted = substeps_;
  if (certify_cost > costly_certificate * substeps_ + one_round) {
    need_more();
    wanted = std::ceil(wanted * more);
  } else if (calm_frames_ >= calm_frames_needed_) {
    if (took_fewer_) {
      calm_frames_needed_ = std::max(calm_frames_needed_ / 2, fewest_calm_frames);
    }
    took_fewer_ = true;
    wanted = std::floor(wanted * fewer);
    calm_frames_ = 0;
  }
  substeps_ = std::clamp(static_cast<int>(wanted), least_, most_);
}

void SubstepControl::need_more() {
  calm_frames_ = 0;
  if (took_fewer_) {
    calm_frames_needed_ = std::min(2 * calm_frames_needed_, most_calm_frames);
    took_fewer_ = false;
  }
}

bool SubstepControl::try_more() {
  if (is_spent()) {
    return false;
  }
  substeps_ = std::clamp(static_cast<int>(std::ceil(substeps_ * many_more)), least_, most_);
  need_more();
  return true;
}

int first_substeps(const Garment& garment, const Layout& layout, const Surroundings& surroundings,
                   double frame_time_s, double max_stretch) {
  const SpringLanes& springs = layout.springs;
  double held_kg = 0.0;
  double length_m = 0.0;
  int count = 0;
  for (std::size_t k = 0; k < springs.lane_count(); ++k) {
    if (springs.spring[k] != SpringLanes::no_spring && springs.row_i[k] < layout.pin_count) {
      held_kg += garment.masses_kg[layout.vertex_of_row[springs.row_j[k]]];
      length_m += garment.springs.rest_lengths_m[springs.spring[k]];
      ++count;
    }
  }
  if (count == 0) {
    return 1;
  }
  double hanging_kg = 0.0;
  for (std::size_t row = layout.pin_count; row < layout.vertex_count(); ++row) {
    hanging_kg +=
        std::isfinite(layout.distance_from_pins_m[row]) ? garment.masses_kg[layout.vertex_of_row[row]] : 0.0;
  }
  const double raw = raw_per_bound * std::max(max_stretch, smallest_bound);
  const double stretch_per_squared_step =
      load_factor * acceleration(surroundings) * (hanging_kg / held_kg) / (length_m / count);
  const double substeps = frame_time_s * std::sqrt(stretch_per_squared_step / raw);
  return static_cast<int>(std::ceil(std::min(substeps, 1e6)));
}

}  // namespace taut::sim::bounded
