#include "app/models/offset_limits.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

namespace taut::app {
namespace {

/// A share of the mean edge: a vertex that reaches further would meet its own neighbours in flat cloth.
constexpr double furthest_reach = 0.25;
/// Below this share layers touch or cross as they were modelled, and followers cannot keep to that.
constexpr float least_share_at_rest = 0.1F;

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
    for (const sim::Index v : simulated.triangles[bond.triangle]) {
      reach_m[v] = std::max(reach_m[v], offset_m);
    }
  }
  return reach_m;
}

}  // namespace

OffsetLimits::OffsetLimits(std::span<const Bond> bonds, const sim::Mesh& simulated)
    : reach_m_(reaches_of(bonds, simulated)), clearances_(simulated.triangles, {}, true, simulated.positions) {
  const std::span<const float> shares = clearances_.find_shares(simulated.positions, reach_m_);
  at_rest_.assign(shares.begin(), shares.end());
  std::replace_if(at_rest_.begin(), at_rest_.end(), [](float share) { return share < least_share_at_rest; }, 1.0F);
}

std::vector<float> OffsetLimits::shares(std::span<const sim::Vec3> positions_m) const {
  const std::lock_guard lock(mutex_);
  const std::span<const float> found = clearances_.find_shares(positions_m, reach_m_);
  std::vector<float> shares(found.begin(), found.end());
  for (std::size_t v = 0; v < shares.size(); ++v) {
    shares[v] = std::min(shares[v] / at_rest_[v], 1.0F);
  }
  return shares;
}

}  // namespace taut::app
