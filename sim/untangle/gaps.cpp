#include "sim/untangle/gaps.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "sim/mesh/extent.hpp"
#include "sim/solvers/bounded/contact/near_pairs.hpp"

namespace taut::sim {
namespace {

using namespace bounded;

bool are_joined(const Adjacency& adjacency, Index v, Index w) {
  const std::span<const Index> edges = adjacency.vertex_edges[v];
  return std::any_of(edges.begin(), edges.end(),
                     [&](Index e) { return other_end(adjacency.edges[e], v) == w; });
}

bool are_joined(const Adjacency& adjacency, const NearPair& pair) {
  for (std::size_t i = 0; i < pair.first_count; ++i) {
    for (std::size_t j = pair.first_count; j < 4; ++j) {
      if (are_joined(adjacency, pair.rows[i], pair.rows[j])) {
        return true;
      }
    }
  }
  return false;
}

/// Where they are nearest is found in single precision, and how near that is in double precision.
Gap gap_of(const NearPair& pair, const Vec3& middle, std::span<const Vec3> positions_m) {
  std::array<glm::vec3, 4> corners;
  for (std::size_t k = 0; k < 4; ++k) {
    corners[k] = glm::vec3(positions_m[pair.rows[k]] - middle);
  }
  const ClosestWeights weights = closest_weights(pair, corners);
  Gap gap{.vertices = pair.rows};
  for (std::size_t k = 0; k < 4; ++k) {
    gap.weights[k] = k < pair.first_count ? weights[k] : -weights[k];
    gap.apart += gap.weights[k] * (positions_m[pair.rows[k]] - middle);
  }
  gap.width_m = glm::length(gap.apart);
  gap.apart = gap.width_m > 0.0 ? gap.apart / gap.width_m : gap.apart;
  return gap;
}

}  // namespace

std::vector<Gap> find_gaps(const Garment& garment, double width_m, double joined_width_m,
                           std::span<const Vec3> positions_m) {
  const Extent extent = extent_of(positions_m);
  const Vec3 middle = extent.middle();
  Float4Array rows;
  for (const Vec3& position_m : positions_m) {
    rows.push_back(float4_of(position_m - middle));
  }
  const std::vector<float> radii(rows.size(), static_cast<float>(0.5 * width_m));
  ParallelKernels kernels(kernels_for(VectorUnit::best), 1);
  NearPairs near(make_contact_mesh(garment.mesh.triangles, {}), true, positions_m);
  std::vector<Gap> gaps;
  for (const NearPair& pair : near.find(rows, Float4Array(rows.size()), radii, kernels)) {
    const double wide_m = are_joined(garment.adjacency, pair) ? joined_width_m : width_m;
    const Gap gap = gap_of(pair, middle, positions_m);
    if (gap.width_m > 0.0 && gap.width_m < wide_m) {
      gaps.push_back(gap);
    }
  }
  return gaps;
}

}  // namespace taut::sim
