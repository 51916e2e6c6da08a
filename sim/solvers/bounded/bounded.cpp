#include "sim/solvers/bounded/bounded.hpp"

#include <chrono>

#include "sim/measures.hpp"
#include "sim/solvers/bounded/projection.hpp"
#include "sim/solvers/bounded/promise.hpp"
#include "sim/solvers/bounded/step.hpp"
#include "sim/solvers/bounded/thread_choice.hpp"
#include "sim/solvers/bounded/within_bound.hpp"

namespace taut::sim {

using namespace bounded;

namespace {

/// Largest fraction of its error that a short spring can correct in one step and still push by its stiffness. Above it
/// the force depends on the length of the step: neighbours undo the correction within the step, and only more steps
/// could restore it.
constexpr double max_short_fraction = 0.9;

float short_share(float stiffness, float mobility_per_kg) {
  return stiffness * mobility_per_kg / (1.0F + stiffness * mobility_per_kg);
}

/// Sets the fraction of its error that a short spring or triangle corrects in one time step: k dt^2 w / (1 + k dt^2 w)
/// with a stiffness k in N/m and the mobility w, as in a compliant constraint (Macklin, Mueller and Chentanez 2016).
void set_short_shares(double stiffness_n_per_m, double time_step_s, Layout& layout, SurfaceLanes& surface) {
  assert(stiffness_n_per_m >= 0.0);
  assert(time_step_s > 0.0);
  const auto stiffness = static_cast<float>(stiffness_n_per_m * time_step_s * time_step_s);
  SpringLanes& springs = layout.springs;
  for (std::size_t k = 0; k < springs.lane_count(); ++k) {
    const float w = layout.inverse_masses_per_kg[springs.row_i(k)] + layout.inverse_masses_per_kg[springs.row_j(k)];
    springs.blocks[k / block_size].short_share[k % block_size] = short_share(stiffness, w);
  }
  for (std::size_t k = 0; k < surface.lane_count(); ++k) {
    surface.blocks[k / block_size].short_share[k % block_size] = short_share(stiffness, surface.mobility_per_kg[k]);
  }
}

/// Returns the mean mobility of springs and triangles, in 1/kg.
double mean_mobility_per_kg(const Layout& layout) {
  const SpringLanes& springs = layout.springs;
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t k = 0; k < springs.lane_count(); ++k) {
    if (springs.spring[k] != SpringLanes::no_spring) {
      sum += layout.inverse_masses_per_kg[springs.row_i(k)] + layout.inverse_masses_per_kg[springs.row_j(k)];
      ++count;
    }
  }
  for (const float mobility_per_kg : layout.surface.mobility_per_kg) {
    sum += mobility_per_kg;
    count += mobility_per_kg > 0.0F ? 1 : 0;
  }
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

/// Returns the largest stiffness that time steps of this length can express, in N/m: stiffer springs correct almost all
/// of their error and push no harder. Infinite if nothing can move.
double followed_compression(double mobility_per_kg, double time_step_s) {
  assert(time_step_s > 0.0);
  return max_short_fraction / (1.0 - max_short_fraction) / (time_step_s * time_step_s * mobility_per_kg);
}

/// Prevents crossings in the projection at the end of a frame.
class ContactConfinement final : public Confinement {
 public:
  /// `time_s` is the end of the frame. All arguments must outlive this object.
  ContactConfinement(const Frame& frame, double time_s, ParallelKernels& kernels, SteppedCloth& cloth)
      : frame_(frame), time_s_(time_s), kernels_(kernels), cloth_(cloth) {}

  void begin(const Float4Array& raw, const Float4Array& expected) override {
    cloth_.contacts.make_regions(frame_, cloth_.layout, cloth_.motion, raw, expected, time_s_, kernels_);
    last_ = raw;
    is_clamped_ = false;
  }
  // Vertices clamped by their trust regions get new ones around their current positions. If the correction is stuck,
  // regions that predict it push obstacles out of its way.
  void project_into_region(Float4Array& displacements, bool is_stuck) override {
    frame_.ask();
    if (is_clamped_ || is_stuck) {
      moved_.resize(last_.size());
      for (std::size_t row = 0; row < last_.size(); ++row) {
        moved_[row] = scaled_sum(displacements[row], last_[row], -1.0F);
      }
      cloth_.contacts.make_regions(frame_, cloth_.layout, cloth_.motion, last_, moved_, time_s_, kernels_);
    }
    is_clamped_ = cloth_.contacts.keep_apart(kernels_, displacements);
    last_ = displacements;
  }
  bool is_spent(double sweeps) const override { return cloth_.contacts.is_spent(sweeps); }

