#pragma once

#include <functional>
#include <span>
#include <vector>

#include "app/frame_record.hpp"
#include "renderer/image.hpp"
#include "sim/simulation.hpp"

namespace taut::app {

/// What becomes of the frames of a run; every part may be left empty.
struct FrameOutputs {
  std::span<const int> pictures;  ///< frames to be drawn, ascending
  /// Draws from the positions alone, while later frames are simulated and earlier ones written. Called on the
  /// thread that called run_frames.
  std::function<renderer::Image(const std::vector<sim::Vec3>& positions)> draw_positions;
  /// Instead of `draw_positions`, for those who need more of the simulation: it waits, nothing overlaps.
  std::function<renderer::Image(const sim::Simulation&)> draw_picture;
  /// This, write_frame and report are called frame after frame, but not always on the caller's thread.
  std::function<void(int frame, const renderer::Image&)> write_picture;
  /// As write_picture, for those who write more than the picture. The record lacks only `encode_ms`.
  std::function<void(const FrameRecord&, const renderer::Image&)> write_frame;
  std::function<void(int frame, const sim::Simulation&)> write_shape;  ///< the simulation waits
  std::function<void(const FrameRecord&)> report;
};

/// Simulates frames 1 to `last_frame`; frame n is the cloth n / frame rate seconds after the clock started,
/// frame 0 the cloth as it was modelled. Returns what was measured of every frame from 1 on, and of frame 0
/// where that is drawn. Throws sim::Diverged, Interrupted and what the outputs throw; the pictures written
/// before are complete.
std::vector<FrameRecord> run_frames(sim::Simulation& simulation, int last_frame, const FrameOutputs& outputs);

}  // namespace taut::app
