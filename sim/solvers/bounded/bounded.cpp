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

/// The part of its error that a short spring may give back in one step and still push by its stiffness, and
/// not by how long the step is: what its neighbours undo within the step it could only give back in more
/// steps.
constexpr double largest_short_share = 0.9;

float short_share(float stiffness, float mobility_per_kg) {
  return stiffness * mobility_per_kg / (1.0F + stiffness * mobility_per_kg);
}

/// Sets what springs and triangles that are too short give back of their error in one time step. With a
/// stiffness k in N/m and the mobility w it is k dt^2 w / (1 + k dt^2 w), as of a compliant constraint
/// (Macklin, Mueller and Chentanez 2016).
void set_short_shares(double stiffness_n_per_m, double time_step_s, Layout& layout, SurfaceLanes& surface) {
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

/// Returns what springs' ends, or triangles, weigh against a correction, on average; 1/kg.
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

/// Returns the largest stiffness that time steps of this length follow, in N/m: stiffer springs give back
/// almost all of their error and push no harder. Infinite where nothing can move.
double followed_compression(double mobility_per_kg, double time_step_s) {
  return largest_short_share / (1.0 - largest_short_share) / (time_step_s * time_step_s * mobility_per_kg);
}

/// Keeps the projection at the end of a frame from making anything cross.
class ApartWhileCorrected final : public Confinement {
 public:
  /// The frame ends at `time_s`. All arguments must outlive this object.
  ApartWhileCorrected(const Frame& frame, double time_s, ParallelKernels& kernels, SteppedCloth& cloth)
      : frame_(frame), time_s_(time_s), kernels_(kernels), cloth_(cloth) {}

  void begin(const Float4Array& raw, const Float4Array& expected) override {
    cloth_.contacts.make_regions(frame_, cloth_.layout, cloth_.motion, raw, expected, time_s_, kernels_);
    last_ = raw;
    is_held_back_ = false;
  }
  // Where vertices are held back by their balls there is more room from where they have come. Regions that expect the
  // correction push what stands in its way.
  void bring_back(Float4Array& displacements, bool is_stuck) override {
    frame_.ask();
    if (is_held_back_ || is_stuck) {
      moved_.resize(last_.size());
      for (std::size_t row = 0; row < last_.size(); ++row) {
        moved_[row] = scaled_sum(displacements[row], last_[row], -1.0F);
      }
      cloth_.contacts.make_regions(frame_, cloth_.layout, cloth_.motion, last_, moved_, time_s_, kernels_);
    }
    is_held_back_ = cloth_.contacts.keep_apart(kernels_, displacements);
    last_ = displacements;
  }
  bool is_spent(double sweeps) const override { return cloth_.contacts.is_spent(sweeps); }

 private:
  const Frame& frame_;
  double time_s_;
  ParallelKernels& kernels_;
  SteppedCloth& cloth_;
  bool is_held_back_ = false;
  Float4Array last_;  ///< displacements that are known to keep everything apart
  Float4Array moved_;
};

/// Stretch, in bounds, that twice the steps would bring down to what a projection copes with ...
constexpr double overstretched = 4.0 * tuning::coped_stretch;
/// ... and that a few more steps would.
constexpr double somewhat_overstretched = 2.0 * tuning::coped_stretch;

/// Returns the work of a frame before there is one to tell, in sweeps: its projection takes as many as its
/// substeps, and a search of its own.
double work_for(int substeps, double frame_time_s) {
  const double searches = 1.0 + tuning::touching_regions_per_s * frame_time_s;
  return 2.0 * substeps + searches * tuning::work_of_search;
}

std::vector<Triangle> by_row(std::span<const Triangle> triangles, const Layout& layout) {
  std::vector<Triangle> rows;
  rows.reserve(triangles.size());
  for (const auto& [a, b, c] : triangles) {
    rows.push_back({layout.row_of_vertex[a], layout.row_of_vertex[b], layout.row_of_vertex[c]});
  }
  return rows;
}

/// Cloth made of springs gives a little across them; tethers of the exact length would lift it.
double tether_slack(const Material& material, const BoundedSettings& settings) {
  if (has_law(material) && settings.bound == BoundKind::surface) return settings.max_stretch;
  return settings.bound == BoundKind::springs ? std::min(tuning::most_tether_slack, settings.max_stretch) : 0.0;
}

}  // namespace