 private:
  const Frame& frame_;
  double time_s_;
  ParallelKernels& kernels_;
  SteppedCloth& cloth_;
  bool is_clamped_ = false;
  Float4Array last_;  ///< last displacements known to be free of crossings
  Float4Array moved_;
};

/// Stretch, in bounds, that twice the steps reduce to a target that the projection can correct.
const double halving_stretch = 4.0 * tuning::target_unprojected_stretch;
/// Stretch, in bounds, that a few more steps reduce to that target.
const double more_steps_stretch = 2.0 * tuning::target_unprojected_stretch;

/// Returns an estimate of the work of a frame, in sweeps: the projection costs as much as the substeps, plus the
/// searches.
double work_for(int substeps, double frame_time_s) {
  assert(substeps >= 0);
  assert(frame_time_s > 0.0);
  const double searches = 1.0 + tuning::touching_regions_per_s * frame_time_s;
  return 2.0 * substeps + searches * tuning::search_work_sweeps;
}

std::vector<Triangle> by_row(std::span<const Triangle> triangles, const Layout& layout) {
  std::vector<Triangle> rows;
  rows.reserve(triangles.size());
  for (const auto& [a, b, c] : triangles) {
    rows.push_back({layout.solver_indices[a], layout.solver_indices[b], layout.solver_indices[c]});
  }
  return rows;
}

/// Returns the slack of tethers. Cloth made of springs yields a little across them; tethers of the exact length would
/// lift it.
double tether_slack(const Material& material, const BoundedSettings& settings) {
  if (has_law(material) && settings.bound == BoundKind::surface) return settings.max_stretch;
  return settings.bound == BoundKind::springs ? std::min(tuning::max_tether_slack, settings.max_stretch) : 0.0;
}

}  // namespace

const char* to_name(BoundKind kind) {
  constexpr std::array names = {"springs", "surface"};
  return names[static_cast<std::size_t>(kind)];
}

/// The solver's arrays for a garment and its pins. No frame depends on the values that earlier frames left in them.
struct BoundedSolver::Cloth : SteppedCloth {
  Cloth(const Garment& garment, const Pins& pinned, const BoundedSettings& settings, double frame_s)
      : SteppedCloth(garment, pinned, settings),
        pins(pinned.vertices),
        compression_stiffness_n_per_m(garment.material.compression_stiffness_n_per_m),
        triangles(by_row(garment.mesh.triangles, layout)),
        mean_edge_m(sim::mean_edge_m(garment.springs)),
        frame_time_s(frame_s),
        projection(layout, frame_s),
        mobility_per_kg(mean_mobility_per_kg(layout)) {
    if (settings.tethers && layout.pin_count > 0) {
      tethers = make_tethers(garment, layout, tether_slack(garment.material, settings));
    }
  }

  std::vector<Index> pins;
  double compression_stiffness_n_per_m;
  std::vector<Triangle> triangles;  ///< triangles by solver index
  double mean_edge_m;
  double frame_time_s;
  BoundProjection projection;
  ThreadChoice threads;
  double mobility_per_kg;
  Float4Array velocities;    ///< velocities in m/s at the start of the frame
  double time_step_s = 0.0;  ///< time step for which the springs' short_share is set
};

/// Outcome of an attempt at a frame or a part of it.
struct BoundedSolver::FrameAttempt {
  State state;    ///< state at its end
  Memory memory;  ///< memory for the next part
  ProjectionResult projected;
  int substeps = 0;
  bool is_finished = true;  ///< the attempt ended within its budget of work
  bool is_far = false;      ///< the projection moved a vertex too far
  std::optional<BlockedContact> blocked;

  bool is_good() const { return projected.is_kept && !is_far && !blocked; }

