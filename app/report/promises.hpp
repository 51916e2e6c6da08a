#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/figures/experiments/experiments.hpp"

namespace taut::app {

/// The promises about the frames of a figure, and the counts in them.
struct PromiseResult {
  std::string figure;  ///< "fig5"
  std::string scene;
  std::optional<double> bound;  ///< the largest stretch that is promised, a fraction; empty: none is
  bool is_apart = false;        ///< whether it is promised that nothing crosses
  PromiseCounts counts;

  bool is_bound_kept() const;
  bool is_kept_apart() const { return counts.crossing_frames == 0; }
};

/// The results of all scenes of figures 2 to 5 whose frames were checked.
std::vector<PromiseResult> promise_results(const Results& results);

/// In a sentence or two what was promised and what came of it.
std::string describe(const std::vector<PromiseResult>& results);

}  // namespace taut::app
