#include "app/models/obj_writing.hpp"

#include <fmt/format.h>

#include <cassert>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

namespace taut::app {
namespace {

/// Writes each pair of coordinates where it is first used. Returns, per corner, which it has, counted from 1.
std::vector<std::size_t> put_texture_vertices(std::span<const glm::vec2> corner_uv, const std::string& number,
                                              std::string& text) {
  const std::string line = "vt " + number + ' ' + number + '\n';
  std::map<std::string, std::size_t> known;
  std::vector<std::size_t> vertices;
  for (const glm::vec2& uv : corner_uv) {
    std::string written = fmt::format(fmt::runtime(line), uv.x, uv.y);
    const auto [place, is_new] = known.try_emplace(std::move(written), known.size() + 1);
    text += is_new ? place->first : "";
    vertices.push_back(place->second);
  }
  return vertices;
}

}  // namespace

std::string obj_text(const sim::Mesh& mesh, std::span<const sim::Vec3> positions,
                     std::span<const glm::vec2> corner_uv, std::string text, const std::string& number) {
  assert(positions.size() == mesh.positions.size());
  assert(corner_uv.empty() || (mesh.quads.empty() && corner_uv.size() == 3 * mesh.triangles.size()));
  auto end = std::back_inserter(text);
  const std::string line = "v " + number + ' ' + number + ' ' + number + '\n';
  for (const sim::Vec3& p : positions) {
    fmt::format_to(end, fmt::runtime(line), p.x, p.y, p.z);
  }
  const std::vector<std::size_t> texture_vertices = put_texture_vertices(corner_uv, number, text);
  // Grid cells stay quads, so that the file maps to the same edges.
  for (const sim::Quad& q : mesh.quads) {
    fmt::format_to(end, "f {} {} {} {}\n", q[0] + 1, q[1] + 1, q[2] + 1, q[3] + 1);
  }
  for (std::size_t t = 2 * mesh.quads.size(); t < mesh.triangles.size(); ++t) {
    const sim::Triangle& corners = mesh.triangles[t];
    text += 'f';
    for (std::size_t k = 0; k < 3; ++k) {
      fmt::format_to(end, " {}", corners[k] + 1);
      if (!texture_vertices.empty()) {
        fmt::format_to(end, "/{}", texture_vertices[3 * t + k]);
      }
    }
    text += '\n';
  }
  return text;
}

}  // namespace taut::app
