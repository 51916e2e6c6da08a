#include "app/models/inspection.hpp"

#include "app/base/words.hpp"
#include "app/models/hanger.hpp"
#include "app/models/model_fitting.hpp"
#include "app/verify/crossing_pairs.hpp"
#include "sim/mesh/topology.hpp"

namespace taut::app {
namespace {

constexpr double degrees_per_radian = 180.0 / std::numbers::pi;

double angle_at(const sim::Vec3& corner, const sim::Vec3& a, const sim::Vec3& b) {
  const sim::Vec3 u = a - corner, v = b - corner;
  return std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
}

double smallest_angle(const sim::Mesh& mesh) {
  double smallest = std::numbers::pi;
  for (const sim::Triangle& t : mesh.triangles) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      smallest = std::min(smallest, angle_at(mesh.positions[t[corner]], mesh.positions[t[(corner + 1) % 3]],
                                             mesh.positions[t[(corner + 2) % 3]]));
    }
  }
  return smallest;
}

void measure_size(const sim::Mesh& mesh, Inspection& result) {
  const sim::Extent extent = sim::extent_of(mesh.positions);
  result.lower_m = extent.lower;
  result.upper_m = extent.upper;
  result.area_m2 = sim::surface_area(mesh);
  result.smallest_angle_rad = smallest_angle(mesh);
}

void measure_edges(const sim::Garment& garment, Inspection& result) {
  result.shortest_edge_m = std::numeric_limits<double>::infinity();
  double sum_m = 0.0;
  for (const sim::Edge& edge : garment.adjacency.edges) {
    const double length_m = glm::distance(garment.mesh.positions[edge[0]], garment.mesh.positions[edge[1]]);
    result.shortest_edge_m = std::min(result.shortest_edge_m, length_m);
    result.longest_edge_m = std::max(result.longest_edge_m, length_m);
    sum_m += length_m;
  }
  result.mean_edge_m = sum_m / static_cast<double>(garment.adjacency.edges.size());
}

void measure_surface(const LoadedGarment& loaded, Inspection& result) {
  const sim::Garment& garment = *loaded.garment;
  result.without_surface = static_cast<std::size_t>(
      std::ranges::count_if(garment.triangles_at_rest, [](const sim::TriangleAtRest& t) { return !t.has_surface(); }));
  if (loaded.start_m) {
    result.start = StretchAtStart{sim::measure_stretch(garment.springs, *loaded.start_m),
                                  sim::measure_surface_stretch(garment, *loaded.start_m)};
  }
}

void count_springs(const sim::Springs& springs, Inspection& result) {
  result.structural_springs = springs.count(sim::SpringKind::structural);
  result.shear_springs = springs.count(sim::SpringKind::shear);
  result.flexural_springs = springs.count(sim::SpringKind::flexural);
}

void say_hanging(const LoadedGarment& loaded, Inspection& result) {
  if (loaded.hanging) {
    result.parts = loaded.hanging->parts;
    result.hanging = describe(*loaded.hanging);
  }
  if (!loaded.hanger.empty()) result.hanging.push_back(describe(loaded.hanger));
}

void find_crossings(const LoadedGarment& loaded, Inspection& result) {
  result.untangling = loaded.untangling;
  const Surface start = surface_at_start(loaded);
  result.crossings = crossing_pairs(start);
  result.crossings_text = result.crossings.empty() ? "none" : describe(start, result.crossings);
}

std::string describe_texture(const LoadedGarment& loaded) {
  const SurfaceColours& colours = loaded.colours;
  if (colours.corner_uv.empty()) return "no coordinates";
  return fmt::format("a unit of its coordinates is {:.3g} m of cloth; {}, {}", loaded.metres_per_uv,
                     counted(colours.materials.size(), "material"), counted(colours.maps.size(), "image"));
}

