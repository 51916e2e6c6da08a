#include "app/models/reading/garment_import.hpp"

namespace taut::app {
namespace {

/// Limit on the count of names, materials, joints and other items. Each takes more memory than its bytes.
constexpr std::uint64_t max_items = max_triangles;
constexpr std::uint64_t max_word_bytes = std::uint64_t{1} << 20U;
/// Limit on all numbers: about the largest of single precision.
constexpr double max_number = 3.5e38;
constexpr double max_duration_s = 1e9;

/// Vectors and matrices of doubles, and doubles.
template <class T>
concept OfDoubles =
    std::same_as<T, double> || std::same_as<T, sim::Vec3> || std::same_as<T, glm::dvec4> || std::same_as<T, glm::dmat4>;

bool are_numbers(std::span<const std::byte> doubles) {
  const std::span numbers(reinterpret_cast<const double*>(doubles.data()), doubles.size() / sizeof(double));
  return std::ranges::all_of(numbers, [](double number) { return std::abs(number) <= max_number; });
}

void require(bool is_so) {
  if (!is_so) throw std::runtime_error("the arrays of a model are not as expected");
}

}  // namespace

/// Writes values one after the other, with their layout in memory, for another process of this program. A value is
/// trivially copyable, a list of values, or of a type with a function `fields(archive, value)`. This function calls the
/// archive with references to the value's members, for writing and for reading. A std::size_t takes eight bytes on
/// every machine, because web pages read what other machines wrote.
class ArrayWriter {
 public:
  template <class... Values> void operator()(const Values&... values) { (put(values), ...); }

  std::string bytes;

 private:
  template <class T> void put(const T& value) {
    if constexpr (std::same_as<T, std::size_t> && sizeof(T) != sizeof(std::uint64_t)) {
      put(std::uint64_t{value});
    } else if constexpr (std::is_trivially_copyable_v<T>) {
      bytes.append(reinterpret_cast<const char*>(&value), sizeof(T));
    } else {
      fields(*this, value);
    }
  }

  template <class T> void put(const std::optional<T>& value) {
    put(value.has_value());
    if (value) put(*value);
  }

  template <class List>
  requires requires(List list) { list.resize(0); }
  void put(const List& list) {
    put(static_cast<std::uint64_t>(list.size()));
    if constexpr (std::is_trivially_copyable_v<typename List::value_type>) {
      bytes.append(reinterpret_cast<const char*>(list.data()), list.size() * sizeof(typename List::value_type));
    } else {
      for (const auto& item : list) put(item);
    }
  }
};

/// Reads the output of an ArrayWriter. The bytes are not trusted: every length is compared with the bytes that are
/// left. Functions throw std::runtime_error if there are fewer.
class ArrayReader {
 public:
  /// `bytes` must outlive this object.
  explicit ArrayReader(const std::string& bytes) : bytes_(bytes) {}

  template <class... Values> void operator()(Values&... values) { (take(values), ...); }

  bool at_end() const { return at_ == bytes_.size(); }

 private:
  template <class T> void take(T& value) {
    if constexpr (std::same_as<T, std::size_t> && sizeof(T) != sizeof(std::uint64_t)) {
      std::uint64_t wide = 0;
      take(wide);
      value = static_cast<T>(wide);
    } else if constexpr (std::is_trivially_copyable_v<T>) {
      copy(std::span(&value, 1));
    } else {
      fields(*this, value);
    }
  }

  void take(bool& value) {
    std::uint8_t byte = 0;
    take(byte);
    value = byte != 0;
  }

  template <class T> void take(std::optional<T>& value) {
    bool has_value = false;
    take(has_value);
    if (has_value) take(value.emplace());
  }

  template <class List>
  requires requires(List list) { list.resize(0); }
  void take(List& list) {
    using Item = typename List::value_type;
    std::uint64_t count = 0;
    take(count);
    if constexpr (std::is_trivially_copyable_v<Item>) {
      require(sizeof(Item), count);
      list.resize(count);
      copy(std::span(list));
    } else {
      if (count > max_items - items_) throw std::runtime_error("the arrays of a model have too many names");
      items_ += count;
      while (list.size() < count) take(list.emplace_back());
    }
    if constexpr (std::same_as<List, std::string>) app::require(count <= max_word_bytes);
  }

  template <class Item> void copy(std::span<Item> to) {
    require(sizeof(Item), to.size());
    if (!to.empty()) std::memcpy(to.data(), bytes_.data() + at_, to.size_bytes());
    at_ += to.size_bytes();
    if constexpr (OfDoubles<Item>) {
      if (!are_numbers(std::as_bytes(to))) {
        throw std::runtime_error("it has a number that is not finite or beyond all bounds");
      }
    }
  }

  void require(std::size_t item_bytes, std::uint64_t count) const {
    if (count > (bytes_.size() - at_) / item_bytes) {
      throw std::runtime_error("the arrays of a model are incomplete");
    }
  }

