#pragma once

#include "sim/contact/contact_measure.hpp"
#include "sim/measures.hpp"
#include "sim/pins.hpp"
#include "sim/solvers/make_solver.hpp"
#include "sim/solvers/solver.hpp"

namespace taut::sim {

/// Everything that has to be saved to go on with the same bits. The garment, its pins, the settings and the
/// surroundings are not in it: they have to be those of the simulation that was saved.
struct Checkpoint {
  State state;                 ///< without `predicted`
  std::vector<Vec3> before_m;  ///< the shape one frame ago, by vertex
  /// The shape at the start of the quiet frames, by vertex; empty if rest is not being judged.
  std::vector<Vec3> quiet_since_m;
  FrameReport report;         ///< of the last frame that was computed
  std::string solver;         ///< the name of the solver
  std::string solver_memory;  ///< see Solver::save
};

/// Returns whether rest is being judged: only then is quiet_since_m needed.
bool is_rest_judged(const State& state);

/// As bytes for a file: what it is and its version, which garment it was made of (numbers of vertices,
/// triangles and springs, and a hash of rest shape, triangles, springs and masses), the checkpoint, and a
/// hash of all of it. Numbers have their lowest byte first.
std::string encode(const Checkpoint& checkpoint, const Garment& garment);

/// The same back. Throws BadBytes, which says where, what was found and what was expected, on bytes that are
/// damaged, cut off, of another version or of another garment; whatever they are, they do no harm.
Checkpoint decode(std::string_view bytes, const Garment& garment);

/// When cloth counts as at rest, where nothing outside changes: when in all of that many frames it was no
/// further from where it was before them than the speed would take it in that time. Cloth that trembles about
/// where it is rests; cloth that swings or still sinks does not.
struct RestSettings {
  double speed_m_per_s = 3e-4;  ///< root mean square; higher sleeps earlier, and further from equilibrium
  int frames = 30;

  bool operator==(const RestSettings&) const = default;
};

struct SimulationSettings {
  double frame_rate_hz = 60.0;
  SolverSettings solver;
  RestSettings rest;

  bool operator==(const SimulationSettings&) const = default;
};

/// A coordinate became infinite or undefined.
class Diverged : public std::runtime_error {
 public:
  Diverged(Index vertex, double time_s);
};

/// A garment, where it is, and what acts on it, moved on frame by frame.
class Simulation {
 public:
  /// Pinned by `pins`. The cloth begins where it was modelled, or in the shape `start_m`, in metres, one
  /// position per vertex. A solver that promises a bound moves the start within it.
  /// Throws std::invalid_argument:
  /// - on settings that the solver refuses, or a frame rate that is not above 0;
  /// - on surroundings that are not possible (require_possible), or in which the bound is not promised
  ///   (promise.hpp);
  /// - on a pin that is no vertex;
  /// - on a start with another number of positions, or with one that is not finite.
  Simulation(std::shared_ptr<const Garment> garment, std::vector<Index> pins, const SimulationSettings& settings,
             Surroundings surroundings, std::optional<std::vector<Vec3>> start_m = {});

  /// Moves on by 1 / frame rate. A garment at rest is left as it is (the paper's Step 2: where no force
  /// results, go straight to rendering). `poll` is called at least once in every time step and search. Throws
  /// Diverged, ContactBlocked and what `poll` throws; the simulation is then as it was, to the last bit.
  void advance_frame(const std::function<void()>& poll = {});

  /// Sets the clock, by which the surroundings move, and wakes the garment; it stays as it is. Below 0 s what
  /// moves from the start on has not begun.
  void set_time(double time_s);

  /// Each wakes the garment if it changes anything. Each throws as the constructor does.
  void set_surroundings(const Surroundings& surroundings);
  void set_settings(const SimulationSettings& settings);
  /// The garment is made of it from now on, in a copy of its own. Throws as make_garment does.
  void set_material(const Material& material);
  /// Throws std::invalid_argument on a pin that is no vertex; nothing has changed then.
  void set_pins(std::vector<Index> pins);

  /// All that decides the frames to come, but for garment, pins, settings and surroundings.
  Checkpoint save() const;
  /// Goes on from there with the same bits, where garment, pins, settings and surroundings are those of the
  /// simulation that was saved. Throws BadBytes on a checkpoint of a garment with more or fewer vertices or
  /// of another solver; nothing has changed then.
  void restore(const Checkpoint& checkpoint);

  const Garment& garment() const { return *garment_; }
  std::shared_ptr<const Garment> shared_garment() const { return garment_; }
  const Pins& pins() const { return pins_; }
  /// Its current positions are the garment's one shape: what is shown, written and measured. Where a solver
  /// promises a bound on stretch they keep it, also before the first frame of new settings.
  const State& state() const { return state_; }
  /// How the last frame changed the shape: not at all before the first frame and while asleep.
  ShapeChange change() const { return {before_m_, state_.current, frame_time_s()}; }
  /// The report of the last frame that was computed. Its contact is measured when it is first asked for.
  const FrameReport& frame_report() const;
  /// The same without the measures of contact, which take longer than a frame of a still garment.
  const FrameReport& last_report() const { return report_; }
  /// Measures how near things are in the present shape, up to twice the cloth's thickness. Nothing is near or crosses
  /// where the solver ignores contact and there are no bodies.
  MeasuredContact measure_contact() const;
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
  std::vector<Vec3> before_m_;       ///< the shape one frame ago
  std::vector<Vec3> quiet_since_m_;  ///< the shape at the start of the quiet frames
  std::unique_ptr<Solver> solver_;
  mutable FrameReport report_;
  mutable bool is_contact_measured_ = true;
  mutable std::optional<ContactMeasure> measure_;  ///< made once for these bodies; it knows no shape
};

}  // namespace taut::sim
