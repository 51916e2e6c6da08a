#pragma once

#include "app/base/job_runner.hpp"
#include "app/drawing/drawn_scene.hpp"
#include "app/output/frame_record.hpp"
#include "app/verify/stretch.hpp"

namespace taut::app {

/// One frame of a run: what was measured, and the positions in metres, per vertex.
struct Moment {
  FrameRecord record;
  std::vector<sim::Vec3> positions;
};

/// Counts in the frames of a run by FrameVerifier, which shares nothing with the solvers.
struct PromiseCounts {
  int frames = 0;                  ///< that were checked
  LargestStretch stretch;          ///< of all of them
  std::size_t crossing_pairs = 0;  ///< the sum of all of them
  std::size_t most_pairs = 0;      ///< in the frame with the most
  int crossing_frames = 0;         ///< in which something crosses
};

/// Selected frames of a run, from which figures are drawn.
struct Recording {
  DrawnScene scene;
  std::shared_ptr<const sim::Garment> garment;
  std::vector<sim::Index> pins;
  std::vector<Moment> moments;   ///< the selected frames, ascending
  double largest_stretch = 0.0;  ///< of all frames of the run, a fraction
  /// The largest of all frames, each member by itself.
  sim::SurfaceStretch largest_surface_stretch;
  std::optional<PromiseCounts> promises;  ///< empty: nobody has counted

  const Moment& last() const { return moments.back(); }
};

/// Takes the stretches of one more frame into the largest of a recording.
void note_stretch(const FrameRecord& record, Recording& recording);

/// Whether every frame is checked for what is promised; it costs about as much as the frame.
enum class Checking { none, promises };

/// Simulates the scene up to the last of `frames`, which must be ascending, and keeps these frames.
Recording record_frames(const DrawnScene& scene, std::span<const int> frames, const ProgressCallback& report_progress,
                        Checking checking = Checking::none);

/// A run that was looked at after every time step. The paper calls a step an iteration.
struct StepRecording {
  Recording frames;
  double time_step_s = 0.0;
  sim::Index vertex = 0;        ///< the vertex that was followed
  std::vector<double> moved_m;  ///< p(t) - p(t - dt)| of the vertex, one entry per step
  bool came_to_rest = false;    ///< as moments.hpp defines it
};

/// Simulates the scene until it is at rest, but not beyond the last of `frames`, which must be ascending. It
/// keeps these frames. If the cloth comes to rest earlier, that moment replaces the frames after it.
StepRecording record_steps(const DrawnScene& scene, std::span<const int> frames, sim::Index vertex,
                           const ProgressCallback& report_progress, Checking checking = Checking::none);

/// The scene with one time step per frame, where the steps keep their length. So each step becomes a frame.
DrawnScene with_steps_as_frames(DrawnScene scene);

/// Frames of the scene cloth-fall in figure 2: the fall, the swing to the far side and back, and the cloth at
/// rest. It comes to rest some time before the last of these frames.
inline constexpr std::array fall_frames = {0, 12, 21, 30, 40, 54, 80, 900};

/// In figures 2 and 3 the cloth counts as at rest if it stays within `fall_rest_m` (root mean square over the
/// vertices) for `fall_rest_s`. The swing shrinks to a tenth every two seconds, and such a small one cannot
/// be seen. A larger value ends the run earlier.
inline constexpr double fall_rest_m = 1e-4;
inline constexpr double fall_rest_s = 0.5;

/// Frames of the scene tshirt-wind-10 in figure 5. A shirt in this wind never comes to rest, so a longer run
/// would only cost more.
inline constexpr int strong_wind_frames = 100;

}  // namespace taut::app
