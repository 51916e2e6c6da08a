#include "app/models/outside.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

#include "sim/mesh/groups.hpp"

namespace taut::app {
namespace {

// The sum of an open surface's normals along the way from its middle, as a share of that sum if all pointed
// away. Collars and cuffs that are turned down point inwards, so it is far from -1.
constexpr double faces_inwards = -0.5;

/// Triangles that are connected across edges with two triangles. Across others none of the sides is the same.
sim::Groups surfaces_of(const sim::Mesh& mesh, const sim::Adjacency& adjacency) {
  sim::Groups surfaces(mesh.triangles.size());
  for (std::size_t e = 0; e < adjacency.edges.size(); ++e) {
    const auto pair = adjacency.edge_triangles[e];
    if (pair.size() == 2) {
      surfaces.join(pair[0], pair[1]);
    }
  }
  return surfaces;
}

struct Facing {
  double outwards = 0.0;  ///< the sum over the triangles, 6 times the volume where the surface is closed
  double all = 0.0;       ///< the sum of the amounts
};

}  // namespace

std::size_t turn_outside_out(std::span<const GarmentPart> parts, const sim::Adjacency& adjacency,
                             sim::Mesh& mesh) {
  sim::Groups surfaces = surfaces_of(mesh, adjacency);
  std::size_t turned = 0;
  for (const GarmentPart& part : parts) {
    if (part.openings.size() == 1) {
      continue;
    }
    std::map<sim::Index, Facing> facings;
    for (const sim::Index t : part.triangles) {
      const sim::Vec3 out = mesh.positions[mesh.triangles[t][0]] - part.centre_m;
      const double outwards = glm::dot(sim::doubled_area_vector(mesh.positions, mesh.triangles[t]), out);
      Facing& facing = facings[surfaces.find(t)];
      facing.outwards += outwards;
      facing.all += std::abs(outwards);
    }
    const double limit = part.openings.empty() && facings.size() == 1 ? 0.0 : faces_inwards;
    for (const sim::Index t : part.triangles) {
      const Facing& facing = facings[surfaces.find(t)];
      if (facing.outwards < limit * facing.all) {
        std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
        ++turned;
      }
    }
  }
  return turned;
}

}  // namespace taut::app