  /// Appends the next part of the frame.
  void follow(FrameAttempt part) {
    part.substeps += substeps;
    part.projected.cost += projected.cost;
    part.projected.raw_max_stretch = std::max(part.projected.raw_max_stretch, projected.raw_max_stretch);
    part.blocked = blocked ? blocked : part.blocked;
    *this = std::move(part);
  }
};

/// Part of a frame, in units of the shortest part.
struct BoundedSolver::FramePart {
  int done = 0;  ///< units done before it
  int length = max_frame_parts;
  int attempts = 0;  ///< failed attempts at it
};

/// Limits of an attempt at a frame or a part of it.
struct BoundedSolver::AttemptLimits {
  int retry_level = 0;        ///< retry level: the number of earlier attempts
  bool is_last = false;       ///< the shape is accepted in any case
  bool can_halve = false;     ///< the part can be halved instead
  double allowed_work = 0.0;  ///< budget in sweeps
};

/// Work of all attempts at a frame.
struct BoundedSolver::WorkBudget {
  double work = 0.0;  ///< work in sweeps
  double sweeps = 0.0;
  ContactReport contact = {};
  CpuTime search = {};
  std::optional<BlockedContact> first_blocked = {};  ///< only the first; later ones are consequences
  double budget = 0.0;                               ///< budget of work, in sweeps
  double pins_turn_m = 0.0;                          ///< deviation of the pins from steady motion in the frame
  bool is_first = false;                             ///< first frame: no earlier frame is known

  bool is_near() const { return contact.max_pairs > 0; }
  /// Returns the work after which the next attempt is the last, if `done` units are done. Half of the budget is
  /// reserved for the last attempts.
  double last_attempt_work(int done) const { return budget * (0.5 + 0.5 * done / max_frame_parts); }

