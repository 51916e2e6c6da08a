#include "gltf_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <nlohmann/json.hpp>

namespace taut::test {
namespace {

using Json = nlohmann::json;

std::string base64(const std::string& bytes) {
  constexpr const char* letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned bits = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      bits = bits << 8U | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k <= bytes.size() ? letters[bits >> (18U - 6U * k) & 63U] : '=';
    }
  }
  return text;
}

constexpr int float_type = 5126;
constexpr int index_type = 5125;
constexpr int short_type = 5123;

class Writer {
 public:
  explicit Writer(const GltfModel& model) : model_(model) {}

  std::string write() {
    json_["asset"] = {{"version", "2.0"}};
    const auto mesh_node = static_cast<int>(model_.joints.size());
    add_mesh();
    for (const auto& joint : model_.joints) {
      json_["nodes"].push_back(
          {{"name", joint.name},
           {"translation", {joint.translation.x, joint.translation.y, joint.translation.z}},
           {"rotation", joint.rotation}});
    }
    json_["nodes"].push_back({{"name", "surface"}, {"mesh", 0}});
    Json roots = {mesh_node};
    for (int j = 0; j < mesh_node; ++j) {
      const int parent = model_.joints[static_cast<std::size_t>(j)].parent;
      (parent < 0 ? roots : json_["nodes"][static_cast<std::size_t>(parent)]["children"]).push_back(j);
    }
    json_["scenes"] = {{{"nodes", roots}}};
    json_["scene"] = 0;
    if (!model_.weights.empty()) {
      add_skin(static_cast<std::size_t>(mesh_node));
    }
    for (const GltfModel::Clip& clip : model_.clips) {
      add_clip(clip, mesh_node);
    }
    json_["buffers"] = {
        {{"byteLength", bytes_.size()}, {"uri", "data:application/octet-stream;base64," + base64(bytes_)}}};
    return json_.dump();
  }

 private:
  template <class T>
  int add(const std::vector<T>& values, std::size_t count, int type, const char* shape, Json more = {}) {
    bytes_.append((4 - bytes_.size() % 4) % 4, '\0');
    json_["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", values.size() * sizeof(T)}});
    bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
    Json accessor = {{"bufferView", json_["bufferViews"].size() - 1},
                     {"componentType", type},
                     {"count", count},
                     {"type", shape}};
    accessor.update(more.is_null() ? Json::object() : more);
    json_["accessors"].push_back(accessor);
    return static_cast<int>(json_["accessors"].size()) - 1;
  }

  int add_places(const std::vector<sim::Vec3>& places) {
    std::vector<float> values;
    sim::Vec3 low(1e9);
    sim::Vec3 high(-1e9);
    for (const sim::Vec3& place : places) {
      for (int axis = 0; axis < 3; ++axis) {
        values.push_back(static_cast<float>(place[axis]));
        low[axis] = std::min(low[axis], place[axis]);
        high[axis] = std::max(high[axis], place[axis]);
      }
    }
    return add(values, places.size(), float_type, "VEC3",
               {{"min", {low.x, low.y, low.z}}, {"max", {high.x, high.y, high.z}}});
  }

  void add_mesh() {
    std::vector<std::uint32_t> corners;
    for (const sim::Triangle& t : model_.triangles) {
      corners.insert(corners.end(), t.begin(), t.end());
    }
    Json primitive = {{"attributes", {{"POSITION", add_places(model_.positions)}}},
                      {"indices", add(corners, corners.size(), index_type, "SCALAR")}};
    if (!model_.weights.empty()) {
      std::vector<std::uint16_t> joints;
      std::vector<float> weights;
      for (const auto& vertex : model_.weights) {
        for (std::size_t k = 0; k < 4; ++k) {
          joints.push_back(k < vertex.size() ? static_cast<std::uint16_t>(vertex[k].first) : 0U);
          weights.push_back(k < vertex.size() ? vertex[k].second : 0.0F);
        }
      }
      primitive["attributes"]["JOINTS_0"] = add(joints, model_.weights.size(), short_type, "VEC4");
      primitive["attributes"]["WEIGHTS_0"] = add(weights, model_.weights.size(), float_type, "VEC4");
    }
    for (const auto& target : model_.targets) {
      primitive["targets"].push_back({{"POSITION", add_places(target)}});
    }
    json_["meshes"] = {{{"name", "tube"}, {"primitives", {primitive}}}};
  }

  void add_skin(std::size_t mesh_node) {
    std::vector<glm::dmat4> to_model;
    std::vector<float> inverse;
    Json joints;
    for (const auto& joint : model_.joints) {
      const auto& [x, y, z, w] = joint.rotation;
      glm::dmat4 transform = glm::mat4_cast(glm::dquat(w, x, y, z));
      transform[3] = glm::dvec4(joint.translation, 1.0);
      to_model.push_back(joint.parent < 0 ? transform
                                          : to_model[static_cast<std::size_t>(joint.parent)] * transform);
      const glm::dmat4 binding = glm::inverse(to_model.back());
      for (int k = 0; k < 16; ++k) {
        inverse.push_back(static_cast<float>(binding[k / 4][k % 4]));
      }
      joints.push_back(joints.size());
    }
    json_["skins"] = {{{"joints", joints},
                       {"inverseBindMatrices", add(inverse, model_.joints.size(), float_type, "MAT4")}}};
    json_["nodes"][mesh_node]["skin"] = 0;
  }

  void add_clip(const GltfModel::Clip& clip, int mesh_node) {
    Json animation = {{"name", clip.name}, {"channels", Json::array()}, {"samplers", Json::array()}};
    for (const GltfModel::Channel& channel : clip.channels) {
      const std::vector<float>& times = channel.times_s;
      const bool is_weights = channel.path == "weights";
      const std::size_t width = is_weights ? 1 : channel.path == "rotation" ? 4 : 3;
      const int input =
          add(times, times.size(), float_type, "SCALAR", {{"min", {times.front()}}, {"max", {times.back()}}});
      const int output = add(channel.values, channel.values.size() / width, float_type,
                             is_weights                   ? "SCALAR"
                             : channel.path == "rotation" ? "VEC4"
                                                          : "VEC3");
      animation["channels"].push_back(
          {{"sampler", animation["samplers"].size()},
           {"target", {{"node", is_weights ? mesh_node : channel.joint}, {"path", channel.path}}}});
      animation["samplers"].push_back({{"input", input}, {"output", output}});
    }
    json_["animations"].push_back(animation);
  }

  const GltfModel& model_;
  Json json_;
  std::string bytes_;
};

}  // namespace

