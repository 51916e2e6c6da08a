#pragma once

#include "app/scene/scene.hpp"
#include "sim/local_wind.hpp"

namespace taut::app {

/// Measurements of one frame. Stretch is a fraction.
struct FrameRecord {
  int frame = 0;
  double time_s = 0.0;
  sim::Stretch stretch;  ///< stretch of the springs
  sim::SurfaceStretch surface_stretch;
  double raw_max_stretch = 0.0;  ///< largest stretch before the solver's last correction
  bool bound_kept = true;        ///< false: the solver has a bound and exceeded it
  bool blocked = false;          ///< a crossing is possible and the scene accepts it
  int substeps = 0;
  double followed_compression_n_per_m = std::numeric_limits<double>::infinity();  ///< see sim::FrameReport
  sim::ContactReport contact = {};
  double rms_speed_m_per_s = 0.0;
  sim::Energy energy;
  sim::WindLoad wind;
  double convergence_m = 0.0;  ///< largest |p(t) - p(t - dt)| of any vertex between two frames
  std::uint64_t state_hash = 0;
  bool asleep = false;
  /// Crossing pairs that --verify does not allow; empty: not counted (frame_verifier.hpp).
  std::optional<std::size_t> crossing_pairs = {};
  /// CPU time of the simulating thread, which waits for its helper threads without sleeping. In the window, which has
  /// to run in real time, it is wall-clock time.
  double sim_ms = 0.0;
  double draw_ms = 0.0;    ///< wall-clock time
  double encode_ms = 0.0;  ///< wall-clock time of encoding and writing the picture or the shape
};

/// Excess over the bound, a fraction of the rest length, that still counts as kept.
inline constexpr double bound_rounding = 1e-6;

/// Returns true if the stretch of the springs is within the bound, and the surface stretch too if the bound limits it.
bool is_within(const sim::BoundedSettings& bound, const FrameRecord& record);

/// Measures both stretches of the current shape.
void measure_stretches(const sim::Simulation& simulation, FrameRecord& record);

/// Measures that the caller needs: all, or only those that decide about promises.
enum class Measured { all, promises };

/// Measures the current state. The CPU and wall-clock times stay 0.
FrameRecord measure_frame(const sim::Simulation& simulation, int frame, Measured measured = Measured::all);

/// Members of a summary: type, name, value before the first frame, name in the statistics. Initial values: -1 means no
/// frame; infinite means no near pair or no limit on the stiffness. Crossings are pairs of triangles; those at the
/// start are measured in the first added frame. Shares are fractions of the cloth's area, as in sim::ContactReport.
// clang-format off
#define TAUT_SUMMARY(X)                                                    \
  X(int, frames, 0, "frames")                                              \
  X(int, simulated_frames, 0, nullptr)                                     \
  X(double, max_stretch, 0.0, "max_stretch")                               \
  X(int, max_stretch_frame, 0, "max_stretch_frame")                        \
  X(double, max_p99_stretch, 0.0, "max_p99_stretch")                       \
  X(double, final_max_stretch, 0.0, "final_max_stretch")                   \
  X(double, max_surface_stretch, 0.0, "max_surface_stretch")               \
  X(int, max_surface_stretch_frame, 0, "max_surface_stretch_frame")        \
  X(double, max_p99_surface_stretch, 0.0, "max_p99_surface_stretch")       \
  X(double, final_max_surface_stretch, 0.0, "final_max_surface_stretch")   \
  X(double, max_raw_stretch, 0.0, "max_raw_stretch")                       \
  X(int, frames_over_bound, 0, "frames_over_bound")                        \
  X(int, first_frame_over_bound, -1, nullptr)                              \
  X(int, frames_blocked, 0, nullptr)                                       \
  X(int, first_frame_blocked, -1, nullptr)                                 \
  X(double, total_substeps, 0.0, nullptr)                                  \
  X(double, followed_compression_n_per_m, INFINITY, nullptr)               \
  X(double, min_distance_m, INFINITY, "smallest_distance")            \
  X(int, crossings_at_start, 0, "crossings_at_start")                      \
  X(int, final_crossings, 0, "final_crossings")                            \
  X(double, most_left_out_share, 0.0, "most_left_out_share")               \
  X(double, final_left_out_share, 0.0, "final_left_out_share")             \
  X(double, final_rms_speed_m_per_s, 0.0, "final_rms_speed")               \
  X(int, asleep_since_frame, -1, "asleep_since_frame")                     \
  X(double, total_sim_ms, 0.0, "total_sim_ms")                             \
  X(double, total_draw_ms, 0.0, "total_draw_ms")                           \
  X(double, total_encode_ms, 0.0, "total_encode_ms")
// clang-format on

/// Summary of the added frames.
struct RunSummary {
  void add(const FrameRecord& record);

  // Means per simulated frame.
  double mean_substeps() const { return total_substeps / std::max(simulated_frames, 1); }
  double mean_sim_ms() const { return total_sim_ms / std::max(simulated_frames, 1); }

#define TAUT_MEMBER(type, member, first, name) type member = first;
  TAUT_SUMMARY(TAUT_MEMBER)
#undef TAUT_MEMBER
};

/// Calls `field` with the statistics name and the number of every member of a summary, in the order of checkpoints. A
/// null name: the member is not in the statistics.
template <class Summary, class Field> void for_each_field(Summary& summary, const Field& field) {
#define TAUT_FIELD(type, member, first, name) field(name, summary.member);
  TAUT_SUMMARY(TAUT_FIELD)
#undef TAUT_FIELD
}

/// Describes in how many frames the solver's bound was exceeded, in which frame first, and by how much; empty: in none.
std::string describe_excess(const Scene& scene, const RunSummary& summary);

/// Describes how many pairs of triangles crossed at the start and cross at the end, and for which fraction of the cloth
/// contact is left out around them; empty: none crossed.
std::string describe_crossings(const RunSummary& summary);

/// Prints warnings to standard error if frames exceeded the solver's bound, if crossings were possible in a scene that
/// accepts them, or if time steps were too long for the fabric's compression stiffness. Returns the command's exit
/// code: exit_promise_broken if the bound was exceeded and the scene does not allow that, else 0.
int judge_bound(const Scene& scene, const RunSummary& summary);

}  // namespace taut::app
