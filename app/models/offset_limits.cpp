#include "app/models/offset_limits.hpp"

namespace taut::app {
namespace {

/// A share of the mean edge. Two that reach further meet across one triangle of flat cloth, whose height is 0.87 edges.
constexpr double furthest_reach = 0.4;
/// Below this share layers nearly touch or cross as they were modelled, and followers cannot keep to that.
constexpr float least_share_at_rest = 0.5F;

double mean_edge_m(const sim::Mesh& mesh) {
  double sum_m = 0.0;
  for (const sim::Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      sum_m += glm::distance(mesh.positions[t[k]], mesh.positions[t[(k + 1) % 3]]);
    }
  }
  return sum_m / (3.0 * static_cast<double>(mesh.triangles.size()));
}

std::vector<float> reaches_of(std::span<const Bond> bonds, const sim::Mesh& simulated) {
  const auto furthest_m = static_cast<float>(furthest_reach * mean_edge_m(simulated));
  std::vector<float> reach_m(simulated.positions.size(), 0.0F);
  for (const Bond& bond : bonds) {
    const float offset_m = std::min(static_cast<float>(glm::length(bond.offset_m)), furthest_m);
    for (const sim::Index v : simulated.triangles[bond.triangle]) reach_m[v] = std::max(reach_m[v], offset_m);
  }
  return reach_m;
}

}  // namespace

OffsetLimits::OffsetLimits(std::span<const Bond> bonds, const sim::Mesh& simulated)
    : reach_m_(reaches_of(bonds, simulated)), clearances_(simulated.triangles, {}, true, simulated.positions) {
  const std::span<const float> shares = clearances_.find_shares(simulated.positions, reach_m_);
  at_rest_.assign(shares.begin(), shares.end());
  std::replace_if(
      at_rest_.begin(), at_rest_.end(), [](float share) { return share < least_share_at_rest; }, 1.0F);
}

std::vector<float> OffsetLimits::shares(std::span<const Bond> bonds, std::span<const sim::Vec3> positions_m,
                                        std::span<const sim::Triangle> triangles) const {
  const std::lock_guard lock(mutex_);
  const std::span<const float> found = clearances_.find_shares(positions_m, reach_m_);
  const auto at_vertex = [&](sim::Index v) { return std::min(found[v] / at_rest_[v], 1.0F); };
  std::vector<float> shares;
  shares.reserve(bonds.size());
  for (const Bond& bond : bonds) {
    const auto& [a, b, c] = triangles[bond.triangle];
    const auto& [u, v, w] = bond.weights;
    shares.push_back(static_cast<float>(u * at_vertex(a) + v * at_vertex(b) + w * at_vertex(c)));
  }
  return shares;
}

}  // namespace taut::app
