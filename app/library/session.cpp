#include "app/library/session.hpp"

#include "app/bodies/body_loading.hpp"
#include "app/garments/dressing/wearing.hpp"
#include "app/garments/sewing/sewing.hpp"
#include "app/library/border.hpp"
#include "app/models/inspecting/remarks.hpp"
#include "app/models/mending/model_fitting.hpp"
#include "app/scene/scene_format.hpp"
#include "sim/mesh/welding.hpp"

namespace taut::library {
namespace {

sim::Plane to_plane(const TautBody& given) {
  const sim::Vec3 normal = to_vector(given.plane_normal[0], given.plane_normal[1], given.plane_normal[2]);
  const double length = glm::length(normal);
  require(length > 0.0 && std::isfinite(length), "plane_normal: expected a vector that is not 0");
  return {to_vector(given.plane_point[0], given.plane_point[1], given.plane_point[2]), normal / length};
}

void take_mesh(const TautBody& given, const app::Scene& scene, GivenBody& taken) {
  app::BodySource source;
  source.file = taken.body.name.empty() ? "body" : taken.body.name;
  source.dress = taken.source.dress = given.dress;
  const double rate_hz = scene.simulation.frame_rate_hz;
  app::ReadBody read = app::make_body(source, model_from(given.mesh), {scene.frames / rate_hz, rate_hz});
  taken.body.shape = std::move(read.mesh);
  taken.wearer = std::move(read.wearer);
  taken.lent = CallerBody{std::move(read.places), read.file_vertices};
  for (const std::string& remark : read.remarks) {
    taken.remarks.push_back("body '" + source.file.string() + "': " + remark);
  }
}

// Settings that may change while a cloth moves. All others define the cloth or its start.
constexpr std::array changeable_sections = {"air.",         "camera.", "cloth.",  "gravity.", "picture.",
                                            "pins.motion.", "rest.",   "solver.", "wind."};

bool is_live(const std::string& key) {
  return key == "forces" ||
         std::ranges::any_of(changeable_sections, [&](const char* section) { return key.starts_with(section); });
}

std::vector<sim::Index> counted_up(std::size_t count) {
  std::vector<sim::Index> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0U);
  return numbers;
}

/// Returns for each mesh vertex the first of the caller's vertices that became it.
std::vector<sim::Index> first_vertices(const std::vector<sim::Index>& mesh_vertex, std::size_t count) {
  std::vector<sim::Index> first(count, sim::no_vertex);
  for (std::size_t v = mesh_vertex.size(); v-- > 0;) {
    if (mesh_vertex[v] != sim::no_vertex) first[mesh_vertex[v]] = static_cast<sim::Index>(v);
  }
  return first;
}

/// Returns the caller's vertex for each mesh vertex. If a model follows the mesh, it is the model's nearest vertex.
std::vector<sim::Index> caller_vertices(const app::GarmentInScene& loaded, const std::vector<sim::Index>& mesh_vertex) {
  const std::vector<sim::Vec3>& mesh_m = loaded.garment->mesh.positions;
  if (!loaded.following || mesh_vertex.size() != loaded.file_vertices.mesh_vertex.size()) {
    return first_vertices(mesh_vertex, mesh_m.size());
  }
  const sim::Mesh& model = loaded.following->mesh;
  const std::vector<sim::Index> of_model =
      first_vertices(loaded.following->file_vertices.mesh_vertex, model.positions.size());
  return app::collect<sim::Index>(app::bonds_to(mesh_m, model), [&](const app::Bond& bond) {
    return of_model[app::find_nearest_corner(bond, model.triangles)];
  });
}

std::string trim(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') + 1 - first);
}

app::DrawnScene make_scene(const TautOptions& options, const std::vector<app::Override>& overrides) {
  const int named =
      (options.scene != nullptr ? 1 : 0) + (options.scene_text != nullptr ? 1 : 0) + (options.mesh != nullptr ? 1 : 0);
  require(named == 1, "expected exactly one of scene, scene_text and mesh");
  if (options.scene != nullptr) return app::find_scene(options.scene, overrides);
  if (options.scene_text != nullptr) return app::read_scene_text(options.scene_text, "scene text", overrides);
  app::DrawnScene scene;
  scene.name = "mesh";
  scene.garment.given = std::make_shared<const app::ImportedModel>(model_from(options.mesh));
  scene.garment.mesh = app::MeshChoice::model;
  app::apply_overrides(overrides, scene);
  require(scene.garment.file.empty(), "garment.file: expected no file where a mesh is given");
  require(scene.garment.subdivisions == 0, "garment.subdivisions: expected a mesh that is subdivided already");
  return scene;
}

void set_importer(const TautOptions& options, app::Scene& scene) {
  if (options.importer != nullptr) {
    scene.garment.importer = options.importer;
    for (app::BodyInScene& body : scene.bodies) body.source.importer = options.importer;
  }
}

void set_threads(const TautOptions& options, app::Scene& scene) {
  require(options.threads >= 0 && options.threads <= sim::max_threads, "threads: expected 1 to 64, or 0");
  if (options.threads > 0) scene.simulation.solver.bounded.threads = options.threads;
}

std::vector<GivenBody> take_bodies(const TautOptions& options, const Start& start) {
  require(options.bodies != nullptr || options.body_count == 0, "found bodies of NULL");
  std::vector<GivenBody> all;
  for (std::size_t k = 0; k < options.body_count; ++k) {
    start.listener.tell(all.emplace_back(take_body(options.bodies[k], start.scene)).remarks);
  }
  return all;
}

std::vector<app::Override> parse_overrides(const TautOptions& options) {
  require(options.settings != nullptr || options.setting_count == 0, "found settings of NULL");
  require(options.setting_count <= 100000, "found more than 100000 settings");
  std::vector<app::Override> overrides;
  for (std::size_t k = 0; k < options.setting_count; ++k) {
    require(options.settings[k] != nullptr, "found a setting of NULL");
    const std::string text = options.settings[k];
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0) {
      throw ArgumentError("found the setting '" + text + "', expected KEY = VALUE, such as wind.speed = 4");
    }
    overrides.push_back({trim(text.substr(0, equals)), trim(text.substr(equals + 1)), text});
  }
  return overrides;
}

}  // namespace

