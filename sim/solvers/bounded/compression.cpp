#include "sim/solvers/bounded/compression.hpp"

namespace taut::sim::bounded {
namespace {

/// The part of its error that a short spring may give back in one step and still push by its stiffness, and
/// not by how long the step is: what its neighbours undo within the step it could only give back in more
/// steps.
constexpr double largest_short_share = 0.9;

float short_share(float stiffness, float mobility_per_kg) {
  return stiffness * mobility_per_kg / (1.0F + stiffness * mobility_per_kg);
}

}  // namespace

void set_short_shares(double stiffness_n_per_m, double time_step_s, Layout& layout, SurfaceLanes& surface) {
  const auto stiffness = static_cast<float>(stiffness_n_per_m * time_step_s * time_step_s);
  SpringLanes& springs = layout.springs;
  for (std::size_t k = 0; k < springs.lane_count(); ++k) {
    const float w = layout.inverse_masses_per_kg[springs.row_i(k)] + layout.inverse_masses_per_kg[springs.row_j(k)];
    springs.blocks[k / block_size].short_share[k % block_size] = short_share(stiffness, w);
  }
  for (std::size_t k = 0; k < surface.lane_count(); ++k) {
    surface.blocks[k / block_size].short_share[k % block_size] = short_share(stiffness, surface.mobility_per_kg[k]);
  }
}

double mean_mobility_per_kg(const Layout& layout) {
  const SpringLanes& springs = layout.springs;
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t k = 0; k < springs.lane_count(); ++k) {
    if (springs.spring[k] != SpringLanes::no_spring) {
      sum += layout.inverse_masses_per_kg[springs.row_i(k)] + layout.inverse_masses_per_kg[springs.row_j(k)];
      ++count;
    }
  }
  for (const float mobility_per_kg : layout.surface.mobility_per_kg) {
    sum += mobility_per_kg;
    count += mobility_per_kg > 0.0F ? 1 : 0;
  }
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

double followed_compression(double mobility_per_kg, double time_step_s) {
  return largest_short_share / (1.0 - largest_short_share) / (time_step_s * time_step_s * mobility_per_kg);
}

}  // namespace taut::sim::bounded
