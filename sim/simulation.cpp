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

constexpr std::string_view magic = "TAUTSAVE";
/// Raised with every change of the format or of a solver's memory.
constexpr std::uint32_t version = 7;

constexpr double max_finite = std::numeric_limits<double>::max();
/// Largest time: about thirty years. The number of gust periods still fits.
constexpr double max_interval_s = 1e9;

std::uint64_t hash_of_rest(const Garment& garment) {
  ByteWriter rest;
  rest.put_positions(garment.mesh.positions);
  for (const Triangle& triangle : garment.mesh.triangles) rest.put(triangle);
  for (std::size_t s = 0; s < garment.springs.ends.size(); ++s) {
    rest.put(garment.springs.ends[s]);
    rest.put(garment.springs.rest_lengths_m[s]);
  }
  for (const double mass_kg : garment.masses_kg) rest.put(mass_kg);
  return fnv1a(fnv1a_of_nothing, rest.bytes());
}

struct Identity {
  const char* what;
  std::uint64_t value;
};

std::array<Identity, 4> garment_identity(const Garment& garment) {
  return {{{"the garment's number of vertices", garment.mesh.positions.size()},
           {"the garment's number of triangles", garment.mesh.triangles.size()},
           {"the garment's number of springs", garment.springs.ends.size()},
           {"the hash of the garment at rest", hash_of_rest(garment)}}};
}

void put_state(const State& state, ByteWriter& out) {
  out.put(state.time_s);
  out.put(state.time_step_s);
  out.put(state.step_count);
  out.put(state.quiet_frames);
  out.put<std::uint8_t>(state.asleep ? 1 : 0);
  out.put_positions(state.previous);
  out.put_positions(state.current);
}

/// Reads positions and requires that none is lost.
std::vector<Vec3> get_shape(const char* what, std::size_t count, ByteReader& in) {
  std::vector<Vec3> positions_m = in.get_positions(what, count);
  if (const std::size_t lost = first_lost(positions_m); lost < count) {
    throw BadBytes(std::string(what) + ": found vertex " + std::to_string(lost) + " further away than " +
                   std::to_string(max_coordinate_m) + " m, expected nearer ones");
  }
  return positions_m;
}

State get_state(std::size_t vertex_count, ByteReader& in) {
  State state;
  state.time_s = in.get("the time", 0.0, max_interval_s);
  state.time_step_s = in.get("the time step", 0.0, max_interval_s);
  state.step_count = in.get<std::uint64_t>("the number of steps");
  state.quiet_frames = in.get("the number of quiet frames", 0, max_counter);
  state.asleep = in.get_bool("whether the cloth sleeps");
  state.previous = get_shape("the previous positions", vertex_count, in);
  state.current = get_shape("the current positions", vertex_count, in);
  return state;
}

void put_report(const FrameReport& report, ByteWriter& out) {
  out.put(report.substeps);
  out.put<std::uint8_t>(report.bound_promised ? 1 : 0);
  out.put<std::uint8_t>(report.bound_kept ? 1 : 0);
  out.put(report.raw_max_stretch);
  out.put(report.sweeps);
  out.put(report.followed_compression_n_per_m);
  out.put(report.contact.detections);
  out.put(report.contact.partial_detections);
  out.put(report.contact.max_pairs);
  out.put(report.contact.min_distance_m);
  out.put<std::uint64_t>(report.contact.crossing_pairs);
  out.put(report.contact.excluded_area_fraction);
}

ContactReport get_contact(ByteReader& in) {
  ContactReport contact;
  contact.detections = in.get("the number of detections", 0, max_counter);
  contact.partial_detections = in.get("the number of partial detections", 0, max_counter);
  contact.max_pairs = in.get("the number of near pairs", 0, max_counter);
  contact.min_distance_m = in.get("the smallest distance", -max_finite, std::numeric_limits<double>::infinity());
  contact.crossing_pairs = in.get<std::uint64_t>("the number of crossing pairs");
  contact.excluded_area_fraction = in.get("the part of the area that is left out", 0.0, 1.0);
  return contact;
}

FrameReport get_report(ByteReader& in) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  FrameReport report;
  report.substeps = in.get("the number of substeps", 0, max_counter);
  report.bound_promised = in.get_bool("whether a bound was promised");
  report.bound_kept = in.get_bool("whether the bound was kept");
  report.raw_max_stretch = in.get("the stretch before the last correction", -1.0, max_finite);
  report.sweeps = in.get("the number of sweeps", 0.0, max_finite);
  report.followed_compression_n_per_m = in.get("the stiffness that was followed", 0.0, infinity);
  report.contact = get_contact(in);
  return report;
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

bool is_rest_judged(const State& state) { return state.quiet_frames > 0 && !state.asleep; }

std::string encode(const Checkpoint& checkpoint, const Garment& garment) {
  ByteWriter out;
  for (const char c : magic) out.put(c);
  out.put(version);
  for (const Identity& part : garment_identity(garment)) out.put(part.value);
  put_state(checkpoint.state, out);
  out.put_positions(checkpoint.before_m);
  out.put_positions(checkpoint.quiet_since_m);
  put_report(checkpoint.report, out);
  out.put_text(checkpoint.solver);
  out.put_text(checkpoint.solver_memory);
  out.seal();
  return out.bytes();
}

Checkpoint decode(std::string_view bytes, const Garment& garment) {
  ByteReader in(bytes);
  in.require_text("what the bytes are", magic);
  in.get("the version", version, version);
  for (const Identity& part : garment_identity(garment)) in.get(part.what, part.value, part.value);
  const std::size_t count = garment.mesh.positions.size();
  Checkpoint checkpoint;
  checkpoint.state = get_state(count, in);
  checkpoint.before_m = get_shape("the positions one frame ago", count, in);
  checkpoint.quiet_since_m = get_shape("the positions of rest", is_rest_judged(checkpoint.state) ? count : 0, in);
  checkpoint.report = get_report(in);
  checkpoint.solver = in.get_text("the solver");
  checkpoint.solver_memory = in.get_text("the solver's memory");
  in.require_seal();
  return checkpoint;
}

}  // namespace taut::sim
