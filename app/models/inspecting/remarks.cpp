#include "app/models/inspecting/remarks.hpp"

#include "app/base/words.hpp"
#include "app/models/hanging/hanger.hpp"
#include "app/models/mending/model_fitting.hpp"
#include "sim/contact/crossing_pairs.hpp"
#include "sim/mesh/topology.hpp"

namespace taut::app {
namespace {

void append_repairs(const sim::MeshReport& repairs, std::vector<std::string>& lines) {
  const auto say = [&](std::size_t count, const char* one, const char* many) {
    if (count > 0) lines.push_back(count_text(count, one, many));
  };
  say(repairs.degenerate_triangles, "triangle without area removed", "triangles without area removed");
  say(repairs.duplicate_triangles, "repeated triangle removed", "repeated triangles removed");
  say(repairs.turned_triangles, "triangle turned to the side of its neighbours",
      "triangles turned to the side of their neighbours");
  say(repairs.unwelded_vertices, "vertex of layers that touch kept apart", "vertices of layers that touch kept apart");
  if (repairs.sewn_vertices > 0) {
    lines.push_back(fmt::format("parts sewn together at {} where their borders lie within {:g} mm (garment.weld)",
                                count_text(repairs.sewn_vertices, "vertex", "vertices"), 1e3 * sewn_within_m));
  }
  say(repairs.near_vertices, "vertex welded to a near one", "vertices welded to near ones");
}

bool has_numbers(const std::optional<std::vector<PinSelector>>& pins) {
  const auto is_number = [](const PinSelector& pin) { return std::holds_alternative<sim::Index>(pin); };
  return pins && std::any_of(pins->begin(), pins->end(), is_number);
}

/// Returns a text on the depth of a point in the body, or that it is in it if the body is a mesh. Empty if it is
/// outside.
std::optional<std::string> depth_in(const sim::Body& body, double time_s, const sim::Vec3& place_m) {
  if (const auto* mesh = std::get_if<sim::BodyMesh>(&body.shape)) {
    const bool is_in = sim::winding_number(place_m, {mesh_positions_m(body, time_s), mesh->data->triangles}) > 0.5;
    return is_in ? std::optional<std::string>("in it") : std::nullopt;
  }
  constexpr double max_depth_m = 5e-10;  // beyond rounding
  const double depth_m = -sim::nearest_surface(sim::shape_at(body, time_s), place_m).distance_m;
  return depth_m > max_depth_m ? std::optional(fmt::format("{:.3g} mm deep", 1e3 * depth_m)) : std::nullopt;
}

/// Returns a remark on pins within a body; empty if there are none.
std::string remark_on_pins(std::span<const sim::Body> bodies, std::size_t body, double time_s,
                           const sim::Surface& start, std::span<const sim::Index> pins) {
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
                                  count_text(count, "pinned vertex begins", "pinned vertices begin"),
                                  describe_body(bodies, body), first);
}

/// Returns the first vertices of parts of the cloth that begin wholly within a body's mesh and cross nothing.
std::vector<sim::Index> parts_within(const sim::Body& body, double time_s, const sim::Surface& start) {
  std::vector<sim::Index> within;
  if (std::holds_alternative<sim::BodyMesh>(body.shape)) {
    within = sim::first_vertices_of_parts(start.positions_m.size(), start.triangles);
    std::erase_if(within, [&](sim::Index v) { return !depth_in(body, time_s, start.positions_m[v]); });
  }
  return within;
}

/// Returns a remark on a body whose mesh crosses itself; empty if it does not.
std::string remark_on_shape(std::span<const sim::Body> bodies, std::size_t body, double time_s) {
  const auto* mesh = std::get_if<sim::BodyMesh>(&bodies[body].shape);
  if (mesh == nullptr) return "";
  const std::vector<sim::Vec3> positions_m = mesh_positions_m(bodies[body], std::max(time_s, 0.0));
  const sim::Surface surface = {positions_m, mesh->data->triangles};
  const std::vector<sim::CrossingPair> pairs = sim::find_crossing_pairs(surface);
  return pairs.empty() ? "" : describe_body(bodies, body) + " crosses itself: " + describe(surface, pairs);
}

}  // namespace

