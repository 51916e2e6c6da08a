#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/bench/entrants.hpp"

namespace taut::app {

/// One frame of one run; stretch over the structural springs, measured from positions.
struct FrameSample {
  FrameCost cost;
  double raw_stretch = 0.0;  ///< of the worst spring, before the engine's last correction
  double stretch = 0.0;      ///< of the worst spring
  double p99_stretch = 0.0;
};

enum class RunEnd {
  finished,
  diverged,
  too_slow,  ///< given up: its frames took longer than the limit
  hopeless,  ///< given up: stretched beyond any use
};

const char* name_of(RunEnd end);

struct Run {
  Entrant entrant;
  std::vector<FrameSample> frames;
  RunEnd end = RunEnd::finished;
  std::vector<sim::Vec3> most_stretched;  ///< the positions of the frame with the largest stretch
};

struct RaceSettings {
  int frames = 120;
  double slowest_frame_ms = 200.0;
  double hopeless_stretch = 0.5;
};

/// Runs all entrants on the scene a few frames each in turns, so that whatever else the machine does meets
/// all alike. `after_turn` is told how many frames are done.
std::vector<Run> race(const std::vector<Entrant>& entrants, const GarmentInScene& cloth, const Scene& scene,
                      const RaceSettings& settings, const std::function<void(int)>& after_turn);

}  // namespace taut::app
