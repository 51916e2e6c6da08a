#include "sim/solvers/bounded/contact/clearances.hpp"

#include "sim/mesh/extent.hpp"

namespace taut::sim::bounded {

Clearances::Clearances(std::span<const Triangle> cloth, std::span<const Triangle> bodies, bool within_cloth,
                       std::span<const Vec3> positions_m)
    : near_(make_contact_mesh(cloth, bodies), within_cloth, positions_m),
      kernels_(kernels_for(VectorUnit::best), 1),
      moves_(positions_m.size()) {}

const std::vector<NearPair>& Clearances::pairs_within(std::span<const Vec3> positions_m,
                                                      std::span<const float> radii_m) {
  const Vec3 middle = compute_extent(positions_m).middle();
  rows_.clear();
  for (const Vec3& position_m : positions_m) rows_.push_back(to_float4(position_m - middle));
  return near_.find(rows_, moves_, radii_m, kernels_);
}

float Clearances::pair_distance_m(const NearPair& pair) const {
  return distance_between(
      pair, {vec(rows_[pair.rows[0]]), vec(rows_[pair.rows[1]]), vec(rows_[pair.rows[2]]), vec(rows_[pair.rows[3]])});
}

std::span<const float> Clearances::find(std::span<const Vec3> positions_m, float max_m) {
  assert(max_m >= 0.0F);
  radii_.assign(positions_m.size(), 0.5F * max_m);
  clearances_m_.assign(positions_m.size(), max_m);
  for (const NearPair& pair : pairs_within(positions_m, radii_)) {
    const float distance_m = pair_distance_m(pair);
    for (const Index row : pair.rows) clearances_m_[row] = std::min(clearances_m_[row], distance_m);
  }
  return clearances_m_;
}

std::span<const float> Clearances::find_ratios(std::span<const Vec3> positions_m, std::span<const float> reach_m) {
  assert(reach_m.size() <= positions_m.size());
  shares_.assign(positions_m.size(), 1.0F);
  for (const NearPair& pair : pairs_within(positions_m, reach_m)) {
    std::array<float, 2> reaches_m = {0.0F, 0.0F};
    for (Index k = 0; k < 4; ++k) {
      float& reach = reaches_m[k < pair.first_count ? 0 : 1];
      reach = std::max(reach, reach_m[pair.rows[k]]);
    }
    const float both_m = reaches_m[0] + reaches_m[1];
    const float share = both_m > 0.0F ? pair_distance_m(pair) / both_m : 1.0F;
    for (const Index row : pair.rows) shares_[row] = std::min(shares_[row], share);
  }
  return shares_;
}

}  // namespace taut::sim::bounded
