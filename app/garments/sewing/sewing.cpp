#include "app/garments/sewing/sewing.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/base/words.hpp"
#include "app/bodies/body_loading.hpp"
#include "app/garments/dressing/fit.hpp"
#include "app/garments/dressing/wearing.hpp"
#include "app/garments/sewing/placing.hpp"
#include "app/garments/sewing/tuning.hpp"
#include "app/models/hanging/garment_parts.hpp"
#include "app/models/inspecting/scene_crossings.hpp"
#include "app/models/reading/file_mesh.hpp"
#include "app/runs/run_checkpoint.hpp"
#include "app/scene/scene_format.hpp"
#include "app/scene/scene_key.hpp"
#include "sim/solvers/bounded/tuning.hpp"

namespace taut::app {
namespace {

using sim::Index;
using sim::Vec3;
using namespace sewing;

constexpr double cm = 0.01;

[[noreturn]] void refuse_open(SewnGarment garment) {
  const SewnPieces& sewn = garment.sewn;
  const Stitch& open = garment.pattern.stitches[sewn.open_stitch];
  std::string message =
      fmt::format("a seam stays open: {}, by {:.2g} cm at {}{}", garment.pattern.describe(open), sewn.gap_m / cm,
                  describe_place(sewn.gap_place_m), sewn.reason.empty() ? "" : "; " + sewn.reason);
  for (const Stitch& other : garment.pattern.stitches) {
    const bool shares = other.first == open.first || other.first == open.second || other.second == open.first ||
                        other.second == open.second;
    if (shares && &other != &open) message += "; it shares an edge with the seam of " + garment.pattern.describe(other);
  }
  throw SewingFailed(message, std::move(garment));
}

/// Assigns their own fabrics to outer layers.
sim::Garment of_fabrics(sim::Garment cloth, const SewnGarment& garment) {
  if (garment.over_fabrics.empty()) return cloth;
  const auto find_material = [](const std::string& fabric) { return find_fabric_material(fabric, "--over-fabric"); };
  std::vector<sim::Material> other_materials = collect<sim::Material>(garment.over_fabrics, find_material);
  std::vector<std::uint8_t> layer_of(cloth.mesh.positions.size());
  for (std::size_t v = 0; v < garment.pieces.flat_m.size(); ++v) {
    layer_of[garment.sewn.vertex_of[v]] =
        static_cast<std::uint8_t>(garment.pieces.layer_of[garment.pieces.panel_of[v]]);
  }
  try {
    return sim::with_other_materials(std::move(cloth), std::move(layer_of), std::move(other_materials));
  } catch (const std::invalid_argument& error) {
    throw InputError("--over-fabric: {}; expected a fabric for all (--fabric)", error.what());
  }
}

/// Returns the panel with the largest stretch, the nearest seam, and the girths of garment and body there. `start_m`
/// are the positions before the body grew.
std::string describe_tightest(const LoadedBodies& bodies, const SewnGarment& garment,
                              const std::vector<Vec3>& start_m) {
  const sim::Mesh& mesh = garment.sewn.garment.mesh;
  const std::vector<double> stretch = sim::triangle_surface_stretch(garment.sewn.garment, mesh.positions);
  const auto t = static_cast<std::size_t>(std::ranges::max_element(stretch) - stretch.begin());
  const Vec3 at_m = mesh.positions[mesh.triangles[t][0]];
  const auto distance_m = [&](const Seam& seam) {
    return std::ranges::min(collect<double>(seam, [&](const std::pair<Index, Index>& pair) {
      return glm::distance(mesh.positions[garment.sewn.vertex_of[pair.first]], at_m);
    }));
  };
  const std::vector<Seam>& seams = garment.pieces.seams;
  const auto nearest = static_cast<std::size_t>(std::ranges::min_element(seams, {}, distance_m) - seams.begin());
  const sim::Index panel = garment.pieces.panel_of[garment.pieces.triangles[t][0]];
  std::string around;
  const BodyMeasures& measures = dressed_body(bodies).wearer->measures;
  const sim::Surface start = {start_m, mesh.triangles};
  const auto tube = find_tube(start);
  const double start_height_m = start_m[mesh.triangles[t][0]].y;
  const double cloth_m = tube ? girth_at(start, std::min(start_height_m, tube->max_height_m)).value_or(0.0) : 0.0;
  const double body_m = measures.level_at(at_m.y).girth_m;
  if (cloth_m > one_limb_fraction * body_m && at_m.y > measures.levels[measures.fork].height_m &&
      at_m.y < measures.levels.back().height_m) {
    around = fmt::format(", where the body is {:.1f} cm around and the garment {:.1f} cm", body_m / cm, cloth_m / cm);
  }
  return fmt::format("it is tightest in the panel '{}', beside the seam of {}{}", garment.pattern.panels[panel].name,
                     garment.pattern.describe(garment.pattern.stitches[nearest]), around);
}

/// Returns hands that bear the garment's weight at the upper ends of parts without shoulder seams that begin well above
/// the waist: they would slide down while the body grows into them and before friction holds them.
std::vector<sim::GrabbedVertex> hold_strapless(const Scene& scene, const LoadedBodies& bodies,
                                               const SewnGarment& garment) {
  const BodyMeasures& measures = dressed_body(bodies).wearer->measures;
  std::vector<sim::GrabbedVertex> hands;
  if (!garment.pieces.first_seams.empty()) return hands;
  const sim::Garment& cloth = garment.sewn.garment;
  const double weight_n = glm::length(scene.surroundings.forces.gravity_m_per_s2) *
                          std::reduce(cloth.masses_kg.begin(), cloth.masses_kg.end());
  for (const GarmentPart& part : find_garment_parts(cloth.mesh, sim::make_adjacency(cloth.mesh))) {
    const Opening* top = top_opening(part);
    if (top == nullptr || top->mean_height_m < measures.waist_m->y + held_above_waist_m) continue;
    const double force_n = weight_n / static_cast<double>(top->vertices.size());
    for (const Index v : top->vertices) {
      hands.push_back({v, cloth.mesh.positions[v], force_n / hold_reach_m, force_n});
    }
  }
  return hands;
}

/// Returns the settings of a run in which cloth counts as at rest below `resting_m_per_s`.
sim::SimulationSettings resting_settings(const RunSettings& run) {
  sim::SimulationSettings settings = simulation_settings(run);
  settings.rest_settings.speed_m_per_s = std::max(settings.rest_settings.speed_m_per_s, resting_m_per_s);
  return settings;
}

/// Thickens the air to this drag, unless it is thicker.
void thicken(double drag_per_s, sim::ExternalForces& forces) {
  forces.air_drag_per_s = std::max(forces.air_drag_per_s, drag_per_s);
}

/// Lets a sewn garment come to rest without a body, gravity and wind, in which it would fall or fly away. It begins
/// anew each second, as bending counts the shape at the start as flat: creases that closing has left would last.
void rest_freely(const Scene& scene, const SewingSettings& settings,
                 const std::function<void(const std::string&)>& stage, SewnGarment& garment) {
  sim::Surroundings air = scene.surroundings;
  air.forces = without_gravity_and_wind(std::move(air.forces));
  thicken(resting_drag_per_s, air.forces);
  sim::Material material = scene.material;
  double& compression_n_per_m = material.compression_stiffness_n_per_m;
  compression_n_per_m = std::min(compression_n_per_m, max_free_compression_n_per_m);
  sim::Garment& cloth = garment.sewn.garment;
  std::optional<sim::Simulation> simulation;
  for (; garment.frames < settings.frames && !garment.is_at_rest; ++garment.frames) {
    throw_if_interrupted();
    stage(fmt::format("coming to rest, {} of {} frames", garment.frames, settings.frames));
    if (garment.frames % frames_to_unfold == 0) {
      sim::Garment unfolded = sim::make_garment(std::move(cloth.mesh), scene.mapping, material);
      unfolded.warps = std::move(cloth.warps);
      cloth = of_fabrics(std::move(unfolded), garment);
      simulation.emplace(sim::share(cloth), std::vector<Index>{}, resting_settings(scene.simulation), air,
                         cloth.mesh.positions);
    }
    try {
      simulation->advance_frame(throw_if_interrupted);
    } catch (const sim::ContactBlocked& error) {
      throw SewingFailed(std::string("its seams are closed, but it does not come to rest: ") + error.what(),
                         std::move(garment));
    }
    cloth.mesh.positions = simulation->state().current;
    garment.rms_speed_m_per_s = sim::rms_speed(simulation->change());
    garment.is_at_rest = simulation->state().asleep;
  }
}

/// Returns whether all cloth is below the fork of the body that is dressed, where `pattern` does not begin.
bool has_fallen(const LoadedBodies& bodies, const SewingPattern& pattern, std::span<const Vec3> positions_m) {
  const Wearer* const wearer = dressed_body(bodies).wearer;
  if (wearer == nullptr) return false;
  const double fork_m = wearer->measures.levels[wearer->measures.fork].height_m;
  const bool begins_below = !pattern.joint.empty() && wearer->joints.at(pattern.joint).y < fork_m;
  return !begins_below && sim::compute_extent(positions_m).upper.y < fork_m;
}

/// Lets the body grow into the sewn garment, which then comes to rest.
void dress_sewn_garment(const Scene& scene, const LoadedBodies& bodies, const SewingSettings& settings,
                        const std::function<void(const std::string&)>& stage, SewnGarment& garment) {
  SewnPieces& sewn = garment.sewn;
  sewn.garment = of_fabrics(sim::with_material(std::move(sewn.garment), scene.material), garment);
  // Smallest distances are then derived from the positions, as for any garment that begins where it lies.
  sewn.garment.untangled_m.clear();
  RunSettings run = scene.simulation;
  run.solver.max_substeps = std::min(run.solver.max_substeps, max_substeps);
  sim::Surroundings air = scene.surroundings;
  air.bodies = bodies.all;
  sim::Surroundings thick_air = air;
  thick_air.forces.grabbed_vertices = hold_strapless(scene, bodies, garment);
  thicken(resting_drag_per_s, thick_air.forces);
  // Thick air slows cloth that comes loose to a speed at which it can be kept apart. Rest counts in the scene's air.
  sim::Simulation simulation(sim::share(sewn.garment), {}, resting_settings(run), thick_air,
                             sewn.garment.mesh.positions);
  const auto keep = [&] {
    sewn.garment.mesh.positions = simulation.state().current;
    garment.time_s = simulation.state().time_s;
  };
  std::vector<FitRow> fit = compute_fit(bodies, sewn.garment, sewn.garment.mesh.positions);
  // A level may meet one limb alone where the body is thin.
  std::erase_if(fit, [](const FitRow& row) { return row.garment_m < one_limb_fraction * row.body_m; });
  const std::vector<Vec3> start_m = sewn.garment.mesh.positions;
  bool is_thick = true;
  try {
    stage("the body grows into it");
    dress(scene, simulation);
    double work = 0.0;
    const auto goes_on = [&] {
      return work < max_work && !has_fallen(bodies, garment.pattern, simulation.state().current);
    };
    for (; garment.frames < settings.frames && goes_on(); ++garment.frames) {
      throw_if_interrupted();
      stage(fmt::format("coming to rest, {} of {} frames", garment.frames, settings.frames));
      if (simulation.state().asleep) {
        if (!is_thick) break;
        is_thick = false;
        simulation.set_surroundings(air);
      } else if (is_thick && garment.frames % frames_to_thicker == 0) {
        simulation.set_surroundings(thick_air);
        thicken(std::min(drag_growth_factor * thick_air.forces.air_drag_per_s, thickest_per_s), thick_air.forces);
      }
      simulation.advance_frame(throw_if_interrupted);
      const sim::FrameReport& frame = simulation.last_report();
      work += frame.sweeps + sim::bounded::tuning::search_work_sweeps *
                                 (frame.contact.detections + 0.5 * frame.contact.partial_detections);
    }
  } catch (const std::exception& error) {
    if (!is_any<InputError, PromiseBroken, sim::ContactBlocked>(error)) throw;
    keep();
    const std::string tight = describe_tightness(bodies, sewn.garment, sewn.garment.mesh.positions, fit);
    std::string misfit = describe_misfit(fit);
    if (!misfit.empty()) misfit = misfit.substr(2) + "; ";
    const std::string message = "its seams are closed, but it cannot be worn: " + misfit +
                                describe_tightest(bodies, garment, start_m) + (tight.empty() ? "" : "; " + tight) +
                                "; " + error.what();
    throw SewingFailed(message, std::move(garment));
  }
  garment.is_at_rest = simulation.state().asleep && !is_thick;
  garment.rms_speed_m_per_s = sim::rms_speed(simulation.change());
  keep();
}

CutPieces cut(const std::filesystem::path& file, const SewingPattern& pattern, int triangles, bool is_exact) {
  try {
    return cut_pieces(pattern, triangles, is_exact);
  } catch (const std::invalid_argument& error) {
    throw InputError("cannot use '{}': {}", file.string(), error.what());
  }
}

/// Records the pattern, its placement, and the first moment in which half of the seams are closed.
void keep_step(double share, const sim::Garment& now, const std::vector<Vec3>& positions_m, SewnGarment& garment) {
  constexpr double half = 0.5;
  if (garment.steps.empty()) {
    const auto to_space = [](const sim::Vec2& at) { return Vec3(at, 0.0); };
    garment.steps = {{"the pattern", now, collect<Vec3>(garment.pieces.flat_m, to_space), garment.time_s},
                     {"placed", now, positions_m, garment.time_s}};
  } else if (garment.steps.size() == 2 && share >= half) {
    garment.steps.push_back({"half closed", now, positions_m, garment.time_s});
  }
}

/// Returns whether the upper ends of all parts lie around the body. A hood's face lies in front of the neck: there the
/// whole part counts.
bool lies_around(const Wearer& wearer, const sim::Mesh& mesh) {
  const auto around = [&](const GarmentPart& part) {
    const Opening* top = top_opening(part);
    if (top == nullptr) return true;
    const bool is_on_trunk = top->mean_height_m < wearer.measures.levels.back().height_m;
    const sim::Extent& range = is_on_trunk ? top->range : part.range;
    const Vec3 middle = is_on_trunk ? wearer.measures.level_at(top->mean_height_m).middle_m : *wearer.measures.neck_m;
    return range.lower.x < middle.x && middle.x < range.upper.x && range.lower.z < middle.z && middle.z < range.upper.z;
  };
  return std::ranges::all_of(find_garment_parts(mesh, sim::make_adjacency(mesh)), around);
}

/// Returns the scene with the body to sew on, the last one that is read from a file, and no other. Without such a body
/// there is none.
Scene scene_to_sew(const Scene& scene) {
  const auto of_file = [](const BodyInScene& entry) { return !entry.source.file.empty(); };
  const auto found = std::find_if(scene.bodies.rbegin(), scene.bodies.rend(), of_file);
  Scene sewn = scene;
  sewn.bodies.clear();
  sewn.surroundings = {};
  if (found == scene.bodies.rend()) return sewn;
  sewn.bodies.push_back(*found);
  auto& [body, source] = sewn.bodies[0];
  body = {.name = found->body.name, .shape = sim::BodyMesh{}};
  source.motion.clear();
  source.clip = "none";
  source.dress = usual_dressing_frames;
  return sewn;
}

/// Returns a hash of all inputs that change the sewn garment.
std::uint64_t compute_fingerprint(const Scene& scene) {
  const sim::Material& m = scene.material;
  sim::ByteWriter bytes;
  bytes.put_text(program_version());
  bytes.put_text(read_text_file(scene.garment.file));
  for (const auto& [placed, body] : scene.bodies) {
    bytes.put_text(read_text_file(body.file, max_model_bytes));
    bytes.put(body.scale.value_or(0.0));
    bytes.put(body.up ? static_cast<std::uint8_t>(*body.up) : std::uint8_t{255});
  }
  for (const double value : {m.areal_density_kg_per_m2, m.bending_rigidity_n_m, m.compression_stiffness_n_per_m,
                             m.tensile_warp_n_per_m, m.tensile_weft_n_per_m, m.shear_n_per_m, m.thickness_m, m.friction,
                             scene.simulation.solver.bounded.max_stretch}) {
    bytes.put(value);
  }
  return sim::fnv1a(sim::fnv1a_of_nothing, bytes.bytes());
}

/// Returns a folder for sewn garments that only this user can write to, so that nobody else can put a file there that
/// is taken for one.
std::filesystem::path own_folder() {
  const std::filesystem::path temporary = std::filesystem::temp_directory_path();
  const std::filesystem::path user_folder = temporary / fmt::format("taut-{}", ::getuid());
  struct stat found = {};
  const bool is_made = ::mkdir(user_folder.c_str(), S_IRWXU) == 0;
  if (is_made || (::lstat(user_folder.c_str(), &found) == 0 && S_ISDIR(found.st_mode) && found.st_uid == ::getuid() &&
                  (found.st_mode & (S_IRWXG | S_IRWXO)) == 0)) {
    return user_folder;
  }
  std::string other = (temporary / "taut-XXXXXX").string();
  if (::mkdtemp(other.data()) == nullptr) {
    throw InputError("cannot make a folder in '{}' for what is sewn: {}", temporary.string(), std::strerror(errno));
  }
  return other;
}

}  // namespace

SewnGarment sew(NamedPattern inner, const Scene& scene, LoadedBodies& bodies, const SewingSettings& settings,
                const std::function<void(const std::string&)>& stage) {
  SewnGarment garment;
  std::vector<NamedPattern> patterns = {std::move(inner)};
  patterns.insert(patterns.end(), settings.over.begin(), settings.over.end());
  const std::filesystem::path fabric = scene.fabric;
  garment.fabric = fabric.has_extension() ? std::filesystem::absolute(fabric).string() : scene.fabric;
  garment.over_fabrics = settings.over_fabrics;
  stage("meshing its panels");
  for (auto& [file, pattern] : patterns) {
    CutPieces pieces = cut(file, pattern, settings.triangles / static_cast<int>(patterns.size()), settings.is_exact);
    for (std::string& remark : bring_to_body(pattern, bodies, pieces)) {
      garment.remarks.push_back((patterns.size() > 1 ? file.stem().string() + ": " : "") + remark);
    }
    if (garment.pattern.panels.empty()) {
      garment.pattern = std::move(pattern);
      garment.pieces = std::move(pieces);
    } else {
      garment.over_names.push_back(file.stem().string());
      add_pattern(garment.over_names.back(), std::move(pattern), garment.pattern);
      add_over(pieces, garment.pieces);
    }
  }
  for (std::string& remark : place_pieces(garment.pieces, scene, bodies)) garment.remarks.push_back(std::move(remark));
  garment.time_s = thin_time_s(bodies);
  garment.sewn =
      close_seams(garment.pieces, scene, bodies, garment.time_s,
                  [&](double share, const sim::Garment& now, const std::vector<Vec3>& positions_m) {
                    stage(fmt::format("drawing its seams together, {:.0f} % are closed", std::floor(100.0 * share)));
                    keep_step(share, now, positions_m, garment);
                  });
  if (garment.sewn.gap_m > 0.0) refuse_open(std::move(garment));
  if (bodies.all.empty()) {
    rest_freely(scene, settings, stage, garment);
  } else {
    dress_sewn_garment(scene, bodies, settings, stage, garment);
  }
  require_worn(scene, bodies, garment);
  return garment;
}

void require_worn(const Scene& scene, const LoadedBodies& bodies, SewnGarment& garment) {
  const sim::Mesh& mesh = garment.sewn.garment.mesh;
  const auto refuse = [&](const std::string& why) { throw SewingFailed(why, std::move(garment)); };
  if (has_fallen(bodies, garment.pattern, mesh.positions)) {
    refuse("its seams are closed, but it does not stay on the body: it falls down");
  }
  const Wearer* const wearer = dressed_body(bodies).wearer;
  if (wearer != nullptr && garment.pattern.joint.empty() && !lies_around(*wearer, mesh)) {
    refuse("its seams are closed, but its upper end does not go around the body");
  }
  const sim::Surface cloth = {mesh.positions, mesh.triangles};
  for (const SceneCrossings& crossings : scene_crossings(cloth, bodies.all, garment.time_s)) {
    if (!crossings.pairs.empty()) refuse("when it is worn, " + describe(crossings, cloth, bodies.all));
  }
  garment.max_stretch = sim::measure_surface_stretch(garment.sewn.garment, mesh.positions).max;
  garment.bound = scene.simulation.solver.bounded.max_stretch;
  if (garment.max_stretch > garment.bound + bound_rounding) {
    refuse(
        fmt::format("its seams are closed, but worn for {} frames it is stretched by {:.3f} %; expected at "
                    "most solver.max_stretch = {:g}",
                    garment.frames, 100.0 * garment.max_stretch, garment.bound));
  }
}

std::string describe_rest(const SewnGarment& garment) {
  return garment.is_at_rest ? "at rest"
                            : fmt::format("after {} frames still moving at {:.2g} mm/s", garment.frames,
                                          1e3 * garment.rms_speed_m_per_s);
}

std::string to_obj(const SewnGarment& garment) {
  const sim::Mesh& mesh = garment.sewn.garment.mesh;
  std::vector<glm::vec2> corner_uv;
  for (const auto& corners : mesh.cut_m) {
    for (const sim::Vec2& corner : corners) corner_uv.emplace_back(corner / metres_per_uv_of_cut);
  }
  FileFaces faces = make_faces(mesh, corner_uv);
  for (std::size_t p = 0; p < garment.pattern.panels.size(); ++p) {
    faces.sections.push_back({garment.pieces.panel_triangles[p], "g " + garment.pattern.panels[p].name});
  }
  return obj_text(faces, mesh.positions, {});
}

std::string to_landmarks_text(const SewnGarment& garment) {
  std::string text =
      "# As it is cut: lengths at rest are those of the texture coordinates, which are cm.\n" +
      fmt::format("metres_per_unit = 1\nup = \"y\"\nmetres_per_uv = {}\nis_cut = true\n", metres_per_uv_of_cut);
  if (!garment.fabric.empty()) text += "fabric = " + toml_text(garment.fabric) + "\n";
  if (garment.max_stretch > sim::BoundedSettings().max_stretch) {
    text += fmt::format("# It is worn within this bound.\nmax_stretch = {:g}\n", garment.bound);
  }
  if (!garment.over_names.empty()) {
    text += fmt::format("\n# Garments that are worn over each other.\nlayers = {}\n", garment.over_names.size() + 1);
  }
  if (!garment.over_fabrics.empty()) text += "\n# Of groups whose names begin so.\n[fabrics]\n";
  for (std::size_t k = 0; k < garment.over_fabrics.size(); ++k) {
    text += toml_text(garment.over_names[k] + ".") + " = " + toml_text(garment.over_fabrics[k]) + "\n";
  }
  text += "\n# Vertices along its seams, from 0.\n[seams]\n";
  for (std::size_t s = 0; s < garment.pieces.seams.size(); ++s) {
    std::string vertices;
    for (const auto& [a, b] : garment.pieces.seams[s]) {
      vertices += (vertices.empty() ? "" : ", ") + std::to_string(garment.sewn.vertex_of[a]);
    }
    text += toml_text(garment.pattern.describe(garment.pattern.stitches[s])) + " = [" + vertices + "]\n";
  }
  return text;
}

std::vector<std::string> sew_garment(Scene& scene, const std::function<void(const std::string&)>& stage) {
  if (!is_sewing_pattern(scene.garment.file)) return {};
  Scene to_sew = scene_to_sew(scene);
  scene.garment.sewn =
      own_folder() / fmt::format("{}-{:016x}.obj", scene.garment.file.stem().string(), compute_fingerprint(to_sew));
  scene.garment.scale = 1.0;
  scene.garment.up = ModelAxis::y;
  if (std::filesystem::exists(scene.garment.sewn)) {
    return {fmt::format("its pattern was sewn before, to '{}'", scene.garment.sewn.string())};
  }
  LoadedBodies bodies = load_bodies(to_sew);
  std::vector<std::string> said = bodies.remarks;
  const SewnGarment garment = sew(
      read_named_pattern(to_sew.garment.file), to_sew, bodies, {}, stage ? stage : [](const std::string&) {});
  said.insert(said.end(), garment.remarks.begin(), garment.remarks.end());
  said.push_back(fmt::format("its pattern was sewn to '{}', {}", scene.garment.sewn.string(), describe_rest(garment)));
  // A reader that finds the OBJ file also finds the other one.
  write_text_file(landmarks_path(scene.garment.sewn), to_landmarks_text(garment));
  write_text_file(scene.garment.sewn, to_obj(garment));
  return said;
}

LoadedBodies sew_and_load_bodies(Scene& scene, std::span<const Override> overrides,
                                 const std::function<void(const std::string&)>& stage) {
  const std::vector<std::string> said = sew_garment(scene, stage);
  if (stage) stage("reading its bodies");
  LoadedBodies bodies = choose_dressing(overrides, scene);
  bodies.remarks.insert(bodies.remarks.begin(), said.begin(), said.end());
  return bodies;
}

}  // namespace taut::app
