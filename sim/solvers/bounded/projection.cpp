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

/// Calls each(block, corners) for all triangles, with the rows of their corners.
template <typename Each> void for_triangles(const SurfaceLanes& surface, const Each& each) {
  for (std::size_t block = 0; block < surface.block_count(); ++block) {
    for (std::size_t lane = 0; lane < block_size; ++lane) {
      std::array<Index, 3> corners{};
      for (std::size_t k = 0; k < 3; ++k) corners[k] = surface.blocks[block].at[k][lane] / 4;
      each(block, corners);
    }
  }
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
    if (confinement != nullptr) confinement->bring_back(corrected_);
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

void BoundProjection::find_rings(const SurfaceLanes& surface, float squared_bound) {
  rings_.assign(corrected_.size(), 0);
  for_triangles(surface, [&](std::size_t block, const std::array<Index, 3>& corners) {
    if (squared_surface_ratios_[block] > squared_bound) {
      for (const Index row : corners) rings_[row] = tuning::evened_rings;
    }
  });
  for (std::uint8_t ring = tuning::evened_rings; ring > 1; --ring) {
    for_triangles(surface, [&](std::size_t, const std::array<Index, 3>& corners) {
      if (std::any_of(corners.begin(), corners.end(), [&](Index row) { return rings_[row] == ring; })) {
        for (const Index row : corners) rings_[row] = std::max<std::uint8_t>(rings_[row], ring - 1);
      }
    });
  }
}

// Where all vertices move alike, triangles are as they were when the frame began: within the bound.
void BoundProjection::even_out(const Layout& layout, float squared_bound) {
  find_rings(layout.surface, squared_bound);
  for (int pass = 0; pass < tuning::most_rounds; ++pass) {
    sums_.assign(corrected_.size(), Float4{});
    counts_.assign(corrected_.size(), 0.0F);
    for_triangles(layout.surface, [&](std::size_t, const std::array<Index, 3>& corners) {
      for (std::size_t k = 0; k < 3; ++k) {
        add_scaled(sums_[corners[k]], corrected_[corners[(k + 1) % 3]], 1.0F);
        add_scaled(sums_[corners[k]], corrected_[corners[(k + 2) % 3]], 1.0F);
        counts_[corners[k]] += 2.0F;
      }
    });
    for (std::size_t row = layout.pin_count; row < layout.vertex_count(); ++row) {
      if (rings_[row] > 0) corrected_[row] = times(sums_[row], 1.0F / counts_[row]);
    }
  }
}

// Layers that are evened out together pass each other only where their regions expect it.
void BoundProjection::expect_evened(const Layout& layout, float squared_bound, Confinement& confinement) {
  before_ = corrected_;
  even_out(layout, squared_bound);
  moved_.resize(before_.size());
  for (std::size_t row = 0; row < moved_.size(); ++row) {
    moved_[row] = scaled_sum(corrected_[row], before_[row], -1.0F);
  }
  confinement.begin(before_, moved_);
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
  // A larger stretch is for more time steps to mend.
  const bool evens_out = confinement != nullptr && result.raw_max_stretch < tuning::coped_stretch * max_stretch;
  double earlier_ratio = ratio;
  const auto may_go_on = [&] {
    return result.cost < limits.cost && std::isfinite(ratio) &&
           (confinement == nullptr || !confinement->is_spent(result.cost));
  };
  for (int round = 1; !(ratio <= squared_bound) && may_go_on(); ++round) {
    if (evens_out && round % tuning::most_rounds == 0) {
      if (ratio - squared_bound > 0.5 * (earlier_ratio - squared_bound)) {
        expect_evened(layout, static_cast<float>(squared_bound), *confinement);
        confinement->bring_back(corrected_);
        largest_ratio(layout, kernels);
      }
      earlier_ratio = ratio;
    }
    result.cost += shorten_long(layout, squared_aim, kernels);
    if (confinement != nullptr) confinement->bring_back(corrected_);
    ratio = largest_ratio(layout, kernels);
  }
  result.kept = ratio <= squared_bound;
  end(raw, result, corrections);
  return result;
}

}  // namespace taut::sim::bounded
