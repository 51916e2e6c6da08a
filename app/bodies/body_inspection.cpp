#include "app/bodies/body_inspection.hpp"

#include "app/base/interruption.hpp"
#include "app/bodies/body_loading.hpp"
#include "app/bodies/shape_rig.hpp"
#include "sim/mesh/extent.hpp"
#include "sim/mesh/topology.hpp"

namespace taut::app {
namespace {

/// Frames in which crossings are looked for. All would take minutes.
constexpr std::size_t most_looked_at = 20;

double volume_of(const sim::BodyMeshData& mesh) {
  double sum = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    sum += glm::dot(mesh.positions_m[a], glm::cross(mesh.positions_m[b], mesh.positions_m[c]));
  }
  return sum / 6.0;
}

std::vector<std::string> joints_of(const Rig& rig) {
  std::set<sim::Index> nodes;
  for (const RigInfluence& influence : rig.influences) {
    nodes.insert(influence.weight > 0.0 ? rig.bones[influence.bone].node : no_node);
  }
  nodes.erase(no_node);
  std::vector<std::string> names;
  for (const sim::Index node : nodes) names.push_back(rig.nodes[node].name);
  return names;
}

Json json_of(const sim::Vec3& p) { return Json::array({p.x, p.y, p.z}); }

/// The motion, or the clip that is played.
Json motion_of(const sim::BodyMesh& body) {
  const std::size_t frames = body.frames->count();
  double fastest_m_per_s = 0.0;
  std::size_t fastest_frame = 0;
  sim::Vec3 fastest_at_m(0.0);
  std::vector<sim::Vec3> before_m(body.data->positions_m.size());
  std::vector<sim::Vec3> now_m(before_m.size());
  body.frames->positions_in(0, before_m);
  for (std::size_t frame = 1; frame < frames; ++frame) {
    throw_if_interrupted();
    body.frames->positions_in(frame, now_m);
    for (std::size_t v = 0; v < now_m.size(); ++v) {
      const double speed = glm::distance(before_m[v], now_m[v]) * body.frames->rate_hz();
      if (speed > fastest_m_per_s) {
        fastest_m_per_s = speed;
        fastest_frame = frame;
        fastest_at_m = now_m[v];
      }
    }
    std::swap(before_m, now_m);
  }
  const LoopBegin loop = find_loop_begin(*body.frames, body.data->positions_m.size());
  return {{"frames", frames},
          {"frame_rate_hz", body.frames->rate_hz()},
          {"fastest_m_per_s", fastest_m_per_s},
          {"fastest_frame", fastest_frame},
          {"fastest_at_m", json_of(fastest_at_m)},
          {"repeats_from_frame", loop.frame},
          {"repeats_from_m_away", loop.furthest_m},
          {"repeats", describe(loop)}};
}

Json crossings_of(const sim::BodyMesh& body) {
  const std::size_t frames = body.frames ? body.frames->count() : 1;
  const std::size_t looked_at = std::min(frames, most_looked_at);
  Json json = {{"frames_looked_at", looked_at}, {"frames", Json::array()}};
  std::vector<sim::Vec3> positions_m = body.data->positions_m;
  for (std::size_t k = 0; k < looked_at; ++k) {
    throw_if_interrupted();
    const std::size_t frame = k * (frames - 1) / std::max<std::size_t>(looked_at - 1, 1);
    if (body.frames) body.frames->positions_in(frame, positions_m);
    const Surface surface = {positions_m, body.data->triangles};
    const std::vector<CrossingPair> pairs = crossing_pairs(surface);
    if (!pairs.empty()) json["frames"].push_back({{"frame", frame}, {"pairs", describe(surface, pairs)}});
  }
  return json;
}

std::string girths_text(const Json& girths) {
  std::string text;
  for (const Json& girth : girths) {
    text += fmt::format("{}{} {:.1f} cm", text.empty() ? "  girths: " : ", ", girth["name"].get<std::string>(),
                        100.0 * girth["girth_m"].get<double>());
  }
  return text.empty() ? text : text + '\n';
}

std::string motion_text(const Json& motion) {
  const std::size_t frames = motion["frames"];
  const double rate_hz = motion["frame_rate_hz"];
  const Json& at_m = motion["fastest_at_m"];
  return fmt::format(
      "  its motion: {} at {:.6g} Hz, {:.4g} s; the fastest vertex at {:.3g} m/s into frame {} at {}\n  {} (loop, "
      "--body-loop)\n",
      counted(frames, "frame"), rate_hz, static_cast<double>(frames - 1) / rate_hz,
      motion["fastest_m_per_s"].get<double>(), motion["fastest_frame"].get<std::size_t>(),
      describe_place({at_m[0], at_m[1], at_m[2]}), motion["repeats"].get<std::string>());
}

std::string crossings_text(const Json& crossings) {
  const std::string looked_at = counted(crossings["frames_looked_at"].get<std::size_t>(), "frame");
  const Json& frames = crossings["frames"];
  if (frames.empty()) return fmt::format("it does not cross itself ({} looked at)", looked_at);
  return fmt::format("it crosses itself in {} of {} looked at; in frame {} {}", frames.size(), looked_at,
                     frames[0]["frame"].get<std::size_t>(), frames[0]["pairs"].get<std::string>());
}

}  // namespace

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
               {"size_m", json_of(sim::extent_of(mesh.positions_m).size())},
               {"volume_m3", volume_of(mesh)},
               {"joints", joints_of(*body.rig)},
               {"shapes", body.rig->targets.size()},
               {"animations", describe_clips(*body.rig)},
               {"girths", Json::array()}};
  for (const Girth& girth : measures_of({mesh.positions_m, mesh.triangles}, body.joints).girths) {
    json["girths"].push_back({{"name", girth.name}, {"girth_m", girth.girth_m}, {"height_m", girth.height_m}});
  }
  if (body.mesh.frames) json["motion"] = motion_of(body.mesh);
  json["crossings"] = crossings_of(body.mesh);
  json["remarks"] = body.remarks;
  return json;
}

std::string describe_body(const Json& body) {
  const Json& size_m = body["size_m"];
  const std::vector<std::string> joints = body["joints"];
  const std::size_t shapes = body["shapes"];
  std::string text =
      fmt::format("{}: a body, {}\n  {:.3f} m high, {:.3f} m wide, {:.3f} m deep, {:.4g} litres\n",
                  body["file"].get<std::string>(), body["format"].get<std::string>(), size_m[1].get<double>(),
                  size_m[0].get<double>(), size_m[2].get<double>(), 1e3 * body["volume_m3"].get<double>());
  text += girths_text(body["girths"]);
  text += fmt::format("  {}, {}, {}\n", counted(body["vertices"].get<std::size_t>(), "vertex", "vertices"),
                      counted(body["triangles"].get<std::size_t>(), "triangle"),
                      counted(body["closed_surfaces"].get<std::size_t>(), "closed surface"));
  text += fmt::format("  {}{}\n", counted(joints.size(), "joint"), joints.empty() ? "" : ": " + joined(joints));
  text += shapes == 0 ? "" : fmt::format("  {} to be mixed in\n", counted(shapes, "shape"));
  text += fmt::format("  animations: {}\n", body["animations"].get<std::string>());
  text += body.contains("motion") ? motion_text(body["motion"]) : "";
  text += "  " + crossings_text(body["crossings"]) + '\n';
  for (const std::string remark : body["remarks"]) text += "  " + remark + '\n';
  return text;
}

}  // namespace taut::app
