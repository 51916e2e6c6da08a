#include "sim/solvers/bounded/contact/clearances.hpp"

#include "sim/mesh/extent.hpp"

namespace taut::sim::bounded {

Clearances::Clearances(std::span<const Triangle> cloth, std::span<const Triangle> bodies, bool within_cloth,
                       std::span<const Vec3> positions_m)
    : near_(make_contact_mesh(cloth, bodies), within_cloth, positions_m),
      kernels_(kernels_for(VectorUnit::best), 1),
      moves_(positions_m.size()) {}

std::span<const float> Clearances::find(std::span<const Vec3> positions_m, float max_m) {
  assert(max_m >= 0.0F);
  const Vec3 middle = compute_extent(positions_m).middle();
  rows_.clear();
  for (const Vec3& position_m : positions_m) rows_.push_back(to_float4(position_m - middle));
  radii_.assign(positions_m.size(), 0.5F * max_m);
  clearances_m_.assign(positions_m.size(), max_m);
  for (const NearPair& pair : near_.find(rows_, moves_, radii_, kernels_)) {
    const float distance_m = distance_between(
        pair, {vec(rows_[pair.rows[0]]), vec(rows_[pair.rows[1]]), vec(rows_[pair.rows[2]]), vec(rows_[pair.rows[3]])});
    for (const Index row : pair.rows) clearances_m_[row] = std::min(clearances_m_[row], distance_m);
  }
  return clearances_m_;
}

}  // namespace taut::sim::bounded
