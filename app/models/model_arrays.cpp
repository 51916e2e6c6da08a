#include "app/models/model_arrays.hpp"

namespace taut::app {
namespace {

constexpr std::uint8_t no_axis = 255;

void require(bool is_so) {
  if (!is_so) throw std::runtime_error("the joints of a model are not as expected");
}

void put_keys(const RigKeys& keys, ArrayWriter& out) {
  out.put_list(keys.times_s);
  out.put_list(keys.values);
}

RigKeys take_keys(ArrayReader& in) {
  RigKeys keys;
  keys.times_s = in.take_list<std::vector<double>>();
  keys.values = in.take_list<std::vector<glm::dvec4>>();
  require(keys.times_s.size() == keys.values.size());
  return keys;
}

void put_clip(const RigClip& clip, ArrayWriter& out) {
  out.put_list(clip.name);
  out.put(clip.duration_s);
  put_all(clip.channels, out, [&](const RigChannel& channel) {
    out.put(channel.node);
    put_keys(channel.positions, out);
    put_keys(channel.rotations, out);
    put_keys(channel.scales, out);
  });
  put_all(clip.targets, out, [&](const RigTargetChannel& channel) {
    out.put(channel.target);
    put_keys(channel.weights, out);
  });
  put_all(clip.unknown, out, [&](const std::string& name) { out.put_list(name); });
}

void take_clip(ArrayReader& in, RigClip& clip) {
  clip.name = in.take_list<std::string>();
  clip.duration_s = in.take<double>();
  take_all(clip.channels, in, [&](RigChannel& channel) {
    channel.node = in.take<sim::Index>();
    channel.positions = take_keys(in);
    channel.rotations = take_keys(in);
    channel.scales = take_keys(in);
  });
  take_all(clip.targets, in, [&](RigTargetChannel& channel) {
    channel.target = in.take<sim::Index>();
    channel.weights = take_keys(in);
  });
  take_all(clip.unknown, in, [&](std::string& name) { name = in.take_list<std::string>(); });
}

void require_tree(const Rig& rig) {
  for (std::size_t n = 0; n < rig.nodes.size(); ++n) {
    require(rig.nodes[n].parent == no_node || rig.nodes[n].parent < n);
  }
  std::size_t vertices = 0;
  for (const RigPart& part : rig.parts) {
    require(part.node < rig.nodes.size() && part.first_vertex == vertices &&
            part.vertices <= rig.in_part.size() - vertices);
    vertices += part.vertices;
  }
  require(vertices == rig.in_part.size());
}

void require_indices(const Rig& rig) {
  std::size_t least = 0;
  for (const RigInfluence& influence : rig.influences) {
    require(influence.bone < rig.bones.size() && influence.vertex >= least && influence.vertex < rig.in_part.size());
    least = influence.vertex;
  }
  for (const RigBone& bone : rig.bones) require(bone.node < rig.nodes.size());
  for (const RigTarget& target : rig.targets) {
    require(target.part < rig.parts.size() && target.offsets.size() == rig.parts[target.part].vertices);
  }
  for (const RigClip& clip : rig.clips) {
    for (const RigChannel& channel : clip.channels) require(channel.node < rig.nodes.size());
    for (const RigTargetChannel& channel : clip.targets) require(channel.target < rig.targets.size());
  }
}

}  // namespace

void number_by_first_use(ModelArrays& model) {
  constexpr sim::Index unused = std::numeric_limits<sim::Index>::max();
  std::vector<sim::Index> number_of(model.positions.size(), unused);
  std::vector<sim::Vec3> positions;
  positions.reserve(model.positions.size());
  const auto number = [&](sim::Index old) {
    if (number_of[old] == unused) {
      number_of[old] = static_cast<sim::Index>(positions.size());
      positions.push_back(model.positions[old]);
    }
    return number_of[old];
  };
  for (sim::Index& corner : model.corners) corner = number(corner);
  for (sim::Index old = 0; old < number_of.size(); ++old) number(old);
  model.positions = std::move(positions);
  model.position_of_vertex = std::move(number_of);
}

std::string encode(const ModelArrays& model) {
  ArrayWriter out;
  out.bytes.reserve(model.positions.size() * sizeof(sim::Vec3) +
                    (model.corners.size() + model.corner_counts.size()) * sizeof(sim::Index) + 256);
  out.put_list(model.positions);
  out.put_list(model.corner_counts);
  out.put_list(model.corners);
  out.put_list(model.position_of_vertex);
  put_all(model.sections, out, [&](const FaceSection& section) {
    out.put(section.first_face);
    out.put_list(section.line);
  });
  out.put(static_cast<std::uint8_t>(model.has_normals ? 1 : 0));
  out.put_list(model.format);
  out.put(static_cast<std::uint64_t>(model.meshes));
  out.put(static_cast<std::uint64_t>(model.ignored_lines));
  out.put(static_cast<std::uint64_t>(model.ignored_points));
  out.put(model.metres_per_unit.value_or(0.0));
  out.put(model.up ? static_cast<std::uint8_t>(*model.up) : no_axis);
  encode(model.rig, out);
  encode(model.colours, out);
  return std::move(out.bytes);
}

ModelArrays decode(const std::string& bytes) {
  ArrayReader reader(bytes);
  ModelArrays model;
  model.positions = reader.take_list<std::vector<sim::Vec3>>();
  model.corner_counts = reader.take_list<std::vector<std::uint32_t>>();
  model.corners = reader.take_list<std::vector<sim::Index>>();
  model.position_of_vertex = reader.take_list<std::vector<sim::Index>>();
  take_all(model.sections, reader, [&](FaceSection& section) {
    section.first_face = reader.take<std::uint32_t>();
    section.line = reader.take_list<std::string>();
  });
  model.has_normals = reader.take<std::uint8_t>() != 0;
  model.format = reader.take_list<std::string>();
  model.meshes = reader.take<std::uint64_t>();
  model.ignored_lines = reader.take<std::uint64_t>();
  model.ignored_points = reader.take<std::uint64_t>();
  const auto unit = reader.take<double>();
  const auto axis = reader.take<std::uint8_t>();
  model.rig = decode_rig(reader);
  model.colours = decode_colours(reader, model.corners.size(), model.corner_counts.size());
  const auto is_position = [&](sim::Index index) { return index < model.positions.size(); };
  const bool has_positions = std::ranges::all_of(model.position_of_vertex, is_position);
  const bool has_rig = model.rig.empty() || model.rig.in_part.size() == model.positions.size();
  if (!reader.at_end() || !has_positions || !has_rig ||
      (axis != no_axis && axis > static_cast<std::uint8_t>(ModelAxis::minus_z))) {
    throw std::runtime_error("the arrays of a model are not as expected");
  }
  model.metres_per_unit = unit > 0.0 ? std::optional(unit) : std::nullopt;
  model.up = axis != no_axis ? std::optional(static_cast<ModelAxis>(axis)) : std::nullopt;
  return model;
}

void encode(const Rig& rig, ArrayWriter& out) {
  put_all(rig.nodes, out, [&](const RigNode& node) {
    out.put_list(node.name);
    out.put(node.parent);
    out.put(node.to_parent);
  });
  put_all(rig.parts, out, [&](const RigPart& part) {
    out.put(part.node);
    out.put_list(part.mesh);
    out.put(static_cast<std::uint64_t>(part.first_vertex));
    out.put(static_cast<std::uint64_t>(part.vertices));
    out.put(static_cast<std::uint8_t>(part.is_skinned ? 1 : 0));
  });
  out.put_list(rig.in_part);
  out.put_list(rig.bones);
  out.put_list(rig.influences);
  put_all(rig.targets, out, [&](const RigTarget& target) {
    out.put(target.part);
    out.put(target.weight);
    out.put_list(target.offsets);
  });
  put_all(rig.clips, out, [&](const RigClip& clip) { put_clip(clip, out); });
}

Rig decode_rig(ArrayReader& in) {
  Rig rig;
  take_all(rig.nodes, in, [&](RigNode& node) {
    node.name = in.take_list<std::string>();
    node.parent = in.take<sim::Index>();
    node.to_parent = in.take<glm::dmat4>();
  });
  take_all(rig.parts, in, [&](RigPart& part) {
    part.node = in.take<sim::Index>();
    part.mesh = in.take_list<std::string>();
    part.first_vertex = in.take<std::uint64_t>();
    part.vertices = in.take<std::uint64_t>();
    part.is_skinned = in.take<std::uint8_t>() == 1;
  });
  rig.in_part = in.take_list<std::vector<sim::Vec3>>();
  rig.bones = in.take_list<std::vector<RigBone>>();
  rig.influences = in.take_list<std::vector<RigInfluence>>();
  take_all(rig.targets, in, [&](RigTarget& target) {
    target.part = in.take<sim::Index>();
    target.weight = in.take<double>();
    target.offsets = in.take_list<std::vector<sim::Vec3>>();
  });
  take_all(rig.clips, in, [&](RigClip& clip) { take_clip(in, clip); });
  require_tree(rig);
  require_indices(rig);
  return rig;
}

}  // namespace taut::app
