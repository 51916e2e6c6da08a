#include "app/models/inspection.hpp"

#include "app/base/words.hpp"
#include "app/models/hanger.hpp"
#include "app/models/model_fitting.hpp"

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

}  // namespace taut::app
