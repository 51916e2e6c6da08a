#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "app/viewer/snapshot.hpp"

namespace taut::app {

/// The last values of something, oldest first.
class RecentValues {
 public:
  void add(float value);
  void clear() { values_.clear(); }
  std::span<const float> values() const { return values_; }
  float last() const { return values_.empty() ? 0.0F : values_.back(); }

  static constexpr std::size_t most = 300;

 private:
  std::vector<float> values_;
};

/// What is plotted beside the scene.
struct Measurements {
  RecentValues max_stretch;
  RecentValues convergence_mm;  ///< the largest |p(t) - p(t - dt)| of a frame
  // Milliseconds of the clock; a run that has to look the same every time does not show them.
  RecentValues simulate_ms;
  RecentValues draw_ms;
  RecentValues panel_ms;
  bool shows_times = true;

  /// Takes note of what a frame of the simulation measured.
  void add(const FrameRecord& record);
  void forget();
};

}  // namespace taut::app
