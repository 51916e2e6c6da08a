#include "sim/solvers/bounded/certificate.hpp"

#include <algorithm>
#include <cmath>

namespace taut::sim::bounded {
namespace {

/// Lengths in single precision are wrong by less than this part of themselves: the bound is kept by that much
/// more, so that it also holds when the positions are read back in double precision.
constexpr double rounding = 2e-6;

/// Over-relaxed sweeps between two looks at all springs, and then one of factor 1: where springs pull at each
/// other, a sweep that is over-relaxed leaves some of them too long.
constexpr int relaxed_sweeps = 6;
constexpr float relaxation = 1.8F;

/// Springs this close to the bound may get too long by the correction of others.
constexpr float nearly = 0.995F;

/// Of the last frame's correction. All of it would be fewest sweeps, but what is shown would drift off.
constexpr float kept_correction = 0.95F;

Row scaled_sum(const Row& a, const Row& b, float factor) {
  return {a.x + factor * b.x, a.y + factor * b.y, a.z + factor * b.z, 0.0F};
}

}  // namespace

Certifier::Certifier(const Layout& layout)
    : shown_(layout.row_count()),
      corrections_(layout.row_count()),
      squared_ratios_(layout.springs.block_count()) {}

void Certifier::start_from_last_frame(const Rows& raw) {
  for (std::size_t row = 0; row < raw.size(); ++row) {
    shown_[row] = scaled_sum(raw[row], corrections_[row], kept_correction);
  }
}

double Certifier::largest_ratio(const Layout& layout, const Kernels& kernels) {
  kernels.largest_ratios(layout.springs, 0, layout.springs.block_count(), shown_.data(),
                         squared_ratios_.data());
  float largest = 0.0F;
  for (const float ratio : squared_ratios_) {
    // Written so that a ratio that is not a number is not passed over.
    largest = ratio <= largest ? largest : ratio;
  }
  return largest;
}

void Certifier::choose_long_blocks(float squared_bound) {
  long_blocks_.clear();
  for (std::uint32_t block = 0; block < squared_ratios_.size(); ++block) {
    if (squared_ratios_[block] > squared_bound * nearly) {
      long_blocks_.push_back(block);
    }
  }
}

void Certifier::shorten_chosen(const Layout& layout, float squared_bound, const Kernels& kernels) {
  for (int sweep = 0; sweep <= relaxed_sweeps; ++sweep) {
    const float factor = sweep < relaxed_sweeps ? relaxation : 1.0F;
    for (const std::uint32_t block : long_blocks_) {
      kernels.shorten(layout.springs, block, block + 1, squared_bound, factor, shown_.data());
    }
  }
}

Certificate Certifier::certify(const Layout& layout, const Rows& raw, double max_stretch, double largest_cost,
                               const Kernels& kernels) {
  const double allowed = (1.0 + max_stretch) * (1.0 - rounding);
  const double squared_bound = allowed * allowed;
  // Aims a little below what is checked, or rounding could leave a spring for ever at the bound's edge.
  const auto squared_aim = static_cast<float>(squared_bound * (1.0 - rounding));
  Certificate certificate;
  shown_ = raw;
  double ratio = largest_ratio(layout, kernels);
  certificate.raw_max_stretch = std::sqrt(ratio) - 1.0;
  if (!(ratio <= squared_bound)) {
    start_from_last_frame(raw);
    ratio = largest_ratio(layout, kernels);
  }
  while (!(ratio <= squared_bound) && certificate.cost < largest_cost && std::isfinite(ratio)) {
    choose_long_blocks(squared_aim);
    shorten_chosen(layout, squared_aim, kernels);
    ratio = largest_ratio(layout, kernels);
    certificate.cost += 1.0 + (1.0 + relaxed_sweeps) * static_cast<double>(long_blocks_.size()) /
                                  static_cast<double>(squared_ratios_.size());
  }
  for (std::size_t row = 0; row < raw.size(); ++row) {
    corrections_[row] = scaled_sum(shown_[row], raw[row], -1.0F);
  }
  certificate.max_stretch = std::sqrt(ratio) - 1.0;
  certificate.kept = ratio <= squared_bound;
  return certificate;
}

}  // namespace taut::sim::bounded
