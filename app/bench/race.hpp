#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/bench/entrants.hpp"
#include "sim/measures.hpp"

namespace taut::app {

/// One frame of one run. Stretch is measured from positions, over the structural springs, as a fraction.
struct FrameSample {
  FrameCost cost;
  double raw_stretch = 0.0;  ///< of the worst spring, before the engine's last correction
  double stretch = 0.0;      ///< of the worst spring
  double p99_stretch = 0.0;
  sim::SurfaceStretch surface = {};  ///< of the triangles, from the same positions
};

/// How a run ended.
enum class RunEnd {
  finished,  ///< all frames were computed
  diverged,  ///< the engine threw sim::Diverged
  too_slow,  ///< stopped: the mean frame took longer than RaceSettings::slowest_frame_ms
  hopeless,  ///< stopped: stretched more than RaceSettings::hopeless_stretch
};

/// For people and JSON.
const char* name_of(RunEnd end);

/// What one entrant did on one scene.
struct Run {
  Entrant entrant;
  std::vector<FrameSample> frames;  ///< those that were computed
  RunEnd end = RunEnd::finished;
  /// Positions in metres, per vertex, of the frame with the largest stretch.
  std::vector<sim::Vec3> most_stretched;
};

/// How long runs are and when a run is stopped early.
struct RaceSettings {
  int frames = 120;
  double slowest_frame_ms = 200.0;  ///< mean processor time per frame; a slower run is stopped
  double hopeless_stretch = 0.5;    ///< a fraction; a frame with more stretch stops the run
};

/// Runs all entrants on the scene. They take turns of a few frames each, so that other load on the machine
/// affects all alike. `after_turn` is called with the number of frames that every entrant has done.
std::vector<Run> race(const std::vector<Entrant>& entrants, const GarmentInScene& cloth, const Scene& scene,
                      const RaceSettings& settings, const std::function<void(int)>& after_turn);

}  // namespace taut::app
