#include "app/output/obj_export.hpp"

#include <fmt/format.h>

#include <cassert>
#include <iterator>

namespace taut::app {

std::string obj_text(const sim::Mesh& mesh, std::span<const sim::Vec3> positions) {
  assert(positions.size() == mesh.positions.size());
  std::string text = "# Taut; metres, y up\n";
  auto end = std::back_inserter(text);
  for (const sim::Vec3& p : positions) {
    fmt::format_to(end, "v {} {} {}\n", p.x, p.y, p.z);
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