std::string gltf_text(const GltfModel& model) {
  return Writer(model).write();
}

GltfModel tube() {
  constexpr sim::Index around = 8;
  constexpr sim::Index rings = 9;
  GltfModel model;
  for (sim::Index ring = 0; ring < rings; ++ring) {
    for (sim::Index k = 0; k < around; ++k) {
      const double angle = 2.0 * 3.14159265358979 * k / around;
      // The coordinates are exact in single precision, so the file rounds nothing.
      model.positions.emplace_back(static_cast<float>(0.2 * std::cos(angle)), 0.25 * ring,
                                   static_cast<float>(0.2 * std::sin(angle)));
    }
  }
  model.positions.emplace_back(0.0, 0.0, 0.0);
  model.positions.emplace_back(0.0, 2.0, 0.0);
  const auto at = [](sim::Index ring, sim::Index k) { return ring * around + k % around; };
  for (sim::Index k = 0; k < around; ++k) {
    for (sim::Index ring = 0; ring + 1 < rings; ++ring) {
      model.triangles.push_back({at(ring, k), at(ring + 1, k), at(ring + 1, k + 1)});
      model.triangles.push_back({at(ring, k), at(ring + 1, k + 1), at(ring, k + 1)});
    }
    model.triangles.push_back({rings * around, at(0, k), at(0, k + 1)});
    model.triangles.push_back({rings * around + 1, at(rings - 1, k + 1), at(rings - 1, k)});
  }
  const double half = std::sqrt(0.5);
  model.joints = {
      {"Hips", -1, {0, 1, 0}}, {"Spine", 0, {0, 0.5, 0}, {0, half, 0, half}}, {"LeftFoot", 0, {0, -1, 0}}};
  for (const sim::Vec3& p : model.positions) {
    const auto y = static_cast<float>(p.y);
    const float upper = std::clamp(2.0F * (y - 1.0F), 0.0F, 1.0F);
    model.weights.push_back(y < 1.0F ? std::vector<std::pair<int, float>>{{2, 1.0F - y}, {0, y}}
                                     : std::vector<std::pair<int, float>>{{0, 1.0F - upper}, {1, upper}});
  }
  return model;
}

}  // namespace taut::test
