#include "app/models/model_arrays.hpp"

#include "app/models/array_coding.hpp"

namespace taut::app {

// The fields of each type, in the order in which they are written and read.
template <class T, class Plain>
concept Is = std::same_as<std::remove_const_t<T>, Plain>;

void fields(auto& archive, Is<FaceSection> auto& section) { archive(section.first_face, section.line); }

void fields(auto& archive, Is<RigKeys> auto& keys) { archive(keys.times_s, keys.values); }

void fields(auto& archive, Is<RigChannel> auto& channel) {
  archive(channel.node, channel.positions, channel.rotations, channel.scales);
}

void fields(auto& archive, Is<RigTargetChannel> auto& channel) { archive(channel.target, channel.weights); }

void fields(auto& archive, Is<RigClip> auto& clip) {
  archive(clip.name, clip.duration_s, clip.channels, clip.targets, clip.unknown);
}

void fields(auto& archive, Is<RigNode> auto& node) { archive(node.name, node.parent, node.to_parent); }

void fields(auto& archive, Is<RigPart> auto& part) {
  archive(part.node, part.mesh, part.first_vertex, part.vertices, part.is_skinned);
}

void fields(auto& archive, Is<RigTarget> auto& target) { archive(target.part, target.weight, target.offsets); }

void fields(auto& archive, Is<Rig> auto& rig) {
  archive(rig.nodes, rig.parts, rig.in_part, rig.bones, rig.influences, rig.targets, rig.clips);
}

void fields(auto& archive, Is<SurfaceMaterial> auto& material) {
  archive(material.name, material.base_colour, material.map, material.map_file);
}

void fields(ArrayWriter& out, const TextureImage& image) { out(image.width_px, image.height_px, *image.rgba); }

void fields(ArrayReader& in, TextureImage& image) {
  std::vector<std::uint8_t> rgba;
  in(image.width_px, image.height_px, rgba);
  image.rgba = std::make_shared<const std::vector<std::uint8_t>>(std::move(rgba));
}

void fields(auto& archive, Is<SurfaceColours> auto& colours) {
  archive(colours.corner_uv, colours.material_of_face, colours.materials, colours.maps, colours.remarks);
}

void fields(auto& archive, Is<ModelArrays> auto& model) {
  archive(model.positions, model.corner_counts, model.corners, model.position_of_vertex, model.sections,
          model.has_normals, model.format, model.meshes, model.ignored_lines, model.ignored_points,
          model.metres_per_unit, model.up, model.rig, model.colours);
}

namespace {

void require(bool is_so) {
  if (!is_so) throw std::runtime_error("the arrays of a model are not as expected");
}

bool are_below(std::span<const sim::Index> indices, std::size_t count) {
  return std::ranges::all_of(indices, [&](sim::Index index) { return index < count; });
}

void require_keys(const RigKeys& keys) { require(keys.times_s.size() == keys.values.size()); }

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
    for (const RigChannel& channel : clip.channels) {
      require(channel.node < rig.nodes.size());
      for (const RigKeys* keys : {&channel.positions, &channel.rotations, &channel.scales}) require_keys(*keys);
    }
    for (const RigTargetChannel& channel : clip.targets) {
      require(channel.target < rig.targets.size());
      require_keys(channel.weights);
    }
  }
}

void require_colours(const ModelArrays& model) {
  const SurfaceColours& colours = model.colours;
  require(colours.corner_uv.empty() || colours.corner_uv.size() == model.corners.size());
  require(colours.material_of_face.empty() || colours.material_of_face.size() == model.corner_counts.size());
  require(are_below(colours.material_of_face, colours.materials.size()));
  for (const SurfaceMaterial& material : colours.materials) {
    require(material.map == no_map || material.map < colours.maps.size());
  }
  for (const TextureImage& map : colours.maps) {
    require(map.width_px > 0 && map.height_px > 0 &&
            map.rgba->size() == std::uint64_t{4} * map.width_px * map.height_px);
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
  out(model);
  return std::move(out.bytes);
}

ModelArrays decode(const std::string& bytes) {
  ArrayReader reader(bytes);
  ModelArrays model;
  reader(model);
  require(reader.at_end() && are_below(model.position_of_vertex, model.positions.size()));
  require(model.rig.empty() || model.rig.in_part.size() == model.positions.size());
  require(!model.up || *model.up <= ModelAxis::minus_z);
  require(!model.metres_per_unit || *model.metres_per_unit > 0.0);
  require_tree(model.rig);
  require_indices(model.rig);
  require_colours(model);
  for (glm::vec2& uv : model.colours.corner_uv) {
    uv = std::isfinite(uv.x) && std::isfinite(uv.y) ? uv : glm::vec2(0.0F);
  }
  return model;
}

}  // namespace taut::app
