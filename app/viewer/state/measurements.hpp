#pragma once

#include "app/viewer/simulation/snapshot.hpp"

namespace taut::app {

/// The last values of a measurement, oldest first.
class RecentValues {
 public:
  void add(float value);
  void clear() { values_.clear(); }
  std::span<const float> values() const { return values_; }
  /// 0 if there is none.
  float last() const { return values_.empty() ? 0.0F : values_.back(); }

  /// Values that are kept; older ones are forgotten.
  static constexpr std::size_t most = 300;

 private:
  std::vector<float> values_;
};

/// Compares simulated time with real time, averaged over about the last second.
class RealTime {
 public:
  /// In `elapsed_s` of real time, `simulated_s` was simulated. `busy_s` is the processor time this program
  /// used, divided by the number of processors.
  void add(double elapsed_s, double simulated_s, double busy_s);
  void forget() { *this = {}; }
  /// Simulated seconds per second of real time. Empty at the beginning.
  std::optional<double> factor() const;
  /// Fraction of all processors' time that this program used.
  double busy_share() const;

 private:
  double elapsed_s_ = 0.0;
  double simulated_s_ = 0.0;
  double busy_s_ = 0.0;
};

/// Why a simulation is slower than it should be.
enum class SlowedBy { nothing, simulation, drawing, other_programs };

/// Finds the reason. `factor` is RealTime::factor and `asked` what it should be. `simulate_ms` is the
/// processor time of a frame; `frame_ms` is what it may take at the speed asked for. If the simulation could
/// keep up, something else uses the processors: drawing if `busy_share` is high, else other programs.
SlowedBy slowed_by(double factor, double asked, double simulate_ms, double frame_ms, double busy_share);

/// A number for people that is no longer than the panel is wide, whatever the simulation does.
std::string in_little_room(double value, int decimals);

/// The stretches that the panel says beside the largest that the bound holds, which it plots: that one's 99th
/// percentile, and both of the other kind.
std::string other_stretches(const FrameRecord& record, sim::BoundKind plotted);

/// How near things come and what crosses, as the panel says it.
std::string contact_text(const sim::ContactReport& contact);

/// The measurements that the panel plots.
struct Measurements {
  RecentValues max_stretch;  ///< of the springs
  RecentValues max_surface_stretch;
  RecentValues convergence_mm;  ///< the largest |p(t) - p(t - dt)| of any vertex in a frame
  // Milliseconds of the clock; a run that has to look the same every time does not show them.
  RecentValues simulate_ms;
  RecentValues draw_ms;
  RecentValues panel_ms;
  RealTime real_time;
  double worked_ms = 0.0;  ///< processor time of the last simulated frame
  bool shows_times = true;

  /// Appends what was measured of a simulated frame.
  void add(const FrameRecord& record);
  /// Removes all values.
  void forget();
};

}  // namespace taut::app