  void add(const FrameAttempt& attempt, Contacts& contacts) {
    const double contact_work = contacts.work();
    const ContactReport report = contacts.report();
    search.ms += contacts.search_ms();
    const double attempt_sweeps = attempt.substeps + attempt.projected.cost;
    sweeps += attempt_sweeps;
    work += attempt_sweeps + contact_work;
    contact.detections += report.detections;
    contact.partial_detections += report.partial_detections;
    contact.max_pairs = std::max(contact.max_pairs, report.max_pairs);
    contact.excluded_area_fraction = report.excluded_area_fraction;
    first_blocked = first_blocked ? first_blocked : attempt.blocked;
  }
};

BoundedSolver::BoundedSolver(const BoundedSettings& settings, std::optional<int> substeps, int max_substeps)
    : settings_(settings), substeps_(substeps), max_substeps_(max_substeps) {
  kernels_for(settings.vector_unit);  // throws now instead of in the first frame
}

BoundedSolver::~BoundedSolver() = default;

void BoundedSolver::require_promised(const Garment& garment, const Surroundings& surroundings) const {
  for (const auto& reason :
       {unpromised_bound_reason(settings_, surroundings), missing_contact_reason(settings_, garment)}) {
    if (reason) throw std::invalid_argument(*reason);
  }
}

void BoundedSolver::move_within_bound(const Garment& garment, const Pins& pins, State& state) const {
  sim::move_within_bound(garment, pins, settings_, state);
}

void BoundedSolver::lay_out(const Frame& frame) {
  const std::size_t count = frame.garment.mesh.positions.size();
  if (cloth_ && cloth_->pins == frame.pins.vertices && cloth_->layout.vertex_count() == count) return;
  kernels_ = std::make_unique<ParallelKernels>(kernels_for(settings_.vector_unit),
                                               thread_count(settings_.threads, frame.garment.mesh.triangles.size()));
  cloth_ = std::make_unique<Cloth>(frame.garment, frame.pins, settings_, frame.duration_s);
}

void BoundedSolver::prepare_first_frame(const Frame& frame) {
  lay_out(frame);
  cloth_->contacts.prepare(frame.garment, cloth_->layout, frame.surroundings.bodies);
}

int BoundedSolver::substeps_for_load(const Frame& frame) const {
  return first_substeps(frame.garment, cloth_->layout, frame.surroundings, frame.duration_s, settings_.max_stretch);
}

double BoundedSolver::bound() const { return std::max(settings_.max_stretch, min_promised_bound); }

// Largest deviation of the pins from continued steady motion.
double BoundedSolver::pins_turn_m(const Frame& frame, const State& state) const {
  std::vector<Vec3> from_m;
  for (const Index pin : frame.pins.vertices) from_m.push_back(state.current[pin]);
  const TimeSpan time = {state.time_s, state.time_s + frame.duration_s};
  const std::vector<Vec3> moved_m = pin_displacements(frame.surroundings, frame.pins.vertices, from_m, time);
  const double steps = state.time_step_s > 0.0 ? frame.duration_s / state.time_step_s : 0.0;
  double max_turn_m = 0.0;
  for (std::size_t i = 0; i < moved_m.size(); ++i) {
    const Index pin = frame.pins.vertices[i];
    max_turn_m = std::max(max_turn_m, glm::length(moved_m[i] - steps * (state.current[pin] - state.previous[pin])));
  }
  return max_turn_m;
}

// Returns the expected work. New loads, fast cloth and jerking pins count as usual. The first frame may begin with a
// jerk.
double BoundedSolver::expected_work(const Frame& frame, double pins_turn_m, const Memory& memory) const {
  const double load_work = work_for(substeps_for_load(frame), frame.duration_s);
  if (memory.median_work == 0.0) return max_work_ratio * load_work;
  const double cloth_turns_m = frame.duration_s * memory.contact.rows.relative_speed_m_per_s(cloth_->triangles);
  const double turns = (cloth_turns_m + pins_turn_m) / (tuning::region_travel_per_edge * cloth_->mean_edge_m);
  const double turns_work = 2.0 * tuning::search_work_sweeps * std::min<double>(turns, max_substeps_);
  return std::max(memory.median_work, load_work + turns_work);
}

Memory BoundedSolver::first_memory(const Frame& frame) const {
  Memory memory;
  memory.pins = frame.pins.vertices;
  memory.corrections.resize(cloth_->layout.row_count());
  if (cloth_->elasticity.has_law()) {
    memory.elastic.tension_n_per_m.resize(cloth_->layout.surface.block_count());
    memory.elastic.shortening_n_per_m.resize(cloth_->layout.surface.block_count());
  }
  if (substeps_) {
    memory.control = SubstepControl(*substeps_, *substeps_, *substeps_, frame.duration_s);
  } else {
    const int min_work = std::max(static_cast<int>(std::lround(tuning::min_steps_per_s * frame.duration_s)),
                                  cloth_->forces.updates_per_frame(frame.duration_s));
    memory.control = SubstepControl(substeps_for_load(frame), min_work, max_substeps_, frame.duration_s);
  }
  return memory;
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
    const Index v = layout.vertex_indices[row];
    motion.start_m[row] = state.current[v];
    cloth_->velocities[row] = to_float4((state.current[v] - state.previous[v]) * steps_per_s);
  }
  set_start(layout, state.current, motion.start);
  kernels_->start(motion.start, cloth_->layout.springs);
  kernels_->start(motion.start, cloth_->layout.surface);
  start_tethers(motion.start, cloth_->tethers);
}

void BoundedSolver::begin_substeps(double time_step_s) {
  assert(time_step_s > 0.0);
  Cloth& cloth = *cloth_;
  const auto h = static_cast<float>(time_step_s);
  for (std::size_t row = 0; row < cloth.layout.vertex_count(); ++row) {
    const Float4& v = cloth.velocities[row];
    cloth.motion.current[row] = Float4{};
    cloth.motion.previous[row] = {-v.x * h, -v.y * h, -v.z * h, 0.0F};
  }
  if (cloth.time_step_s != time_step_s) {
    cloth.time_step_s = time_step_s;
    set_short_shares(cloth.compression_stiffness_n_per_m, time_step_s, cloth.layout, cloth.swept_surface());
  }
}

