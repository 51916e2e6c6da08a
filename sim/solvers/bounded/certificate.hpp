#pragma once

#include <span>
#include <vector>

#include "sim/solvers/bounded/kernels/loops.hpp"
#include "sim/solvers/bounded/layout.hpp"

namespace taut::sim::bounded {

/// What came of making a frame keep its bound.
struct Certificate {
  double raw_max_stretch = 0.0;  ///< before
  double cost = 0.0;             ///< the work it took, in sweeps over all springs
  double largest_shift_m = 0.0;  ///< the furthest a vertex was moved
  bool kept = false;             ///< no spring is longer than the bound allows
};

/// The last correction of a frame: moves the cloth to where no spring is longer than the bound.
///
/// Springs no longer than a bound are a convex set of shapes, so that correcting the longer ones again and
/// again ends in it wherever the pins allow it (cyclic projection; Bregman 1965). That is so for any weights
/// of the vertices, and this correction need not move as masses do: weights that grow towards the pins hand
/// corrections down the cloth instead of back and forth. The correction of the last frame, a little faded, is
/// where the next one starts.
class Certifier {
 public:
  explicit Certifier(const Layout& layout);

  /// Gives up when it has cost `largest_cost`.
  Certificate certify(const Layout& layout, const Rows& raw, double max_stretch, double largest_cost,
                      Loops& loops);

  /// The last certificate is that of the frame; the next call is for the next one.
  void end_frame() { corrections_.swap(new_corrections_); }

  /// Displacements since the frame's start that keep the bound.
  const Rows& corrected() const { return corrected_; }

 private:
  void start_from_last_frame(const Rows& raw);
  double largest_ratio(const Layout& layout, Loops& loops);
  void choose_long_blocks(const SpringLanes& springs, float squared_bound);
  void shorten_chosen(const Layout& layout, float squared_bound, Loops& loops);

  float relaxation_;
  Rows corrected_;
  Rows corrections_;                        ///< of the last frame
  Rows new_corrections_;                    ///< of this one
  std::vector<float> squared_ratios_;       ///< by block
  std::vector<std::uint32_t> long_blocks_;  ///< colour by colour
  std::vector<std::size_t> colour_begin_;   ///< in long_blocks_
};

}  // namespace taut::sim::bounded
