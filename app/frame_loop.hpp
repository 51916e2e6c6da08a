#pragma once

#include "app/base/errors.hpp"
#include "app/frame_pipeline.hpp"
#include "app/output/frame_record.hpp"
#include "renderer/page/image.hpp"
#include "sim/simulation.hpp"

namespace taut::app {

/// A frame could not be made without a crossing (sim::ContactBlocked). The simulation is where it was before.
struct FrameBlocked : PromiseBroken {
  FrameBlocked(int blocked_frame, const sim::ContactBlocked& error);

  int frame;
  sim::BlockedContact blocked;
};

/// Receivers of the frames of a run. Every member may be left empty.
struct FrameOutputs {
  std::span<const int> pictures;  ///< numbers of the frames to draw, ascending
  int start_frame = 0;            ///< frame the simulation is at
  bool with_start = false;        ///< also hands out the start frame, drawn or not
  Measured measured = Measured::all;
  /// Called on the thread that called run_frames.
  std::function<renderer::Image(const std::vector<sim::Vec3>& positions, double time_s)> draw_positions;
  /// This and report are called frame after frame, but not always on the caller's thread. The record lacks
  /// only `encode_ms`.
  std::function<void(const FrameRecord&, const renderer::Image&)> write_frame;
  std::function<void(int frame, const sim::Simulation&)> write_shape;  ///< called while the simulation waits
  std::function<void(const FrameRecord&)> report;
  /// Called first of all, for the start frame too, handed out or not. Returns what promise the frame breaks;
  /// empty: none. A frame that breaks one is reported, but neither drawn nor written.
  std::function<std::string(const sim::Simulation&, FrameRecord&)> verify;
  /// If set, all frames are simulated before the first is drawn, and handed to this in between; positions are
  /// empty of frames that are not drawn. Called on the caller's thread.
  std::function<void(std::span<const FrameInWork>)> before_drawing;
  /// Called on the simulating thread for every frame, before it is drawn.
  std::function<void(const FrameRecord&)> simulated;
  /// Later frames are simulated while earlier ones are drawn and written; never changes what comes out.
  bool overlap = true;
};

/// Simulates the frames after the start frame up to `last_frame`; frame n is the cloth n / frame rate seconds
/// after the clock started, frame 0 the cloth as it was modelled. Returns what was
/// measured of these, and of the start frame where that is drawn or asked for. Throws sim::Diverged,
/// FrameBlocked, PromiseBroken after the report of a frame that was not verified, Interrupted and what the
/// outputs throw; the pictures written before are complete. Without overlap, an interrupted run has handed
/// out every frame that it has simulated.
std::vector<FrameRecord> run_frames(sim::Simulation& simulation, int last_frame, const FrameOutputs& outputs);

}  // namespace taut::app
