#include "sim/simulation.hpp"

#include "sim/local_wind.hpp"

namespace taut::sim {
namespace {

void require_frame_rate(const SimulationSettings& settings) {
  if (!(settings.frame_rate_hz > 0.0)) throw std::invalid_argument("the frame rate must be above 0 Hz");
}

void require_shape(const Garment& garment, std::span<const Vec3> positions_m) {
  const std::size_t count = garment.mesh.positions.size();
  if (positions_m.size() != count) {
    throw std::invalid_argument("the start has " + std::to_string(positions_m.size()) +
                                " positions, expected one for each vertex of the garment, " + std::to_string(count));
  }
  const std::size_t lost = first_lost(positions_m);
  if (lost < count) {
    throw std::invalid_argument("the start's position of vertex " + std::to_string(lost) +
                                " is not finite or beyond all bounds");
  }
}

void require_equal(const char* what, std::size_t found, std::size_t expected) {
  if (found != expected) {
    throw BadBytes("a checkpoint with " + std::to_string(found) + ' ' + what + ", expected " +
                   std::to_string(expected));
  }
}

}  // namespace

Diverged::Diverged(Index vertex, double time_s)
    : std::runtime_error("the simulation diverged: at " + std::to_string(time_s) + " s vertex " +
                         std::to_string(vertex) +
                         " is lost, its position not finite or beyond all bounds; use more substeps, weaker "
                         "springs or weaker forces") {}

Simulation::Simulation(std::shared_ptr<const Garment> garment, std::vector<Index> pins,
                       const SimulationSettings& settings, Surroundings surroundings,
                       std::optional<std::vector<Vec3>> start_m)
    : garment_(std::move(garment)),
      pins_(make_pins(*garment_, std::move(pins))),
      settings_(settings),
      surroundings_(std::move(surroundings)),
      state_(make_state(*garment_)),
      before_m_(state_.current),
      solver_(make_solver(settings.solver)) {
  require_frame_rate(settings);
  require_possible(surroundings_, state_.current.size());
  solver_->require_promised(*garment_, surroundings_);
  if (start_m) begin_in(std::move(*start_m));
  solver_->prepare_first_frame(frame({}));
}

void Simulation::begin_in(std::vector<Vec3> start_m) {
  require_shape(*garment_, start_m);
  state_.current = std::move(start_m);
  state_.previous = state_.current;
  solver_->move_within_bound(*garment_, pins_, state_);
  state_.previous = state_.predicted = before_m_ = state_.current;
}

Frame Simulation::frame(const std::function<void()>& poll) const {
  return {*garment_, pins_, surroundings_, frame_time_s(), poll};
}

void Simulation::advance_frame(const std::function<void()>& poll) {
  if (state_.asleep) {
    frame_report();
    before_m_ = state_.current;
    state_.time_s += frame_time_s();
    wind_fractions_.reset();
    return;
  }
  State next = state_;
  Frame next_frame = frame(poll);
  next_frame.wind_fractions = wind_fractions();
  const FrameReport report = solver_->advance_frame(next_frame, next);
  const std::size_t lost = first_lost(next.current);
  if (lost < next.current.size()) throw Diverged(static_cast<Index>(lost), next.time_s);
  solver_->keep_frame();
  std::swap(state_, next);
  before_m_ = std::move(next.current);
  report_ = report;
  is_contact_measured_ = false;
  wind_fractions_.reset();
  fall_asleep_at_rest();
}

const FrameReport& Simulation::frame_report() const {
  if (!is_contact_measured_) {
    const MeasuredContact measured = measure_contact();
    report_.contact.min_distance_m = measured.min_distance_m;
    report_.contact.crossing_pairs = measured.crossing_pairs;
    is_contact_measured_ = true;
  }
  return report_;
}

MeasuredContact Simulation::measure_contact() const {
  if (solver_->ignores_contact() && surroundings_.bodies.empty()) return {};
  if (!measure_ || measure_->bodies() != surroundings_.bodies) {
    measure_.emplace(garment_->mesh.triangles, garment_->mesh.positions, surroundings_.bodies);
  }
  return measure_->measure(state_.current, state_.time_s, 2.0 * garment_->material.thickness_m);
}

const std::vector<float>& Simulation::wind_fractions() const {
  if (!wind_fractions_) {
    wind_fractions_ = find_wind_fractions(*garment_, state_.current, surroundings_, state_.time_s);
  }
  return *wind_fractions_;
}

void Simulation::start_solver() {
  solver_ = make_solver(settings_.solver);
  solver_->move_within_bound(*garment_, pins_, state_);
  wake();
}

Checkpoint Simulation::save() const {
  ByteWriter memory;
  solver_->save(*garment_, pins_, memory);
  Checkpoint saved;
  saved.state = state_;
  saved.state.predicted.clear();
  saved.before_m = before_m_;
  if (is_rest_judged(state_)) saved.quiet_since_m = quiet_since_m_;
  saved.report = frame_report();
  saved.report.blocked.reset();
  saved.report.excluded_triangles.clear();
  saved.solver = to_name(solver_kind(settings_.solver.method));
  saved.solver_memory = memory.bytes();
  return saved;
}

void Simulation::restore(const Checkpoint& checkpoint) {
  const std::size_t count = garment_->mesh.positions.size();
  require_equal("positions", checkpoint.state.current.size(), count);
  require_equal("previous positions", checkpoint.state.previous.size(), count);
  require_equal("positions one frame ago", checkpoint.before_m.size(), count);
  require_equal("positions of rest", checkpoint.quiet_since_m.size(), is_rest_judged(checkpoint.state) ? count : 0);
  const std::string solver = to_name(solver_kind(settings_.solver.method));
  if (checkpoint.solver != solver) {
    throw BadBytes("what the solver '" + checkpoint.solver + "' remembers, expected '" + solver + '\'');
  }
  std::unique_ptr<Solver> restored = make_solver(settings_.solver);
  ByteReader memory(checkpoint.solver_memory);
  restored->restore(frame({}), memory);
  memory.require_end();

  solver_ = std::move(restored);
  state_ = checkpoint.state;
  state_.predicted.resize(count);
  before_m_ = checkpoint.before_m;
  quiet_since_m_ = checkpoint.quiet_since_m;
  report_ = checkpoint.report;
  is_contact_measured_ = true;
  wind_fractions_.reset();
}

void Simulation::set_time(double time_s) {
  frame_report();
  state_.time_s = time_s;
  wake();
}

void Simulation::set_surroundings(const Surroundings& surroundings) {
  if (surroundings != surroundings_) {
    require_possible(surroundings, state_.current.size());
    solver_->require_promised(*garment_, surroundings);
    frame_report();
    surroundings_ = surroundings;
    wake();
  }
}

void Simulation::set_settings(const SimulationSettings& settings) {
  if (settings != settings_) {
    require_frame_rate(settings);
    // Throws before anything has changed.
    make_solver(settings.solver)->require_promised(*garment_, surroundings_);
    frame_report();
    settings_ = settings;
    start_solver();
  }
}

void Simulation::set_material(const Material& material) {
  if (material != garment_->material) {
    Garment garment = with_material(*garment_, material);
    solver_->require_promised(garment, surroundings_);
    frame_report();
    garment_ = share(std::move(garment));
    pins_ = make_pins(*garment_, std::move(pins_.vertices));
    start_solver();
  }
}

void Simulation::set_pins(std::vector<Index> pins) {
  pins_ = make_pins(*garment_, std::move(pins));
  wake();
}

void Simulation::wake() {
  wind_fractions_.reset();
  state_.asleep = false;
  state_.quiet_frames = 0;
}

void Simulation::fall_asleep_at_rest() {
  const RestSettings& rest = settings_.rest_settings;
  if (!is_steady(surroundings_, state_.time_s)) {
    state_.quiet_frames = 0;
    return;
  }
  if (state_.quiet_frames == 0) quiet_since_m_ = before_m_;
  ++state_.quiet_frames;
  const ShapeChange drift = {quiet_since_m_, state_.current, rest.frames * frame_time_s()};
  if (!(rms_speed(drift) < rest.speed_m_per_s)) {
    state_.quiet_frames = 0;
  } else if (state_.quiet_frames >= rest.frames) {
    state_.asleep = true;
    state_.previous = state_.current;
  }
}

}  // namespace taut::sim