GivenBody take_body(const TautBody* body, const app::Scene& scene) {
  const TautBody caller_body = read_struct(body);
  GivenBody parsed;
  parsed.body.name = caller_body.name != nullptr ? caller_body.name : "";
  if (caller_body.has_friction != 0) {
    require(caller_body.friction >= 0.0 && caller_body.friction <= 10.0, "friction: expected 0 to 10");
    parsed.body.friction = caller_body.friction;
  }
  require(caller_body.dress >= 0 && caller_body.dress <= 10000, "dress: expected 0 to 10000 frames");
  if (caller_body.mesh != nullptr) {
    take_mesh(caller_body, scene, parsed);
  } else {
    require(caller_body.dress == 0, "dress: expected 0 for a plane");
    parsed.body.shape = to_plane(caller_body);
  }
  return parsed;
}

std::size_t Session::add_body(const TautBody* body) {
  GivenBody parsed = take_body(body, scene_);
  require(parsed.source.dress == 0, "dress: expected 0 of a body that is added later");
  app::DrawnScene next = scene_;
  app::LoadedBodies bodies_before = bodies_;
  const std::size_t number = bodies_.all.size();
  next.bodies.push_back({parsed.body, parsed.source});
  bodies_.all.push_back(parsed.body);
  try {
    change(std::move(next));
  } catch (...) {
    std::swap(bodies_, bodies_before);
    throw;
  }
  if (parsed.lent) caller_bodies_[number] = std::move(*parsed.lent);
  const sim::State& state = simulation_.state();
  const app::StartRemarks remarks =
      app::remarks_on_body(bodies_.all, number, state.time_s, {state.current, simulation_.garment().mesh.triangles},
                           simulation_.pins().vertices);
  crossings_at_start_ += remarks.crossings;
  begin_again();
  listener_.tell(parsed.remarks);
  listener_.tell(remarks.lines);
  return number;
}

const CallerBody& Session::lent_body(std::size_t body) const {
  const auto found = caller_bodies_.find(body);
  if (found == caller_bodies_.end()) throw ArgumentError("found body {}, expected one that was added as a mesh", body);
  return found->second;
}

std::vector<sim::Vec3> Session::to_body_positions(const CallerBody& lent,
                                                  const std::vector<sim::Vec3>& positions_m) const {
  const auto in_body_m = app::collect<sim::Vec3>(
      lent.places.file_vertex, [&](std::size_t vertex) { return lent.places.placement(positions_m[vertex]); });
  const std::size_t lost = sim::first_lost(in_body_m);
  if (lost < in_body_m.size()) throw ArgumentError("found vertex {} beyond all bounds", lent.places.file_vertex[lost]);
  return in_body_m;
}

std::vector<sim::Vec3> Session::shape_m(std::size_t body) const {
  return app::mesh_positions_m(bodies_.all[body], simulation_.state().time_s);
}

