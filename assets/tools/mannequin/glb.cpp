#include "tailor/mannequin/glb.hpp"

#include <algorithm>
#include <bit>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace taut::tailor {
namespace {

using Json = nlohmann::ordered_json;

// Constants of the glTF 2.0 specification.
constexpr int type_byte = 5121;
constexpr int type_short = 5123;
constexpr int type_float = 5126;
constexpr int target_vertices = 34962;
constexpr int target_indices = 34963;

class Buffer {
 public:
  void put(std::uint32_t number, int bytes) {
    for (int i = 0; i < bytes; ++i) {
      bytes_.push_back(static_cast<std::uint8_t>(number >> (8 * i)));
    }
  }
  void put(float number) { put(std::bit_cast<std::uint32_t>(number), 4); }
  void put(const Vec3& v) {
    for (int axis = 0; axis < 3; ++axis) {
      put(static_cast<float>(v[axis]));
    }
  }
  void pad(std::uint8_t with) { bytes_.resize((bytes_.size() + 3) / 4 * 4, with); }
  void append(const std::vector<std::uint8_t>& more) {
    bytes_.insert(bytes_.end(), more.begin(), more.end());
  }
  std::size_t size() const { return bytes_.size(); }
  std::vector<std::uint8_t>& bytes() { return bytes_; }

 private:
  std::vector<std::uint8_t> bytes_;
};

/// Writes the data of accessors, each with its own view.
class Accessors {
 public:
  template <class Write>
  std::size_t add(int type, const char* shape, std::size_t count, int target, Write&& write) {
    const std::size_t start = data.size();
    write(data);
    data.pad(0);
    Json view = {{"buffer", 0}, {"byteOffset", start}, {"byteLength", data.size() - start}};
    if (target != 0) {
      view["target"] = target;
    }
    views.push_back(view);
    list.push_back(
        {{"bufferView", views.size() - 1}, {"componentType", type}, {"count", count}, {"type", shape}});
    return list.size() - 1;
  }