// Updates the rest shapes at equal intervals; the last one ends with the frame.
void BoundedSolver::follow_tension(int done, int substeps, double frame_time_s) {
  assert(done >= 0 && done <= substeps);
  assert(frame_time_s > 0.0);
  Cloth& cloth = *cloth_;
  const int follows = std::min(tension_updates_per_frame(frame_time_s), substeps);
  if (cloth.elasticity.has_law() && done * follows / substeps != (done - 1) * follows / substeps) {
    cloth.elasticity.follow(cloth.layout, cloth.motion, frame_time_s / substeps, *kernels_);
  }
}

// Returns whether the frame ended within its budget of work. If crossings are accepted, the last attempt always ends:
// contact is disabled once the budget is spent.
bool BoundedSolver::run_substeps(const Frame& frame, double time_s, int substeps, bool is_last) {
  assert(substeps > 0);
  assert(std::isfinite(time_s));
  Cloth& cloth = *cloth_;
  const double dt = frame.duration_s / substeps;
  const int updates = cloth.forces.updates_per_frame(frame.duration_s);
  const int substeps_per_update = std::max(1, substeps / updates);
  const int wind_updates = SlowForces::wind_updates_per_frame(frame.duration_s);
  const int substeps_per_wind = std::max(1, substeps / wind_updates / substeps_per_update) * substeps_per_update;
  begin_substeps(dt);
  for (int substep = 0; substep < substeps; ++substep) {
    TimeStep time;
    time.frame_began_s = time_s;
    time.frame_ends_s = time_s + frame.duration_s;
    time.time_s = time_s + substep * dt;
    time.time_step_s = dt;
    time.updates_forces = substep % substeps_per_update == 0;
    time.update_interval_s = substeps_per_update * dt;
    time.updates_wind = substep % substeps_per_wind == 0;
    time.wind_interval_s = substeps_per_wind * dt;
    bounded::step(frame, time, *kernels_, cloth);
    follow_tension(substep + 1, substeps, frame.duration_s);
    if (!cloth.contacts.is_spent()) continue;
    if (!is_last || !settings_.allow_crossing) return false;
    cloth.contacts.let_cross(cloth.layout, cloth.motion, *kernels_);
  }
  return true;
}

// The next frame starts from the shape that keeps the bound. set_previous() shifts the positions of one time step ago
// by the same correction, so that it adds no velocity.
State BoundedSolver::end_state(const Frame& frame, const State& begin, int substeps) const {
  const Cloth& cloth = *cloth_;
  State state = begin;
  for (std::size_t row = 0; row < cloth.layout.vertex_count(); ++row) {
    state.current[cloth.layout.vertex_indices[row]] =
        cloth.motion.start_m[row] + to_vec3(cloth.projection.corrected()[row]);
  }
  // Pins are set in double precision: rounding errors would add up from frame to frame.
  const std::vector<Vec3> moved_m =
      pins_moved(frame.surroundings, cloth, {begin.time_s, begin.time_s + frame.duration_s});
  for (std::size_t row = 0; row < moved_m.size(); ++row) {
    state.current[cloth.layout.vertex_indices[row]] = cloth.motion.start_m[row] + moved_m[row];
  }
  state.time_step_s = frame.duration_s / substeps;
  state.time_s += frame.duration_s;
  state.step_count += static_cast<std::uint64_t>(substeps);
  return state;
}

void BoundedSolver::set_previous(State& state) const {
  const Cloth& cloth = *cloth_;
  for (std::size_t row = 0; row < cloth.layout.vertex_count(); ++row) {
    const Vec3 moved = to_vec3(cloth.motion.current[row]) - to_vec3(cloth.motion.previous[row]);
    const Index v = cloth.layout.vertex_indices[row];
    state.previous[v] = state.current[v] - moved;
  }
}

