#include "app/bodies/body_loading.hpp"

#include "app/base/errors.hpp"
#include "app/base/words.hpp"
#include "app/bodies/body_mesh.hpp"
#include "app/scene/scene_key.hpp"
#include "sim/contact/crossing_pairs.hpp"
#include "sim/mesh/topology.hpp"

namespace taut::app {
namespace {

/// Known systems of axes; the body's own is the first.
const std::array<AxisSystem, 5> axis_systems = {{{"x, y, z", {0, 1, 2}, {1, 1, 1}},
                                                 {"x, z, -y", {0, 2, 1}, {1, 1, -1}},
                                                 {"x, -z, y", {0, 2, 1}, {1, -1, 1}},
                                                 {"x, y, -z", {0, 1, 2}, {1, 1, -1}},
                                                 {"x, z, y", {0, 2, 1}, {1, 1, 1}}}};

/// Square of the factor by which other axes must bring the first frame nearer to the body to be chosen.
constexpr double min_squared_distance_ratio = 9.0;

/// Returns the sum of the squared distances, in m^2.
double distance_from(const LoadedMesh& body, const std::vector<sim::Vec3>& in_file, const AxisSystem& axes) {
  double sum = 0.0;
  for (std::size_t v = 0; v < body.mesh.positions.size(); ++v) {
    const sim::Vec3 apart = body.places.placement(axes(in_file[body.places.file_vertex[v]])) - body.mesh.positions[v];
    sum += glm::dot(apart, apart);
  }
  return sum;
}

/// Returns the axes of a motion of vertices. Programs write caches in axes of their own: Blender with z up beside OBJ
/// with y up, others in a left-handed system. The system in which the first frame is nearest to the body is chosen if
/// it is clearly nearer than the file's own, and reported in `remarks`. A motion of joints has the file's axes.
/// Requires a frame source with the vertices of the body's file.
AxisSystem find_motion_axes(const LoadedMesh& body, const FrameSource& motion, std::vector<std::string>& remarks) {
  if (motion.pose(0)) return {};
  std::vector<sim::Vec3> in_file(motion.vertices());
  motion.read(0, in_file);
  const AxisSystem* best_axes = &axis_systems.front();
  double distance = distance_from(body, in_file, *best_axes) / min_squared_distance_ratio;
  for (const AxisSystem& axes : axis_systems) {
    if (const double here = distance_from(body, in_file, axes); here < distance) {
      best_axes = &axes;
      distance = here;
    }
  }
  if (best_axes != &axis_systems.front()) {
    remarks.push_back(std::string("its motion is in other axes than it, guessed from its first frame: there (") +
                      best_axes->name + ") are its x, y and z");
  }
  return *best_axes;
}

// Range of people's heights.
constexpr double min_person_height_m = 0.5;
constexpr double max_person_height_m = 2.5;
/// Numbers of poses in which the clearance between parts of a body is measured. Layered garments need more clearance,
/// which is missing in more frames of the motion.
constexpr int pose_count = 6, layered_pose_count = 25;

std::shared_ptr<const Rig> take_rig(const std::filesystem::path& file, ImportedModel& model) {
  auto rig = std::make_shared<Rig>(std::move(model.rig));
  if (!rig->empty()) {
    try {
      require_weights(*rig);
    } catch (const std::invalid_argument& error) {
      throw InputError("'" + file.string() + "': " + error.what());
    }
    pose_vertices(*rig, stored_pose(*rig), model.positions);
  }
  return rig;
}

/// Returns an empty text if the body is as high as a person.
std::string remark_on_height(const sim::Mesh& mesh) {
  const double height_m = sim::compute_extent(mesh.positions).size().y;
  const bool is_person = height_m >= min_person_height_m && height_m <= max_person_height_m;
  return is_person ? "" : fmt::format("it is {:.3g} m high (scale, --body-units)", height_m);
}

double frame_rate(const BodySource& source, const FrameSource& motion, std::vector<std::string>& remarks) {
  const std::optional<double> own_hz = motion.rate_hz();
  if (!source.frame_rate_hz && !own_hz) {
    remarks.push_back(
        fmt::format("its motion does not say how fast it is: {:g} frames a second are taken (frame_rate, --body-fps)",
                    usual_frame_rate_hz));
  }
  return source.frame_rate_hz.value_or(own_hz.value_or(usual_frame_rate_hz));
}

std::size_t first_frame(const BodySource& source, const std::filesystem::path& file, const FrameSource& motion,
                        double rate_hz) {
  const double first = std::round(source.start_s * rate_hz);
  const std::size_t frames = motion.frames();
  if (first >= static_cast<double>(frames)) {
    throw InputError("'{}': found start = {:g} s, expected a time of the motion, which ends at {:g} s", file.string(),
                     source.start_s, static_cast<double>(frames - 1) / rate_hz);
  }
  return static_cast<std::size_t>(first);
}

/// Reads the frames that the run shows, so that their errors are reported before it begins.
void preload_frames(const sim::BodyFrames& frames, std::size_t vertices, double duration_s) {
  const double last = std::min(std::ceil(duration_s * frames.rate_hz()) + 1.0, static_cast<double>(frames.count() - 1));
  std::vector<sim::Vec3> positions_m(vertices);
  for (std::size_t frame = 0; frame <= static_cast<std::size_t>(last); ++frame) {
    throw_if_interrupted();
    frames.positions_in(frame, positions_m);
  }
}

void require_vertices(const BodySource& source, const LoadedMesh& loaded, const OpenedMotion& motion) {
  if (motion.frames->vertices() != loaded.file_vertices) {
    throw InputError("'{}': found {}, expected the {} of '{}', in their order", motion.file.string(),
                     count_text(motion.frames->vertices(), "vertex", "vertices"), loaded.file_vertices,
                     source.file.string());
  }
}

std::shared_ptr<const sim::BodyFrames> load_repeated(const std::filesystem::path& file,
                                                     std::shared_ptr<const sim::BodyFrames> motion,
                                                     const LoopBegin& begin, std::size_t first) try {
  return make_loop(std::move(motion), begin, first);
} catch (const InputError& error) {
  throw InputError('\'' + file.string() + "': " + error.what());
}

/// Sets `pose` to the joints in the first frame.
std::shared_ptr<const sim::BodyFrames> load_body_frames(const BodySource& source, const LoadedMesh& loaded,
                                                        OpenedMotion motion, double duration_s,
                                                        std::vector<std::string>& remarks,
                                                        std::optional<RigPose>& pose) {
  require_vertices(source, loaded, motion);
  FileVertexPlaces places = loaded.places;
  places.motion_axes = find_motion_axes(loaded, *motion.frames, remarks);
  if (motion.frames->frames() == 1) remarks.emplace_back("its motion has 1 frame, in which it stays");
  const double rate_hz = frame_rate(source, *motion.frames, remarks);
  const std::size_t first = first_frame(source, motion.file, *motion.frames, rate_hz);
  pose = motion.frames->pose(first);
  std::shared_ptr<const sim::BodyFrames> frames =
      placed_frames(motion.file, std::move(motion.frames), std::move(places), rate_hz, source.loop ? 0 : first);
  if (source.loop) {
    const LoopBegin begin = find_loop_begin(*frames, loaded.mesh.positions.size());
    if (!begin.meets) remarks.push_back(describe(begin));
    frames = load_repeated(motion.file, std::move(frames), begin, first);
  }
  preload_frames(*frames, loaded.mesh.positions.size(), duration_s);
  return frames;
}

[[noreturn]] void refuse_to_dress(const BodySource& source, const char* reason) {
  throw InputError('\'' + source.file.string() + "': found a body to be dressed (dress, --dress) " + reason +
                   "; expected one that grows from its joints: a model with a skin, still or moved by an "
                   "animation of its own or a BVH motion; or one that stands still, arms off its trunk");
}

/// Gives joints to a body without any, guessed from its shape.
void guess_joints(const BodySource& source, const LoadedMesh& loaded, const BodyMeasures& measures, bool is_still,
                  FileVertexPlaces& places, ReadBody& body) {
  std::optional<Rig> rig =
      !is_still ? std::nullopt : guess_rig({loaded.mesh.positions, loaded.mesh.triangles}, measures);
  if (!rig) refuse_to_dress(source, "without joints");
  body.rig = std::make_shared<const Rig>(std::move(*rig));
  places.placement = {};
  places.file_vertex.resize(loaded.mesh.positions.size());
  std::iota(places.file_vertex.begin(), places.file_vertex.end(), 0U);
  body.remarks.emplace_back("it has no joints: those that it grows from are guessed from its shape");
}

/// Returns poses spread over the shown time of the motion, or the stored pose of a body that does not move.
std::vector<RigPose> poses_shown(const BodySource& source, const Rig& rig, const FrameSource* motion,
                                 const ShownTime& shown) {
  const int count = shown.garments > 1 ? layered_pose_count : pose_count;
  std::vector<RigPose> poses;
  if (motion != nullptr) {
    const double rate_hz = source.frame_rate_hz.value_or(motion->rate_hz().value_or(usual_frame_rate_hz));
    const double last = static_cast<double>(motion->frames() - 1);
    for (int k = 0; k < count; ++k) {
      const double time_s = source.start_s + k * shown.duration_s / (count - 1);
      const auto pose = motion->pose(static_cast<std::size_t>(std::min(last, std::round(time_s * rate_hz))));
      poses.insert(poses.end(), pose ? 1 : 0, pose.value_or(RigPose{}));
    }
  } else {
    poses.push_back(stored_pose(rig));
  }
  return poses;
}

/// Moves parts of the body apart that close in on each other, so that cloth fits between them. Returns whether there
/// are any.
bool add_cloth_clearance(std::span<const RigPose> poses, const FileVertexPlaces& places, int garments,
                         LoadedMesh& loaded, ReadBody& body) {
  std::optional<ClearanceResult> room =
      poses.empty() ? std::nullopt : leave_clearance(*body.rig, poses, places, loaded.mesh.triangles, garments);
  if (room) {
    body.remarks.push_back(
        fmt::format("parts of it come near each other: {} stay back by up to {:.1f} cm, so that cloth has room",
                    count_text(room->vertices, "vertex", "vertices"), 100.0 * room->max_distance_m));
    body.rig = std::make_shared<const Rig>(std::move(room->rig));
    loaded.mesh.positions = placed_m(places, posed_vertices(*body.rig, stored_pose(*body.rig)));
  }
  return room.has_value();
}

std::shared_ptr<const Wearer> make_wearer(const BodySource& source, const LoadedMesh& loaded, FileVertexPlaces places,
                                          const std::optional<RigPose>& pose, double frame_rate_hz,
                                          BodyMeasures measures, const ReadBody& body) {
  if (!pose) refuse_to_dress(source, "whose motion moves vertices and no joints");
  Wearer wearer{.rig = body.rig, .places = std::move(places), .pose = *pose, .full_m = loaded.mesh.positions};
  wearer.motion = body.mesh.frames;
  if (wearer.motion) wearer.motion->positions_in(0, wearer.full_m);
  wearer.rate_hz = wearer.motion ? wearer.motion->rate_hz() : frame_rate_hz;
  wearer.duration_s = source.dress / frame_rate_hz;
  wearer.measures = std::move(measures);
  wearer.stored_joints = compute_joint_positions(*wearer.rig, stored_pose(*wearer.rig), wearer.places.placement);
  wearer.joints = compute_joint_positions(*wearer.rig, wearer.pose, wearer.places.placement);
  wearer.frames = make_growing_frames(wearer);
  return std::make_shared<const Wearer>(std::move(wearer));
}

/// Number of frames that are examined for crossings. All frames would take minutes.
constexpr std::size_t max_examined_frames = 20;

double enclosed_volume(const sim::BodyMeshData& mesh) {
  double sum = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    sum += glm::dot(mesh.positions_m[a], glm::cross(mesh.positions_m[b], mesh.positions_m[c]));
  }
  return sum / 6.0;
}

std::vector<std::string> joint_names(const Rig& rig) {
  std::set<sim::Index> nodes;
  for (const RigInfluence& influence : rig.influences) {
    nodes.insert(influence.weight > 0.0 ? rig.bones[influence.bone].node : no_node);
  }
  nodes.erase(no_node);
  return collect<std::string>(nodes, [&](sim::Index node) { return rig.nodes[node].name; });
}

Json to_json_list(const sim::Vec3& p) { return Json::array({p.x, p.y, p.z}); }

/// Describes the motion, or the clip that is played.
Json describe_motion(const sim::BodyMesh& body) {
  const LoopBegin loop = find_loop_begin(*body.frames, body.data->positions_m.size());
  return {{"frames", body.frames->count()},
          {"frame_rate_hz", body.frames->rate_hz()},
          {"repeats_from_frame", loop.frame},
          {"repeats_from_m_away", loop.max_distance_m},
          {"repeats", describe(loop)}};
}

Json describe_crossings(const sim::BodyMesh& body) {
  const std::size_t frames = body.frames ? body.frames->count() : 1;
  const std::size_t looked_at = std::min(frames, max_examined_frames);
  Json json = {{"frames_looked_at", looked_at}, {"frames", Json::array()}};
  std::vector<sim::Vec3> positions_m = body.data->positions_m;
  for (std::size_t k = 0; k < looked_at; ++k) {
    throw_if_interrupted();
    const std::size_t frame = k * (frames - 1) / std::max<std::size_t>(looked_at - 1, 1);
    if (body.frames) body.frames->positions_in(frame, positions_m);
    const sim::Surface surface = {positions_m, body.data->triangles};
    const std::vector<sim::CrossingPair> pairs = sim::find_crossing_pairs(surface);
    if (!pairs.empty()) json["frames"].push_back({{"frame", frame}, {"pairs", describe(surface, pairs)}});
  }
  return json;
}

/// Reads a body of the scene and puts it into `bodies`, in place of the one of this number.
void load_body(const Scene& scene, std::size_t number, int garments, LoadedBodies& bodies) {
  const double frame_rate_hz = scene.simulation.frame_rate_hz;
  const ShownTime shown = {scene.frames / frame_rate_hz, frame_rate_hz,
                           std::max(garments, read_garment_facts(scene.garment.model()).layers)};
  const auto& [named, source] = scene.bodies[number];
  bodies.all.resize(std::max(bodies.all.size(), number + 1));
  bodies.wearers.resize(bodies.all.size());
  sim::Body& body = bodies.all[number] = named;
  auto* mesh = std::get_if<sim::BodyMesh>(&body.shape);
  if (mesh == nullptr || mesh->data) return;
  const std::string name = "body " + (body.name.empty() ? fmt::format("{}", number + 1) : '\'' + body.name + '\'');
  try {
    ReadBody read = read_body(source, shown);
    *mesh = std::move(read.mesh);
    bodies.wearers[number] = std::move(read.wearer);
    bodies.files_read.insert(bodies.files_read.end(), read.files.begin(), read.files.end());
    for (const std::string& remark : read.remarks) bodies.remarks.push_back(name + ": " + remark);
  } catch (const InputError& error) {
    throw InputError(name + ": " + error.what());
  }
}

}  // namespace