// Keeps the body's mesh data as the caller first gave them, as for a file's body, because the last bits depend on them.
void Session::set_shape(std::size_t body, std::vector<sim::Vec3> positions_m) {
  std::get<sim::BodyMesh>(bodies_.all[body].shape).frames = std::make_shared<const StillBody>(std::move(positions_m));
}

void Session::move_body(std::size_t body, const std::vector<sim::Vec3>& positions_m) {
  const CallerBody& body_in_use = lent_body(body);
  std::vector<sim::Vec3> target_m = to_body_positions(body_in_use, positions_m);
  const std::vector<sim::Vec3> now_m = shape_m(body);
  for (std::size_t v = 0; v < target_m.size(); ++v) {
    const double way_m = glm::distance(target_m[v], now_m[v]);
    if (!(way_m <= app::max_motion_per_frame_m)) {
      throw ArgumentError("found vertex {} {:.3g} m from where it is, expected at most {:g} m in a frame",
                          body_in_use.places.file_vertex[v], way_m, app::max_motion_per_frame_m);
    }
  }
  // A target equal to the current shape is no motion; otherwise it would wake cloth at rest.
  caller_bodies_[body].target_m = target_m == now_m ? std::nullopt : std::optional(std::move(target_m));
}

void Session::place_body(std::size_t body, const std::vector<sim::Vec3>& positions_m) {
  set_shape(body, to_body_positions(lent_body(body), positions_m));
  caller_bodies_[body].target_m.reset();
  simulation_.set_surroundings(surroundings_of(scene_));
  begin_again();
}

Session::Session(const TautOptions& options, Start start)
    : scene_(std::move(start.scene)),
      bodies_(std::move(start.bodies)),
      loaded_(std::move(start.loaded)),
      mesh_vertex_(scene_.garment.given ? loaded_.file_vertices.mesh_vertex
                                        : counted_up(loaded_.garment->mesh.positions.size())),
      own_vertex_(caller_vertices(loaded_, mesh_vertex_)),
      simulation_(app::make_simulation(scene_, loaded_, bodies_.all)),
      frame_(app::go_to_start(scene_, bodies_, simulation_)),
      caller_bodies_(std::move(start.lent)),
      crossings_at_start_(start.crossings),
      listener_(start.listener) {
  if (options.counts_crossings != 0) verifier_.emplace();
  begin_again();
}

void Session::begin_again() {
  if (verifier_) verifier_->begin(simulation_);
}

void Session::require_not_diverged() const {
  const std::vector<sim::Vec3>& positions_m = simulation_.state().current;
  const std::size_t lost = sim::first_lost(positions_m);
  if (lost < positions_m.size()) throw sim::Diverged(static_cast<sim::Index>(lost), simulation_.state().time_s);
}

app::FrameRecord Session::step() {
  require_not_diverged();
  const sim::Surroundings still = simulation_.surroundings();
  sim::Surroundings moving = still;
  apply_targets(moving);
  simulation_.set_surroundings(moving);
  try {
    simulation_.advance_frame();
  } catch (...) {
    simulation_.set_surroundings(still);
    forget_targets();
    throw;
  }
  ++frame_;
  stay_at_targets();
  app::FrameRecord record = app::measure_frame(simulation_, frame_);
  if (verifier_) verifier_->check(simulation_, record);
  return record;
}

void Session::apply_targets(sim::Surroundings& surroundings) const {
  const double from_s = simulation_.state().time_s;
  const double rate_hz = simulation_.settings().frame_rate_hz;
  // A kinematic pin keeps cloth from being at rest, however short its path.
  const bool stay_by_themselves =
      surroundings.pin_motion.amplitude_m == sim::Vec3(0.0) && !sim::has_pins_of_their_own(surroundings);
  sim::PrescribedPins& prescribed_pins = surroundings.prescribed_pins;
  for (const auto& [vertex, target_m] : pin_targets_m_) {
    const sim::Vec3& now_m = simulation_.state().current[vertex];
    if (target_m != now_m || !stay_by_themselves) {
      prescribed_pins.vertices.push_back(vertex);
      prescribed_pins.by_m.push_back(target_m - now_m);
    }
  }
  // Times without prescribed pins would count as a change, which wakes cloth at rest.
  if (!prescribed_pins.vertices.empty()) {
    prescribed_pins.from_s = from_s;
    prescribed_pins.until_s = from_s + simulation_.frame_time_s();
  }
  for (const auto& [number, lent] : caller_bodies_) {
    if (lent.target_m) {
      auto& mesh = std::get<sim::BodyMesh>(surroundings.bodies[number].shape);
      mesh.frames = std::make_shared<const BodyMove>(shape_m(number), *lent.target_m, from_s, rate_hz);
    }
  }
}