// If a crossing is accepted, the bound is still kept: a last attempt may project without contact.
ProjectionResult BoundedSolver::project(const Frame& frame, double end_s, int substeps, const AttemptLimits& how,
                                        Float4Array& corrections) {
  Cloth& cloth = *cloth_;
  BoundProjection::ProjectionLimits limits;
  limits.cost =
      how.is_last ? tuning::last_resort_sweeps : tuning::max_cost_ratio * std::max<double>(substeps, round_sweeps);
  if (how.can_halve && cloth.contacts.is_near()) {
    limits.raw_max_stretch = halving_stretch * bound();
  }
  const auto project_within = [&](Confinement* confinement, Float4Array& from) {
    return cloth.projection.project(cloth.layout, cloth.motion.current, settings_.max_stretch, limits, confinement,
                                    *kernels_, from);
  };
  if (!cloth.contacts.is_on()) return project_within(nullptr, corrections);
  const Float4Array before = corrections;
  ContactConfinement apart(frame, end_s, *kernels_, cloth);
  const ProjectionResult confined = project_within(&apart, corrections);
  if (confined.is_kept || !settings_.allow_crossing || !how.is_last) return confined;
  const BoundProjection within_regions = cloth.projection;
  Float4Array free_corrections = before;
  const ProjectionResult free = project_within(nullptr, free_corrections);
  if (!free.is_kept) {
    cloth.projection = within_regions;
    return confined;
  }
  corrections = std::move(free_corrections);
  cloth.contacts.give_up(cloth.layout, cloth.motion);
  return free;
}

// SubstepControl counts the substeps of a whole frame.
int BoundedSolver::substeps_in(double time_s, const SubstepControl& control) const {
  const double parts = std::max(1.0, std::round(cloth_->frame_time_s / time_s));
  return static_cast<int>(std::ceil(control.substeps() / parts));
}

// Does the time steps, then projects their end onto the bound.
BoundedSolver::FrameAttempt BoundedSolver::attempt(const Frame& frame, const State& state, Memory memory,
                                                   const AttemptLimits& how) {
  Cloth& cloth = *cloth_;
  const double end_s = state.time_s + frame.duration_s;
  const int substeps = substeps_in(frame.duration_s, memory.control);
  begin_frame(state);
  if (cloth.elasticity.has_law()) {
    const bool is_first_frame = memory.median_work == 0.0;
    const double most = aimed_stretch(settings_.max_stretch);
    if (is_first_frame) memory.elastic = cloth.elasticity.at_start(cloth.layout, most);
    cloth.elasticity.begin_attempt(cloth.layout, cloth.motion.start, memory.elastic, most, frame.duration_s / substeps,
                                   *kernels_);
  }
  cloth.forces.begin_attempt(memory.wind_velocity_m_per_s, frame.wind_fractions);
  cloth.contacts.begin_attempt(frame, cloth.layout, cloth.motion, memory.contact, {state.time_s, end_s},
                               how.retry_level, how.allowed_work - substeps);
  if (!run_substeps(frame, state.time_s, substeps, how.is_last)) {
    cloth.contacts.give_up(cloth.layout, cloth.motion);
    FrameAttempt unfinished;
    unfinished.state = state;
    unfinished.memory = std::move(memory);
    unfinished.substeps = substeps;
    unfinished.is_finished = false;
    unfinished.blocked = cloth.contacts.blocked();
    return unfinished;
  }
  cloth.contacts.observe(cloth.layout, cloth.motion, end_s);
  FrameAttempt attempt;
  attempt.substeps = substeps;
  attempt.projected = project(frame, end_s, substeps, how, memory.corrections);
  attempt.state = end_state(frame, state, substeps);
  if (!attempt.projected.is_kept || cloth.layout.surface.has_thin_triangles) {
    const auto allow = [&](Index vertex, const Vec3& position_m) {
      const Index row = cloth.layout.solver_indices[vertex];
      return cloth.contacts.allow(row, position_m - cloth.motion.start_m[row]);
    };
    attempt.projected.is_kept =
        keeps_bound_in_double(frame.garment, frame.pins, settings_, attempt.state.current, allow);
  }
  set_previous(attempt.state);
  const double allowed_m = allowed_shift_m(cloth.layout);
  const double last_shift =
      std::exchange(memory.shift_ratio, allowed_m > 0.0 ? attempt.projected.max_shift_m / allowed_m : 0.0);
  attempt.is_far =
      memory.shift_ratio > tuning::max_shift_ratio && memory.shift_ratio > tuning::max_shift_growth * last_shift;
  attempt.blocked = cloth.contacts.blocked();
  memory.wind_velocity_m_per_s = cloth.forces.wind_velocity_m_per_s();
  memory.contact = cloth.contacts.memory();
  if (cloth.elasticity.has_law()) {
    memory.elastic = cloth.elasticity.memory();
    memory.control.need_at_least(cloth.elasticity.steps_needed_per_s() * cloth.frame_time_s);
  }
  attempt.memory = std::move(memory);
  return attempt;
}

