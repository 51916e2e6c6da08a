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

MotionInspection motion_of(const sim::BodyMesh& body) {
  MotionInspection motion{
      body.frames->count(), body.frames->rate_hz(), {}, find_loop_begin(*body.frames, body.data->positions_m.size())};
  std::vector<sim::Vec3> before_m(body.data->positions_m.size());
  std::vector<sim::Vec3> now_m(before_m.size());
  body.frames->positions_in(0, before_m);
  for (std::size_t frame = 1; frame < motion.frames; ++frame) {
    throw_if_interrupted();
    body.frames->positions_in(frame, now_m);
    for (std::size_t v = 0; v < now_m.size(); ++v) {
      const double speed = glm::distance(before_m[v], now_m[v]) * motion.rate_hz;
      if (speed > motion.fastest.speed_m_per_s) motion.fastest = {speed, frame, now_m[v]};
    }
    std::swap(before_m, now_m);
  }
  return motion;
}

void look_for_crossings(const sim::BodyMesh& body, BodyInspection& result) {
  const std::size_t frames = body.frames ? body.frames->count() : 1;
  result.frames_looked_at = std::min(frames, most_looked_at);
  std::vector<sim::Vec3> positions_m = body.data->positions_m;
  for (std::size_t k = 0; k < result.frames_looked_at; ++k) {
    throw_if_interrupted();
    const std::size_t frame = k * (frames - 1) / std::max<std::size_t>(result.frames_looked_at - 1, 1);
    if (body.frames) body.frames->positions_in(frame, positions_m);
    const Surface surface = {positions_m, body.data->triangles};
    const std::vector<CrossingPair> pairs = crossing_pairs(surface);
    if (!pairs.empty()) result.crossings.push_back({frame, describe(surface, pairs)});
  }
}

std::string girths_text(const BodyInspection& body) {
  std::string text;
  for (const Girth& girth : body.girths) {
    text += fmt::format("{}{} {:.1f} cm", text.empty() ? "  girths: " : ", ", girth.name, 100.0 * girth.girth_m);
  }
  return text.empty() ? text : text + '\n';
}

std::string crossings_text(const BodyInspection& body) {
  const std::string looked = fmt::format(" ({} looked at)", counted(body.frames_looked_at, "frame"));
  if (body.crossings.empty()) return "it does not cross itself" + looked;
  return fmt::format("it crosses itself in {} of {}; in frame {} {}", body.crossings.size(),
                     counted(body.frames_looked_at, "frame") + " looked at", body.crossings.front().frame,
                     body.crossings.front().pairs);
}

}  // namespace

BodyInspection inspect_body(const BodySource& source) {
  BodySource undressed = source;
  undressed.dress = 0;
  undressed.loop = false;
  const ReadBody body = read_body(undressed, {});
  BodyInspection result;
  result.file = source.file.string();
  result.format = body.format;
  result.vertices = body.mesh.data->positions_m.size();
  result.triangles = body.mesh.data->triangles.size();
  result.shells = sim::first_vertices_of_parts(result.vertices, body.mesh.data->triangles).size();
  result.size_m = sim::extent_of(body.mesh.data->positions_m).size();
  result.volume_m3 = volume_of(*body.mesh.data);
  result.joints = joints_of(*body.rig);
  result.shapes = body.rig->targets.size();
  result.clips = describe_clips(*body.rig);
  result.girths = measures_of({body.mesh.data->positions_m, body.mesh.data->triangles}, body.joints).girths;
  result.remarks = body.remarks;
  if (body.mesh.frames) result.motion = motion_of(body.mesh);
  look_for_crossings(body.mesh, result);
  return result;
}

std::string describe(const BodyInspection& body) {
  std::string text = fmt::format("{}: a body, {}\n", body.file, body.format);
  text += fmt::format("  {:.3f} m high, {:.3f} m wide, {:.3f} m deep, {:.4g} litres\n", body.size_m.y, body.size_m.x,
                      body.size_m.z, 1e3 * body.volume_m3);
  text += girths_text(body);
  text += fmt::format("  {}, {}, {}\n", counted(body.vertices, "vertex", "vertices"),
                      counted(body.triangles, "triangle"), counted(body.shells, "closed surface"));
  text += fmt::format("  {}{}\n", counted(body.joints.size(), "joint"),
                      body.joints.empty() ? "" : ": " + joined(body.joints));
  text += body.shapes == 0 ? "" : fmt::format("  {} to be mixed in\n", counted(body.shapes, "shape"));
  text += fmt::format("  animations: {}\n", body.clips);
  if (body.motion) {
    const FastestVertex& fastest = body.motion->fastest;
    text +=
        fmt::format("  its motion: {} at {:.6g} Hz, {:.4g} s; the fastest vertex at {:.3g} m/s into frame {} at {}\n",
                    counted(body.motion->frames, "frame"), body.motion->rate_hz,
                    static_cast<double>(body.motion->frames - 1) / body.motion->rate_hz, fastest.speed_m_per_s,
                    fastest.frame, describe_place(fastest.place_m));
    text += "  " + describe(body.motion->loop) + " (loop, --body-loop)\n";
  }
  text += "  " + crossings_text(body) + '\n';
  for (const std::string& remark : body.remarks) text += "  " + remark + '\n';
  return text;
}

Json json_of(const BodyInspection& body) {
  const auto point = [](const sim::Vec3& p) { return Json::array({p.x, p.y, p.z}); };
  Json json = {{"file", body.file},           {"format", body.format},          {"vertices", body.vertices},
               {"triangles", body.triangles}, {"closed_surfaces", body.shells}, {"size_m", point(body.size_m)},
               {"volume_m3", body.volume_m3}, {"joints", body.joints},          {"shapes", body.shapes},
               {"animations", body.clips}};
  json["girths"] = Json::array();
  for (const Girth& girth : body.girths) {
    json["girths"].push_back({{"name", girth.name}, {"girth_m", girth.girth_m}, {"height_m", girth.height_m}});
  }
  if (body.motion) {
    const FastestVertex& fastest = body.motion->fastest;
    json["motion"] = {{"frames", body.motion->frames},
                      {"frame_rate_hz", body.motion->rate_hz},
                      {"fastest_m_per_s", fastest.speed_m_per_s},
                      {"fastest_frame", fastest.frame},
                      {"fastest_at_m", point(fastest.place_m)},
                      {"repeats_from_frame", body.motion->loop.frame},
                      {"repeats_from_m_away", body.motion->loop.furthest_m}};
  }
  json["crossings"] = {{"frames_looked_at", body.frames_looked_at}, {"frames", Json::array()}};
  for (const CrossingFrame& crossing : body.crossings) {
    json["crossings"]["frames"].push_back({{"frame", crossing.frame}, {"pairs", crossing.pairs}});
  }
  json["remarks"] = body.remarks;
  return json;
}

}  // namespace taut::app