// Forgets the motion, so that the next frame depends on the shape alone and not on how it was reached.
void Session::stay_at_targets() {
  for (auto& [number, lent] : caller_bodies_) {
    if (lent.target_m) set_shape(number, std::move(*lent.target_m));
  }
  forget_targets();
  simulation_.set_surroundings(surroundings_of(scene_));
}

void Session::forget_targets() {
  pin_targets_m_.clear();
  for (auto& [number, lent] : caller_bodies_) lent.target_m.reset();
}

sim::Surroundings Session::surroundings_of(const app::Scene& scene) const {
  sim::Surroundings surroundings = app::settle_surroundings(scene.surroundings, loaded_, bodies_.all);
  std::vector<sim::PointForce>& all = surroundings.forces.artificial_forces;
  all.insert(all.end(), forces_.begin(), forces_.end());
  return surroundings;
}

void Session::change(app::DrawnScene next) {
  require_not_diverged();
  simulation_.set_surroundings(surroundings_of(next));
  simulation_.set_settings(app::simulation_settings(next.simulation));
  simulation_.set_material(next.material);
  scene_ = std::move(next);
}

void Session::set(const std::string& key, const std::string& value) {
  if (!is_live(key)) {
    throw ArgumentError(
        key +
        ": expected a key of wind, gravity, forces, air, solver, cloth, rest, pins.motion, camera or picture; "
        "others are set when a cloth is made");
  }
  app::DrawnScene next = scene_;
  const app::Override changed{key, value, key + " = " + value};
  app::apply_overrides({&changed, 1}, next);
  change(std::move(next));
}

void Session::set_wind(const sim::Vec3& velocity_m_per_s) {
  app::DrawnScene next = scene_;
  sim::Wind& wind = next.surroundings.forces.wind;
  wind.speed_m_per_s = glm::length(velocity_m_per_s);
  wind.direction = wind.speed_m_per_s > 0.0 ? velocity_m_per_s : wind.direction;
  change(std::move(next));
}

void Session::set_gravity(const sim::Vec3& gravity_m_per_s2) {
  app::DrawnScene next = scene_;
  next.surroundings.forces.gravity_m_per_s2 = gravity_m_per_s2;
  change(std::move(next));
}

void Session::set_forces(const std::vector<sim::Index>& vertices, const std::vector<sim::Vec3>& forces_n) {
  std::vector<sim::PointForce> next;
  for (std::size_t k = 0; k < vertices.size(); ++k) next.push_back({mesh_vertex(vertices[k]), forces_n[k]});
  forces_.swap(next);
  try {
    simulation_.set_surroundings(surroundings_of(scene_));
  } catch (...) {
    forces_.swap(next);
    throw;
  }
}

void Session::set_pins(const std::vector<sim::Index>& vertices) {
  simulation_.set_pins(app::collect<sim::Index>(vertices, [this](sim::Index vertex) { return mesh_vertex(vertex); }));
  pin_targets_m_.clear();
}

std::vector<sim::Index> Session::pins() const {
  auto pins = app::collect<sim::Index>(simulation_.pins().vertices, [this](sim::Index pin) { return vertex_of(pin); });
  std::ranges::sort(pins);
  return pins;
}

void Session::move_pins(const std::vector<sim::Index>& vertices, const std::vector<sim::Vec3>& targets_m) {
  const std::vector<sim::Index>& pins = simulation_.pins().vertices;
  std::map<sim::Index, sim::Vec3> next;
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    const sim::Index vertex = mesh_vertex(vertices[k]);
    if (!std::ranges::binary_search(pins, vertex)) {
      throw ArgumentError("found vertex {}, expected one that is pinned", vertices[k]);
    }
    next.emplace(vertex, targets_m[k] + vertex_offset_m(vertex, vertices[k]));
  }
  pin_targets_m_ = std::move(next);
}

sim::Vec3 Session::vertex_offset_m(sim::Index in_mesh, sim::Index own) const {
  return scene_.garment.given && loaded_.following ? loaded_.garment->mesh.positions[in_mesh] - loaded_.file_rest_m[own]
                                                   : sim::Vec3(0.0);
}

sim::Index Session::mesh_vertex(sim::Index vertex) const {
  if (vertex >= mesh_vertex_.size() || mesh_vertex_[vertex] == sim::no_vertex) {
    throw ArgumentError("found vertex {}, expected one of a face, below {}", vertex, vertex_count());
  }
  return mesh_vertex_[vertex];
}

