#pragma once

#include <memory>
#include <stdexcept>

#include "sim/garment.hpp"
#include "sim/solvers/solver.hpp"
#include "sim/state.hpp"
#include "sim/surroundings.hpp"

namespace taut::sim {

/// When cloth counts as at rest. A steady garment that moved less than the speed for that many frames is put
/// to sleep.
struct RestSettings {
  double speed_m_per_s = 1e-4;  ///< root mean square; higher sleeps earlier, and further from equilibrium
  int frames = 30;

  bool operator==(const RestSettings&) const = default;
};

struct SimulationSettings {
  double frame_rate_hz = 60.0;
  SolverSettings solver;
  RestSettings rest;

  bool operator==(const SimulationSettings&) const = default;
};

/// A coordinate became infinite or undefined; the state is lost.
class Diverged : public std::runtime_error {
 public:
  Diverged(Index vertex, double time_s);
};

/// A garment, where it is, and what acts on it, moved on frame by frame.
class Simulation {
 public:
  /// Throws std::invalid_argument on settings a solver refuses or a frame rate that is not positive.
  Simulation(Garment garment, const SimulationSettings& settings, Surroundings surroundings);

  /// Moves on by 1 / frame rate. A garment at rest is left as it is (the paper's Step 2: where no force
  /// results, go straight to rendering). Throws Diverged.
  void advance_frame();

  /// Each wakes the garment where it changes anything.
  void set_surroundings(const Surroundings& surroundings);
  void set_settings(const SimulationSettings& settings);
  void set_pins(std::vector<Index> pins);

  /// Goes on from a state that this garment was in, with what was shown of it; positions of this garment's
  /// vertices. What a solver remembers of earlier frames is not part of a state: it begins anew.
  void go_back_to(const State& state, std::span<const Vec3> shown);

  const Garment& garment() const { return garment_; }
  const State& state() const { return state_; }
  /// What is to be shown and written: the state's positions, or where a solver promises a bound on stretch,
  /// positions near them that keep it, also before the first frame of new settings. In metres, by vertex.
  std::span<const Vec3> shown_positions() const;
  /// Of the last frame; asleep, of the last frame that was computed.
  const FrameReport& frame_report() const { return report_; }
  const Surroundings& surroundings() const { return surroundings_; }
  const SimulationSettings& settings() const { return settings_; }
  double frame_time_s() const { return 1.0 / settings_.frame_rate_hz; }

 private:
  void start_solver(std::span<const Vec3> shown);
  void wake();
  void fall_asleep_at_rest();

  Garment garment_;
  SimulationSettings settings_;
  Surroundings surroundings_;
  State state_;
  std::unique_ptr<Solver> solver_;
  std::vector<Vec3> shown_before_m_;  ///< shown until the solver has computed a frame; empty: the state
  FrameReport report_;
};

}  // namespace taut::sim
