#include "app/output/frame_record.hpp"

#include <algorithm>

namespace taut::app {
namespace {

/// What a solver says is held against what is measured: of springs a billion times shorter than others it
/// can be wrong.
bool is_bound_kept(const sim::Simulation& simulation, const sim::Stretch& stretch) {
  constexpr double rounding = 1e-6;
  const sim::FrameReport& report = simulation.frame_report();
  const auto* bounded = std::get_if<sim::BoundedSettings>(&simulation.settings().solver.method);
  return report.bound_kept && (bounded == nullptr || stretch.max <= bounded->max_stretch + rounding);
}

}  // namespace

FrameRecord measure_frame(const sim::Simulation& simulation, int frame) {
  const sim::Garment& garment = simulation.garment();
  const sim::State& state = simulation.state();
  FrameRecord record;
  record.frame = frame;
  record.time_s = state.time_s;
  record.stretch = sim::measure_stretch(garment.springs, state.current);
  if (frame > 0) {
    const sim::FrameReport& report = simulation.frame_report();
    record.raw_max_stretch = report.bound_promised ? report.raw_max_stretch : record.stretch.max;
    record.bound_kept = is_bound_kept(simulation, record.stretch);
    record.substeps = report.substeps;
    record.followed_compression_n_per_m = report.followed_compression_n_per_m;
  }
  const sim::ShapeChange change = simulation.change();
  record.rms_speed_m_per_s = sim::rms_speed(change);
  record.energy = sim::measure_energy(garment, change, simulation.surroundings().forces.gravity_m_per_s2);
  record.convergence_m = sim::measure_convergence(change).max_m;
  record.state_hash = sim::hash(state);
  record.asleep = state.asleep;
  return record;
}

RunSummary summarise(const std::vector<FrameRecord>& records) {
  RunSummary summary;
  int simulated = 0;
  for (const FrameRecord& record : records) {
    if (record.stretch.max > summary.max_stretch) {
      summary.max_stretch = record.stretch.max;
      summary.max_stretch_frame = record.frame;
    }
    summary.max_p99_stretch = std::max(summary.max_p99_stretch, record.stretch.p99);
    summary.asleep_since_frame =
        !record.asleep ? -1 : (summary.asleep_since_frame < 0 ? record.frame : summary.asleep_since_frame);
    simulated += record.frame > 0 ? 1 : 0;
    summary.max_raw_stretch = std::max(summary.max_raw_stretch, record.raw_max_stretch);
    summary.mean_substeps += record.substeps;
    summary.followed_compression_n_per_m =
        std::min(summary.followed_compression_n_per_m, record.followed_compression_n_per_m);
    if (!record.bound_kept) {
      ++summary.frames_over_bound;
      summary.first_frame_over_bound =
          summary.first_frame_over_bound < 0 ? record.frame : summary.first_frame_over_bound;
    }
    summary.total_sim_ms += record.sim_ms;
    summary.total_draw_ms += record.draw_ms;
    summary.total_encode_ms += record.encode_ms;
  }
  summary.frames = static_cast<int>(records.size());
  summary.mean_substeps /= std::max(simulated, 1);
  summary.mean_sim_ms = simulated > 0 ? summary.total_sim_ms / simulated : 0.0;
  if (!records.empty()) {
    summary.final_max_stretch = records.back().stretch.max;
    summary.final_rms_speed_m_per_s = records.back().rms_speed_m_per_s;
  }
  return summary;
}

}  // namespace taut::app