std::vector<sim::Vec3> Session::to_mesh_positions(const std::vector<sim::Vec3>& positions_m) const {
  if (scene_.garment.given && loaded_.following) {
    return app::simulated_m(*loaded_.following, loaded_.garment->mesh, positions_m);
  }
  return app::collect<sim::Vec3>(own_vertex_, [&](sim::Index vertex) { return positions_m[vertex]; });
}

std::vector<sim::Vec3> Session::positions_m() const {
  if (!scene_.garment.given) return simulation_.state().current;
  const std::vector<sim::Index>& shown_vertex =
      loaded_.following ? loaded_.following->file_vertices.mesh_vertex : mesh_vertex_;
  const std::vector<sim::Vec3> shown_m = loaded_.shown_m(simulation_.state().current);
  std::vector<sim::Vec3> positions_m = loaded_.file_rest_m;
  for (std::size_t v = 0; v < positions_m.size(); ++v) {
    if (shown_vertex[v] != sim::no_vertex) positions_m[v] = shown_m[shown_vertex[v]];
  }
  return positions_m;
}

void Session::set_positions(const std::vector<sim::Vec3>& positions_m) {
  const double time_s = simulation_.state().time_s;
  sim::Simulation next(simulation_.shared_garment(), simulation_.pins().vertices, simulation_.settings(),
                       simulation_.surroundings(), to_mesh_positions(positions_m));
  next.set_time(time_s);
  simulation_ = std::move(next);
  pin_targets_m_.clear();
  begin_again();
}

std::vector<double> Session::stretch() const {
  const std::vector<double> in_mesh = sim::vertex_surface_stretch(simulation_.garment(), simulation_.state().current);
  std::vector<double> stretch(vertex_count(), 0.0);
  for (std::size_t v = 0; v < stretch.size(); ++v) {
    stretch[v] = mesh_vertex_[v] == sim::no_vertex ? 0.0 : in_mesh[mesh_vertex_[v]];
  }
  return stretch;
}

std::string Session::save() const {
  app::RunCheckpoint run;
  run.scene_name = scene_.name;
  const app::Scene& simulated = scene_;
  run.scene = app::to_scene_text(app::scene_to_json(app::simulation_format(), simulated), simulated,
                                 app::GarmentNaming::in_assets);
  run.frame = frame_;
  run.simulation = sim::encode(simulation_.save(), simulation_.garment());
  return app::to_bytes(run);
}

void Session::restore(const std::filesystem::path& name, const app::RunCheckpoint& checkpoint) {
  app::restore(name, checkpoint, simulation_);
  frame_ = checkpoint.frame;
  forget_targets();
  begin_again();
}

void Listener::tell(const std::vector<std::string>& lines) const {
  for (const std::string& line : lines) {
    if (log != nullptr) log(user, line.c_str());
  }
}

Start load(const TautOptions& options) {
  Start start;
  start.listener = {options.log, options.log_user};
  start.scene = make_scene(options, parse_overrides(options));
  set_importer(options, start.scene);
  set_threads(options, start.scene);
  if (options.start != nullptr) {
    start.scene.garment.given_start_m = std::make_shared<const std::vector<sim::Vec3>>(points_from(options.start));
  }
  std::vector<GivenBody> given_bodies = take_bodies(options, start);
  const std::size_t first = start.scene.bodies.size();
  for (const GivenBody& body : given_bodies) start.scene.bodies.push_back({body.body, body.source});
  start.bodies = app::sew_and_load_bodies(start.scene);
  start.listener.tell(start.bodies.remarks);
  for (std::size_t k = 0; k < given_bodies.size(); ++k) {
    start.bodies.wearers[first + k] = given_bodies[k].wearer;
    if (given_bodies[k].lent) start.lent[first + k] = std::move(*given_bodies[k].lent);
  }
  start.loaded = app::load_garment(start.scene);
  start.listener.tell(app::put_where_it_begins(start.loaded, start.scene, start.bodies));
  start.listener.tell(app::collect_remarks(start.loaded));
  app::face_front(start.loaded, start.scene);
  const app::StartRemarks remarks = app::remarks_on_start(start.scene, start.loaded, start.bodies.all);
  start.listener.tell(remarks.lines);
  start.crossings = remarks.crossings;
  if (options.struct_size == min_struct_size<TautOptions>) {
    start.listener = {};  // a caller built for that version may have ended its log after the call
  }
  return start;
}

}  // namespace taut::library