const char* name_of(BoundKind kind) {
  constexpr std::array names = {"springs", "surface"};
  return names[static_cast<std::size_t>(kind)];
}

/// The solver's arrays for a garment and its pins. No frame depends on what earlier ones left in them.
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
  std::vector<Triangle> triangles;  ///< by row
  double mean_edge_m;
  double frame_time_s;
  BoundProjection projection;
  ThreadChoice threads;
  double mobility_per_kg;
  Float4Array velocities;    ///< m/s, when the frame began
  double time_step_s = 0.0;  ///< the one the springs' short_share is made for
};

/// The outcome of an attempt at a frame or a part of it.
struct BoundedSolver::Attempt {
  State state;    ///< at its end
  Memory memory;  ///< for what follows
  ProjectionResult projected;
  int substeps = 0;
  bool is_finished = true;  ///< it came to its end within its work
  bool is_far = false;      ///< the projection went further than it may
  std::optional<BlockedContact> blocked;

  bool is_good() const { return projected.kept && !is_far && !blocked; }

  /// Becomes what it was and the next part of the frame.
  void follow(Attempt part) {
    part.substeps += substeps;
    part.projected.cost += projected.cost;
    part.projected.raw_max_stretch = std::max(part.projected.raw_max_stretch, projected.raw_max_stretch);
    part.blocked = blocked ? blocked : part.blocked;
    *this = std::move(part);
  }
};

/// A part of a frame, in units of the shortest.
struct BoundedSolver::FramePart {
  int done = 0;  ///< before it
  int length = most_parts;
  int attempts = 0;  ///< at it, that failed
};

/// The limits of an attempt at a frame or a part of it.
struct BoundedSolver::Try {
  int caution = 0;            ///< earlier attempts
  bool is_last = false;       ///< its shape is taken, whatever it is
  bool can_halve = false;     ///< the time, instead
  double allowed_work = 0.0;  ///< in sweeps
};

/// The work of all attempts at a frame.
struct BoundedSolver::Effort {
  double work = 0.0;  ///< in sweeps
  double sweeps = 0.0;
  ContactReport contact = {};
  Took search = {};
  std::optional<BlockedContact> first_blocked = {};  ///< later attempts tell how cloth flees from it
  double budget = 0.0;                               ///< of work
  double pins_turn_m = 0.0;                          ///< in the frame
  bool is_first = false;                             ///< frame: nothing is known of those before

  bool is_near() const { return contact.most_pairs > 0; }
  /// Returns the work after which attempts are the last, where so many parts are done: half of the budget is
  /// for these.
  double due(int done) const { return budget * (0.5 + 0.5 * done / most_parts); }

  void add(const Attempt& attempt, Contacts& contacts) {
    const double contact_work = contacts.work();
    const ContactReport report = contacts.report();
    search.ms += contacts.search_ms();
    const double attempt_sweeps = attempt.substeps + attempt.projected.cost;
    sweeps += attempt_sweeps;
    work += attempt_sweeps + contact_work;
    contact.detections += report.detections;
    contact.partial_detections += report.partial_detections;
    contact.most_pairs = std::max(contact.most_pairs, report.most_pairs);
    contact.left_out_share = report.left_out_share;
    first_blocked = first_blocked ? first_blocked : attempt.blocked;
  }
};

BoundedSolver::BoundedSolver(const BoundedSettings& settings, std::optional<int> substeps, int max_substeps)
    : settings_(settings), substeps_(substeps), max_substeps_(max_substeps) {
  kernels_for(settings.vector_unit);  // refuses now what it would refuse in the first frame
}

BoundedSolver::~BoundedSolver() = default;

