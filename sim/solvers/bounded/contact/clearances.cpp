#include "sim/solvers/bounded/contact/clearances.hpp"

#include <algorithm>

#include "sim/mesh/extent.hpp"

namespace taut::sim::bounded {

Clearances::Clearances(std::span<const Triangle> cloth, std::span<const Triangle> bodies, bool within_cloth,
                       std::span<const Vec3> positions_m)
    : near_(make_contact_mesh(cloth, bodies), within_cloth, positions_m),
      kernels_(kernels_for(VectorUnit::best), 1),
      moves_(positions_m.size()) {}

std::span<const float> Clearances::find(std::span<const Vec3> positions_m, float most_m) {
  const Vec3 middle = extent_of(positions_m).middle();
  rows_.clear();
  for (const Vec3& position_m : positions_m) {
    rows_.push_back(float4_of(position_m - middle));
  }
  radii_.assign(rows_.size(), 0.5F * most_m);
  clearances_m_.assign(rows_.size(), most_m);
  for (const NearPair& pair : near_.find(rows_, moves_, radii_, kernels_)) {
    const float distance_m = distance_between(pair, {vec(rows_[pair.rows[0]]), vec(rows_[pair.rows[1]]),
                                                     vec(rows_[pair.rows[2]]), vec(rows_[pair.rows[3]])});
    for (const Index row : pair.rows) {
      clearances_m_[row] = std::min(clearances_m_[row], distance_m);
    }
  }
  return clearances_m_;
}

}  // namespace taut::sim::bounded