void remark(Inspection& result) {
  const double size_m = glm::length(result.upper_m - result.lower_m);
  if (size_m > 10.0 || size_m < 0.05) {
    result.remarks.push_back(fmt::format(
        "it measures {:.3g} m across, which is no garment's size: --units mm reads it as millimetres", size_m));
  }
  if (result.topology.non_manifold_edges + result.topology.non_manifold_vertices > 0) {
    result.remarks.emplace_back("more than two triangles meet in places; it can be simulated all the same");
  }
  if (result.topology.misoriented_edges > 0) {
    result.remarks.emplace_back("neighbouring triangles disagree about which side is outside");
  }
  if (result.smallest_angle_rad * degrees_per_radian < 2.0) {
    result.remarks.emplace_back("some triangles are needles, which make cloth stiff there");
  }
  if (result.without_surface > 0) {
    result.remarks.push_back(fmt::format("{} too thin to have a surface, of which only the edges are held and measured",
                                         counted(result.without_surface, "triangle is", "triangles are")));
  }
}

std::string describe_size(const Inspection& i) {
  const sim::Vec3 size = i.upper_m - i.lower_m;
  return fmt::format(
      "size        {:.4g} x {:.4g} x {:.4g} m, from [{:.4g}, {:.4g}, {:.4g}] to [{:.4g}, {:.4g}, {:.4g}]\n"
      "area        {:.4g} m2\n"
      "edges       {:.3g} to {:.3g} mm, mean {:.3g} mm\n"
      "angles      {:.3g} degrees and more\n",
      size.x, size.y, size.z, i.lower_m.x, i.lower_m.y, i.lower_m.z, i.upper_m.x, i.upper_m.y, i.upper_m.z, i.area_m2,
      1e3 * i.shortest_edge_m, 1e3 * i.longest_edge_m, 1e3 * i.mean_edge_m, i.smallest_angle_rad * degrees_per_radian);
}

std::string vertices(std::size_t count) { return counted(count, "vertex", "vertices"); }

std::string triangles(std::size_t count) { return counted(count, "triangle"); }

std::string describe_reading(const Inspection& i) {
  std::string text = fmt::format("read        {}, {}: {}, {}, {}", i.model.format,
                                 counted(i.model.meshes, "mesh", "meshes"), triangles(i.model.file_triangles),
                                 counted(i.model.file_quads, "quad"), counted(i.model.file_polygons, "polygon"));
  text += fmt::format("; ignored {}, {}\n", counted(i.model.ignored_lines, "line"),
                      counted(i.model.ignored_points, "point"));
  text +=
      fmt::format("repaired    {} of {} welded, {} unused; {} degenerate and {} repeated of {} removed\n",
                  i.repairs.welded_vertices, vertices(i.repairs.input_vertices), i.repairs.unused_vertices,
                  i.repairs.degenerate_triangles, i.repairs.duplicate_triangles, triangles(i.repairs.input_triangles));
  return text +
         fmt::format("            {} turned, {} welded to near ones, {} sewn, {} of touching layers kept apart\n",
                     triangles(i.repairs.turned_triangles), vertices(i.repairs.near_vertices), i.repairs.sewn_vertices,
                     i.repairs.parted_vertices);
}

std::string describe_start(const StretchAtStart& start) {
  return fmt::format(
      "start       springs stretched by up to {:.4f} %, 99 of 100 by {:.4f} %\n"
      "            surface stretched by up to {:.4f} %, 99 of 100 triangles by {:.4f} %\n",
      100.0 * start.springs.max, 100.0 * start.springs.p99, 100.0 * start.surface.max, 100.0 * start.surface.p99);
}

std::string describe_topology(const sim::Topology& t) {
  const std::string border =
      t.boundary_loops == 0 ? "no boundary"
                            : fmt::format("{} ({}{})", counted(t.boundary_loops, "boundary loop"),
                                          counted(t.boundary_edges, "edge"), t.boundary_loops > 1 ? " in all" : "");
  const std::string text = fmt::format("topology    {}, {}, Euler characteristic {}\n",
                                       counted(t.components, "component"), border, t.euler_characteristic);
  return text + fmt::format("            {}, {}, {}\n", counted(t.non_manifold_edges, "non-manifold edge"),
                            counted(t.non_manifold_vertices, "non-manifold vertex", "non-manifold vertices"),
                            counted(t.misoriented_edges, "misoriented edge"));
}