void BoundedSolver::require_promised(const Garment& garment, const Surroundings& surroundings) const {
  for (const auto& reason : {beyond_promise(settings_, surroundings), beyond_contact(settings_, garment)}) {
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

int BoundedSolver::substeps_for_load(const Frame& frame) const {
  return first_substeps(frame.garment, cloth_->layout, frame.surroundings, frame.duration_s, settings_.max_stretch);
}

double BoundedSolver::bound() const { return std::max(settings_.max_stretch, smallest_promised_bound); }

// How far pins go from where they would be if they went on as they did.
double BoundedSolver::pins_turn_m(const Frame& frame, const State& state) const {
  std::vector<Vec3> from_m;
  for (const Index pin : frame.pins.vertices) from_m.push_back(state.current[pin]);
  const TimeSpan time = {state.time_s, state.time_s + frame.duration_s};
  const std::vector<Vec3> moved_m = pin_displacements(frame.surroundings, frame.pins.vertices, from_m, time);
  const double steps = state.time_step_s > 0.0 ? frame.duration_s / state.time_step_s : 0.0;
  double furthest_m = 0.0;
  for (std::size_t i = 0; i < moved_m.size(); ++i) {
    const Index pin = frame.pins.vertices[i];
    furthest_m = std::max(furthest_m, glm::length(moved_m[i] - steps * (state.current[pin] - state.previous[pin])));
  }
  return furthest_m;
}

// A load that sets in is as usual as what has been, and so are the regions that fast cloth and pins with a
// jerk need. Before the first frame nothing is known: it may begin with a jerk.
double BoundedSolver::usual_work(const Frame& frame, double pins_turn_m, const Memory& memory) const {
  const double load_work = work_for(substeps_for_load(frame), frame.duration_s);
  if (memory.median_work == 0.0) return most_work * load_work;
  const double cloth_turns_m = frame.duration_s * memory.contact.rows.relative_speed_m_per_s(cloth_->triangles);
  const double turns = (cloth_turns_m + pins_turn_m) / (tuning::turned_part_of_edge * cloth_->mean_edge_m);
  const double turns_work = 2.0 * tuning::work_of_search * std::min<double>(turns, max_substeps_);
  return std::max(memory.median_work, load_work + turns_work);
}

Memory BoundedSolver::first_memory(const Frame& frame) const {
  Memory memory;
  memory.pins = frame.pins.vertices;
  memory.corrections.resize(cloth_->layout.row_count());
  if (cloth_->elasticity.has_law()) {
    memory.elastic.tension_n_per_m.resize(cloth_->layout.surface.block_count());
    memory.elastic.held_n_per_m.resize(cloth_->layout.surface.block_count());
  }
  if (substeps_) {
    memory.control = SubstepControl(*substeps_, *substeps_, *substeps_, frame.duration_s);
  } else {
    const int least = std::max(static_cast<int>(std::lround(tuning::least_steps_per_s * frame.duration_s)),
                               cloth_->forces.updates_per_frame(frame.duration_s));
    memory.control = SubstepControl(substeps_for_load(frame), least, max_substeps_, frame.duration_s);
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
    set_short_shares(cloth.compression_stiffness_n_per_m, time_step_s, cloth.layout, cloth.swept_surface());
  }
}

// At the end of equal parts of a frame. Their last steps are the frame's.
void BoundedSolver::follow_tension(int done, int substeps, double frame_time_s) {
  Cloth& cloth = *cloth_;
  const int follows = std::min(follows_in(frame_time_s), substeps);
  if (cloth.elasticity.has_law() && done * follows / substeps != (done - 1) * follows / substeps) {
    cloth.elasticity.follow(cloth.layout, cloth.motion, frame_time_s / substeps, *kernels_);
  }
}

// Returns whether it came to the frame's end within its work. Where crossings are accepted, the last attempt
// reaches it: nothing is kept apart any more from where the work is done.
bool BoundedSolver::run_substeps(const Frame& frame, double time_s, int substeps, bool is_last) {
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

// The shape that keeps the bound is where the next frame begins. Positions of a time step ago go with it, so
// that its last correction adds no velocity.
State BoundedSolver::shape_of(const Frame& frame, const State& begin, int substeps) const {
  const Cloth& cloth = *cloth_;
  State state = begin;
  for (std::size_t row = 0; row < cloth.layout.vertex_count(); ++row) {
    state.current[cloth.layout.vertex_of_row[row]] =
        cloth.motion.start_m[row] + vector_of(cloth.projection.corrected()[row]);
  }
  // Exactly where they belong: what single precision rounds away would add up from frame to frame.
  const std::vector<Vec3> moved_m =
      pins_moved(frame.surroundings, cloth, {begin.time_s, begin.time_s + frame.duration_s});
  for (std::size_t row = 0; row < moved_m.size(); ++row) {
    state.current[cloth.layout.vertex_of_row[row]] = cloth.motion.start_m[row] + moved_m[row];
  }
  state.time_step_s = frame.duration_s / substeps;
  state.time_s += frame.duration_s;
  state.step_count += static_cast<std::uint64_t>(substeps);
  return state;
}

void BoundedSolver::set_previous(State& state) const {
  const Cloth& cloth = *cloth_;
  for (std::size_t row = 0; row < cloth.layout.vertex_count(); ++row) {
    const Vec3 moved = vector_of(cloth.motion.current[row]) - vector_of(cloth.motion.previous[row]);
    const Index v = cloth.layout.vertex_of_row[row];
    state.previous[v] = state.current[v] - moved;
  }
}

// Where a crossing is accepted, it is no reason to break the other promise.
ProjectionResult BoundedSolver::project(const Frame& frame, double end_s, int substeps, const Try& how,
                                        Float4Array& corrections) {
  Cloth& cloth = *cloth_;
  BoundProjection::Limits limits;
  limits.cost = how.is_last ? tuning::last_resort_sweeps : tuning::costliest * std::max<double>(substeps, round_sweeps);
  if (how.can_halve && cloth.contacts.is_near()) {
    limits.raw_max_stretch = overstretched * bound();
  }
  const auto project_within = [&](Confinement* confinement, Float4Array& from) {
    return cloth.projection.project(cloth.layout, cloth.motion.current, settings_.max_stretch, limits, confinement,
                                    *kernels_, from);
  };
  if (!cloth.contacts.is_on()) return project_within(nullptr, corrections);
  const Float4Array before = corrections;
  ApartWhileCorrected apart(frame, end_s, *kernels_, cloth);
  const ProjectionResult confined = project_within(&apart, corrections);
  if (confined.kept || !settings_.allow_crossing || !how.is_last) return confined;
  const BoundProjection within_regions = cloth.projection;
  Float4Array free_corrections = before;
  const ProjectionResult free = project_within(nullptr, free_corrections);
  if (!free.kept) {
    cloth.projection = within_regions;
    return confined;
  }
  corrections = std::move(free_corrections);
  cloth.contacts.give_up(cloth.layout, cloth.motion);
  return free;
}

// The control counts those of a whole frame.
int BoundedSolver::substeps_in(double time_s, const SubstepControl& control) const {
  const double parts = std::max(1.0, std::round(cloth_->frame_time_s / time_s));
  return static_cast<int>(std::ceil(control.substeps() / parts));
}

// The time steps, and the projection of where they end onto the bound.
BoundedSolver::Attempt BoundedSolver::attempt(const Frame& frame, const State& state, Memory memory, const Try& how) {
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
  cloth.forces.begin_attempt(memory.blown_m_per_s);
  cloth.contacts.begin_attempt(frame, cloth.layout, cloth.motion, memory.contact, {state.time_s, end_s}, how.caution,
                               how.allowed_work - substeps);
  if (!run_substeps(frame, state.time_s, substeps, how.is_last)) {
    cloth.contacts.give_up(cloth.layout, cloth.motion);
    Attempt unfinished;
    unfinished.state = state;
    unfinished.memory = std::move(memory);
    unfinished.substeps = substeps;
    unfinished.is_finished = false;
    unfinished.blocked = cloth.contacts.blocked();
    return unfinished;
  }
  cloth.contacts.observe(cloth.layout, cloth.motion, end_s);
  Attempt attempt;
  attempt.substeps = substeps;
  attempt.projected = project(frame, end_s, substeps, how, memory.corrections);
  attempt.state = shape_of(frame, state, substeps);
  if (!attempt.projected.kept || cloth.layout.surface.has_thin) {
    const auto allow = [&](Index vertex, const Vec3& position_m) {
      const Index row = cloth.layout.row_of_vertex[vertex];
      return cloth.contacts.allow(row, position_m - cloth.motion.start_m[row]);
    };
    attempt.projected.kept = keeps_bound_in_double(frame.garment, frame.pins, settings_, attempt.state.current, allow);
  }
  set_previous(attempt.state);
  const double allowed_m = allowed_shift_m(cloth.layout);
  const double last_shift =
      std::exchange(memory.shift, allowed_m > 0.0 ? attempt.projected.largest_shift_m / allowed_m : 0.0);
  attempt.is_far = memory.shift > tuning::costliest && memory.shift > tuning::more_steps * last_shift;
  attempt.blocked = cloth.contacts.blocked();
  memory.blown_m_per_s = cloth.forces.blown_m_per_s();
  memory.contact = cloth.contacts.memory();
  if (cloth.elasticity.has_law()) {
    memory.elastic = cloth.elasticity.memory();
    memory.control.need_at_least(
        static_cast<int>(std::ceil(cloth.elasticity.steps_needed_per_s() * cloth.frame_time_s)));
  }
  attempt.memory = std::move(memory);
  return attempt;
}

BoundedSolver::Try BoundedSolver::next_try(const FramePart& part, const SubstepControl& control, const Effort& effort) {
  const double due = effort.due(part.done);
  Try how;
  how.caution = part.attempts;
  // An attempt that is left less than this could not end well.
  const double least = tuning::least_of_budget * effort.budget * part.length / most_parts;
  how.is_last = control.is_spent() || (effort.is_near() && effort.work + least >= due);
  how.can_halve = !how.is_last && !effort.is_first && part.length > 1;
  const int until = control.is_spent() ? most_parts : part.done + part.length;
  how.allowed_work = (how.is_last ? effort.due(until) : due) - effort.work;
  if (how.can_halve && part.length == most_parts) {
    how.allowed_work = std::min(how.allowed_work, 0.25 * effort.budget);
  }
  return how;
}

// A part twice as long would be stretched twice as much.
void BoundedSolver::go_on(FramePart& part, double raw_bounds, bool is_cheap) {
  part.done += part.length;
  part.attempts = 0;
  const double limit = is_cheap ? overstretched : tuning::coped_stretch;
  if (part.length < most_parts && part.done % (2 * part.length) == 0 && raw_bounds < 0.5 * limit) {
    part.length *= 2;
  }
}

// Regions that hold cloth back are no reason for more time steps: where steps alone do not stretch it that
// much, the second attempt takes the same number, with more care. Where nothing is near, more steps help in
// the end, and so they do where they stretch the cloth a little too much. Else parts of the frame do, as each
// ends in a projection. They take no more steps: in shorter ones the same correction is more speed.
void BoundedSolver::try_otherwise(FramePart& part, const Attempt& failed, double raw_bounds, const Try& how,
                                  const Effort& effort, SubstepControl& control) const {
  ++part.attempts;
  if (part.length == most_parts && part.attempts == 1 && cloth_->contacts.is_on() && failed.is_finished &&
      raw_bounds < tuning::coped_stretch) {
    return;
  }
  const bool needs_more = part.length == most_parts && failed.is_finished && raw_bounds < somewhat_overstretched;
  if (!effort.is_near() || !how.can_halve || needs_more) {
    control.try_more(raw_bounds);
    return;
  }
  part.attempts = 0;
  part.length /= 2;
  halve(part, 0.5 * raw_bounds, overstretched);
}

// Until it is stretched by so many bounds that an attempt at it may end well.
void BoundedSolver::halve(FramePart& part, double raw_bounds, double limit) {
  for (; part.length > 1 && raw_bounds > limit; raw_bounds *= 0.5) part.length /= 2;
}

// Pins with a jerk leave the cloth behind, and stretch the edges that meet in them by at least that.
BoundedSolver::FramePart BoundedSolver::first_part(const Memory& memory, const Effort& effort) const {
  FramePart part;
  if (memory.contact.rows.is_touching && !effort.is_first) {
    const double turned_m_per_step = effort.pins_turn_m / memory.control.substeps();
    halve(part, turned_m_per_step / cloth_->mean_edge_m / bound(), tuning::coped_stretch);
  }
  return part;
}

BoundedSolver::Attempt BoundedSolver::advance(const Frame& frame, const State& begin, Memory memory, Effort& effort) {
  FramePart part = first_part(memory, effort);
  Attempt made;
  made.state = begin;
  made.memory = std::move(memory);
  while (part.done < most_parts) {
    const Frame this_part = {frame.garment, frame.pins, frame.surroundings, frame.duration_s * part.length / most_parts,
                             frame.poll};
    const Try how = next_try(part, made.memory.control, effort);
    Attempt tried = attempt(this_part, made.state, made.memory, how);
    effort.add(tried, cloth_->contacts);
    const double raw_bounds = tried.projected.raw_max_stretch / bound();
    if (!tried.is_good() && !how.is_last) {
      try_otherwise(part, tried, raw_bounds, how, effort, made.memory.control);
      continue;
    }
    const bool is_costly = tried.projected.cost > tuning::costliest * tried.substeps;
    const bool is_cheap = tried.projected.cost < tuning::cheap * tried.substeps;
    made.follow(std::move(tried));
    if (made.blocked && !settings_.allow_crossing) return made;
    const bool was_halved = part.length < most_parts;
    go_on(part, raw_bounds, is_cheap);
    if (is_costly && part.done < most_parts) {
      made.memory.control.try_more(raw_bounds);
    } else if (was_halved && part.done == most_parts) {
      made.memory.control.ease(raw_bounds);
    }
  }
  return made;
}

// Where the cloth is lost, contact is not what went wrong.
void BoundedSolver::require_a_way_on(const Frame& frame, const State& begin, const Attempt& last,
                                     const Effort& effort) const {
  if (last.blocked && !settings_.allow_crossing && first_lost(last.state.current) == last.state.current.size()) {
    throw ContactBlocked(*effort.first_blocked, frame.pins, frame.surroundings.bodies, begin.time_s + frame.duration_s);
  }
}

FrameReport BoundedSolver::advance_frame(const Frame& frame, State& state) {
  lay_out(frame);
  const auto began = std::chrono::steady_clock::now();
  Cloth& cloth = *cloth_;
  kernels_->share(cloth.threads.is_shared());
  const Memory begin = memory_ && memory_->pins == frame.pins.vertices ? *memory_ : first_memory(frame);
  Effort effort;
  effort.pins_turn_m = pins_turn_m(frame, state);
  effort.budget = most_work * usual_work(frame, effort.pins_turn_m, begin);
  effort.is_first = begin.median_work == 0.0;
  Attempt tried = advance(frame, state, begin, effort);
  require_a_way_on(frame, state, tried, effort);

  next_ = std::move(tried.memory);
  if (tried.blocked) {
    next_.control = begin.control;  // no number of steps brought it through
  }
  next_.control.frame_kept(tried.projected.cost, next_.shift);
  next_.median_work *= effort.work > begin.median_work ? tuning::more_steps : 1.0 / tuning::more_steps;
  next_.median_work = effort.is_first ? effort.work : next_.median_work;
  state = std::move(tried.state);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
  cloth.threads.frame_took(took.count(), kernels_->take_work());
  return {tried.substeps,
          true,
          tried.projected.kept,
          tried.projected.raw_max_stretch,
          effort.sweeps,
          followed_compression(cloth.mobility_per_kg, state.time_step_s),
          tried.blocked ? effort.first_blocked : std::nullopt,
          effort.contact,
          effort.search,
          next_.contact.left_out};
}

void BoundedSolver::keep_frame() { std::swap(memory_.emplace(), next_); }

// With other pins than the last frame's the next one begins anew.
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