std::shared_ptr<const Rig> read_rig(const std::filesystem::path& file) {
  ImportedModel model = import_garment(file);
  return take_rig(file, model);
}

ReadBody read_body(const BodySource& source, const ShownTime& shown) {
  return make_body(source, import_garment(source.file, {.program = source.importer}), shown);
}

ReadBody make_body(const BodySource& source, ImportedModel model, const ShownTime& shown) {
  ReadBody body{{}, take_rig(source.file, model), {}, {}, model.format, model.files};
  LoadedMesh loaded = make_body_mesh(source, model);
  body.joints = compute_joint_positions(*body.rig, stored_pose(*body.rig), loaded.places.placement);
  body.remarks = loaded.remarks;
  OpenedMotion motion = open_motion(source, body.rig, loaded.places.placement.up);
  body.remarks.insert(body.remarks.end(), motion.remarks.begin(), motion.remarks.end());
  if (body.format.find("FBX") != std::string::npos && !body.rig->targets.empty() &&
      (!motion.frames || !source.motion.empty())) {
    body.remarks.emplace_back("none of its shapes is mixed in: how much of them is not read from FBX");
  }
  const std::string height = motion.frames || !body.rig->influences.empty() ? remark_on_height(loaded.mesh) : "";
  if (!height.empty()) body.remarks.push_back(height);
  BodyMeasures measures;
  FileVertexPlaces places = loaded.places;
  if (source.dress > 0) {
    measures = measure_body_and_arms({loaded.mesh.positions, loaded.mesh.triangles}, body.joints);
    if (body.rig->influences.empty() && (!motion.frames || motion.frames->pose(0))) {
      guess_joints(source, loaded, measures, !motion.frames, places, body);
    }
    if (add_cloth_clearance(poses_shown(source, *body.rig, motion.frames.get(), shown), places, shown.garments, loaded,
                            body)) {
      motion = open_motion(source, body.rig, loaded.places.placement.up);
    }
  }
  std::optional<RigPose> pose = stored_pose(*body.rig);
  if (motion.frames) {
    try {
      body.mesh.frames = load_body_frames(source, loaded, std::move(motion), shown.duration_s, body.remarks, pose);
    } catch (const InputError& error) {
      throw InputError(error.what() + (height.empty() ? "" : "; " + height));
    }
  }
  if (source.dress > 0) {
    body.wearer = make_wearer(source, loaded, std::move(places), pose, shown.frame_rate_hz, std::move(measures), body);
    body.mesh.frames = body.wearer->frames;
  }
  body.mesh.data = std::make_shared<const sim::BodyMeshData>(
      sim::BodyMeshData{std::move(loaded.mesh.positions), std::move(loaded.mesh.triangles)});
  body.places = std::move(loaded.places);
  body.file_vertices = loaded.file_vertices;
  return body;
}

