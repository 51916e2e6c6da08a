#include "sim/solvers/bounded/projection.hpp"

namespace taut::sim::bounded {
namespace {

/// Largest relative error of lengths in single precision. The bound is tightened by it, so that it also holds when the
/// positions are read back in double precision.
constexpr double rounding = 2e-6;

float compute_squared_aim(double max_stretch) {
  assert(max_stretch >= 0.0);
  const double length = (1.0 + aimed_stretch(max_stretch)) * (1.0 - 2.0 * rounding);
  return static_cast<float>(length * length);
}

/// Returns the blocks with a squared ratio above `least`.
std::vector<std::uint32_t> long_blocks(const std::vector<float>& squared_ratios, float min_ratio) {
  std::vector<std::uint32_t> blocks;
  for (std::uint32_t block = 0; block < squared_ratios.size(); ++block) {
    if (squared_ratios[block] > min_ratio) blocks.push_back(block);
  }
  return blocks;
}

/// Sweeps over the blocks once, and again over those near the pins. Returns the number of swept blocks.
template <typename AnyLanes>
double shorten_blocks(const AnyLanes& lanes, const std::vector<std::uint32_t>& blocks, float squared_bound,
                      float factor, ParallelKernels& kernels, Float4Array& rows) {
  std::size_t shortened = 0;
  for (const auto [begin, end, again] : lanes.sweep) {
    const auto first = std::lower_bound(blocks.begin(), blocks.end(), begin);
    const auto last = std::lower_bound(first, blocks.end(), end);
    const auto found = std::span(blocks).subspan(static_cast<std::size_t>(first - blocks.begin()),
                                                 static_cast<std::size_t>(last - first));
    kernels.shorten(lanes, found, squared_bound, factor, rows.data());
    shortened += found.size();
  }
  return static_cast<double>(shortened);
}

/// Returns whether any were long.
template <typename AnyLanes>
bool shorten_long_blocks(const AnyLanes& lanes, float squared_bound, ParallelKernels& kernels, Float4Array& rows) {
  std::vector<float> squared_ratios(lanes.block_count());
  kernels.find_max_ratios(lanes, rows.data(), squared_ratios.data());
  return shorten_blocks(lanes, long_blocks(squared_ratios, squared_bound), squared_bound, 1.0F, kernels, rows) > 0.0;
}

}  // namespace

void shorten_roughly(const Layout& layout, double max_stretch, ParallelKernels& kernels, Float4Array& rows) {
  assert(max_stretch >= 0.0);
  const auto squared_bound = static_cast<float>((1.0 + max_stretch) * (1.0 + max_stretch));
  bool are_any_long = true;
  for (int sweep = 0; sweep < tuning::prediction_sweeps && are_any_long; ++sweep) {
    are_any_long = shorten_long_blocks(layout.springs, squared_bound, kernels, rows);
    are_any_long = shorten_long_blocks(layout.surface, squared_bound, kernels, rows) || are_any_long;
  }
}

float relaxation_factor(const Layout& layout) {
  return static_cast<float>(2.0 / (1.0 + 2.0 / std::max(layout.reach_springs, tuning::min_chain_springs)));
}

double aimed_stretch(double max_stretch) { return tuning::aim_fraction * max_stretch; }

BoundProjection::BoundProjection(const Layout& layout, double frame_time_s)
    : relaxation_(relaxation_factor(layout)),
      correction_factor_(static_cast<float>(std::max(0.0, 1.0 - tuning::correction_decay_per_s * frame_time_s))),
      corrected_(layout.row_count()),
      squared_spring_ratios_(layout.springs.block_count()),
      squared_surface_ratios_(layout.surface.block_count()) {}

double BoundProjection::find_max_ratio(const Layout& layout, ParallelKernels& kernels) {
  kernels.find_max_ratios(layout.springs, corrected_.data(), squared_spring_ratios_.data());
  kernels.find_max_ratios(layout.surface, corrected_.data(), squared_surface_ratios_.data());
  float max_ratio = 0.0F;
  for (const std::vector<float>* ratios : {&squared_spring_ratios_, &squared_surface_ratios_}) {
    for (const float ratio : *ratios) {
      // This form does not skip a ratio that is not a number.
      max_ratio = ratio <= max_ratio ? max_ratio : ratio;
    }
  }
  return max_ratio;
}

// Does one round. Returns its work, in sweeps over all springs and triangles.
double BoundProjection::shorten_long(const Layout& layout, float squared_aim, ParallelKernels& kernels) {
  const float min_ratio = 1.0F + tuning::near_bound_fraction * (squared_aim - 1.0F);
  const std::vector<std::uint32_t> springs = long_blocks(squared_spring_ratios_, min_ratio);
  const std::vector<std::uint32_t> surface = long_blocks(squared_surface_ratios_, min_ratio);
  double shortened = 0.0;
  for (int sweep = 0; sweep <= tuning::relaxed_sweeps; ++sweep) {
    const float factor = sweep < tuning::relaxed_sweeps ? relaxation_ : 1.0F;
    shortened += shorten_blocks(layout.springs, springs, squared_aim, factor, kernels, corrected_);
    shortened += shorten_blocks(layout.surface, surface, squared_aim, factor, kernels, corrected_);
  }
  const std::size_t all = squared_spring_ratios_.size() + squared_surface_ratios_.size();
  return 1.0 + shortened / static_cast<double>(all);
}

// Starts from the last correction, or from the raw state if that is better. Returns the largest squared ratio there.
double BoundProjection::start(const Layout& layout, const Float4Array& raw, const Float4Array& corrections,
                              double raw_ratio, Confinement* confinement, ParallelKernels& kernels) {
  const auto project_into_region = [&] {
    if (confinement != nullptr) confinement->project_into_region(corrected_, false);
    return find_max_ratio(layout, kernels);
  };
  if (confinement != nullptr) confinement->begin(raw, corrections);
  for (std::size_t row = 0; row < raw.size(); ++row) {
    corrected_[row] = scaled_sum(raw[row], corrections[row], correction_factor_);
  }
  const double ratio = project_into_region();
  if (ratio <= raw_ratio) return ratio;
  corrected_ = raw;
  return project_into_region();
}

void BoundProjection::end(const Float4Array& raw, ProjectionResult& result, Float4Array& corrections) const {
  float max_shift2_m2 = 0.0F;
  for (std::size_t row = 0; row < raw.size(); ++row) {
    const Float4& shift = corrections[row] = scaled_sum(corrected_[row], raw[row], -1.0F);
    max_shift2_m2 = std::max(max_shift2_m2, shift.x * shift.x + shift.y * shift.y + shift.z * shift.z);
  }
  result.max_shift_m = std::sqrt(max_shift2_m2);
}

ProjectionResult BoundProjection::project(const Layout& layout, const Float4Array& raw, double max_stretch,
                                          const ProjectionLimits& limits, Confinement* confinement,
                                          ParallelKernels& kernels, Float4Array& corrections) {
  assert(max_stretch >= 0.0);
  assert(raw.size() == corrections.size());
  const double allowed = (1.0 + max_stretch) * (1.0 - rounding);
  const double squared_bound = allowed * allowed;
  const float squared_aim = compute_squared_aim(max_stretch);
  ProjectionResult result;
  corrected_ = raw;
  double ratio = find_max_ratio(layout, kernels);
  result.raw_max_stretch = std::sqrt(ratio) - 1.0;
  if (!(result.raw_max_stretch < limits.raw_max_stretch)) return result;
  if (!(ratio <= squared_bound)) ratio = start(layout, raw, corrections, ratio, confinement, kernels);
  int rounds = 0;
  bool is_stuck = false;
  double checked_ratio = ratio;
  const auto may_go_on = [&] {
    return result.cost < limits.cost && std::isfinite(ratio) &&
           (confinement == nullptr || !confinement->is_spent(result.cost));
  };
  while (!(ratio <= squared_bound) && may_go_on()) {
    result.cost += shorten_long(layout, squared_aim, kernels);
    if (confinement != nullptr) confinement->project_into_region(corrected_, is_stuck);
    ratio = find_max_ratio(layout, kernels);
    const bool is_checked = ++rounds % tuning::rounds_per_check == 0;
    is_stuck = is_checked && ratio - squared_bound > 0.5 * (checked_ratio - squared_bound);
    checked_ratio = is_checked ? ratio : checked_ratio;
  }
  result.is_kept = ratio <= squared_bound;
  end(raw, result, corrections);
  return result;
}

}  // namespace taut::sim::bounded
