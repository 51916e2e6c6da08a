#include "sim/solvers/bounded/substep_control.hpp"

#include "sim/solvers/bounded/promise.hpp"

namespace taut::sim::bounded {
namespace {

/// Drag coefficient of a flag on its area, as most cloth turns out of the wind (Hoerner 1965: 0.1 to 0.2).
constexpr double flag_drag = 0.15;

double acceleration(const Garment& garment, const Surroundings& surroundings) {
  const PinMotion& motion = surroundings.pin_motion;
  const double rate = 6.283185307179586 * motion.frequency_hz;
  const double speed = surroundings.forces.wind.speed_m_per_s;
  const double pressure = 0.5 * air_density_kg_per_m3 * speed * speed;
  return max_gravity_m_per_s2(surroundings.forces) + rate * rate * glm::length(motion.amplitude_m) +
         flag_drag * pressure / min_density_kg_per_m2(garment);
}

int frames_in(double time_s, double frame_time_s) {
  assert(time_s >= 0.0);
  assert(frame_time_s > 0.0);
  return std::max(1, static_cast<int>(std::lround(time_s / frame_time_s)));
}

}  // namespace

SubstepControl::SubstepControl(int first, int least, int most, double frame_time_s)
    : min_substeps_(std::clamp(least, 1, most)),
      max_substeps_(most),
      min_calm_frames_(frames_in(tuning::low_cost_time_s, frame_time_s)),
      substeps_(std::clamp(first, min_substeps_, most)),
      calm_frames_needed_(min_calm_frames_) {}

void SubstepControl::frame_kept(double projection_cost, double shift) {
  const bool is_calm = projection_cost < tuning::low_cost_ratio * substeps_ && shift < tuning::low_shift_ratio;
  calm_frames_ = is_calm ? calm_frames_ + 1 : 0;
  ++frames_since_more_;
  const bool is_costly = projection_cost > substeps_ + round_sweeps;
  // The projection starts from its last correction, so shifts continue for some frames after they were needed.
  const bool is_far = shift > 1.0 && frames_since_more_ > 2 * min_calm_frames_;
  double wanted = substeps_;
  if (is_costly || is_far) {
    need_more();
    wanted = std::ceil(wanted * tuning::step_growth_factor);
  } else if (is_calm && usual_substeps_ > 0) {
    wanted = std::max(tuning::step_growth_factor * usual_substeps_, 0.5 * wanted);
    calm_frames_ = 0;
  } else if (calm_frames_ >= calm_frames_needed_) {
    if (took_fewer_) calm_frames_needed_ = std::max(calm_frames_needed_ / 2, min_calm_frames_);
    took_fewer_ = true;
    wanted = std::floor(wanted / tuning::step_growth_factor);
    calm_frames_ = 0;
  }
  substeps_ = std::clamp(static_cast<int>(wanted), std::max(min_substeps_, needed_substeps_), max_substeps_);
  if (is_costly || substeps_ <= tuning::step_growth_factor * usual_substeps_) usual_substeps_ = 0;
}

void SubstepControl::need_more() {
  frames_since_more_ = 0;
  calm_frames_ = 0;
  if (took_fewer_) {
    // Ever-changing step numbers would keep cloth awake that is about to rest.
    calm_frames_needed_ = std::min(2 * calm_frames_needed_, max_counter);
    took_fewer_ = false;
  }
}

void SubstepControl::need_at_least(double substeps) {
  needed_substeps_ =
      substeps <= max_substeps_ ? std::max(static_cast<int>(std::ceil(substeps)), min_substeps_) : max_substeps_;
  if (needed_substeps_ > substeps_) {
    substeps_ = needed_substeps_;
    need_more();
  }
}

bool SubstepControl::try_more(double raw_bounds) {
  if (is_spent()) return false;
  if (usual_substeps_ == 0) usual_substeps_ = substeps_;
  // Stretch falls with the square of the time step. The stretch of lost cloth is NaN, which asks for the largest
  // number.
  const double min_growth_factor = tuning::step_growth_factor * tuning::step_growth_factor * tuning::step_growth_factor;
  const double wanted =
      std::max(min_growth_factor, std::min(2.0, std::sqrt(raw_bounds / tuning::target_unprojected_stretch)));
  substeps_ = std::clamp(static_cast<int>(std::ceil(substeps_ * wanted)), min_substeps_, max_substeps_);
  need_more();
  return true;
}

void SubstepControl::reduce_substeps(double raw_bounds) {
  const double wanted = substeps_ * std::min(1.0, std::sqrt(raw_bounds / tuning::target_unprojected_stretch));
  substeps_ = std::clamp(static_cast<int>(std::ceil(wanted)), std::max(min_substeps_, needed_substeps_), max_substeps_);
}

void SubstepControl::save(ByteWriter& memory) const {
  memory.put(substeps_);
  memory.put(usual_substeps_);
  memory.put(calm_frames_);
  memory.put(frames_since_more_);
  memory.put(calm_frames_needed_);
  memory.put<std::uint8_t>(took_fewer_ ? 1 : 0);
}

void SubstepControl::restore(ByteReader& memory) {
  substeps_ = memory.get("the number of substeps", min_substeps_, max_substeps_);
  usual_substeps_ = memory.get("the usual number of substeps", 0, max_substeps_);
  calm_frames_ = memory.get("the number of calm frames", 0, max_counter);
  frames_since_more_ = memory.get("the number of frames since more were needed", 0, max_counter);
  calm_frames_needed_ = memory.get("the calm frames needed", min_calm_frames_, max_counter);
  took_fewer_ = memory.get_bool("whether fewer substeps were taken");
}

double allowed_shift_m(const Layout& layout) { return tuning::shift_per_reach * layout.reach_m; }

int first_substeps(const Garment& garment, const Layout& layout, const Surroundings& surroundings, double frame_time_s,
                   double max_stretch) {
  assert(frame_time_s > 0.0);
  assert(max_stretch >= 0.0);
  double joined_kg = 0.0;
  double length_m = 0.0;
  int count = 0;
  for (std::size_t s = 0; s < garment.springs.begin_index(SpringKind::flexural); ++s) {
    const auto [a, b] = garment.springs.ends[s];
    const bool is_a_pinned = layout.solver_indices[a] < layout.pin_count;
    const bool is_b_pinned = layout.solver_indices[b] < layout.pin_count;
    if (is_a_pinned != is_b_pinned) {
      joined_kg += garment.masses_kg[is_a_pinned ? b : a];
      length_m += garment.springs.rest_lengths_m[s];
      ++count;
    }
  }
  if (count == 0) return 1;
  double hanging_kg = 0.0;
  for (std::size_t row = layout.pin_count; row < layout.vertex_count(); ++row) {
    hanging_kg += std::isfinite(layout.distance_from_pins_m[row]) ? garment.masses_kg[layout.vertex_indices[row]] : 0.0;
  }
  const double bound = std::max(max_stretch, min_promised_bound);
  const double stretch_per_squared_step =
      acceleration(garment, surroundings) * (hanging_kg / joined_kg) / (length_m / count);
  const double substeps = frame_time_s * std::sqrt(stretch_per_squared_step / bound);
  return static_cast<int>(std::ceil(std::min(substeps, 1e6)));
}

}  // namespace taut::sim::bounded
