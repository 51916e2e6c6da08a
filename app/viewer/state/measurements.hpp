#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "app/viewer/simulation/snapshot.hpp"

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

/// How simulated time goes by beside the clock's, over about the last second.
class RealTime {
 public:
  /// In `elapsed_s` of the clock so much was simulated, and so long this program had all processors busy.
  void add(double elapsed_s, double simulated_s, double busy_s);
  void forget() { *this = {}; }
  /// Simulated seconds in a second of the clock; none in the first moments.
  std::optional<double> factor() const;
  /// Share of the processors' time that this program has had.
  double busy_share() const;

 private:
  double elapsed_s_ = 0.0;
  double simulated_s_ = 0.0;
  double busy_s_ = 0.0;
};

/// Why a simulation is slower than it was asked to be.
enum class SlowedBy { nothing, simulation, drawing, other_programs };

/// `simulate_ms` is what the processor takes for a frame, `frame_ms` what it may take at the speed asked for.
/// Where it could keep up and does not, something else has the processors: the window's drawing, if the
/// program has had most of their time, else other programs.
SlowedBy slowed_by(double factor, double asked, double simulate_ms, double frame_ms, double busy_share);

/// What is plotted beside the scene.
struct Measurements {
  RecentValues max_stretch;
  RecentValues convergence_mm;  ///< the largest |p(t) - p(t - dt)| of a frame
  // Milliseconds of the clock; a run that has to look the same every time does not show them.
  RecentValues simulate_ms;
  RecentValues draw_ms;
  RecentValues panel_ms;
  RealTime real_time;
  double worked_ms = 0.0;  ///< of the processor, for the last simulated frame
  bool shows_times = true;

  /// Takes note of what a frame of the simulation measured.
  void add(const FrameRecord& record);
  void forget();
};

}  // namespace taut::app