LoadedBodies load_bodies(const Scene& scene, int garments) {
  LoadedBodies bodies;
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) load_body(scene, k, garments, bodies);
  return bodies;
}

LoadedBodies reload_body(const Scene& scene, std::size_t body, LoadedBodies bodies) {
  bodies.remarks.clear();
  load_body(scene, body, 1, bodies);
  return bodies;
}

LoadedBodies choose_dressing(std::span<const Override> overrides, Scene& scene) {
  const bool lets_go = sets(overrides, "body.file") && !sets(overrides, "pins.at") && scene.moving_pins.empty();
  if (lets_go && scene.dressing_frames() > 0) scene.pins.reset();
  const bool is_unsaid = lets_go && !sets(overrides, "body.dress") && scene.dressing_frames() == 0;
  if (!is_unsaid || scene.garment.is_grid() || scene.garment.has_start() || !scene.checkpoint.empty()) {
    return load_bodies(scene);
  }
  Scene dressed_scene = scene;
  dressed_scene.bodies.back().source.dress = usual_dressing_frames;
  dressed_scene.pins.reset();
  try {
    LoadedBodies bodies = load_bodies(dressed_scene);
    if (bodies.wearers.back() && !bodies.wearers.back()->measures.girths.empty()) {
      bodies.remarks.push_back(
          fmt::format("it is put on the body '{}' in {} frames before frame 0; --dress 0 leaves both where they are",
                      bodies.all.back().name, usual_dressing_frames));
      scene = std::move(dressed_scene);
      return bodies;
    }
  } catch (const InputError&) {
    // The body cannot be dressed or cannot be read. The call below reports the latter.
  }
  return load_bodies(scene);
}