std::vector<std::string> collect_remarks(const LoadedGarment& loaded) {
  std::vector<std::string> lines;
  if (loaded.model && !loaded.model->is_importer_confined) lines.emplace_back(importer_remark);
  if (loaded.placement && loaded.placement->guessed) {
    lines.push_back("its unit is the " + loaded.placement->unit_text + " (--units)");
    lines.push_back("up is " + loaded.placement->up_text + " (--up)");
  }
  if (loaded.placement && loaded.placement->is_vast) {
    lines.push_back(fmt::format("it is {:.3g} m large, which no garment is, with the unit {} (--units)",
                                loaded.placement->scale * loaded.placement->extent, loaded.placement->unit_text));
  }
  if (loaded.rigid.count > 0) lines.push_back(describe(loaded.rigid));
  if (loaded.strays.triangles > 0) lines.push_back(describe(loaded.strays, loaded.placement->scale));
  if (loaded.placement && loaded.placement->moved_m != sim::Vec3(0.0)) {
    lines.emplace_back("it is very far from the origin and was moved there");
  }
  if (loaded.repairs) append_repairs(*loaded.repairs, lines);
  if (loaded.following) lines.push_back(loaded.following->description);
  if (!loaded.fitting_refusal.empty()) {
    lines.push_back(fmt::format("{}: {} (garment.mesh)",
                                loaded.following
                                    ? "even triangles fitted to it would not be its cloth"
                                    : "the model itself is simulated, as no mesh fitted to it is its cloth",
                                loaded.fitting_refusal));
  }
  if (loaded.trims_sewn_on > 0) {
    lines.push_back(count_text(loaded.trims_sewn_on, "small part") + " sewn to the cloth below (garment.weld)");
  }
  if (loaded.turned_outside_out > 0) {
    lines.push_back(count_text(loaded.turned_outside_out, "triangle") + " of surfaces that faced inwards turned");
  }
  if (!loaded.hanger.empty()) lines.push_back(describe(loaded.hanger));
  if (loaded.hanging) {
    const std::vector<std::string> parts = describe(*loaded.hanging);
    lines.insert(lines.end(), parts.begin(), parts.end());
  }
  return lines;
}

StartRemarks remarks_on_body(std::span<const sim::Body> bodies, std::size_t body, double time_s,
                             const sim::Surface& cloth, std::span<const sim::Index> pins) {
  StartRemarks remarks;
  const SceneCrossings crossings = crossings_with(bodies, body, time_s, cloth);
  remarks.crossings = crossings.pairs.size();
  if (!crossings.pairs.empty()) {
    remarks.lines.push_back("at the start " + describe(crossings, cloth, bodies));
  } else if (const std::vector<sim::Index> within = parts_within(bodies[body], time_s, cloth); !within.empty()) {
    remarks.crossings = within.size();
    remarks.lines.push_back(
        fmt::format("at the start {} wholly within {}, the first: that of vertex {} at {}; nothing lets it out",
                    count_text(within.size(), "part of the cloth is", "parts of the cloth are"),
                    describe_body(bodies, body), within.front(), describe_place(cloth.positions_m[within.front()])));
  }
  remarks.lines.push_back(remark_on_pins(bodies, body, time_s, cloth, pins));
  remarks.lines.push_back(remark_on_shape(bodies, body, time_s));
  std::erase(remarks.lines, "");
  return remarks;
}

StartRemarks remarks_on_start(const Scene& scene, const GarmentInScene& loaded, std::span<const sim::Body> bodies) {
  const sim::Surface start = surface_at_start(loaded);
  StartRemarks all;
  if (loaded.untangling) all.lines.push_back(describe(*loaded.untangling));
  const std::vector<sim::CrossingPair> own_pairs = sim::find_crossing_pairs(start);
  all.crossings = own_pairs.size();
  if (!own_pairs.empty()) {
    all.lines.push_back("at the start " + describe(start, own_pairs) +
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

void print_remarks(const Scene& scene, const LoadedGarment& loaded, std::span<const sim::Body> bodies,
                   std::FILE* output) {
  const std::string file = loaded.model ? scene.garment.file.filename().string() : scene.name;
  std::vector<std::string> lines = collect_remarks(loaded);
  if (loaded.file_vertices.are_corners && has_numbers(scene.pins)) {
    lines.push_back("pins.at counts " + loaded.file_vertices.describe());
  }
  const std::vector<std::string> on_start = remarks_on_start(scene, loaded, bodies).lines;
  lines.insert(lines.end(), on_start.begin(), on_start.end());
  for (const std::string& line : lines) fmt::print(output, "{}: {}\n", file, printable(line));
}

}  // namespace taut::app
