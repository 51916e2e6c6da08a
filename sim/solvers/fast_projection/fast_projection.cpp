#include "sim/solvers/fast_projection/fast_projection.hpp"

namespace taut::sim {

SpringStiffness soft_springs(const FastProjectionSettings& settings) {
  SpringStiffness soft = settings.stiffness;
  soft.structural_n_per_m = 0.0;
  return soft;
}

FastProjection::FastProjection(const FastProjectionSettings& settings)
    : IdealSprings({soft_springs(settings)}), settings_(settings) {}

void FastProjection::compensate(const Garment& garment, const Pins& pins, State& state) {
  if (!system_ || pinned_ != pins.vertices) {
    const std::size_t count = garment.springs.end_of(SpringKind::structural);
    system_ = std::make_unique<LengthSystem>(std::span(garment.springs.ends).first(count),
                                             std::span(garment.springs.rest_lengths_m).first(count), pins);
    pinned_ = pins.vertices;
  }
  for (int projection = 0; projection < settings_.most_projections; ++projection) {
    if (system_->largest_strain(state.predicted) <= settings_.max_strain || !system_->project(state.predicted)) {
      return;
    }
  }
}

}  // namespace taut::sim