void print_body_remarks(const Scene& scene, const std::vector<std::string>& remarks, std::FILE* output) {
  for (const std::string& remark : output == nullptr ? std::vector<std::string>{} : remarks) {
    fmt::print(output, "{}: {}\n", scene.name, printable(remark));
  }
}

Json inspect_body(const BodySource& source) {
  BodySource undressed = source;
  undressed.dress = 0;
  undressed.loop = false;
  const ReadBody body = read_body(undressed, {});
  const sim::BodyMeshData& mesh = *body.mesh.data;
  Json json = {{"file", source.file.string()},
               {"format", body.format},
               {"vertices", mesh.positions_m.size()},
               {"triangles", mesh.triangles.size()},
               {"closed_surfaces", sim::first_vertices_of_parts(mesh.positions_m.size(), mesh.triangles).size()},
               {"size_m", to_json_list(sim::compute_extent(mesh.positions_m).size())},
               {"volume_m3", enclosed_volume(mesh)},
               {"joints", joint_names(*body.rig)},
               {"shapes", body.rig->targets.size()},
               {"animations", describe_clips(*body.rig)},
               {"girths", Json::array()}};
  for (const Girth& girth : measure_body_and_arms({mesh.positions_m, mesh.triangles}, body.joints).girths) {
    json["girths"].push_back({{"name", girth.name}, {"girth_m", girth.girth_m}, {"height_m", girth.height_m}});
  }
  if (body.mesh.frames) json["motion"] = describe_motion(body.mesh);
  json["crossings"] = describe_crossings(body.mesh);
  json["remarks"] = body.remarks;
  return json;
}

}  // namespace taut::app
