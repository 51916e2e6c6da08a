#include "app/models/inspecting/inspection.hpp"

#include "app/base/words.hpp"
#include "app/models/hanging/hanger.hpp"
#include "app/models/mending/model_fitting.hpp"
#include "sim/contact/crossing_pairs.hpp"

namespace taut::app {
namespace {

double min_angle(const sim::Mesh& mesh) {
  double sine = 1.0;
  for (const sim::Triangle& t : mesh.triangles) sine = std::min(sine, sine_of_smallest_angle(mesh, t));
  return std::asin(sine);
}

Json point_json(const sim::Vec3& p) { return {p.x, p.y, p.z}; }

Json edges_json(const sim::Garment& garment) {
  double min_length_m = std::numeric_limits<double>::infinity(), max_length_m = 0.0, sum_m = 0.0;
  for (const sim::Edge& edge : garment.adjacency.edges) {
    const double length_m = glm::distance(garment.mesh.positions[edge[0]], garment.mesh.positions[edge[1]]);
    min_length_m = std::min(min_length_m, length_m);
    max_length_m = std::max(max_length_m, length_m);
    sum_m += length_m;
  }
  const auto count = static_cast<double>(garment.adjacency.edges.size());
  return {{"min", min_length_m}, {"mean", sum_m / count}, {"max", max_length_m}};
}

Json start_json(const LoadedGarment& loaded) {
  if (!loaded.start_m) return {};
  const sim::Stretch springs = sim::measure_stretch(loaded.garment->springs, *loaded.start_m);
  const sim::SurfaceStretch surface = sim::measure_surface_stretch(*loaded.garment, *loaded.start_m);
  return {{"max_stretch", springs.max},
          {"p99_stretch", springs.p99},
          {"max_surface_stretch", surface.max},
          {"p99_surface_stretch", surface.p99}};
}

Json crossings_json(const sim::Surface& start, const std::vector<sim::CrossingPair>& pairs) {
  Json json = {{"pairs", pairs.size()}};
  if (!pairs.empty()) {
    json["first"] = {{"triangles", {pairs[0].first, pairs[0].second}}, {"place_m", point_json(pairs[0].place_m)}};
  }
  json["said"] = pairs.empty() ? "none" : describe(start, pairs);
  return json;
}

Json untangling_json(const std::optional<UntangleReport>& untangling) {
  return untangling ? Json{{"pairs_before", untangling->pairs_before},
                           {"pairs_left", untangling->pairs_left},
                           {"largest_move_m", untangling->max_move_m},
                           {"said", describe(*untangling)}}
                    : Json();
}

/// Adds the parts of the garment and how they are pinned.
void add_hanging(const LoadedGarment& loaded, Json& facts) {
  constexpr std::array ways = {"top opening",  "highest points", "back edge", "neck",
                               "two openings", "shoulders",      "hanger"};
  facts["parts"] = facts["hanging"] = Json::array();
  for (const HungPart& part : loaded.hanging ? loaded.hanging->parts : std::vector<HungPart>()) {
    facts["parts"].push_back({{"vertices", part.vertices},
                              {"hung_by", ways[static_cast<std::size_t>(part.by)]},
                              {"pins", part.pins},
                              {"closed", part.closed},
                              {"flat", part.flat}});
  }
  if (loaded.hanging) facts["hanging"] = describe(*loaded.hanging);
  if (!loaded.hanger.empty()) facts["hanging"].push_back(describe(loaded.hanger));
}

Json import_json(const ImportedModel& model) {
  return {{"format", model.format},
          {"meshes", model.meshes},
          {"triangles", model.file_triangles},
          {"quads", model.file_quads},
          {"polygons", model.file_polygons},
          {"ignored_lines", model.ignored_lines},
          {"ignored_points", model.ignored_points}};
}

Json repairs_json(const sim::MeshReport& repairs) {
  return {{"input_vertices", repairs.input_vertices},
          {"input_triangles", repairs.input_triangles},
          {"welded_vertices", repairs.welded_vertices},
          {"unused_vertices", repairs.unused_vertices},
          {"degenerate_triangles", repairs.degenerate_triangles},
          {"duplicate_triangles", repairs.duplicate_triangles},
          {"turned_triangles", repairs.turned_triangles},
          {"near_vertices", repairs.near_vertices},
          {"sewn_vertices", repairs.sewn_vertices},
          {"parted_vertices", repairs.unwelded_vertices}};
}

Json placement_json(const Placement& placement) {
  return {{"metres_per_unit", placement.scale},
          {"unit", placement.unit_text},
          {"up", axis_names[static_cast<std::size_t>(placement.up)]},
          {"up_from", placement.up_text},
          {"guessed", placement.guessed},
          {"moved_m", point_json(placement.moved_m)}};
}

Json topology_json(const sim::Topology& topology) {
  return {{"components", topology.components},
          {"boundary_edges", topology.boundary_edges},
          {"boundary_loops", topology.boundary_loops},
          {"non_manifold_edges", topology.non_manifold_edges},
          {"non_manifold_vertices", topology.non_manifold_vertices},
          {"misoriented_edges", topology.misoriented_edges},
          {"euler_characteristic", topology.euler_characteristic}};
}

std::string describe_texture(const LoadedGarment& loaded) {
  const SurfaceColours& colours = loaded.colours;
  if (colours.corner_uv.empty()) return "no coordinates";
  return fmt::format("a unit of its coordinates is {:.3g} m of cloth; {}, {}", loaded.metres_per_uv,
                     count_text(colours.materials.size(), "material"), count_text(colours.maps.size(), "image"));
}

void remark(const sim::Extent& extent, Json& facts) {
  Json& remarks = facts["remarks"];
  const Json& topology = facts["topology"];
  const double size_m = glm::length(extent.size());
  if (size_m > 10.0 || size_m < 0.05) {
    remarks.push_back(fmt::format(
        "it measures {:.3g} m across, which is no garment's size: --units mm reads it as millimetres", size_m));
  }
  if (topology["non_manifold_edges"] != 0 || topology["non_manifold_vertices"] != 0) {
    remarks.push_back("more than two triangles meet in places; it can be simulated all the same");
  }
  if (topology["misoriented_edges"] != 0) {
    remarks.push_back("neighbouring triangles disagree about which side is outside");
  }
  if (facts["smallest_angle_degrees"] < 2.0) {
    remarks.push_back("some triangles are needles, which make cloth stiff there");
  }
  if (const std::size_t thin = facts["triangles_without_surface"]; thin > 0) {
    remarks.push_back(count_text(thin, "triangle is", "triangles are") +
                      " too thin to have a surface, of which only the edges are held and measured");
  }
}

std::string fact_text(const Json& value) {
  if (value.is_null()) return "";
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_float()) return fmt::format("{:.6g}", value.get<double>());
  if (!value.is_structured()) return value.dump();
  std::vector<std::string> parts;
  for (const auto& [key, item] : value.items()) {
    const std::string text = fact_text(item);
    if (!text.empty()) parts.push_back(value.is_object() ? key + ' ' + text : text);
  }
  return value.is_array() && !parts.empty() ? '[' + join(parts) + ']' : join(parts);
}

}  // namespace

