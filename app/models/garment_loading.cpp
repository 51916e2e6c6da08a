#include "app/models/garment_loading.hpp"

#include "app/base/errors.hpp"
#include "app/base/progress.hpp"
#include "app/base/words.hpp"
#include "app/models/garment_start.hpp"
#include "app/models/hanging/hanger.hpp"
#include "app/models/mending/model_fitting.hpp"
#include "app/scene/scene_format.hpp"
#include "sim/mesh/geodesics.hpp"
#include "sim/mesh/subdivide.hpp"
#include "sim/mesh/welding.hpp"

namespace taut::app {
namespace {

// Smallest median edge, as a fraction of the garment's size. Double precision cannot measure the stretch of shorter
// edges. Usual edges have a thousandth of the size.
constexpr double min_median_edge_m = 1e-9;

// Limits on the size of a garment. Outside them double precision is not enough for positions.
constexpr double min_size_m = 1e-4;
constexpr double max_size_m = 1e4;

// One damaged coordinate can be 1e38 times as far away as all others.
void require_one_size(const sim::Mesh& mesh) {
  std::vector<double> lengths;
  lengths.reserve(mesh.triangles.size());
  for (const sim::Triangle& t : mesh.triangles) {
    lengths.push_back(glm::distance(mesh.positions[t[0]], mesh.positions[t[1]]));
  }
  const double middle = quantile(std::move(lengths), 0.5);
  const double size = glm::length(sim::compute_extent(mesh.positions).size());
  if (middle < min_median_edge_m * size) {
    throw std::invalid_argument(
        fmt::format("it reaches over {:.3g} of its units, but half of its edges are shorter than {:.3g}; "
                    "expected all vertices in one place, so one of them may be damaged",
                    size, middle));
  }
}

/// Largest number of triangles at one edge. Every two of them are compared, and solved together: 3 000 took 10 s.
/// Layers of cloth that are welded to each other have some ten.
constexpr std::size_t max_triangles_at_edge = 1000;

void require_few_at_edges(const sim::Mesh& mesh) {
  // Edges are searched only where so many triangles meet at a vertex.
  std::vector<std::size_t> counts(mesh.positions.size(), 0);
  for (const sim::Triangle& t : mesh.triangles) {
    for (const sim::Index v : t) ++counts[v];
  }
  if (*std::ranges::max_element(counts) <= max_triangles_at_edge) return;
  const sim::Adjacency adjacency = sim::make_adjacency(mesh);
  for (std::size_t e = 0; e < adjacency.edges.size(); ++e) {
    const std::size_t count = adjacency.edge_triangles[e].size();
    if (count <= max_triangles_at_edge) continue;
    const auto [a, b] = adjacency.edges[e];
    throw std::invalid_argument(fmt::format("{} triangles meet at one edge, of vertices {} and {}; expected at most {}",
                                            count, a, b, max_triangles_at_edge));
  }
}

// Only a unit that the user sets can make a garment of any size.
void require_size(const GarmentSource& source, const Placement& placement) {
  const double size_m = placement.scale * placement.extent;
  const bool has_size = std::isfinite(placement.extent) && placement.extent > 0.0;
  if (source.scale && has_size && !(size_m >= min_size_m && size_m <= max_size_m)) {
    throw InputError(
        "cannot use the garment '{}': with the unit asked for it is {:.3g} m large; expected {:g} m to {:g} "
        "m",
        source.file.string(), size_m, min_size_m, max_size_m);
  }
}

// No mesh can be made of cloth as thick as its garment.
void require_thin(double thickness_m, double size_m) {
  constexpr double thickest = 0.08;  // fraction of the garment's size
  if (thickness_m > thickest * size_m) {
    throw InputError("cloth.thickness: found {:g} m for a garment that is {:.3g} m large; expected at most {:.2g} m",
                     thickness_m, size_m, thickest * size_m);
  }
}

FileVertices vertices_of_file(const ImportedModel& model, const std::vector<sim::Index>& kept) {
  FileVertices vertices{model.position_of_vertex, !model.shares_vertices && model.position_of_vertex.empty()};
  for (sim::Index& vertex : vertices.mesh_vertex) vertex = kept[vertex];
  if (vertices.mesh_vertex.empty()) vertices.mesh_vertex = kept;
  return vertices;
}

/// Removes quads with the positions of an earlier one, such as the backs of cloth that is seen from both sides. Cut
/// along the other diagonal, their triangles differ. Returns the number of removed triangles.
std::size_t leave_out_backs(const ImportedModel& model, sim::Mesh& soup) {
  const std::vector<sim::Index> places = sim::first_at_same_position(soup.positions);
  std::vector<std::pair<std::array<sim::Index, 4>, std::size_t>> quads;  ///< ascending positions, first triangle
  std::size_t at = 0, triangle = 0;
  for (const std::uint32_t count : model.faces.corner_counts) {
    for (std::size_t k = 0; count == 4 && k < 4; ++k) {
      const sim::Index vertex = model.faces.corners[at + k];
      const sim::Index position = model.position_of_vertex.empty() ? vertex : model.position_of_vertex[vertex];
      if (k == 0) quads.push_back({{}, triangle});
      quads.back().first[k] = places[position];
    }
    at += count;
    triangle += count - 2;
  }
  for (auto& quad : quads) std::ranges::sort(quad.first);
  std::ranges::sort(quads);
  std::vector<char> is_back(soup.triangles.size(), 0);
  for (std::size_t q = 1; q < quads.size(); ++q) {
    const bool is_same = quads[q].first == quads[q - 1].first;
    is_back[quads[q].second] = is_back[quads[q].second + 1] = static_cast<char>(is_same);
  }
  std::size_t next = 0;
  return std::erase_if(soup.triangles, [&](const sim::Triangle&) { return is_back[next++] != 0; });
}

/// Turns surfaces that face inwards. Sews trims to the cloth below if the model itself is simulated.
void turn_and_sew(const GarmentSource& source, bool is_fitted, sim::Mesh& mesh, LoadedGarment& loaded) {
  const sim::Adjacency adjacency = sim::make_adjacency(mesh);
  const std::vector<GarmentPart> parts = find_garment_parts(mesh, adjacency);
  loaded.turned_outside_out = turn_outside_out(parts, adjacency, mesh);
  // A scene that sets the welding distance gets no other seams.
  loaded.trims_sewn_on = source.weld_m || is_fitted ? 0 : sew_on_trims(parts, loaded.placement->scale, mesh);
}

/// Returns the triangles with their texture coordinates, in m. Throws std::invalid_argument if there are none.
std::vector<std::array<sim::Vec2, 3>> cut_by_uv(const sim::Mesh& mesh, const SurfaceColours& colours, double metres) {
  if (colours.corner_uv.size() != 3 * mesh.triangles.size()) {
    throw std::invalid_argument("it is said to be cut (is_cut), but has no texture coordinates");
  }
  std::vector<std::array<sim::Vec2, 3>> cut_m;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto at = [&](std::size_t k) { return metres * sim::Vec2(colours.corner_uv[3 * t + k]); };
    cut_m.push_back({at(0), at(1), at(2)});
  }
  return cut_m;
}

sim::Mesh scale_mesh(sim::Mesh mesh, double factor) {
  for (sim::Vec3& position : mesh.positions) position *= factor;
  return mesh;
}

/// Subdivides a model whose edges are longer by a fifth than the edges of the mesh that was fitted to it. Otherwise its
/// folds would not be seen, and its triangles would cut through the layers within.
void subdivide_coarse(sim::Mesh& model, FittedModel& fitted, SurfaceColours& colours) {
  const bool is_garment = model.triangles.size() >= min_garment_triangles;
  while (is_garment && 10 * model.triangles.size() < 7 * fitted.mesh.triangles.size()) {
    model = sim::subdivide({std::move(model), {}}).mesh;
    colours = subdivided_colours(std::move(colours));
    std::vector<std::uint8_t> finer;
    for (const std::uint8_t is_simulated : fitted.is_simulated) finer.insert(finer.end(), 4, is_simulated);
    fitted.is_simulated = std::move(finer);
  }
}

/// Binds the model to the mesh that was fitted to it. Vertices of the file are mapped to the nearest ones of this mesh.
void let_follow(sim::Mesh model, const FittedModel& fitted, double bound, LoadedGarment& loaded) {
  FollowingModel following = follow_fitted(std::move(model), fitted, bound);
  following.file_vertices = loaded.file_vertices;
  for (sim::Index& vertex : loaded.file_vertices.mesh_vertex) {
    vertex = vertex == sim::no_vertex ? vertex : find_nearest_corner(following.bonds[vertex], fitted.mesh.triangles);
  }
  loaded.following = std::make_shared<const FollowingModel>(std::move(following));
}

bool is_hung(const Scene& scene) {
  return !scene.garment.is_grid() && !scene.garment.given && !scene.pins && scene.dressing_frames() == 0;
}

/// Finds the axis that is up by the openings of the model, or else by hanging what is simulated both ways if it will be
/// hung and is no rigid thing.
void find_up(const Scene& scene, const sim::Mesh& model_m, const sim::Mesh& simulated_m, const RigidParts& rigid,
             const StageReport& begin, PlacementHints& hints) {
  hints.up_by_openings = up_by_openings(model_m);
  if (!hints.up_by_openings && is_hung(scene) && scene.bodies.empty() && !rigid.are_all) {
    begin("hanging it both ways to see which is up");
    hints.up_by_hanging = up_by_hanging(simulated_m);
  }
}

sim::Mesh read_mesh(const Scene& scene, LoadedGarment& loaded, const StageReport& begin) {
  const GarmentSource& source = scene.garment;
  const std::string name = source.given ? "the garment that was given" : "the garment '" + source.file.string() + '\'';
  begin("reading " + source.file.filename().string());
  ImportedModel& model = loaded.model.emplace(
      source.given ? *source.given : import_garment(source.model(), {.program = source.importer}, ReadParts::model));
  loaded.files_read.assign(model.files.begin(), model.files.end());
  const std::vector<sim::Triangle> imported = model.triangles;
  sim::Mesh soup{std::move(model.positions), std::move(model.triangles), {}};
  const std::size_t backs = leave_out_backs(model, soup);
  loaded.strays = remove_strays(soup);
  const GarmentFacts facts = source.given ? GarmentFacts() : read_garment_facts(source.model());
  PlacementHints hints{source.scale, source.up, facts.metres_per_unit ? facts.metres_per_unit : model.metres_per_unit,
                       facts.up ? facts.up : model.up};
  try {
    // A given mesh and a sewn garment are cloth. A given mesh stays in its place.
    if (!source.given && !facts.is_cut) loaded.rigid = remove_rigid_parts(soup);
    loaded.placement = source.given ? Placement{} : choose_unit(soup, hints);
    require_size(source, *loaded.placement);
    begin("joining its vertices");
    const double scale = loaded.placement->scale;
    // Two walls of one cloth must not be sewn together.
    const double weld = source.weld_m.value_or(0.0) / scale;
    sim::ValidatedMesh valid = sim::weld_and_validate(soup, {weld, 0.0});
    require_one_size(valid.mesh);
    require_few_at_edges(valid.mesh);
    require_thin(scene.material.thickness_m, scale * glm::length(sim::compute_extent(valid.mesh.positions).size()));
    begin("looking whether it is fit to be simulated");
    const bool is_cut = facts.is_cut;
    std::optional<FittedModel> fitted;
    if (!is_cut) {
      FittingOutcome outcome = fit_model(source, scene.material.thickness_m, scale_mesh(valid.mesh, scale));
      fitted = std::move(outcome.fitted);
      loaded.fitting_refusal = std::move(outcome.refusal);
    }
    if (!fitted && !is_cut) {
      valid = sim::weld_and_validate(soup, {weld, source.weld_m ? 0.0 : sewn_within_m / scale});
      require_few_at_edges(valid.mesh);
    }
    loaded.repairs = valid.report;
    loaded.repairs->duplicate_triangles += backs;
    turn_and_sew(source, fitted.has_value() || is_cut, valid.mesh, loaded);
    loaded.colours = kept_colours(std::move(model.colours), imported, valid.result_vertices, valid.mesh.triangles);
    loaded.file_vertices = vertices_of_file(model, valid.result_vertices);
    if (!source.up && !hints.up) {
      const sim::Mesh model_m = scale_mesh(valid.mesh, scale);
      find_up(scene, model_m, fitted ? fitted->mesh : model_m, loaded.rigid, begin, hints);
    }
    if (!source.given) choose_up(soup, hints, *loaded.placement);
    model.positions = std::move(soup.positions);
    if (source.subdivisions == 0) {
      loaded.file_faces = std::move(model.faces);
      loaded.file_rest_m = positions_in_file(model);
      for (sim::Vec3& position : loaded.file_rest_m) position = (*loaded.placement)(position);
    }
    for (sim::Vec3& position : valid.mesh.positions) position = (*loaded.placement)(position);
    for (sim::Vec3& position : loaded.rigid.mesh.positions) position = (*loaded.placement)(position);
    loaded.metres_per_uv = facts.metres_per_uv.value_or(metres_per_uv(valid.mesh, loaded.colours.corner_uv));
    if (is_cut) valid.mesh.cut_m = cut_by_uv(valid.mesh, loaded.colours, loaded.metres_per_uv);
    if (!fitted) return std::move(valid.mesh);
    for (sim::Vec3& position : fitted->mesh.positions) {
      position = (*loaded.placement)(position / loaded.placement->scale);
    }
    if (!source.given && source.is_drawn_finer) subdivide_coarse(valid.mesh, *fitted, loaded.colours);
    let_follow(std::move(valid.mesh), *fitted, scene.simulation.solver.bounded.max_stretch, loaded);
    return std::move(fitted->mesh);
  } catch (const std::invalid_argument& error) {
    throw InputError("cannot use " + name + ": " + error.what());
  }
}

sim::Mesh make_mesh(const Scene& scene, LoadedGarment& loaded, const StageReport& begin) {
  if (!scene.garment.is_grid()) return read_mesh(scene, loaded, begin);
  sim::Mesh mesh = sim::make_grid(scene.garment.grid);
  loaded.file_vertices.mesh_vertex.resize(mesh.positions.size());
  std::iota(loaded.file_vertices.mesh_vertex.begin(), loaded.file_vertices.mesh_vertex.end(), 0U);
  return mesh;
}

void require_count(const char* key, double triangles) {
  if (triangles > static_cast<double>(max_triangles)) {
    throw InputError("{}: it would have {:.0f} triangles, more than the {} that can be simulated", key, triangles,
                     max_triangles);
  }
}

sim::PinnedMesh subdivide(sim::PinnedMesh pinned, int times) {
  require_count("garment.subdivisions", static_cast<double>(pinned.mesh.triangles.size()) * std::pow(4.0, times));
  for (int i = 0; i < times; ++i) {
    if (!pinned.mesh.quads.empty()) {
      throw InputError("garment.subdivisions is for models; give a grid more columns and rows instead");
    }
    pinned = sim::subdivide(pinned);
  }
  return pinned;
}

/// Pins all vertices within half of this width of the pins, along the cloth at rest.
void add_width(sim::PinnedMesh& pinned, double width_m) {
  if (width_m <= 0.0 || pinned.pins.empty()) return;
  const auto distances_m =
      sim::geodesic_distances(pinned.mesh, sim::make_adjacency(pinned.mesh), pinned.pins).distances_m;
  pinned.pins.clear();
  for (sim::Index v = 0; v < distances_m.size(); ++v) {
    if (distances_m[v] <= 0.5 * width_m) pinned.pins.push_back(v);
  }
}

std::vector<sim::Index> choose_pins(const Scene& scene, const sim::Mesh& mesh, LoadedGarment& loaded,
                                    const StageReport& begin) {
  const bool is_grid = scene.garment.is_grid();
  if (!is_grid && !scene.pins && !is_hung(scene)) {
    return {};  // the garment is worn, or held by the caller
  }
  if (is_hung(scene)) {
    begin("hanging it");
    const sim::Adjacency adjacency = sim::make_adjacency(mesh);
    // A garment with a body is meant to be worn, not hung on a hanger.
    loaded.hanging =
        scene.bodies.empty() && loaded.rigid.count == 0 ? hang_as_in_a_shop(mesh, adjacency) : hang(mesh, adjacency);
    loaded.hanger = loaded.hanging->hanger;
    return loaded.hanging->pins;
  }
  if (!is_grid && asks_for_hanger(scene)) {
    loaded.hanger = make_hanger(mesh);
    return {};
  }
  return select_pins(scene.pins,
                     {mesh, loaded.landmarks, loaded.file_vertices, is_grid ? &scene.garment.grid : nullptr});
}

/// Requires that no pin has two motions.
void require_one_motion(const std::vector<sim::MovingPins>& groups, const FileVertices& file_vertices) {
  std::vector<sim::Index> all;
  for (const sim::MovingPins& group : groups) {
    all.insert(all.end(), group.vertices.begin(), group.vertices.end());
  }
  std::ranges::sort(all);
  const auto twice = std::ranges::adjacent_find(all);
  if (twice != all.end()) {
    throw InputError("pins.moving: found vertex {} in two entries, expected each in one",
                     file_vertices.number_of(*twice).value_or(*twice));
  }
}

std::vector<sim::MovingPins> choose_moving_pins(const Scene& scene, const sim::Mesh& mesh,
                                                const LoadedGarment& loaded) {
  const sim::GridSettings* grid = scene.garment.is_grid() ? &scene.garment.grid : nullptr;
  std::vector<sim::MovingPins> groups;
  for (const MovingPinsInScene& entry : scene.moving_pins) {
    std::vector<sim::Index> vertices =
        select_pins(entry.at, {mesh, loaded.landmarks, loaded.file_vertices, grid, "pins.moving"});
    std::ranges::sort(vertices);
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    sim::PinnedMesh finer = subdivide({scene.garment.subdivisions > 0 ? mesh : sim::Mesh{}, std::move(vertices)},
                                      scene.garment.subdivisions);
    groups.push_back({std::move(finer.pins), entry.motion});
  }
  require_one_motion(groups, loaded.file_vertices);
  return groups;
}

/// Gives layers their own fabrics from the file beside the garment, by the start of their groups' names.
sim::Garment of_fabrics(sim::Garment garment, const Scene& scene, const LoadedGarment& loaded) {
  const std::filesystem::path& model = scene.garment.model();
  const auto fabrics = read_garment_facts(model).fabrics;
  if (fabrics.empty()) return garment;
  const std::string where = "'" + landmarks_path(model).string() + "': fabrics";
  if (loaded.file_faces.empty()) throw InputError("{}: expected a garment that is simulated as it was read", where);
  std::vector<std::uint8_t> layer_of(garment.mesh.positions.size(), 0);
  std::vector<sim::Material> other_materials;
  const FileFaces& faces = loaded.file_faces;
  for (const auto& [group, name] : fabrics) {
    other_materials.push_back(find_fabric_material(name, where));
    std::size_t corner = 0, section = 0, found = 0;
    bool is_of_group = false;
    for (std::size_t face = 0; face < faces.corner_counts.size(); ++face) {
      for (; section < faces.sections.size() && faces.sections[section].first_face <= face; ++section) {
        is_of_group = faces.sections[section].line.starts_with("g " + group);
      }
      for (std::size_t k = 0; k < faces.corner_counts[face]; ++k, ++corner) {
        const std::optional<sim::Index> v = loaded.file_vertices.find(faces.corners[corner]);
        if (!is_of_group || !v) continue;
        layer_of[*v] = static_cast<std::uint8_t>(other_materials.size());
        ++found;
      }
    }
    if (found == 0) throw InputError("{}: found no group of the garment that begins with '{}'", where, group);
  }
  try {
    return sim::with_other_materials(std::move(garment), std::move(layer_of), std::move(other_materials));
  } catch (const std::invalid_argument& error) {
    throw InputError("{}: {}; expected a fabric for all (--fabric)", where, error.what());
  }
}

}  // namespace

