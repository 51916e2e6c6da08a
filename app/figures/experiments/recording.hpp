#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "app/base/job_runner.hpp"
#include "app/drawing/drawn_scene.hpp"
#include "app/output/frame_record.hpp"
#include "sim/garment.hpp"

namespace taut::app {

/// One moment of a run: where every vertex was, and what was measured then.
struct Moment {
  FrameRecord record;
  std::vector<sim::Vec3> positions;
};

/// What figures are drawn from once a scene has been run.
struct Recording {
  DrawnScene scene;
  std::shared_ptr<const sim::Garment> garment;
  std::vector<sim::Index> pins;
  std::vector<Moment> moments;
  double largest_stretch = 0.0;  ///< of all frames

  const Moment& last() const { return moments.back(); }
};

/// Runs the scene up to the last of the frames (ascending) and keeps those.
Recording record_frames(const DrawnScene& scene, std::span<const int> frames, const Checkpoint& checkpoint);

/// A run looked at after every single time step, which is the paper's iteration.
struct StepRecording {
  Recording frames;
  double time_step_s = 0.0;
  sim::Index vertex = 0;
  std::vector<double> moved_m;  ///< |p(t) - p(t - dt)| of the vertex, one entry a step
  bool came_to_rest = false;
};

/// Runs the scene until it is at rest, at most to the last of the frames (ascending). They are kept as by
/// `record_frames`; where the cloth is at rest earlier, that moment stands for those that would follow.
StepRecording record_steps(const DrawnScene& scene, std::span<const int> frames, sim::Index vertex,
                           const Checkpoint& checkpoint);

/// The scene with one time step a frame instead of several, of the same length: frames become steps.
DrawnScene with_steps_as_frames(DrawnScene scene);

}  // namespace taut::app
