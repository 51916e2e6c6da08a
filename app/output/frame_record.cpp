#include "app/output/frame_record.hpp"

#include <algorithm>

namespace taut::app {
namespace {

/// What a solver says is held against what is measured: of springs a billion times shorter than others it
/// can be wrong.
bool is_bound_kept(const sim::Simulation& simulation, const FrameRecord& record) {
  const sim::FrameReport& report = simulation.last_report();
  const auto* bounded = std::get_if<sim::BoundedSettings>(&simulation.settings().solver.method);
  return report.bound_kept && (bounded == nullptr || is_within(*bounded, record));
}

}  // namespace

bool is_within(const sim::BoundedSettings& bound, const FrameRecord& record) {
  const double most = bound.max_stretch + bound_rounding;
  return record.stretch.max <= most &&
         (bound.bound == sim::BoundKind::springs || record.surface_stretch.max <= most);
}

void measure_stretches(const sim::Simulation& simulation, FrameRecord& record) {
  const sim::Garment& garment = simulation.garment();
  const std::vector<sim::Vec3>& positions = simulation.state().current;
  record.stretch = sim::measure_stretch(garment.springs, positions);
  record.surface_stretch = sim::measure_surface_stretch(garment, positions);
}

FrameRecord measure_frame(const sim::Simulation& simulation, int frame, Measured measured) {
  const sim::Garment& garment = simulation.garment();
  const sim::State& state = simulation.state();
  FrameRecord record;
  record.frame = frame;
  record.time_s = state.time_s;
  record.asleep = state.asleep;
  measure_stretches(simulation, record);
  if (measured == Measured::promises) {
    record.bound_kept = frame == 0 || is_bound_kept(simulation, record);
    record.blocked = frame > 0 && simulation.last_report().blocked.has_value();
    return record;
  }
  if (frame > 0) {
    const sim::FrameReport& report = simulation.frame_report();
    record.raw_max_stretch = report.bound_promised ? report.raw_max_stretch : record.stretch.max;
    record.bound_kept = is_bound_kept(simulation, record);
    record.blocked = report.blocked.has_value();
    record.substeps = report.substeps;
    record.followed_compression_n_per_m = report.followed_compression_n_per_m;
    record.contact = report.contact;
  } else {
    const sim::MeasuredContact contact = simulation.measure_contact();
    record.contact.smallest_distance_m = contact.nearest_m;
    record.contact.crossing_pairs = contact.crossing_pairs;
  }
  const sim::ShapeChange change = simulation.change();
  record.rms_speed_m_per_s = sim::rms_speed(change);
  record.energy =
      sim::measure_energy(garment, change, sim::gravity_at(simulation.surroundings().forces, state.time_s));
  record.convergence_m = sim::measure_convergence(change).max_m;
  record.state_hash = sim::hash(state);
  return record;
}

void RunSummary::add(const FrameRecord& record) {
  if (frames++ == 0) {
    crossings_at_start = static_cast<int>(record.contact.crossing_pairs);
  }
  final_crossings = static_cast<int>(record.contact.crossing_pairs);
  final_left_out_share = record.contact.left_out_share;
  most_left_out_share = std::max(most_left_out_share, record.contact.left_out_share);
  simulated_frames += record.frame > 0 ? 1 : 0;
  if (record.stretch.max > max_stretch) {
    max_stretch = record.stretch.max;
    max_stretch_frame = record.frame;
  }
  max_p99_stretch = std::max(max_p99_stretch, record.stretch.p99);
  final_max_stretch = record.stretch.max;
  if (record.surface_stretch.max > max_surface_stretch) {
    max_surface_stretch = record.surface_stretch.max;
    max_surface_stretch_frame = record.frame;
  }
  max_p99_surface_stretch = std::max(max_p99_surface_stretch, record.surface_stretch.p99);
  final_max_surface_stretch = record.surface_stretch.max;
  max_raw_stretch = std::max(max_raw_stretch, record.raw_max_stretch);
  if (!record.bound_kept) {
    ++frames_over_bound;
    first_frame_over_bound = first_frame_over_bound < 0 ? record.frame : first_frame_over_bound;
  }
  if (record.blocked) {
    ++frames_blocked;
    first_frame_blocked = first_frame_blocked < 0 ? record.frame : first_frame_blocked;
  }
  total_substeps += record.substeps;
  followed_compression_n_per_m = std::min(followed_compression_n_per_m, record.followed_compression_n_per_m);
  smallest_distance_m = std::min(smallest_distance_m, record.contact.smallest_distance_m);
  final_rms_speed_m_per_s = record.rms_speed_m_per_s;
  if (!record.asleep) {
    asleep_since_frame = -1;
  } else if (asleep_since_frame < 0) {
    asleep_since_frame = record.frame;
  }
  total_sim_ms += record.sim_ms;
  total_draw_ms += record.draw_ms;
  total_encode_ms += record.encode_ms;
}

double RunSummary::mean_substeps() const {
  return total_substeps / std::max(simulated_frames, 1);
}

double RunSummary::mean_sim_ms() const {
  return total_sim_ms / std::max(simulated_frames, 1);
}

}  // namespace taut::app