LoadedGarment load_garment(const Scene& scene, const StageReport& report) {
  const StageReport begin = report ? report : [](const std::string&) {};
  LoadedGarment loaded;
  const bool is_grid = scene.garment.is_grid();
  if (is_grid) {
    require_count("garment.grid", 2.0 * (scene.garment.grid.columns - 1.0) * (scene.garment.grid.rows - 1.0));
  }
  sim::Mesh mesh = make_mesh(scene, loaded, begin);
  begin("mapping it to springs");
  if (!scene.garment.file.empty()) {
    loaded.landmarks = read_landmarks(scene.garment.model(), *loaded.placement, mesh, loaded.file_vertices);
  }
  // Pins are vertices of the mesh before subdivision, so that they stay the same after it.
  std::vector<sim::Index> pins = choose_pins(scene, mesh, loaded, begin);
  loaded.moving_pins = choose_moving_pins(scene, mesh, loaded);
  sim::PinnedMesh pinned = subdivide({std::move(mesh), std::move(pins)}, scene.garment.subdivisions);
  add_width(pinned, scene.pin_width_m);
  for (int i = 0; i < scene.garment.subdivisions; ++i) {
    loaded.colours = subdivided_colours(std::move(loaded.colours));
  }
  sim::Garment garment = sim::make_garment(std::move(pinned.mesh), scene.mapping, scene.material);
  if (!loaded.colours.corner_uv.empty()) {
    garment.warps = loaded.following ? warps_below(garment.mesh, loaded.following->mesh, loaded.colours.corner_uv)
                                     : sim::warps_from_coordinates(garment.mesh, loaded.colours.corner_uv);
  }
  loaded.garment = sim::share(of_fabrics(std::move(garment), scene, loaded));
  if (const std::optional<std::string> reason = missing_contact_reason(scene, *loaded.garment)) {
    throw InputError(*reason);
  }
  loaded.pins = std::move(pinned.pins);
  for (const sim::MovingPins& group : loaded.moving_pins) {
    loaded.pins.insert(loaded.pins.end(), group.vertices.begin(), group.vertices.end());
  }
  if (scene.garment.has_start()) loaded.start_m = read_start(scene.garment, loaded);
  if (scene.garment.untangle || can_be_untangled(loaded)) untangle(scene, loaded, begin);
  return loaded;
}