Json springs_json(const sim::Springs& springs) {
  Json counts;
  for (const sim::SpringKind kind : sim::all_spring_kinds) counts[sim::to_name(kind)] = springs.count(kind);
  return counts;
}

Inspection inspect_garment(const Scene& scene, const LoadedGarment& loaded) {
  if (loaded.following) {
    Inspection modelled = inspect_garment(scene, as_modelled(loaded, scene.mapping));
    const sim::Garment& fitted = *loaded.garment;
    modelled.facts["fitted"] = {{"triangles", fitted.mesh.triangles.size()}, {"said", loaded.following->description}};
    modelled.facts["springs"] = springs_json(fitted.springs);
    add_hanging(loaded, modelled.facts);
    return modelled;
  }
  const sim::Garment& garment = *loaded.garment;
  const sim::Extent extent = sim::compute_extent(garment.mesh.positions);
  const sim::Surface start = surface_at_start(loaded);
  Inspection result = {{}, sim::find_crossing_pairs(start)};
  Json& facts = result.facts;
  facts = {{"file", scene.garment.file.string()},
           {"import", import_json(*loaded.model)},
           {"repairs", repairs_json(*loaded.repairs)},
           {"placement", placement_json(*loaded.placement)}};
  add_hanging(loaded, facts);
  facts["vertices"] = garment.mesh.positions.size();
  facts["triangles"] = garment.mesh.triangles.size();
  facts["bounding_box_m"] = {point_json(extent.lower), point_json(extent.upper)};
  facts["area_m2"] = sim::surface_area(garment.mesh);
  facts["edge_length_m"] = edges_json(garment);
  facts["smallest_angle_degrees"] = min_angle(garment.mesh) * 180.0 / std::numbers::pi;
  facts["triangles_without_surface"] =
      std::ranges::count_if(garment.triangles_at_rest, [](const sim::TriangleAtRest& t) { return !t.has_surface(); });
  facts["texture"] = describe_texture(loaded);
  facts["start"] = start_json(loaded);
  facts["crossings"] = crossings_json(start, result.crossings);
  facts["untangling"] = untangling_json(loaded.untangling);
  facts["topology"] = topology_json(sim::measure_topology(garment.mesh, garment.adjacency));
  facts["fitted"] = Json();
  facts["springs"] = springs_json(garment.springs);
  facts["landmarks"] = Json::object();
  for (const auto& [name, vertices] : loaded.landmarks) facts["landmarks"][name] = vertices.size();
  facts["vertex_numbers"] = loaded.file_vertices.describe();
  facts["remarks"] = loaded.colours.remarks;
  if (loaded.model && !loaded.model->is_importer_confined) facts["remarks"].push_back(importer_remark);
  if (loaded.rigid.count > 0) facts["remarks"].push_back(describe(loaded.rigid));
  remark(extent, facts);
  return result;
}

std::string describe(const Json& facts) {
  std::string text;
  for (const auto& [key, value] : facts.items()) {
    const bool is_list = key == "remarks" || key == "hanging" || key == "girths";
    for (const Json& item : is_list ? value : Json::array({value})) {
      const std::string said = fact_text(item);
      if (!said.empty()) text += fmt::format("{:<26}{}\n", key, printable(said));
    }
  }
  return text;
}

}  // namespace taut::app
