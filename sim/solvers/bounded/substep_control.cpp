#include "sim/solvers/bounded/substep_control.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace taut::sim::bounded {
namespace {

/// The projection may cost about as much as the substeps; much less than that and there are too many of
/// them. In between nothing is changed, so that hanging cloth keeps its step and comes to rest.
constexpr double costly_projection = 1.0;  ///< sweeps per time step; above it the next frame takes more steps
constexpr double cheap_projection = 0.6;   ///< likewise; below it the next may take fewer
constexpr double small_shift = 0.6;        ///< of the largest allowed; as above
constexpr double idle_projection = 0.2;    ///< below both of these many fewer
constexpr double idle_shift = 0.25;
/// As the projection starts from its last correction, shifts go on for a while after they were needed.
constexpr double shifts_last_s = 8.0 / 60.0;
/// A projection comes in rounds of about this many sweeps; one round is never too many.
constexpr double one_round = 8.0;
/// Doubled every time fewer steps prove too few, halved when they do not: cloth about to rest is not kept
/// awake by steps that change for ever.
constexpr double shortest_calm_s = 4.0 / 60.0;
constexpr double longest_calm_s = 192.0 / 60.0;
/// The steps of the next frame over those of the last: the further from 1, the sooner they fit and the more
/// they change about what fits. `many_more` is for a frame that is done again.
constexpr double fewer = 0.94;
constexpr double many_fewer = 0.85;
constexpr double more = 1.12;
constexpr double many_more = 1.4;
constexpr double most_more = 2.0;
/// A frame that is repeated takes so many steps that they stretch by this many times the bound.
constexpr double repeated_raw = 4.0;

/// What first_substeps calls c, measured on hanging T-shirts and sheets; more begins with more steps.
constexpr double load_factor = 6.0;
/// The projection copes with raw stretch of about this many times the bound.
constexpr double raw_per_bound = 6.0;
/// Tighter bounds begin with no more steps than this one.
constexpr double smallest_bound = 1e-4;

/// Wind pulls at the pins with a part of its pressure, as most cloth turns out of it.
constexpr double caught_wind = 0.15;

/// The shift that is allowed, in parts of the cloth's reach from its pins: so much, and this part of the
/// bound. More takes fewer steps and moves the cloth further at the end of a frame.
constexpr double part_of_reach = 0.003;
constexpr double part_of_bound = 0.1;

double acceleration(const Garment& garment, const Surroundings& surroundings) {
  const PinMotion& motion = surroundings.pin_motion;
  const double rate = 6.283185307179586 * motion.frequency_hz;
  const double speed = surroundings.forces.wind.speed_m_per_s;
  const double pressure = 0.5 * air_density_kg_per_m3 * speed * speed;
  return largest_gravity_m_per_s2(surroundings.forces) + rate * rate * glm::length(motion.amplitude_m) +
         caught_wind * pressure / garment.material.areal_density_kg_per_m2;
}

int frames_in(double time_s, double frame_time_s) {
  return std::max(1, static_cast<int>(std::lround(time_s / frame_time_s)));
}

}  // namespace

SubstepControl::SubstepControl(int first, int least, int most, double frame_time_s, int multiple)
    : least_(std::clamp(least, 1, most)),
      most_(most),
      fewest_calm_frames_(frames_in(shortest_calm_s, frame_time_s)),
      most_calm_frames_(frames_in(longest_calm_s, frame_time_s)),
      frames_shifts_last_(frames_in(shifts_last_s, frame_time_s)),
      multiple_(multiple),
      substeps_(std::clamp(first, least_, most)),
      calm_frames_needed_(fewest_calm_frames_) {}

void SubstepControl::frame_kept(double projection_cost, double shift) {
  const double part = projection_cost / substeps_;
  const bool is_calm = part < cheap_projection && shift < small_shift;
  calm_frames_ = is_calm ? calm_frames_ + 1 : 0;
  ++frames_since_more_;
  const bool is_costly = projection_cost > costly_projection * substeps_ + one_round;
  const bool is_far = shift > 1.0 && frames_since_more_ > frames_shifts_last_;
  double wanted = substeps_;
  if (is_costly || is_far) {
    need_more();
    wanted = std::ceil(wanted * more);
  } else if (calm_frames_ >= calm_frames_needed_) {
    if (took_fewer_) {
      calm_frames_needed_ = std::max(calm_frames_needed_ / 2, fewest_calm_frames_);
    }
    took_fewer_ = true;
    const bool is_idle = part < idle_projection && shift < idle_shift;
    wanted = std::floor(wanted * (is_idle ? many_fewer : fewer));
    calm_frames_ = 0;
  }
  substeps_ = std::clamp(static_cast<int>(wanted), std::max(least_, needed_), most_);
}

void SubstepControl::need_more() {
  frames_since_more_ = 0;
  calm_frames_ = 0;
  if (took_fewer_) {
    calm_frames_needed_ = std::min(2 * calm_frames_needed_, most_calm_frames_);
    took_fewer_ = false;
  }
}

void SubstepControl::need_at_least(int substeps) {
  needed_ = std::clamp(substeps, least_, most_);
  if (needed_ > substeps_) {
    substeps_ = needed_;
    need_more();
  }
}

bool SubstepControl::try_more(double raw) {
  if (is_spent()) {
    return false;
  }
  // Stretch falls with the square of the time step.
  const double wanted = std::clamp(std::sqrt(raw / repeated_raw), many_more, most_more);
  substeps_ = std::clamp(static_cast<int>(std::ceil(substeps_ * wanted)), least_, most_);
  need_more();
  return true;
}

void SubstepControl::save(ByteWriter& memory) const {
  memory.put(substeps_);
  memory.put(calm_frames_);
  memory.put(frames_since_more_);
  memory.put(calm_frames_needed_);
  memory.put<std::uint8_t>(took_fewer_ ? 1 : 0);
}

void SubstepControl::restore(ByteReader& memory) {
  substeps_ = memory.get("the number of substeps", least_, most_);
  calm_frames_ = memory.get("the number of calm frames", 0, most_counted);
  frames_since_more_ = memory.get("the number of frames since more were needed", 0, most_counted);
  calm_frames_needed_ = memory.get("the calm frames needed", fewest_calm_frames_, most_calm_frames_);
  took_fewer_ = memory.get_bool("whether fewer substeps were taken");
}

double allowed_shift_m(const Layout& layout, double max_stretch) {
  return layout.reach_m * (part_of_reach + part_of_bound * max_stretch);
}

int first_substeps(const Garment& garment, const Layout& layout, const Surroundings& surroundings,
                   double frame_time_s, double max_stretch) {
  double joined_kg = 0.0;
  double length_m = 0.0;
  int count = 0;
  for (std::size_t s = 0; s < garment.springs.begin_of(SpringKind::flexural); ++s) {
    const auto [a, b] = garment.springs.ends[s];
    const bool is_a_pinned = layout.row_of_vertex[a] < layout.pin_count;
    const bool is_b_pinned = layout.row_of_vertex[b] < layout.pin_count;
    if (is_a_pinned != is_b_pinned) {
      joined_kg += garment.masses_kg[is_a_pinned ? b : a];
      length_m += garment.springs.rest_lengths_m[s];
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
      load_factor * acceleration(garment, surroundings) * (hanging_kg / joined_kg) / (length_m / count);
  const double substeps = frame_time_s * std::sqrt(stretch_per_squared_step / raw);
  return static_cast<int>(std::ceil(std::min(substeps, 1e6)));
}

}  // namespace taut::sim::bounded
