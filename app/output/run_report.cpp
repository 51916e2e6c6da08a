#include "app/output/run_report.hpp"

#include <fmt/core.h>

#include <array>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/scene/scene_file.hpp"
#include "app/version.hpp"

namespace taut::app {
namespace {

using Json = nlohmann::ordered_json;

struct JsonWriter {
  Json operator()(std::monostate) const { return nullptr; }
  Json operator()(bool value) const { return value; }
  Json operator()(std::int64_t value) const { return value; }
  Json operator()(double value) const { return value; }
  Json operator()(const std::string& value) const { return value; }
  Json operator()(const ValueList& values) const {
    Json list = Json::array();
    for (const Value& value : values) {
      list.push_back(std::visit(*this, value.data));
    }
    return list;
  }
  Json operator()(const ValueTable& table) const {
    Json object = Json::object();
    for (const auto& [key, value] : table) {
      object[key] = std::visit(*this, value.data);
    }
    return object;
  }
};

Json spring_counts(std::size_t structural, std::size_t shear, std::size_t flexural) {
  return {{"structural", structural}, {"shear", shear}, {"flexural", flexural}};
}

Json garment_json(const sim::Garment& garment) {
  return {{"vertices", garment.mesh.positions.size()},
          {"triangles", garment.mesh.triangles.size()},
          {"springs", spring_counts(garment.springs.count(sim::SpringKind::structural),
                                    garment.springs.count(sim::SpringKind::shear),
                                    garment.springs.count(sim::SpringKind::flexural))},
          {"pins", garment.pins.size()}};
}

Json versions_json(const std::string& gl_renderer) {
  Json versions = {{"program", program_version()}, {"compiler", compiler_version()}};
  if (!gl_renderer.empty()) {
    versions["gl_renderer"] = gl_renderer;
  }
  return versions;
}

Json record_json(const FrameRecord& record) {
  return {{"frame", record.frame},
          {"time_s", record.time_s},
          {"max_stretch", record.stretch.max},
          {"p99_stretch", record.stretch.p99},
          {"mean_stretch", record.stretch.mean},
          {"raw_max_stretch", record.raw_max_stretch},
          {"bound_kept", record.bound_kept},
          {"substeps", record.substeps},
          {"max_compression", record.stretch.max_compression},
          {"rms_speed", record.rms_speed_m_per_s},
          {"kinetic_energy", record.energy.kinetic_j},
          {"potential_energy", record.energy.potential_j},
          {"convergence", record.convergence_m},
          {"sim_ms", record.sim_ms},
          {"draw_ms", record.draw_ms},
          {"encode_ms", record.encode_ms},
          {"state_hash", fmt::format("{:016x}", record.state_hash)},
          {"asleep", record.asleep}};
}

Json summary_json(const RunSummary& summary) {
  Json json = {{"frames", summary.frames},
               {"max_stretch", summary.max_stretch},
               {"max_stretch_frame", summary.max_stretch_frame},
               {"max_p99_stretch", summary.max_p99_stretch},
               {"final_max_stretch", summary.final_max_stretch},
               {"max_raw_stretch", summary.max_raw_stretch},
               {"frames_over_bound", summary.frames_over_bound},
               {"mean_substeps", summary.mean_substeps},
               {"final_rms_speed", summary.final_rms_speed_m_per_s},
               {"asleep_since_frame", nullptr},
               {"mean_sim_ms", summary.mean_sim_ms},
               {"total_sim_ms", summary.total_sim_ms},
               {"total_draw_ms", summary.total_draw_ms},
               {"total_encode_ms", summary.total_encode_ms}};
  if (summary.asleep_since_frame >= 0) {
    json["asleep_since_frame"] = summary.asleep_since_frame;
  }
  return json;
}

Json point_json(const sim::Vec3& p) {
  return {p.x, p.y, p.z};
}

Json parts_json(const std::vector<HungPart>& parts) {
  constexpr std::array ways = {"top opening", "highest points", "back edge"};
  Json list = Json::array();
  for (const HungPart& part : parts) {
    list.push_back({{"vertices", part.vertices},
                    {"hung_by", ways[static_cast<std::size_t>(part.by)]},
                    {"pins", part.pins},
                    {"closed", part.closed},
                    {"flat", part.flat}});
  }
  return list;
}

// File names can hold bytes that are no UTF-8.
std::string text_of(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace

std::string statistics_json(const Scene& scene, const sim::Garment& garment, const std::string& gl_renderer,
                            const std::vector<FrameRecord>& records) {
  Json json = {{"scene", scene.name},
               {"garment", garment_json(garment)},
               {"settings", std::visit(JsonWriter{}, scene_settings(scene).data)},
               {"versions", versions_json(gl_renderer)},
               {"summary", summary_json(summarise(records))},
               {"frames", Json::array()}};
  for (const FrameRecord& record : records) {
    json["frames"].push_back(record_json(record));
  }
  return text_of(json);
}

std::string inspection_json(const Inspection& i) {
  Json landmarks = Json::object();
  for (const LandmarkSize& landmark : i.landmarks) {
    landmarks[landmark.name] = landmark.vertices;
  }
  const Json import = {{"format", i.model.format},
                       {"meshes", i.model.meshes},
                       {"triangles", i.model.file_triangles},
                       {"quads", i.model.file_quads},
                       {"polygons", i.model.file_polygons},
                       {"ignored_lines", i.model.ignored_lines},
                       {"ignored_points", i.model.ignored_points}};
  const Json repairs = {{"input_vertices", i.repairs.input_vertices},
                        {"input_triangles", i.repairs.input_triangles},
                        {"welded_vertices", i.repairs.welded_vertices},
                        {"unused_vertices", i.repairs.unused_vertices},
                        {"degenerate_triangles", i.repairs.degenerate_triangles},
                        {"duplicate_triangles", i.repairs.duplicate_triangles},
                        {"turned_triangles", i.repairs.turned_triangles},
                        {"near_vertices", i.repairs.near_vertices},
                        {"parted_vertices", i.repairs.parted_vertices}};
  const Json placement = {{"metres_per_unit", i.placement.scale},
                          {"unit", i.placement.unit_text},
                          {"up", axis_names[static_cast<std::size_t>(i.placement.up)]},
                          {"up_from", i.placement.up_text},
                          {"guessed", i.placement.guessed},
                          {"moved_m", point_json(i.placement.moved_m)}};
  const Json topology = {{"components", i.topology.components},
                         {"boundary_edges", i.topology.boundary_edges},
                         {"boundary_loops", i.topology.boundary_loops},
                         {"non_manifold_edges", i.topology.non_manifold_edges},
                         {"non_manifold_vertices", i.topology.non_manifold_vertices},
                         {"misoriented_edges", i.topology.misoriented_edges},
                         {"euler_characteristic", i.topology.euler_characteristic}};
  return text_of(
      {{"file", i.file},
       {"import", import},
       {"repairs", repairs},
       {"placement", placement},
       {"parts", parts_json(i.parts)},
       {"vertices", i.vertices},
       {"triangles", i.triangles},
       {"bounding_box_m", {point_json(i.lower_m), point_json(i.upper_m)}},
       {"area_m2", i.area_m2},
       {"edge_length_m", {{"min", i.shortest_edge_m}, {"mean", i.mean_edge_m}, {"max", i.longest_edge_m}}},
       {"smallest_angle_degrees", i.smallest_angle_rad * 180.0 / std::numbers::pi},
       {"topology", topology},
       {"springs", spring_counts(i.structural_springs, i.shear_springs, i.flexural_springs)},
       {"landmarks", landmarks},
       {"remarks", i.remarks}});
}

}  // namespace taut::app
