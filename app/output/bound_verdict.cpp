#include "app/output/bound_verdict.hpp"

#include <fmt/core.h>

#include <cstdio>

namespace taut::app {

int judge_bound(const Scene& scene, const RunSummary& summary) {
  if (summary.frames_over_bound == 0) {
    return 0;
  }
  const bool allowed = scene.allow_exceeding_bound;
  std::fflush(stdout);
  fmt::print(stderr,
             "taut: {}: {} of {} frames exceed solver.max_stretch = {:g}, the first is frame {}; the largest "
             "stretch is {:.4g}. Pins may pull the cloth apart, or more time steps are needed "
             "(solver.max_substeps = {}){}\n",
             allowed ? "warning" : "error", summary.frames_over_bound, summary.frames,
             scene.simulation.solver.max_stretch, summary.first_frame_over_bound, summary.max_stretch,
             scene.simulation.solver.max_substeps,
             allowed ? "" : "; solver.allow_exceeding = true accepts such frames");
  return allowed ? 0 : 1;
}

}  // namespace taut::app
