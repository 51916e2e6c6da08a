#pragma once

#include "app/scene/scene.hpp"
#include "sim/measures.hpp"
#include "sim/simulation.hpp"

namespace taut::app {

/// Measurements of one frame. Stretch is a fraction.
struct FrameRecord {
  int frame = 0;
  double time_s = 0.0;
  sim::Stretch stretch;  ///< of the springs
  sim::SurfaceStretch surface_stretch;
  double raw_max_stretch = 0.0;  ///< before the solver's last correction
  bool bound_kept = true;        ///< false: the solver has a bound and exceeded it
  bool blocked = false;          ///< something may cross, and the scene accepts it
  int substeps = 0;
  double followed_compression_n_per_m =
      std::numeric_limits<double>::infinity();  ///< as sim::FrameReport has it
  sim::ContactReport contact = {};
  double rms_speed_m_per_s = 0.0;
  sim::Energy energy;
  double convergence_m = 0.0;  ///< the largest |p(t) - p(t - dt)| of any vertex, from frame to frame
  std::uint64_t state_hash = 0;
  bool asleep = false;
  /// Those that --verify does not allow; empty: nobody has counted (frame_verifier.hpp).
  std::optional<std::size_t> crossing_pairs = {};
  /// Processor time of the thread that simulates, which waits for its helpers without sleeping. In the
  /// window, which has to keep up with the clock, time on the clock.
  double sim_ms = 0.0;
  double draw_ms = 0.0;    ///< wall time
  double encode_ms = 0.0;  ///< wall time of encoding and writing the picture or the shape
};

/// How much more than the bound a stretch may be and still count as kept, a fraction.
inline constexpr double bound_rounding = 1e-6;

/// Whether the record's stretches are within the bound: that of the springs, and that of the surface too if
/// the bound holds it.
bool is_within(const sim::BoundedSettings& bound, const FrameRecord& record);

/// Measures both stretches of the present shape.
void measure_stretches(const sim::Simulation& simulation, FrameRecord& record);

/// Which measures somebody reads: all, or those that say whether promises are kept.
enum class Measured { all, promises };

/// Measures the present state. The times stay 0.
FrameRecord measure_frame(const sim::Simulation& simulation, int frame, Measured measured = Measured::all);

/// A summary of the frames that were added.
struct RunSummary {
  void add(const FrameRecord& record);

  double mean_substeps() const;  ///< per simulated frame
  double mean_sim_ms() const;    ///< per simulated frame

  int frames = 0;
  int simulated_frames = 0;  ///< without frame 0
  double max_stretch = 0.0;  ///< of all frames
  int max_stretch_frame = 0;
  double max_p99_stretch = 0.0;
  double final_max_stretch = 0.0;
  double max_surface_stretch = 0.0;  ///< of all frames
  int max_surface_stretch_frame = 0;
  double max_p99_surface_stretch = 0.0;
  double final_max_surface_stretch = 0.0;
  double max_raw_stretch = 0.0;
  int frames_over_bound = 0;
  int first_frame_over_bound = -1;  ///< none: -1
  int frames_blocked = 0;
  int first_frame_blocked = -1;  ///< none: -1
  double total_substeps = 0.0;
  double followed_compression_n_per_m =
      std::numeric_limits<double>::infinity();  ///< in the least stiff frame
  /// Of all frames, as sim::ContactReport has it; infinite: nothing was near.
  double smallest_distance_m = std::numeric_limits<double>::infinity();
  int crossings_at_start = 0;  ///< pairs of triangles, measured in the first frame that was added
  int final_crossings = 0;
  double most_left_out_share = 0.0;  ///< of the cloth's area, as sim::ContactReport has it
  double final_left_out_share = 0.0;
  double final_rms_speed_m_per_s = 0.0;
  int asleep_since_frame = -1;  ///< none: -1
  double total_sim_ms = 0.0;
  double total_draw_ms = 0.0;
  double total_encode_ms = 0.0;
};

/// Calls `field` with the name and the number of every member of a summary, in the order of checkpoints. The
/// name is the one in the statistics; null: it is not there.
template <class Summary, class Field>
void for_each_field(Summary& summary, const Field& field) {
  field("frames", summary.frames);
  field(nullptr, summary.simulated_frames);
  field("max_stretch", summary.max_stretch);
  field("max_stretch_frame", summary.max_stretch_frame);
  field("max_p99_stretch", summary.max_p99_stretch);
  field("final_max_stretch", summary.final_max_stretch);
  field("max_surface_stretch", summary.max_surface_stretch);
  field("max_surface_stretch_frame", summary.max_surface_stretch_frame);
  field("max_p99_surface_stretch", summary.max_p99_surface_stretch);
  field("final_max_surface_stretch", summary.final_max_surface_stretch);
  field("max_raw_stretch", summary.max_raw_stretch);
  field("frames_over_bound", summary.frames_over_bound);
  field(nullptr, summary.first_frame_over_bound);
  field(nullptr, summary.frames_blocked);
  field(nullptr, summary.first_frame_blocked);
  field(nullptr, summary.total_substeps);
  field(nullptr, summary.followed_compression_n_per_m);
  field("smallest_distance", summary.smallest_distance_m);
  field("crossings_at_start", summary.crossings_at_start);
  field("final_crossings", summary.final_crossings);
  field("most_left_out_share", summary.most_left_out_share);
  field("final_left_out_share", summary.final_left_out_share);
  field("final_rms_speed", summary.final_rms_speed_m_per_s);
  field("asleep_since_frame", summary.asleep_since_frame);
  field("total_sim_ms", summary.total_sim_ms);
  field("total_draw_ms", summary.total_draw_ms);
  field("total_encode_ms", summary.total_encode_ms);
}

/// Says in how many frames the solver's bound was exceeded, in which first and by how much. Empty: in none.
std::string describe_excess(const Scene& scene, const RunSummary& summary);

/// Says how many pairs of triangles crossed at the start and cross at the end, and which part of the cloth
/// contact leaves out around them. Empty: nothing crossed.
std::string describe_crossings(const RunSummary& summary);

/// Prints to standard error how a run differs from what the scene asks for. That is: frames exceeded the
/// solver's bound, something may have crossed where the scene accepts that, or time steps were too long for
/// the fabric's stiffness against compression. Returns the exit code of the command: exit_promise_broken if
/// the bound was exceeded and the scene does not allow it, else 0.
int judge_bound(const Scene& scene, const RunSummary& summary);

}  // namespace taut::app
