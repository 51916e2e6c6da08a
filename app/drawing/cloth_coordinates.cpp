#include "app/drawing/cloth_coordinates.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/drawing/framing.hpp"
#include "app/drawing/mesh_arrays.hpp"
#include "renderer/surface/refined_mesh.hpp"
#include "renderer/surface/seams.hpp"
#include "sim/mesh/groups.hpp"
#include "sim/mesh/mesh.hpp"

namespace taut::app {
namespace {

sim::Groups pieces_of(const sim::Garment& garment, std::span<const glm::vec2> corner_uv) {
  const std::vector<std::uint32_t> triangles = flat(garment.mesh.triangles);
  const std::vector<renderer::VertexPair> seams =
      renderer::seam_edges(to_float(garment.mesh.positions), triangles, corner_uv);
  const std::vector<renderer::TriangleSide> sides = renderer::sorted_sides(triangles);
  sim::Groups pieces(garment.mesh.triangles.size());
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    if (sides[i].ends == sides[i + 1].ends &&
        !std::binary_search(seams.begin(), seams.end(), sides[i].ends)) {
      pieces.join(sides[i].number / 3, sides[i + 1].number / 3);
    }
  }
  return pieces;
}

struct Areas {
  double in_m2 = 0.0;
  double in_uv = 0.0;  ///< below 0: mirrored
};

}  // namespace

std::vector<glm::vec2> cloth_coordinates(const sim::Garment& garment, std::span<const glm::vec2> corner_uv) {
  if (corner_uv.empty()) {
    return {};
  }
  const sim::Mesh& mesh = garment.mesh;
  sim::Groups pieces = pieces_of(garment, corner_uv);
  std::vector<Areas> areas(mesh.triangles.size());
  for (sim::Index t = 0; t < mesh.triangles.size(); ++t) {
    const glm::dvec2 a(corner_uv[3 * t]);
    const glm::dvec2 ab = glm::dvec2(corner_uv[3 * t + 1]) - a, ac = glm::dvec2(corner_uv[3 * t + 2]) - a;
    Areas& own = areas[pieces.find(t)];
    own.in_m2 += 0.5 * glm::length(sim::doubled_area_vector(mesh.positions, mesh.triangles[t]));
    own.in_uv += 0.5 * (ab.x * ac.y - ab.y * ac.x);
  }
  std::vector<glm::vec2> coordinates;
  coordinates.reserve(corner_uv.size());
  for (sim::Index t = 0; t < mesh.triangles.size(); ++t) {
    const Areas& own = areas[pieces.find(t)];
    const double scale = std::sqrt(own.in_m2 / std::abs(own.in_uv));
    if (!std::isfinite(scale)) {
      return {};
    }
    for (std::size_t corner = 3 * t; corner < 3 * t + 3; ++corner) {
      coordinates.emplace_back(std::copysign(scale, own.in_uv) * corner_uv[corner].x,
                               scale * corner_uv[corner].y);
    }
  }
  return coordinates;
}

}  // namespace taut::app