  const std::string& bytes_;
  std::size_t at_ = 0;
  std::uint64_t items_ = 0;
};

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
  archive(model.positions, model.faces.corner_counts, model.faces.corners, model.position_of_vertex,
          model.faces.sections, model.faces.has_normals, model.format, model.meshes, model.ignored_lines,
          model.ignored_points, model.metres_per_unit, model.up, model.rig, model.colours, model.files,
          model.is_importer_confined);
}

namespace {

bool are_below(std::span<const sim::Index> indices, std::size_t count) {
  return std::ranges::all_of(indices, [&](sim::Index index) { return index < count; });
}

void require_faces(const FileFaces& faces, std::size_t positions) {
  std::uint64_t corners = 0;
  for (const std::uint32_t count : faces.corner_counts) {
    require(count >= 3);
    corners += count;
  }
  require(corners == faces.corners.size() && are_below(faces.corners, positions));
  std::size_t first = 0;
  for (const FaceSection& section : faces.sections) {
    require(section.first_face >= first && section.first_face <= faces.corner_counts.size());
    require(section.line.find_first_of("\r\n") == std::string::npos);
    first = section.first_face;
  }
}

void require_order(const std::vector<sim::Index>& order, std::size_t positions) {
  require(order.empty() || order.size() == positions);
  std::vector<char> is_used(order.size(), 0);
  for (const sim::Index position : order) require(position < positions && std::exchange(is_used[position], 1) == 0);
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
    const auto influence =
        std::lower_bound(rig.influences.begin(), rig.influences.end(), part.first_vertex,
                         [](const RigInfluence& i, std::size_t vertex) { return i.vertex < vertex; });
    require(part.is_skinned || influence == rig.influences.end() || influence->vertex >= vertices);
  }
  require(vertices == rig.in_part.size());
}

void require_indices(const Rig& rig) {
  std::size_t min_index = 0;
  for (const RigInfluence& influence : rig.influences) {
    require(influence.bone < rig.bones.size() && influence.vertex >= min_index &&
            influence.vertex < rig.in_part.size());
    require(std::abs(influence.weight) <= max_number);
    min_index = influence.vertex;
  }
  for (const RigBone& bone : rig.bones) {
    require(bone.node < rig.nodes.size() && are_numbers(std::as_bytes(std::span(&bone.from_mesh, 1))));
  }
  for (const RigTarget& target : rig.targets) {
    require(target.part < rig.parts.size() && target.offsets.size() == rig.parts[target.part].vertices);
  }
  for (const RigClip& clip : rig.clips) {
    require(std::abs(clip.duration_s) <= max_duration_s);
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
  require(colours.corner_uv.empty() || colours.corner_uv.size() == model.faces.corners.size());
  require(colours.material_of_face.empty() || colours.material_of_face.size() == model.faces.corner_counts.size());
  require(are_below(colours.material_of_face, colours.materials.size()));
  for (const SurfaceMaterial& material : colours.materials) {
    require(material.map == no_map || material.map < colours.maps.size());
  }
  for (const TextureImage& map : colours.maps) {
    require(map.width_px > 0 && map.height_px > 0 && std::max(map.width_px, map.height_px) <= max_print_side_px &&
            map.rgba->size() == std::uint64_t{4} * map.width_px * map.height_px);
  }
}

/// Mends damaged colours, because a garment is more than its print.
void mend_colours(SurfaceColours& colours) {
  constexpr float max_uv = 1e9F;
  for (glm::vec2& uv : colours.corner_uv) {
    uv = std::abs(uv.x) <= max_uv && std::abs(uv.y) <= max_uv ? uv : glm::vec2(0.0F);
  }
  for (SurfaceMaterial& material : colours.materials) {
    glm::vec3& colour = material.base_colour;
    for (int k = 0; k < 3; ++k) colour[k] = colour[k] >= 0.0F ? std::min(colour[k], 1.0F) : 0.0F;
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
  for (sim::Index& corner : model.faces.corners) corner = number(corner);
  for (sim::Index old = 0; old < number_of.size(); ++old) number(old);
  model.positions = std::move(positions);
  model.position_of_vertex = std::move(number_of);
}

std::string encode(const ModelArrays& model) {
  ArrayWriter out;
  out.bytes.reserve(model.positions.size() * sizeof(sim::Vec3) +
                    (model.faces.corners.size() + model.faces.corner_counts.size()) * sizeof(sim::Index) + 256);
  out(model);
  return std::move(out.bytes);
}

ModelArrays decode(const std::string& bytes) {
  ArrayReader reader(bytes);
  ModelArrays model;
  reader(model);
  require(reader.at_end());
  require_faces(model.faces, model.positions.size());
  require_order(model.position_of_vertex, model.positions.size());
  require(model.rig.empty() || model.rig.in_part.size() == model.positions.size());
  require(!model.up || (*model.up >= ModelAxis::x && *model.up <= ModelAxis::minus_z));
  require(!model.metres_per_unit || *model.metres_per_unit > 0.0);
  require_indices(model.rig);
  require_tree(model.rig);
  require_colours(model);
  mend_colours(model.colours);
  return model;
}

}  // namespace taut::app
