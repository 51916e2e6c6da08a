#include "app/models/obj_writing.hpp"

#include <fmt/format.h>

#include <cassert>
#include <iterator>

namespace taut::app {

std::string obj_text(const sim::Mesh& mesh, std::span<const sim::Vec3> positions, std::string text,
                     const std::string& number) {
  assert(positions.size() == mesh.positions.size());
  auto end = std::back_inserter(text);
  const std::string line = "v " + number + ' ' + number + ' ' + number + '\n';
  for (const sim::Vec3& p : positions) {
    fmt::format_to(end, fmt::runtime(line), p.x, p.y, p.z);
  }
  // Grid cells stay quads, so that the file maps to the same edges.
  for (const sim::Quad& q : mesh.quads) {
    fmt::format_to(end, "f {} {} {} {}\n", q[0] + 1, q[1] + 1, q[2] + 1, q[3] + 1);
  }
  for (std::size_t t = 2 * mesh.quads.size(); t < mesh.triangles.size(); ++t) {
    const sim::Triangle& corners = mesh.triangles[t];
    fmt::format_to(end, "f {} {} {}\n", corners[0] + 1, corners[1] + 1, corners[2] + 1);
  }
  return text;
}

}  // namespace taut::app