sim::Surface surface_at_start(const GarmentInScene& loaded) {
  const sim::Mesh& mesh = loaded.garment->mesh;
  return {loaded.start_m ? *loaded.start_m : mesh.positions, mesh.triangles};
}

sim::Surroundings settle_surroundings(sim::Surroundings surroundings, const GarmentInScene& loaded,
                                      std::vector<sim::Body> bodies) {
  for (sim::PointForce& force : surroundings.forces.artificial_forces) {
    const std::optional<sim::Index> vertex = loaded.file_vertices.find(force.vertex);
    if (!vertex) throw InputError("forces.vertex: " + loaded.file_vertices.why_missing(force.vertex));
    force.vertex = *vertex;
  }
  surroundings.moving_pins = loaded.moving_pins;
  surroundings.bodies = std::move(bodies);
  return surroundings;
}

sim::Simulation make_simulation(const Scene& scene, const GarmentInScene& loaded, std::vector<sim::Body> bodies) {
  return {loaded.garment, loaded.pins, simulation_settings(scene.simulation),
          settle_surroundings(scene.surroundings, loaded, std::move(bodies)), loaded.start_m};
}

sim::Simulation make_simulation(const Scene& scene, const GarmentInScene& loaded) {
  return make_simulation(scene, loaded, named_bodies(scene));
}

}  // namespace taut::app