void append_repairs(const sim::MeshReport& repairs, std::vector<std::string>& lines) {
  const auto say = [&](std::size_t count, const char* one, const char* many) {
    if (count > 0) lines.push_back(counted(count, one, many));
  };
  say(repairs.degenerate_triangles, "triangle without area removed", "triangles without area removed");
  say(repairs.duplicate_triangles, "repeated triangle removed", "repeated triangles removed");
  say(repairs.turned_triangles, "triangle turned to the side of its neighbours",
      "triangles turned to the side of their neighbours");
  say(repairs.parted_vertices, "vertex of layers that touch kept apart", "vertices of layers that touch kept apart");
  if (repairs.sewn_vertices > 0) {
    lines.push_back(fmt::format("parts sewn together at {} where their borders lie within {:g} mm (garment.weld)",
                                counted(repairs.sewn_vertices, "vertex", "vertices"), 1e3 * sewn_within_m));
  }
  say(repairs.near_vertices, "vertex welded to a near one", "vertices welded to near ones");
}

bool has_numbers(const std::optional<std::vector<PinSelector>>& pins) {
  const auto is_number = [](const PinSelector& pin) { return std::holds_alternative<sim::Index>(pin); };
  return pins && std::any_of(pins->begin(), pins->end(), is_number);
}

/// How deep a point is in the body, in m, or that it is in it if that is a mesh. Empty: it is outside.
std::optional<std::string> depth_in(const sim::Body& body, double time_s, const sim::Vec3& place_m) {
  if (const auto* mesh = std::get_if<sim::BodyMesh>(&body.shape)) {
    const bool is_in = winding_number(place_m, {mesh_positions_m(body, time_s), mesh->data->triangles}) > 0.5;
    return is_in ? std::optional<std::string>("in it") : std::nullopt;
  }
  const double depth_m = -sim::nearest_surface(sim::shape_at(body, time_s), place_m).distance_m;
  return depth_m > most_depth_m ? std::optional(fmt::format("{:.3g} mm deep", 1e3 * depth_m)) : std::nullopt;
}

/// Of pins within a body; empty: none are.
std::string remark_on_pins(std::span<const sim::Body> bodies, std::size_t body, double time_s, const Surface& start,
                           std::span<const sim::Index> pins) {
  std::string first;
  std::size_t count = 0;
  for (const sim::Index pin : pins) {
    const sim::Vec3& place_m = start.positions_m[pin];
    const std::optional<std::string> depth = depth_in(bodies[body], time_s, place_m);
    if (depth && ++count == 1) {
      first = fmt::format("vertex {}, {} at {}", pin, *depth, describe_place(place_m));
    }
  }
  return count == 0 ? ""
                    : fmt::format("{} within {}, the first: {}; a body does not push pins out",
                                  counted(count, "pinned vertex begins", "pinned vertices begin"),
                                  describe_body(bodies, body), first);
}

/// The first vertices of parts of the cloth that begin wholly within a body that is a mesh, where it crosses
/// nothing.
std::vector<sim::Index> parts_within(const sim::Body& body, double time_s, const Surface& start) {
  std::vector<sim::Index> within;
  if (std::holds_alternative<sim::BodyMesh>(body.shape)) {
    within = sim::first_vertices_of_parts(start.positions_m.size(), start.triangles);
    std::erase_if(within, [&](sim::Index v) { return !depth_in(body, time_s, start.positions_m[v]); });
  }
  return within;
}

/// Returns a remark on a body whose mesh crosses itself; empty: it does not.
std::string remark_on_shape(std::span<const sim::Body> bodies, std::size_t body, double time_s) {
  const auto* mesh = std::get_if<sim::BodyMesh>(&bodies[body].shape);
  if (mesh == nullptr) return "";
  const std::vector<sim::Vec3> positions_m = mesh_positions_m(bodies[body], std::max(time_s, 0.0));
  const Surface surface = {positions_m, mesh->data->triangles};
  const std::vector<CrossingPair> pairs = crossing_pairs(surface);
  return pairs.empty() ? "" : describe_body(bodies, body) + " crosses itself: " + describe(surface, pairs);
}

}  // namespace

