#include "mannequin/body_file.hpp"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <glm/geometric.hpp>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace taut::test {
namespace {

using nlohmann::json;

/// A glTF binary: its JSON, and the numbers of each accessor as the file stores them.
class Glb {
 public:
  explicit Glb(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    bytes_.assign(std::istreambuf_iterator<char>(stream), {});
    if (bytes_.size() < 28 || bytes_.compare(0, 4, "glTF") != 0 || word(4) != 2 || word(8) != bytes_.size()) {
      throw std::runtime_error(file.string() + " is no glTF 2.0 binary of the length it says");
    }
    const std::size_t text = word(12);
    root = json::parse(bytes_.substr(20, text));
    data_ = 28 + text;
  }

  template <class Number>
  std::vector<Number> numbers(std::size_t accessor, std::size_t in_each, int type) const {
    const json& a = root.at("accessors").at(accessor);
    if (a.at("componentType") != type) {
      throw std::runtime_error("accessor " + std::to_string(accessor) + " has another type");
    }
    const json& view = root.at("bufferViews").at(a.at("bufferView").get<std::size_t>());
    std::vector<Number> result(a.at("count").get<std::size_t>() * in_each);
    const std::size_t start = data_ + view.at("byteOffset").get<std::size_t>();
    if (start + result.size() * sizeof(Number) > bytes_.size()) {
      throw std::runtime_error("accessor " + std::to_string(accessor) + " goes beyond the file");
    }
    std::memcpy(result.data(), bytes_.data() + start, result.size() * sizeof(Number));
    return result;
  }

  json root;

 private:
  std::uint32_t word(std::size_t at) const {
    std::uint32_t result = 0;
    std::memcpy(&result, bytes_.data() + at, 4);
    return result;
  }

  std::string bytes_;
  std::size_t data_ = 0;
};

void read_mesh(const Glb& glb, BodyFile& body) {
  const json& primitive = glb.root.at("meshes").at(0).at("primitives").at(0);
  const json& attributes = primitive.at("attributes");
  const auto positions = glb.numbers<float>(attributes.at("POSITION"), 3, 5126);
  const auto joints = glb.numbers<std::uint8_t>(attributes.at("JOINTS_0"), 4, 5121);
  const auto weights = glb.numbers<float>(attributes.at("WEIGHTS_0"), 4, 5126);
  for (std::size_t v = 0; v < positions.size() / 3; ++v) {
    body.mesh.positions.emplace_back(positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]);
    body.joints.push_back({joints[4 * v], joints[4 * v + 1], joints[4 * v + 2], joints[4 * v + 3]});
    body.weights.push_back({weights[4 * v], weights[4 * v + 1], weights[4 * v + 2], weights[4 * v + 3]});
  }
  const auto indices = glb.numbers<std::uint16_t>(primitive.at("indices"), 1, 5123);
  for (std::size_t t = 0; t + 2 < indices.size(); t += 3) {
    body.mesh.triangles.push_back({indices[t], indices[t + 1], indices[t + 2]});
  }
}

void read_skin(const Glb& glb, BodyFile& body) {
  const json& skin = glb.root.at("skins").at(0);
  const json& nodes = glb.root.at("nodes");
  const std::vector<std::size_t> joints = skin.at("joints");
  const auto inverse_binds = glb.numbers<float>(skin.at("inverseBindMatrices"), 16, 5126);
  for (std::size_t j = 0; j < joints.size(); ++j) {
    body.names.push_back(nodes.at(joints[j]).at("name"));
    body.parents.push_back(-1);
    for (std::size_t i = 0; i < joints.size(); ++i) {
      const std::vector<std::size_t> children =
          nodes.at(joints[i]).value("children", std::vector<std::size_t>());
      body.parents[j] = std::find(children.begin(), children.end(), joints[j]) != children.end()
                            ? static_cast<int>(i)
                            : body.parents[j];
    }
    const std::vector<double> from = nodes.at(joints[j]).at("translation");
    const sim::Vec3 parent =
        body.parents[j] < 0 ? sim::Vec3(0.0) : body.places.at(static_cast<std::size_t>(body.parents[j]));
    body.places.push_back(parent + sim::Vec3(from[0], from[1], from[2]));
    const float* bind = &inverse_binds[16 * j];
    if (glm::length(body.places[j] + sim::Vec3(bind[12], bind[13], bind[14])) > 1e-6) {
      throw std::runtime_error(body.names[j] + " is not where its inverse bind matrix says");
    }
  }
}

}  // namespace

std::size_t BodyFile::joint(const std::string& name) const {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    throw std::runtime_error("no joint " + name);
  }
  return static_cast<std::size_t>(found - names.begin());
}

BodyFile read_body(const std::filesystem::path& file) {
  const Glb glb(file);
  BodyFile body;
  read_mesh(glb, body);
  read_skin(glb, body);
  return body;
}

}  // namespace taut::test