  Buffer data;
  Json views = Json::array();
  Json list = Json::array();
};

Json round_to_json(const Vec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

std::vector<Vec3> normals(const sim::Mesh& mesh) {
  std::vector<Vec3> result(mesh.positions.size(), Vec3(0.0));
  for (const sim::Triangle& t : mesh.triangles) {
    for (const sim::Index v : t) {
      result[v] += sim::doubled_area_vector(mesh.positions, t);
    }
  }
  for (Vec3& normal : result) {
    normal = glm::normalize(normal);
  }
  return result;
}

Json add_mesh(Accessors& accessors, const std::string& name, const sim::Mesh& mesh,
              const std::vector<VertexWeights>& weights) {
  const auto vectors = [&](const std::vector<Vec3>& list) {
    return accessors.add(type_float, "VEC3", list.size(), target_vertices, [&](Buffer& data) {
      std::for_each(list.begin(), list.end(), [&data](const Vec3& v) { data.put(v); });
    });
  };
  const std::size_t positions = vectors(mesh.positions);
  Vec3 low = mesh.positions.front();
  Vec3 high = low;
  for (const Vec3& p : mesh.positions) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  accessors.list[positions]["min"] = round_to_json(low);
  accessors.list[positions]["max"] = round_to_json(high);
  const std::size_t directions = vectors(normals(mesh));
  const std::size_t joints =
      accessors.add(type_byte, "VEC4", weights.size(), target_vertices, [&](Buffer& data) {
        for (const VertexWeights& w : weights) {
          std::for_each(w.joints.begin(), w.joints.end(),
                        [&data](std::uint8_t joint) { data.put(joint, 1); });
        }
      });
  const std::size_t amounts =
      accessors.add(type_float, "VEC4", weights.size(), target_vertices, [&](Buffer& data) {
        for (const VertexWeights& w : weights) {
          std::for_each(w.weights.begin(), w.weights.end(), [&data](float weight) { data.put(weight); });
        }
      });
  const std::size_t indices =
      accessors.add(type_short, "SCALAR", 3 * mesh.triangles.size(), target_indices, [&](Buffer& data) {
        for (const sim::Triangle& t : mesh.triangles) {
          std::for_each(t.begin(), t.end(), [&data](sim::Index v) { data.put(v, 2); });
        }
      });
  const Json attributes = {
      {"POSITION", positions}, {"NORMAL", directions}, {"JOINTS_0", joints}, {"WEIGHTS_0", amounts}};
  // Makes the array of one explicitly, because compilers disagree about a braced list of one.
  const Json primitive = {{"attributes", attributes}, {"indices", indices}};
  return {{"name", name}, {"primitives", Json::array({primitive})}};
}

std::size_t add_inverse_binds(Accessors& accessors, const Body& body) {
  return accessors.add(type_float, "MAT4", body.joints.size(), 0, [&](Buffer& data) {
    for (const Joint& joint : body.joints) {
      for (int column = 0; column < 4; ++column) {
        data.put(column < 3 ? Vec3(column == 0, column == 1, column == 2) : -joint.place_m);
        data.put(column < 3 ? 0.0F : 1.0F);
      }
    }
  });
}

Json make_nodes(const std::string& name, const Body& body) {
  Json nodes = Json::array();
  nodes.push_back({{"name", name}, {"mesh", 0}, {"skin", 0}});
  for (const Joint& joint : body.joints) {
    const auto parent = static_cast<std::size_t>(std::max(joint.parent, 0));
    const Vec3 from = joint.parent < 0 ? Vec3(0.0) : body.joints[parent].place_m;
    nodes.push_back({{"name", joint.name}, {"translation", round_to_json(joint.place_m - from)}});
    if (joint.parent >= 0) {
      nodes[parent + 1]["children"].push_back(nodes.size() - 1);
    }
  }
  return nodes;
}

void put_chunk(Buffer& file, const char* kind, const std::vector<std::uint8_t>& content) {
  file.put(static_cast<std::uint32_t>(content.size()), 4);
  std::for_each(kind, kind + 4, [&file](char c) { file.put(static_cast<std::uint8_t>(c), 1); });
  file.append(content);
}

}  // namespace

std::vector<std::uint8_t> make_glb(const std::string& name, const std::string& origin, const Body& body,
                                   const sim::Mesh& mesh, const std::vector<VertexWeights>& weights) {
  if (mesh.positions.size() > 65535) {
    throw std::runtime_error(name + " has more than 65535 vertices");
  }
  Accessors accessors;
  Json gltf;
  gltf["asset"] = {{"version", "2.0"}, {"generator", "make_mannequins"}, {"copyright", origin}};
  gltf["scene"] = 0;
  Json scene;
  scene["nodes"] = {0, 1};
  gltf["scenes"] = Json::array({scene});
  gltf["nodes"] = make_nodes(name, body);
  gltf["meshes"] = Json::array({add_mesh(accessors, name, mesh, weights)});
  Json joints = Json::array();
  for (std::size_t j = 0; j < body.joints.size(); ++j) {
    joints.push_back(j + 1);
  }
  const Json skin = {
      {"inverseBindMatrices", add_inverse_binds(accessors, body)}, {"skeleton", 1}, {"joints", joints}};
  gltf["skins"] = Json::array({skin});
  gltf["accessors"] = accessors.list;
  gltf["bufferViews"] = accessors.views;
  const Json buffer = {{"byteLength", accessors.data.size()}};
  gltf["buffers"] = Json::array({buffer});

  const std::string text = gltf.dump();
  Buffer json;
  json.append({text.begin(), text.end()});
  json.pad(' ');
  Buffer file;
  put_chunk(file, "JSON", json.bytes());
  put_chunk(file, "BIN\0", accessors.data.bytes());
  Buffer whole;
  whole.bytes() = {'g', 'l', 'T', 'F'};
  whole.put(2, 4);
  whole.put(static_cast<std::uint32_t>(file.size() + 12), 4);
  whole.append(file.bytes());
  return whole.bytes();
}

}  // namespace taut::tailor
