#include "app/runs/frame_record.hpp"

#include "app/base/errors.hpp"
#include "app/base/words.hpp"

namespace taut::app {
namespace {

/// Checks the solver's report against a measurement: the report can be wrong about springs that are a billion times
/// shorter than others.
bool is_bound_kept(const sim::Simulation& simulation, const FrameRecord& record) {
  const sim::FrameReport& report = simulation.last_report();
  const auto* bounded = std::get_if<sim::BoundedSettings>(&simulation.settings().solver.method);
  return report.bound_kept && (bounded == nullptr || is_within(*bounded, record));
}

// Ratio of the fabric's stiffness to the stiffness that the time steps can follow above which the user is warned. Below
// it the springs push back nearly as they should.
constexpr double min_warning_ratio = 2.0;

void warn_of_stiffness(const Scene& scene, const RunSummary& summary) {
  const SolverChoice& solver = scene.simulation.solver;
  const double asked = scene.material.compression_stiffness_n_per_m;
  const double followed = summary.followed_compression_n_per_m;
  const bool is_asked_for = asked != sim::Material{}.compression_stiffness_n_per_m;
  if (!is_asked_for || !(asked > min_warning_ratio * followed)) return;
  const double steps = std::ceil(summary.mean_substeps() * std::sqrt(asked / followed));
  const std::string remedy = steps <= solver.max_substeps
                                 ? fmt::format("solver.substeps = {:.0f} would follow it", steps)
                                 : fmt::format("it would take {:.2g} of them", steps);
  fmt::print(stderr,
             "taut: warning: cloth.compression_stiffness = {:g} N/m is stiffer than {:.0f} time steps a "
             "frame can follow; short springs pushed back as at about {:.2g} N/m; {}\n",
             asked, summary.mean_substeps(), followed, remedy);
}

// Prints only in runs that accept crossings; other runs end at the first.
void warn_of_crossings(const RunSummary& summary) {
  if (summary.frames_blocked > 0) {
    fmt::print(stderr,
               "taut: warning: in {} of {} pins or bodies closed in so that something may cross, first in "
               "frame {}\n",
               summary.frames_blocked, count_text(summary.frames, "frame"), summary.first_frame_blocked);
  }
}

/// Returns "the surface is stretched by up to 0.23, 0.22 too much".
std::string describe(const char* what, double largest, double bound) {
  const std::string text = fmt::format("{} stretched by up to {:.4g}", what, largest);
  return largest > bound + bound_rounding ? text + fmt::format(", {:.2g} too much", largest - bound) : text;
}

/// Describes the largest stretches of all measures that the bound limits.
std::string describe_stretch(const sim::BoundedSettings& bound, const RunSummary& summary) {
  const std::string springs = describe("springs are", summary.max_stretch, bound.max_stretch);
  return bound.bound == sim::BoundKind::springs
             ? springs
             : springs + "; " + describe("the surface is", summary.max_surface_stretch, bound.max_stretch);
}

}  // namespace

bool is_within(const sim::BoundedSettings& bound, const FrameRecord& record) {
  const double max_allowed = bound.max_stretch + bound_rounding;
  return record.stretch.max <= max_allowed &&
         (bound.bound == sim::BoundKind::springs || record.surface_stretch.max <= max_allowed);
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
    record.contact.min_distance_m = contact.min_distance_m;
    record.contact.crossing_pairs = contact.crossing_pairs;
  }
  const sim::ShapeChange change = simulation.change();
  record.rms_speed_m_per_s = sim::rms_speed(change);
  record.energy = sim::measure_energy(garment, change, sim::gravity_at(simulation.surroundings().forces, state.time_s));
  record.wind = sim::measure_wind(garment, state, simulation.surroundings().forces.wind, simulation.wind_fractions());
  record.convergence_m = sim::measure_convergence(change).max_m;
  record.state_hash = sim::hash(state);
  return record;
}

void RunSummary::add(const FrameRecord& record) {
  if (frames++ == 0) crossings_at_start = static_cast<int>(record.contact.crossing_pairs);
  final_crossings = static_cast<int>(record.contact.crossing_pairs);
  final_left_out_share = record.contact.excluded_area_fraction;
  most_left_out_share = std::max(most_left_out_share, record.contact.excluded_area_fraction);
  simulated_frames += record.frame > 0 ? 1 : 0;
  const auto note_largest = [&](double stretch, double& largest, int& its_frame) {
    its_frame = stretch > largest ? record.frame : its_frame;
    largest = std::max(largest, stretch);
  };
  note_largest(record.stretch.max, max_stretch, max_stretch_frame);
  max_p99_stretch = std::max(max_p99_stretch, record.stretch.p99);
  final_max_stretch = record.stretch.max;
  note_largest(record.surface_stretch.max, max_surface_stretch, max_surface_stretch_frame);
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
  min_distance_m = std::min(min_distance_m, record.contact.min_distance_m);
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

std::string describe_crossings(const RunSummary& summary) {
  if (summary.crossings_at_start == 0 && summary.final_crossings == 0 && !(summary.most_left_out_share > 0.0)) {
    return "";
  }
  const std::string counts = fmt::format("{} at the start and {} at the end",
                                         count_text(static_cast<std::size_t>(summary.crossings_at_start),
                                                    "pair of triangles crosses", "pairs of triangles cross"),
                                         summary.final_crossings);
  return summary.most_left_out_share > 0.0
             ? fmt::format(
                   "{}; around them, and where cloth touches itself at rest, contact leaves out {:.2f} % of the cloth, "
                   "at the end {:.2f} %",
                   counts, 100.0 * summary.most_left_out_share, 100.0 * summary.final_left_out_share)
             : counts;
}

std::string describe_excess(const Scene& scene, const RunSummary& summary) {
  const sim::BoundedSettings& bounded = scene.simulation.solver.bounded;
  return summary.frames_over_bound == 0
             ? ""
             : fmt::format("{} of {} {} solver.max_stretch = {:g} of the {}, the first is frame {}; {}",
                           summary.frames_over_bound, count_text(summary.frames, "frame"),
                           summary.frames_over_bound == 1 ? "exceeds" : "exceed", bounded.max_stretch,
                           sim::to_name(bounded.bound), summary.first_frame_over_bound,
                           describe_stretch(bounded, summary));
}

int judge_bound(const Scene& scene, const RunSummary& summary) {
  std::fflush(stdout);
  warn_of_stiffness(scene, summary);
  warn_of_crossings(summary);
  const std::string excess = describe_excess(scene, summary);
  if (excess.empty()) return 0;
  const bool allowed = scene.simulation.solver.bounded.allow_exceeding;
  fmt::print(stderr,
             "taut: {}: {}. {} may pull the cloth apart, or more time steps are needed (solver.max_substeps "
             "= {}){}\n",
             allowed ? "warning" : "error", excess,
             scene.bodies.empty() ? "Pins" : "Pins, or a body that it is too tight for,",
             scene.simulation.solver.max_substeps,
             allowed ? "" : "; solver.allow_exceeding = \"bound\" accepts such frames");
  return allowed ? 0 : exit_promise_broken;
}

}  // namespace taut::app
