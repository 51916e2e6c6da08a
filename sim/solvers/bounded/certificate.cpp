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

/// Below 2 the distance to every shape within the bound can only fall, whatever the weights (Agmon 1954).
/// What is best for a chain of n springs is 2 / (1 + sin(pi / n)) (Young 1954); the weights make chains
/// shorter.
float relaxation_of(const Layout& layout) {
  constexpr double least_springs = 16.0;
  constexpr double most_springs = 128.0;
  return static_cast<float>(2.0 /
                            (1.0 + 2.0 / std::clamp(layout.reach_springs, least_springs, most_springs)));
}

/// Springs this close to the bound may get too long by the correction of others.
constexpr float nearly = 0.995F;

/// Of the last frame's correction. All of it would be fewest sweeps, but shapes would drift off.
constexpr float kept_correction = 0.9F;

/// Aims a little below what is checked: the last of a correction takes the most sweeps.
constexpr double aimed_part = 0.97;

float squared_aim_of(double max_stretch) {
  const double length = (1.0 + aimed_part * max_stretch) * (1.0 - 2.0 * rounding);
  return static_cast<float>(length * length);
}

}  // namespace

Certifier::Certifier(const Layout& layout)
    : relaxation_(relaxation_of(layout)),
      corrected_(layout.row_count()),
      corrections_(layout.row_count()),
      new_corrections_(layout.row_count()),
      squared_ratios_(layout.springs.block_count()) {}

void Certifier::start_from_last_frame(const Rows& raw) {
  for (std::size_t row = 0; row < raw.size(); ++row) {
    corrected_[row] = scaled_sum(raw[row], corrections_[row], kept_correction);
  }
}

double Certifier::largest_ratio(const Layout& layout, Loops& loops) {
  loops.largest_ratios(layout.springs, corrected_.data(), squared_ratios_.data());
  float largest = 0.0F;
  for (const float ratio : squared_ratios_) {
    // Written so that a ratio that is not a number is not passed over.
    largest = ratio <= largest ? largest : ratio;
  }
  return largest;
}

void Certifier::choose_long_blocks(const SpringLanes& springs, float squared_bound) {
  long_blocks_.clear();
  colour_begin_.assign(1, 0);
  for (std::size_t c = 0; c < springs.colour_count(); ++c) {
    for (std::uint32_t block = springs.colour_begin[c]; block < springs.colour_begin[c + 1]; ++block) {
      if (squared_ratios_[block] > squared_bound * nearly) {
        long_blocks_.push_back(block);
      }
    }
    colour_begin_.push_back(long_blocks_.size());
  }
}

void Certifier::shorten_chosen(const Layout& layout, float squared_bound, Loops& loops) {
  for (int sweep = 0; sweep <= relaxed_sweeps; ++sweep) {
    const float factor = sweep < relaxed_sweeps ? relaxation_ : 1.0F;
    for (std::size_t c = 0; c + 1 < colour_begin_.size(); ++c) {
      const std::size_t count = colour_begin_[c + 1] - colour_begin_[c];
      loops.shorten(layout.springs, std::span(long_blocks_).subspan(colour_begin_[c], count), squared_bound,
                    factor, corrected_.data());
    }
  }
}

Certificate Certifier::certify(const Layout& layout, const Rows& raw, double max_stretch, double largest_cost,
                               Loops& loops) {
  const double allowed = (1.0 + max_stretch) * (1.0 - rounding);
  const double squared_bound = allowed * allowed;
  const float squared_aim = squared_aim_of(max_stretch);
  Certificate certificate;
  corrected_ = raw;
  double ratio = largest_ratio(layout, loops);
  certificate.raw_max_stretch = std::sqrt(ratio) - 1.0;
  if (const double raw_ratio = ratio; !(raw_ratio <= squared_bound)) {
    start_from_last_frame(raw);
    ratio = largest_ratio(layout, loops);
    if (!(ratio <= raw_ratio)) {
      corrected_ = raw;
      ratio = largest_ratio(layout, loops);
    }
  }
  while (!(ratio <= squared_bound) && certificate.cost < largest_cost && std::isfinite(ratio)) {
    choose_long_blocks(layout.springs, squared_aim);
    shorten_chosen(layout, squared_aim, loops);
    ratio = largest_ratio(layout, loops);
    certificate.cost += 1.0 + (1.0 + relaxed_sweeps) * static_cast<double>(long_blocks_.size()) /
                                  static_cast<double>(squared_ratios_.size());
  }
  float largest_shift2 = 0.0F;
  for (std::size_t row = 0; row < raw.size(); ++row) {
    const Row& shift = new_corrections_[row] = scaled_sum(corrected_[row], raw[row], -1.0F);
    largest_shift2 = std::max(largest_shift2, shift.x * shift.x + shift.y * shift.y + shift.z * shift.z);
  }
  certificate.largest_shift_m = std::sqrt(largest_shift2);
  certificate.kept = ratio <= squared_bound;
  return certificate;
}

}  // namespace taut::sim::bounded
