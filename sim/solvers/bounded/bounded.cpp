#include "sim/solvers/bounded/bounded.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <limits>

#include "sim/measures.hpp"
#include "sim/solvers/bounded/compression.hpp"
#include "sim/solvers/bounded/projection.hpp"
#include "sim/solvers/bounded/step.hpp"
#include "sim/solvers/bounded/substep_control.hpp"
#include "sim/solvers/bounded/thread_choice.hpp"
#include "sim/solvers/bounded/within_bound.hpp"

namespace taut::sim {

using namespace bounded;

namespace {

/// Time steps in a frame. Fewer would do for small stiff cloths, and let fast ones pass through obstacles.
constexpr int least_substeps = 8;

/// A projection that costs more sweeps than this many times the substeps is not worth it: more substeps are.
constexpr double costliest_projection = 3.0;
/// Where no more substeps are to be had, it is.
constexpr double last_resort_sweeps = 1000.0;

/// A frame corrected by this many times more than allowed is repeated, unless the frame before it was
/// corrected as far.
constexpr double too_far = 3.0;
constexpr double further_than_before = 1.2;

/// Rounds of a correction that go on within the same regions.
constexpr int most_rounds = 8;

/// Cloth made of springs gives a little across them; tethers of the exact length would lift it.
double tether_slack(const BoundedSettings& settings) {
  return settings.bound == BoundKind::springs ? 0.5 * settings.max_stretch : 0.0;
}

}  // namespace

const char* name_of(BoundKind kind) {
  constexpr std::array names = {"springs", "surface"};
  return names[static_cast<std::size_t>(kind)];
}

/// What the solver derives from a garment, and keeps from frame to frame.
struct BoundedSolver::Cloth : SteppedCloth {
  Cloth(const Garment& garment, const Pins& pinned, const BoundedSettings& settings, double frame_time_s)
      : SteppedCloth(garment, pinned, settings, frame_time_s),
        pins(pinned.vertices),
        compression_stiffness_n_per_m(garment.material.compression_stiffness_n_per_m),
        projection(layout),
        mobility_per_kg(mean_mobility_per_kg(layout)) {
    if (settings.tethers && layout.pin_count > 0) {
      tethers = make_tethers(garment, layout, tether_slack(settings));
    }
  }

  std::vector<Index> pins;
  double compression_stiffness_n_per_m;
  BoundProjection projection;
  SubstepControl control{1, 1, 1};
  ThreadChoice threads;
  double mobility_per_kg;
  Float4Array velocities;    ///< m/s, when the frame began
  double shift = 0.0;        ///< of the last frame, in parts of the largest allowed
  double time_step_s = 0.0;  ///< the one the springs' short_share is made for
};

/// Keeps the last correction of a frame from making anything cross.
class BoundedSolver::ApartWhileCorrected : public Confinement {
 public:
  ApartWhileCorrected(const Garment& garment, double time_s, ParallelKernels& kernels, Cloth& cloth)
      : garment_(garment), time_s_(time_s), kernels_(kernels), cloth_(cloth) {}

  void begin(const Float4Array& raw, const Float4Array& expected) override {
    cloth_.contacts.make_regions(garment_, cloth_.layout, cloth_.motion, raw, expected, time_s_, kernels_);
    last_ = raw;
  }

  // Where rows are held back by their balls there is more room from where they have come; and so there is
  // beside planes from which one of the two has moved away.
  void bring_back(Float4Array& displacements) override {
    ++rounds_;
    if (is_held_back_ || rounds_ % most_rounds == 0) {
      moved_.resize(last_.size());
      for (std::size_t row = 0; row < last_.size(); ++row) {
        moved_[row] = scaled_sum(displacements[row], last_[row], -1.0F);
      }
      cloth_.contacts.renew_regions(garment_, cloth_.layout, cloth_.motion, last_, moved_, time_s_, kernels_);
    }
    is_held_back_ = cloth_.contacts.keep_apart(kernels_, displacements);
    last_ = displacements;
  }

