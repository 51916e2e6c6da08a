#include "garment_file.hpp"

#include <toml++/toml.h>

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace taut::test {

sim::Mesh read_obj(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) {
    throw std::runtime_error(file.string() + " cannot be read");
  }
  sim::Mesh mesh;
  std::string line;
  while (std::getline(in, line)) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "v") {
      sim::Vec3 p;
      words >> p.x >> p.y >> p.z;
      mesh.positions.push_back(p);
    } else if (kind == "f") {
      sim::Triangle t;
      words >> t[0] >> t[1] >> t[2];
      mesh.triangles.push_back({t[0] - 1, t[1] - 1, t[2] - 1});
    } else if (!kind.starts_with("#")) {
      throw std::runtime_error(file.string() + ": unexpected line: " + line);
    }
    std::string rest;
    if (!words && !kind.starts_with("#")) {
      throw std::runtime_error(file.string() + ": malformed line: " + line);
    }
    if (!kind.starts_with("#") && words >> rest) {
      throw std::runtime_error(file.string() + ": too much on the line: " + line);
    }
  }
  return mesh;
}

std::map<std::string, std::vector<sim::Index>> read_landmarks(const std::filesystem::path& file) {
  std::map<std::string, std::vector<sim::Index>> landmarks;
  for (const auto& [name, value] : toml::parse_file(file.string())) {
    for (const toml::node& vertex : *value.as_array()) {
      landmarks[std::string(name.str())].push_back(
          static_cast<sim::Index>(vertex.value<std::int64_t>().value()));
    }
  }
  return landmarks;
}

}  // namespace taut::test