Inspection inspect_garment(const Scene& scene, const LoadedGarment& loaded) {
  if (loaded.following) {
    Inspection modelled = inspect_garment(scene, as_modelled(loaded, scene.mapping));
    modelled.simulated = describe(*loaded.following, loaded.garment->mesh);
    modelled.fitted_triangles = loaded.garment->mesh.triangles.size();
    count_springs(loaded.garment->springs, modelled);
    say_hanging(loaded, modelled);
    return modelled;
  }
  const sim::Garment& garment = *loaded.garment;
  Inspection result;
  result.file = scene.garment.file.string();
  result.model = *loaded.model;
  result.model.positions.clear();
  result.model.triangles.clear();
  result.model.colours = {};
  result.repairs = *loaded.repairs;
  result.placement = *loaded.placement;
  say_hanging(loaded, result);
  result.vertex_numbers = loaded.file_vertices.describe();
  result.vertices = garment.mesh.positions.size();
  result.triangles = garment.mesh.triangles.size();
  measure_size(garment.mesh, result);
  measure_edges(garment, result);
  measure_surface(loaded, result);
  find_crossings(loaded, result);
  result.texture = describe_texture(loaded);
  result.remarks = loaded.colours.remarks;
  result.topology = sim::measure_topology(garment.mesh, garment.adjacency);
  count_springs(garment.springs, result);
  for (const auto& [name, vertices] : loaded.landmarks) result.landmarks.push_back({name, vertices.size()});
  remark(result);
  return result;
}

std::string describe(const Inspection& i) {
  std::string text = i.file + '\n' + describe_reading(i);
  text += fmt::format("unit        {}\nup          {}\n", i.placement.unit_text, i.placement.up_text);
  text += fmt::format("mesh        {}, {}\n", vertices(i.vertices), triangles(i.triangles)) + describe_size(i);
  text += describe_topology(i.topology);
  text += i.simulated.empty() ? "" : "simulated   " + i.simulated + '\n';
  text += fmt::format("springs     {} structural, {} shear, {} flexural\n", i.structural_springs, i.shear_springs,
                      i.flexural_springs);
  text += fmt::format("texture     {}\n", i.texture);
  text += fmt::format("crossings   {}\n", i.crossings_text);
  text += i.untangling ? "untangled   " + describe(*i.untangling) + '\n' : "";
  text += i.start ? describe_start(*i.start) : "";
  text += fmt::format("numbers     in pins.at count the {}\n", i.vertex_numbers);
  for (const std::string& line : i.hanging) text += "hung        " + line + '\n';
  for (const LandmarkSize& landmark : i.landmarks) {
    text += fmt::format("landmark    {}: {}\n", landmark.name, vertices(landmark.vertices));
  }
  for (const std::string& line : i.remarks) text += "remark      " + line + '\n';
  return text;
}