 private:
  const Garment& garment_;
  double time_s_;
  ParallelKernels& kernels_;
  Cloth& cloth_;
  int rounds_ = 0;
  bool is_held_back_ = false;
  Float4Array last_;  ///< displacements that are known to keep everything apart
  Float4Array moved_;
};

BoundedSolver::BoundedSolver(const BoundedSettings& settings, std::optional<int> substeps, int max_substeps)
    : settings_(settings), substeps_(substeps), max_substeps_(max_substeps) {
  kernels_for(settings.vector_unit);  // refuses now what it would refuse in the first frame
}

BoundedSolver::~BoundedSolver() = default;

bool BoundedSolver::is_laid_out_for(const Garment& garment, const Pins& pins) const {
  return cloth_ && cloth_->pins == pins.vertices &&
         cloth_->layout.vertex_count() == garment.mesh.positions.size();
}

void BoundedSolver::lay_out(const Garment& garment, const Pins& pins, const Surroundings& surroundings,
                            double frame_time_s) {
  if (is_laid_out_for(garment, pins)) {
    return;
  }
  kernels_ = std::make_unique<ParallelKernels>(
      kernels_for(settings_.vector_unit), thread_count(settings_.threads, garment.mesh.triangles.size()));
  cloth_ = std::make_unique<Cloth>(garment, pins, settings_, frame_time_s);
  if (substeps_) {
    cloth_->control = SubstepControl(*substeps_, *substeps_, *substeps_);
  } else {
    const int least = std::max(least_substeps, cloth_->forces.updates_per_frame({}, frame_time_s));
    cloth_->control = SubstepControl(
        first_substeps(garment, cloth_->layout, surroundings, frame_time_s, settings_.max_stretch), least,
        max_substeps_);
  }
}

void BoundedSolver::begin_frame(const State& state) {
  const Layout& layout = cloth_->layout;
  Motion& motion = cloth_->motion;
  motion.start_m.resize(layout.vertex_count());
  for (Float4Array* rows : {&motion.current, &motion.previous, &cloth_->velocities}) {
    rows->resize(layout.row_count());
  }
  const double steps_per_s = state.time_step_s > 0.0 ? 1.0 / state.time_step_s : 0.0;
  for (std::size_t row = 0; row < layout.vertex_count(); ++row) {
    const Index v = layout.vertex_of_row[row];
    motion.start_m[row] = state.current[v];
    cloth_->velocities[row] = float4_of((state.current[v] - state.previous[v]) * steps_per_s);
  }
  set_start(layout, state.current, motion.start);
  kernels_->start(motion.start, cloth_->layout.springs);
  kernels_->start(motion.start, cloth_->layout.surface);
  start_tethers(motion.start, cloth_->tethers);
}

void BoundedSolver::begin_substeps(double time_step_s) {
  Cloth& cloth = *cloth_;
  const auto h = static_cast<float>(time_step_s);
  for (std::size_t row = 0; row < cloth.layout.vertex_count(); ++row) {
    const Float4& v = cloth.velocities[row];
    cloth.motion.current[row] = Float4{};
    cloth.motion.previous[row] = {-v.x * h, -v.y * h, -v.z * h, 0.0F};
  }
  if (cloth.time_step_s != time_step_s) {
    cloth.time_step_s = time_step_s;
    set_short_shares(cloth.compression_stiffness_n_per_m, time_step_s, cloth.layout);
  }
}

void BoundedSolver::run_substeps(const Garment& garment, const Surroundings& surroundings, double time_s,
                                 double frame_time_s, int substeps, int earlier_attempts) {
  Cloth& cloth = *cloth_;
  const double dt = frame_time_s / substeps;
  const int updates = cloth.forces.updates_per_frame(surroundings.forces, frame_time_s);
  const int substeps_per_update = std::max(1, substeps / updates);
  const int wind_updates = cloth.forces.wind_updates_per_frame(surroundings.forces, frame_time_s);
  const int substeps_per_wind =
      std::max(1, substeps / wind_updates / substeps_per_update) * substeps_per_update;
  begin_substeps(dt);
  cloth.contacts.begin_attempt({time_s, time_s + frame_time_s}, earlier_attempts);
  for (int substep = 0; substep < substeps; ++substep) {
    TimeStep time;
    time.frame_began_s = time_s;
    time.frame_ends_s = time_s + frame_time_s;
    time.time_s = time_s + substep * dt;
    time.time_step_s = dt;
    time.updates_forces = substep % substeps_per_update == 0;
    time.update_interval_s = substeps_per_update * dt;
    time.updates_wind = substep % substeps_per_wind == 0;
    time.wind_interval_s = substeps_per_wind * dt;
    bounded::step(garment, surroundings, time, *kernels_, cloth);
  }
}

// The shape that keeps the bound is where the next frame begins.
void BoundedSolver::write_shape(const Surroundings& surroundings, double frame_time_s, State& state) const {
  const Cloth& cloth = *cloth_;
  for (std::size_t row = 0; row < cloth.layout.vertex_count(); ++row) {
    state.current[cloth.layout.vertex_of_row[row]] =
        cloth.motion.start_m[row] + vector_of(cloth.projection.corrected()[row]);
  }
  // Exactly where they belong: what single precision rounds away would add up from frame to frame.
  const std::vector<Vec3> moved_m =
      pins_moved(surroundings, cloth, {state.time_s, state.time_s + frame_time_s});
  for (std::size_t row = 0; row < moved_m.size(); ++row) {
    state.current[cloth.layout.vertex_of_row[row]] = cloth.motion.start_m[row] + moved_m[row];
  }
}

// Positions of a time step ago go with the shape, so that its last correction adds no velocity.
void BoundedSolver::end_frame(double frame_time_s, int substeps, State& state) const {
  const Cloth& cloth = *cloth_;
  for (std::size_t row = 0; row < cloth.layout.vertex_count(); ++row) {
    const Vec3 moved = vector_of(cloth.motion.current[row]) - vector_of(cloth.motion.previous[row]);
    const Index v = cloth.layout.vertex_of_row[row];
    state.previous[v] = state.current[v] - moved;
  }
  state.time_step_s = frame_time_s / substeps;
  state.time_s += frame_time_s;
  state.step_count += static_cast<std::uint64_t>(substeps);
}

// From where the frame began: the time steps, and the projection of where they end onto the bound.
ProjectionResult BoundedSolver::try_frame(const Garment& garment, const Pins& pins,
                                          const Surroundings& surroundings, double frame_time_s,
                                          int earlier_attempts, State& state) {
  Cloth& cloth = *cloth_;
  const int substeps = cloth.control.substeps();
  run_substeps(garment, surroundings, state.time_s, frame_time_s, substeps, earlier_attempts);
  const double largest_cost = cloth.control.is_spent() ? last_resort_sweeps : costliest_projection * substeps;
  cloth.contacts.observe(cloth.layout, cloth.motion, state.time_s + frame_time_s);
  ApartWhileCorrected apart(garment, state.time_s + frame_time_s, *kernels_, cloth);
  const auto project = [&](Confinement* confinement) {
    return cloth.projection.project(cloth.layout, cloth.motion.current, settings_.max_stretch, largest_cost,
                                    confinement, *kernels_);
  };
  ProjectionResult projected = project(cloth.contacts.is_on() ? &apart : nullptr);
  // Where a crossing is accepted, it is no reason to break the other promise.
  if (!projected.kept && settings_.allow_crossing && cloth.contacts.is_blocked() &&
      cloth.control.is_spent()) {
    projected = project(nullptr);
  }
  write_shape(surroundings, frame_time_s, state);
  if (!projected.kept || cloth.layout.surface.has_thin) {
    projected.kept = keeps_bound_in_double(garment, pins, settings_, state.current);
  }
  return projected;
}

// Otherwise the cloth goes back to where the frame began. Where it is lost, contact is not what went wrong.
void BoundedSolver::require_a_way_on(const Pins& pins, const Surroundings& surroundings, double frame_time_s,
                                     State& state) const {
  const Cloth& cloth = *cloth_;
  if (!cloth.contacts.is_blocked() || settings_.allow_crossing ||
      first_lost(state.current) < state.current.size()) {
    return;
  }
  for (std::size_t row = 0; row < cloth.layout.vertex_count(); ++row) {
    state.current[cloth.layout.vertex_of_row[row]] = cloth.motion.start_m[row];
  }
  throw ContactBlocked(cloth.contacts.blocked(), pins, surroundings.bodies, state.time_s + frame_time_s);
}

FrameReport BoundedSolver::advance_frame(const Garment& garment, const Pins& pins,
                                         const Surroundings& surroundings, double frame_time_s,
                                         State& state) {
  lay_out(garment, pins, surroundings, frame_time_s);
  const auto began = std::chrono::steady_clock::now();
  Cloth& cloth = *cloth_;
  kernels_->share(cloth.threads.is_shared());
  begin_frame(state);
  cloth.contacts.begin_frame(garment, cloth.layout, surroundings, cloth.motion, state.time_s);
  SubstepControl& control = cloth.control;
  ProjectionResult projected;
  const double allowed_m = allowed_shift_m(cloth.layout, settings_.max_stretch);
  double sweeps = 0.0;
  double shift = 0.0;
  int attempts = 0;
  bool is_good = false;
  do {
    projected = try_frame(garment, pins, surroundings, frame_time_s, attempts++, state);
    sweeps += control.substeps() + projected.cost;
    shift = allowed_m > 0.0 ? projected.largest_shift_m / allowed_m : 0.0;
    is_good = projected.kept && !cloth.contacts.is_blocked() &&
              (shift <= too_far || shift <= further_than_before * cloth.shift);
    // Regions that hold cloth back are no reason for more steps: first with the same again, and more care.
  } while (!is_good && ((cloth.contacts.is_on() && attempts == 1) || control.try_more()));
  require_a_way_on(pins, surroundings, frame_time_s, state);
  cloth.shift = shift;
  cloth.projection.end_frame();
  cloth.contacts.end_frame();

  const int substeps = control.substeps();
  control.frame_kept(projected.cost, shift);
  end_frame(frame_time_s, substeps, state);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
  cloth.threads.frame_took(took.count(), kernels_->take_work());
  return {substeps,
          true,
          projected.kept,
          projected.raw_max_stretch,
          sweeps,
          followed_compression(cloth.mobility_per_kg, frame_time_s / substeps),
          cloth.contacts.is_blocked() ? std::optional(cloth.contacts.blocked()) : std::nullopt,
          !settings_.contact,
          cloth.contacts.report()};
}

// With other pins than the last frame's the next one begins anew.
void BoundedSolver::save(const Garment& garment, const Pins& pins, ByteWriter& memory) const {
  const bool goes_on = is_laid_out_for(garment, pins);
  memory.put<std::uint8_t>(goes_on ? 1 : 0);
  if (goes_on) {
    memory.put(cloth_->shift);
    cloth_->control.save(memory);
    cloth_->projection.save(cloth_->layout, memory);
    cloth_->contacts.save(cloth_->layout, memory);
  }
}

void BoundedSolver::restore(const Garment& garment, const Pins& pins, const Surroundings& surroundings,
                            double frame_time_s, ByteReader& memory) {
  if (!memory.get_bool("whether there was a frame")) {
    cloth_.reset();
    return;
  }
  lay_out(garment, pins, surroundings, frame_time_s);
  cloth_->shift = memory.get("the last frame's shift", 0.0, std::numeric_limits<double>::max());
  cloth_->control.restore(memory);
  cloth_->projection.restore(cloth_->layout, memory);
  cloth_->contacts.restore(cloth_->layout, memory);
}

}  // namespace taut::sim
