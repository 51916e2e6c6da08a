#include "sim/solvers/bounded/projection.hpp"

namespace taut::sim::bounded {
namespace {

/// Lengths in single precision are wrong by less than this part of themselves: the bound is kept by that much
/// more, so that it also holds when the positions are read back in double precision.
constexpr double rounding = 2e-6;

float squared_aim_of(double max_stretch) {
  const double length = (1.0 + aimed_stretch(max_stretch)) * (1.0 - 2.0 * rounding);
  return static_cast<float>(length * length);
}

/// Returns the blocks that hold one of at least this ratio.
std::vector<std::uint32_t> long_blocks(const std::vector<float>& squared_ratios, float least) {
  std::vector<std::uint32_t> blocks;
  for (std::uint32_t block = 0; block < squared_ratios.size(); ++block) {
    if (squared_ratios[block] > least) blocks.push_back(block);
  }
  return blocks;
}

/// Sweeps over the blocks once, those near the pins again. Returns how many it swept.
template <typename AnyLanes>
double shorten(const AnyLanes& lanes, const std::vector<std::uint32_t>& blocks, float squared_bound, float factor,
               ParallelKernels& kernels, Float4Array& rows) {
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

/// Returns whether there were any.
template <typename AnyLanes>
bool shorten_long_ones(const AnyLanes& lanes, float squared_bound, ParallelKernels& kernels, Float4Array& rows) {
  std::vector<float> squared_ratios(lanes.block_count());
  kernels.largest_ratios(lanes, rows.data(), squared_ratios.data());
  return shorten(lanes, long_blocks(squared_ratios, squared_bound), squared_bound, 1.0F, kernels, rows) > 0.0;
}

}  // namespace

void shorten_roughly(const Layout& layout, double max_stretch, ParallelKernels& kernels, Float4Array& rows) {
  const auto squared_bound = static_cast<float>((1.0 + max_stretch) * (1.0 + max_stretch));
  bool are_any_long = true;
  for (int sweep = 0; sweep < tuning::most_rounds / 4 && are_any_long; ++sweep) {
    are_any_long = shorten_long_ones(layout.springs, squared_bound, kernels, rows);
    are_any_long = shorten_long_ones(layout.surface, squared_bound, kernels, rows) || are_any_long;
  }
}

float relaxation_of(const Layout& layout) {
  return static_cast<float>(2.0 / (1.0 + 2.0 / std::max(layout.reach_springs, tuning::shortest_chain)));
}

double aimed_stretch(double max_stretch) { return tuning::aimed_part * max_stretch; }

BoundProjection::BoundProjection(const Layout& layout, double frame_time_s)
    : relaxation_(relaxation_of(layout)),
      kept_correction_(static_cast<float>(std::max(0.0, 1.0 - tuning::faded_per_s * frame_time_s))),
      corrected_(layout.row_count()),
      squared_spring_ratios_(layout.springs.block_count()),
      squared_surface_ratios_(layout.surface.block_count()) {}

double BoundProjection::largest_ratio(const Layout& layout, ParallelKernels& kernels) {
  kernels.largest_ratios(layout.springs, corrected_.data(), squared_spring_ratios_.data());
  kernels.largest_ratios(layout.surface, corrected_.data(), squared_surface_ratios_.data());
  float largest = 0.0F;
  for (const std::vector<float>* ratios : {&squared_spring_ratios_, &squared_surface_ratios_}) {
    for (const float ratio : *ratios) {
      // Written so that a ratio that is not a number is not passed over.
      largest = ratio <= largest ? largest : ratio;
    }
  }
  return largest;
}

// One round. Returns its work, in sweeps over all springs and triangles.
double BoundProjection::shorten_long(const Layout& layout, float squared_aim, ParallelKernels& kernels) {
  const float least = 1.0F + tuning::nearly_long * (squared_aim - 1.0F);
  const std::vector<std::uint32_t> springs = long_blocks(squared_spring_ratios_, least);
  const std::vector<std::uint32_t> surface = long_blocks(squared_surface_ratios_, least);
  double shortened = 0.0;
  for (int sweep = 0; sweep <= tuning::relaxed_sweeps; ++sweep) {
    const float factor = sweep < tuning::relaxed_sweeps ? relaxation_ : 1.0F;
    shortened += shorten(layout.springs, springs, squared_aim, factor, kernels, corrected_);
    shortened += shorten(layout.surface, surface, squared_aim, factor, kernels, corrected_);
  }
  const std::size_t all = squared_spring_ratios_.size() + squared_surface_ratios_.size();
  return 1.0 + shortened / static_cast<double>(all);
}

// Returns the largest ratio of where the correction starts: at the last one, unless the raw state is nearer.
double BoundProjection::start(const Layout& layout, const Float4Array& raw, const Float4Array& corrections,
                              double raw_ratio, Confinement* confinement, ParallelKernels& kernels) {
  const auto bring_back = [&] {
    if (confinement != nullptr) confinement->bring_back(corrected_, false);
    return largest_ratio(layout, kernels);
  };
  if (confinement != nullptr) confinement->begin(raw, corrections);
  for (std::size_t row = 0; row < raw.size(); ++row) {
    corrected_[row] = scaled_sum(raw[row], corrections[row], kept_correction_);
  }
  const double ratio = bring_back();
  if (ratio <= raw_ratio) return ratio;
  corrected_ = raw;
  return bring_back();
}

void BoundProjection::end(const Float4Array& raw, ProjectionResult& result, Float4Array& corrections) const {
  float largest_shift2 = 0.0F;
  for (std::size_t row = 0; row < raw.size(); ++row) {
    const Float4& shift = corrections[row] = scaled_sum(corrected_[row], raw[row], -1.0F);
    largest_shift2 = std::max(largest_shift2, shift.x * shift.x + shift.y * shift.y + shift.z * shift.z);
  }
  result.largest_shift_m = std::sqrt(largest_shift2);
}

ProjectionResult BoundProjection::project(const Layout& layout, const Float4Array& raw, double max_stretch,
                                          const Limits& limits, Confinement* confinement, ParallelKernels& kernels,
                                          Float4Array& corrections) {
  const double allowed = (1.0 + max_stretch) * (1.0 - rounding);
  const double squared_bound = allowed * allowed;
  const float squared_aim = squared_aim_of(max_stretch);
  ProjectionResult result;
  corrected_ = raw;
  double ratio = largest_ratio(layout, kernels);
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
    if (confinement != nullptr) confinement->bring_back(corrected_, is_stuck);
    ratio = largest_ratio(layout, kernels);
    const bool is_checked = ++rounds % (tuning::most_rounds / 2) == 0;
    is_stuck = is_checked && ratio - squared_bound > 0.5 * (checked_ratio - squared_bound);
    checked_ratio = is_checked ? ratio : checked_ratio;
  }
  result.kept = ratio <= squared_bound;
  end(raw, result, corrections);
  return result;
}

}  // namespace taut::sim::bounded