BoundedSolver::AttemptLimits BoundedSolver::next_try(const FramePart& part, const SubstepControl& control,
                                                     const WorkBudget& effort) {
  const double due = effort.last_attempt_work(part.done);
  AttemptLimits how;
  how.retry_level = part.attempts;
  // An attempt with less work than this is unlikely to succeed.
  const double min_work = tuning::min_budget_fraction * effort.budget * part.length / max_frame_parts;
  how.is_last = control.is_spent() || (effort.is_near() && effort.work + min_work >= due);
  how.can_halve = !how.is_last && !effort.is_first && part.length > 1;
  const int until = control.is_spent() ? max_frame_parts : part.done + part.length;
  how.allowed_work = (how.is_last ? effort.last_attempt_work(until) : due) - effort.work;
  if (how.can_halve && part.length == max_frame_parts) {
    how.allowed_work = std::min(how.allowed_work, tuning::max_whole_frame_fraction * effort.budget);
  }
  return how;
}

// A part twice as long would stretch twice as much.
void BoundedSolver::advance_part(FramePart& part, double raw_bounds, bool is_cheap) {
  part.done += part.length;
  part.attempts = 0;
  const double limit = is_cheap ? halving_stretch : tuning::target_unprojected_stretch;
  if (part.length < max_frame_parts && part.done % (2 * part.length) == 0 && raw_bounds < 0.5 * limit) {
    part.length *= 2;
  }
}

// Regions that clamp the cloth do not call for more time steps. If the stretch is small, the second attempt keeps their
// number and is more cautious. If nothing is near, more steps eventually help; they also help if the stretch is
// slightly too large. Otherwise the part is halved, as each half ends in a projection. Halves take no more steps: in
// shorter steps the same correction means more speed.
void BoundedSolver::adapt_after_failure(FramePart& part, const FrameAttempt& failed, double raw_bounds,
                                        const AttemptLimits& how, const WorkBudget& effort,
                                        SubstepControl& control) const {
  ++part.attempts;
  if (part.length == max_frame_parts && part.attempts == 1 && cloth_->contacts.is_on() && failed.is_finished &&
      raw_bounds < tuning::target_unprojected_stretch) {
    return;
  }
  const bool needs_more = part.length == max_frame_parts && failed.is_finished && raw_bounds < more_steps_stretch;
  if (!effort.is_near() || !how.can_halve || needs_more) {
    control.try_more(raw_bounds);
    return;
  }
  part.attempts = 0;
  part.length /= 2;
  halve(part, 0.5 * raw_bounds, halving_stretch);
}

// Halves the part until an attempt at it is likely to succeed.
void BoundedSolver::halve(FramePart& part, double raw_bounds, double limit) {
  for (; part.length > 1 && raw_bounds > limit; raw_bounds *= 0.5) part.length /= 2;
}

// Jerking pins leave the cloth behind and stretch their edges by at least that distance.
BoundedSolver::FramePart BoundedSolver::first_part(const Memory& memory, const WorkBudget& effort) const {
  FramePart part;
  if (memory.contact.rows.is_touching && !effort.is_first) {
    const double turned_m_per_step = effort.pins_turn_m / memory.control.substeps();
    halve(part, turned_m_per_step / cloth_->mean_edge_m / bound(), tuning::target_unprojected_stretch);
  }
  return part;
}

