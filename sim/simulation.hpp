#pragma once

#include "sim/contact/contact_measure.hpp"
#include "sim/measures.hpp"
#include "sim/pins.hpp"
#include "sim/solvers/make_solver.hpp"
#include "sim/solvers/solver.hpp"

namespace taut::sim {

/// Everything to save for a run that continues with the same bits. Garment, pins, settings and surroundings are not
/// part of it: they have to be the same when it is restored.
struct Checkpoint {
  State state;                 ///< without `predicted`
  std::vector<Vec3> before_m;  ///< shape one frame ago, one position per vertex
  /// Shape at the start of the quiet frames, one position per vertex; empty if rest is not judged.
  std::vector<Vec3> quiet_since_m;
  FrameReport report;         ///< report of the last computed frame
  std::string solver;         ///< the name of the solver
  std::string solver_memory;  ///< see Solver::save
};

/// Returns whether rest is judged; only then quiet_since_m is needed.
bool is_rest_judged(const State& state);

/// Returns the bytes of a file: magic and version, the identity of the garment (numbers of vertices, triangles and
/// springs, and a hash of rest shape, triangles, springs and masses), the checkpoint, and a hash of all bytes. Numbers
/// have their lowest byte first.
std::string encode(const Checkpoint& checkpoint, const Garment& garment);

/// Reads what encode() wrote. Throws BadBytes, with the place and the found and expected values, on bytes that are
/// damaged, cut off, of another version or of another garment. No bytes do harm.
Checkpoint decode(std::string_view bytes, const Garment& garment);

/// Condition for rest in steady surroundings: over `frames` frames in a row the net motion is slower than the speed.
/// Cloth that trembles in place rests; cloth that swings or sinks does not.
struct RestSettings {
  double speed_m_per_s = 3e-4;  ///< root mean square; higher values sleep earlier, further from equilibrium
  int frames = 30;

  bool operator==(const RestSettings&) const = default;
};

struct SimulationSettings {
  double frame_rate_hz = 60.0;
  SolverSettings solver;
  RestSettings rest_settings;

  bool operator==(const SimulationSettings&) const = default;
};

/// Thrown if a coordinate becomes infinite or undefined.
class Diverged : public std::runtime_error {
 public:
  Diverged(Index vertex, double time_s);
};

/// A garment with its state and its surroundings, advanced frame by frame.
class Simulation {
 public:
  /// `pins` are the pinned vertices. The cloth starts as modelled or at `start_m`, in metres, one position per vertex.
  /// A solver that promises a bound moves the start within it. Throws std::invalid_argument:
  /// - on settings that the solver refuses, or a frame rate that is not above 0;
  /// - on surroundings that require_possible rejects, or in which the bound is not promised (promise.hpp);
  /// - on a pin that is no vertex;
  /// - on a start with another number of positions, or with one that is not finite.
  Simulation(std::shared_ptr<const Garment> garment, std::vector<Index> pins, const SimulationSettings& settings,
             Surroundings surroundings, std::optional<std::vector<Vec3>> start_m = {});

  /// Advances by 1 / frame rate. A garment at rest stays unchanged (the paper's Step 2: where no force results, go
  /// straight to rendering). `poll` is called at least once in every time step and search. Throws Diverged,
  /// ContactBlocked and the exceptions of `poll`; the simulation is then unchanged to the last bit.
  void advance_frame(const std::function<void()>& poll = {});

  /// Sets the clock of the surroundings and wakes the garment, whose shape stays. Below 0 s no motion has begun.
  void set_time(double time_s);

  /// Each wakes the garment if anything changes, and throws as the constructor does.
  void set_surroundings(const Surroundings& surroundings);
  void set_settings(const SimulationSettings& settings);
  /// Changes the material in a private copy of the garment. Throws as make_garment does.
  void set_material(const Material& material);
  /// Throws std::invalid_argument on a pin that is no vertex, and changes nothing then.
  void set_pins(std::vector<Index> pins);

  /// Returns everything that decides later frames except garment, pins, settings and surroundings.
  Checkpoint save() const;
  /// Continues a saved run with the same bits. Requires its garment, pins, settings and surroundings. Throws BadBytes
  /// on another number of vertices or another solver, and changes nothing then.
  void restore(const Checkpoint& checkpoint);

  const Garment& garment() const { return *garment_; }
  std::shared_ptr<const Garment> shared_garment() const { return garment_; }
  const Pins& pins() const { return pins_; }
  /// The current positions are the shape that is shown, written and measured. They keep a promised bound on stretch,
  /// also before the first frame of new settings.
  const State& state() const { return state_; }
  /// Change of shape in the last frame; none before the first frame and while asleep.
  ShapeChange change() const { return {before_m_, state_.current, frame_time_s()}; }
  /// Report of the last computed frame. Its contact is measured at the first call.
  const FrameReport& frame_report() const;
  /// The same report without measured contact, which takes longer than a frame of still cloth.
  const FrameReport& last_report() const { return report_; }
  /// Measures contact in the present shape, up to twice the cloth's thickness. Reports nothing near and no crossing if
  /// the solver ignores contact and there are no bodies.
  MeasuredContact measure_contact() const;
  /// Returns find_wind_fractions() of the present shape. They are found at the first call.
  const std::vector<float>& wind_fractions() const;
  const Surroundings& surroundings() const { return surroundings_; }
  const SimulationSettings& settings() const { return settings_; }
  double frame_time_s() const { return 1.0 / settings_.frame_rate_hz; }

 private:
  Frame frame(const std::function<void()>& poll) const;
  void begin_in(std::vector<Vec3> start_m);
  void start_solver();
  void wake();
  void fall_asleep_at_rest();

  std::shared_ptr<const Garment> garment_;
  Pins pins_;
  SimulationSettings settings_;
  Surroundings surroundings_;
  State state_;
  std::vector<Vec3> before_m_;       ///< shape one frame ago
  std::vector<Vec3> quiet_since_m_;  ///< shape at the start of the quiet frames
  std::unique_ptr<Solver> solver_;
  mutable FrameReport report_;
  mutable bool is_contact_measured_ = true;
  mutable std::optional<std::vector<float>> wind_fractions_;  ///< fractions for the present shape; empty until asked
  mutable std::optional<ContactMeasure> measure_;  ///< made once for these bodies; independent of the shape
};

}  // namespace taut::sim