std::vector<std::string> remarks_of(const LoadedGarment& loaded) {
  std::vector<std::string> lines;
  if (loaded.placement && loaded.placement->guessed) {
    lines.push_back("its unit is the " + loaded.placement->unit_text + " (--units)");
    lines.push_back("up is " + loaded.placement->up_text + " (--up)");
  }
  if (loaded.placement && loaded.placement->is_vast) {
    lines.push_back(fmt::format("it is {:.3g} m large, which no garment is, with the unit {} (--units)",
                                loaded.placement->scale * loaded.placement->extent, loaded.placement->unit_text));
  }
  if (loaded.strays.triangles > 0) lines.push_back(describe(loaded.strays, loaded.placement->scale));
  if (loaded.strays.body_triangles > 0) {
    lines.push_back(counted(loaded.strays.body_triangles, "triangle") +
                    " of a body in its file left out; --body FILE has it worn");
  }
  if (loaded.placement && loaded.placement->moved_m != sim::Vec3(0.0)) {
    lines.emplace_back("it is very far from the origin and was moved there");
  }
  if (loaded.repairs) append_repairs(*loaded.repairs, lines);
  if (loaded.following) lines.push_back(describe(*loaded.following, loaded.garment->mesh));
  if (loaded.refused_crossings > 0) {
    lines.push_back(
        fmt::format("the model itself is simulated: a mesh fitted to it would cross itself in {} places (garment.mesh)",
                    loaded.refused_crossings));
  }
  if (loaded.trims_sewn_on > 0) {
    lines.push_back(counted(loaded.trims_sewn_on, "small part") + " sewn to the cloth below (garment.weld)");
  }
  if (loaded.turned_outside_out > 0) {
    lines.push_back(counted(loaded.turned_outside_out, "triangle") + " of surfaces that faced inwards turned");
  }
  if (!loaded.hanger.empty()) lines.push_back(describe(loaded.hanger));
  if (loaded.hanging) {
    const std::vector<std::string> parts = describe(*loaded.hanging);
    lines.insert(lines.end(), parts.begin(), parts.end());
  }
  return lines;
}

StartRemarks remarks_on_body(std::span<const sim::Body> bodies, std::size_t body, double time_s, const Surface& cloth,
                             std::span<const sim::Index> pins) {
  StartRemarks remarks;
  const SceneCrossings crossings = crossings_with(bodies, body, time_s, cloth);
  remarks.crossings = crossings.pairs.size();
  if (!crossings.pairs.empty()) {
    remarks.lines.push_back("at the start " + describe(crossings, cloth, bodies));
  } else if (const std::vector<sim::Index> within = parts_within(bodies[body], time_s, cloth); !within.empty()) {
    remarks.crossings = within.size();
    remarks.lines.push_back(
        fmt::format("at the start {} wholly within {}, the first: that of vertex {} at {}; nothing lets it out",
                    counted(within.size(), "part of the cloth is", "parts of the cloth are"),
                    describe_body(bodies, body), within.front(), describe_place(cloth.positions_m[within.front()])));
  }
  remarks.lines.push_back(remark_on_pins(bodies, body, time_s, cloth, pins));
  remarks.lines.push_back(remark_on_shape(bodies, body, time_s));
  std::erase(remarks.lines, "");
  return remarks;
}

StartRemarks remarks_on_start(const Scene& scene, const GarmentInScene& loaded) {
  const Surface start = surface_at_start(loaded);
  const std::vector<sim::Body>& bodies = scene.surroundings.bodies;
  StartRemarks all;
  if (loaded.untangling) all.lines.push_back(describe(*loaded.untangling));
  const std::vector<CrossingPair> own = crossing_pairs(start);
  all.crossings = own.size();
  if (!own.empty()) {
    all.lines.push_back("at the start " + describe(start, own) +
                        (loaded.untangling ? "" : "; --untangle parts what it can"));
  }
  const double begin_s = -scene.dressing_frames() / scene.simulation.frame_rate_hz;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const StartRemarks of_body = remarks_on_body(bodies, b, begin_s, start, loaded.pins);
    all.lines.insert(all.lines.end(), of_body.lines.begin(), of_body.lines.end());
    all.crossings += of_body.crossings;
  }
  return all;
}

void print_remarks(const Scene& scene, const LoadedGarment& loaded, std::FILE* output) {
  const std::string file = loaded.model ? scene.garment.file.filename().string() : scene.name;
  std::vector<std::string> lines = remarks_of(loaded);
  if (loaded.file_vertices.are_corners && has_numbers(scene.pins)) {
    lines.push_back("pins.at counts " + loaded.file_vertices.describe());
  }
  const std::vector<std::string> on_start = remarks_on_start(scene, loaded).lines;
  lines.insert(lines.end(), on_start.begin(), on_start.end());
  for (const std::string& line : lines) fmt::print(output, "{}: {}\n", file, line);
}

}  // namespace taut::app