BoundedSolver::FrameAttempt BoundedSolver::advance(const Frame& frame, const State& begin, Memory memory,
                                                   WorkBudget& effort) {
  FramePart part = first_part(memory, effort);
  FrameAttempt progress;
  progress.state = begin;
  progress.memory = std::move(memory);
  while (part.done < max_frame_parts) {
    const double part_s = frame.duration_s * part.length / max_frame_parts;
    const Frame this_part = {frame.garment, frame.pins, frame.surroundings, part_s, frame.poll, frame.wind_fractions};
    const AttemptLimits how = next_try(part, progress.memory.control, effort);
    FrameAttempt tried = attempt(this_part, progress.state, progress.memory, how);
    effort.add(tried, cloth_->contacts);
    const double raw_bounds = tried.projected.raw_max_stretch / bound();
    if (!tried.is_good() && !how.is_last) {
      adapt_after_failure(part, tried, raw_bounds, how, effort, progress.memory.control);
      continue;
    }
    const bool is_costly = tried.projected.cost > tuning::max_cost_ratio * tried.substeps;
    const bool is_cheap = tried.projected.cost < tuning::low_cost_ratio * tried.substeps;
    progress.follow(std::move(tried));
    if (progress.blocked && !settings_.allow_crossing) return progress;
    const bool was_halved = part.length < max_frame_parts;
    advance_part(part, raw_bounds, is_cheap);
    if (is_costly && part.done < max_frame_parts) {
      progress.memory.control.try_more(raw_bounds);
    } else if (was_halved && part.done == max_frame_parts) {
      progress.memory.control.reduce_substeps(raw_bounds);
    }
  }
  return progress;
}

// Lost cloth is not reported as blocked contact.
void BoundedSolver::require_unblocked(const Frame& frame, const State& begin, const FrameAttempt& last,
                                      const WorkBudget& effort) const {
  if (last.blocked && !settings_.allow_crossing && first_lost(last.state.current) == last.state.current.size()) {
    throw ContactBlocked(*effort.first_blocked, frame.pins, frame.surroundings.bodies, begin.time_s + frame.duration_s);
  }
}

FrameReport BoundedSolver::advance_frame(const Frame& frame, State& state) {
  assert(frame.duration_s > 0.0);
  assert(state.current.size() == frame.garment.mesh.positions.size());
  assert(state.previous.size() == state.current.size());
  lay_out(frame);
  const auto began = std::chrono::steady_clock::now();
  Cloth& cloth = *cloth_;
  kernels_->share(cloth.threads.is_shared());
  const Memory begin = memory_ && memory_->pins == frame.pins.vertices ? *memory_ : first_memory(frame);
  WorkBudget effort;
  effort.pins_turn_m = pins_turn_m(frame, state);
  effort.budget = max_work_ratio * expected_work(frame, effort.pins_turn_m, begin);
  effort.is_first = begin.median_work == 0.0;
  FrameAttempt tried = advance(frame, state, begin, effort);
  require_unblocked(frame, state, tried, effort);

  next_ = std::move(tried.memory);
  if (tried.blocked) {
    next_.control = begin.control;  // no number of steps succeeded
  }
  next_.control.frame_kept(tried.projected.cost, next_.shift_ratio);
  next_.median_work *= effort.work > begin.median_work ? tuning::median_growth_factor : 1.0 / tuning::median_growth_factor;
  next_.median_work = effort.is_first ? effort.work : next_.median_work;
  state = std::move(tried.state);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
  cloth.threads.frame_took(took.count(), kernels_->take_work());
  return {tried.substeps,
          true,
          tried.projected.is_kept,
          tried.projected.raw_max_stretch,
          effort.sweeps,
          followed_compression(cloth.mobility_per_kg, state.time_step_s),
          tried.blocked ? effort.first_blocked : std::nullopt,
          effort.contact,
          effort.search,
          next_.contact.excluded_triangles};
}

void BoundedSolver::keep_frame() { std::swap(memory_.emplace(), next_); }

// A frame with other pins than the last one starts anew.
void BoundedSolver::save(const Garment& garment, const Pins& pins, ByteWriter& bytes) const {
  const bool goes_on = memory_ && memory_->pins == pins.vertices;
  bytes.put<std::uint8_t>(goes_on ? 1 : 0);
  if (goes_on) bounded::save(*memory_, garment.mesh.positions.size(), bytes);
}

void BoundedSolver::restore(const Frame& frame, ByteReader& bytes) {
  memory_.reset();
  if (bytes.get_bool("whether there was a frame")) {
    lay_out(frame);
    memory_ = first_memory(frame);
    bounded::restore(frame, cloth_->layout.row_count(), bytes, *memory_);
  }
}

}  // namespace taut::sim
