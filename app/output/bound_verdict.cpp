#include "app/output/bound_verdict.hpp"

#include <fmt/core.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "app/base/counted.hpp"
#include "app/base/errors.hpp"

namespace taut::app {

namespace {

// How many times stiffer than the time steps can follow the fabric must be before the user is told. Below it
// the springs push back nearly as they should.
constexpr double noticeable = 2.0;

void warn_of_stiffness(const Scene& scene, const RunSummary& summary) {
  const SolverChoice& solver = scene.simulation.solver;
  const double asked = scene.material.compression_stiffness_n_per_m;
  const double followed = summary.followed_compression_n_per_m;
  const bool is_asked_for = asked != sim::Material{}.compression_stiffness_n_per_m;
  if (!is_asked_for || !(asked > noticeable * followed)) {
    return;
  }
  const double steps = std::ceil(summary.mean_substeps() * std::sqrt(asked / followed));
  const std::string remedy = steps <= solver.max_substeps
                                 ? fmt::format("solver.substeps = {:.0f} would follow it", steps)
                                 : fmt::format("it would take {:.2g} of them", steps);
  fmt::print(
      stderr,
      "taut: warning: cloth.compression_stiffness = {:g} N/m is stiffer than {:.0f} time steps a frame can "
      "follow; short springs pushed back as at about {:.2g} N/m; {}\n",
      asked, summary.mean_substeps(), followed, remedy);
}

// Only where the scene accepts them: other runs end at the first.
void warn_of_crossings(const RunSummary& summary) {
  if (summary.frames_blocked > 0) {
    fmt::print(
        stderr,
        "taut: warning: in {} of {} pins or bodies closed in so that something may cross, first in frame "
        "{}\n",
        summary.frames_blocked, counted(summary.frames, "frame"), summary.first_frame_blocked);
  }
}

/// "the surface is stretched by up to 0.23, 0.22 too much".
std::string describe(const char* what, double largest, double bound) {
  const std::string text = fmt::format("{} stretched by up to {:.4g}", what, largest);
  return largest > bound + bound_rounding ? text + fmt::format(", {:.2g} too much", largest - bound) : text;
}

/// All that the bound holds, by the worst frames.
std::string describe_stretch(const sim::BoundedSettings& bound, const RunSummary& summary) {
  const std::string springs = describe("springs are", summary.max_stretch, bound.max_stretch);
  return bound.bound == sim::BoundKind::springs
             ? springs
             : springs + "; " + describe("the surface is", summary.max_surface_stretch, bound.max_stretch);
}

}  // namespace

std::string describe_crossings(const RunSummary& summary) {
  if (summary.crossings_at_start == 0 && summary.final_crossings == 0 && !(summary.most_left_out_share > 0.0)) {
    return "";
  }
  const std::string counts = fmt::format("{} at the start and {} at the end",
                                         counted(static_cast<std::size_t>(summary.crossings_at_start),
                                                 "pair of triangles crosses", "pairs of triangles cross"),
                                         summary.final_crossings);
  return summary.most_left_out_share > 0.0
             ? fmt::format("{}; around them contact leaves out {:.2f} % of the cloth, at the end {:.2f} %", counts,
                           100.0 * summary.most_left_out_share, 100.0 * summary.final_left_out_share)
             : counts;
}

std::string describe_excess(const Scene& scene, const RunSummary& summary) {
  const sim::BoundedSettings& bounded = scene.simulation.solver.bounded;
  return summary.frames_over_bound == 0
             ? ""
             : fmt::format("{} of {} {} solver.max_stretch = {:g} of the {}, the first is frame {}; {}",
                           summary.frames_over_bound, counted(summary.frames, "frame"),
                           summary.frames_over_bound == 1 ? "exceeds" : "exceed", bounded.max_stretch,
                           sim::name_of(bounded.bound), summary.first_frame_over_bound,
                           describe_stretch(bounded, summary));
}

int judge_bound(const Scene& scene, const RunSummary& summary) {
  std::fflush(stdout);
  warn_of_stiffness(scene, summary);
  warn_of_crossings(summary);
  const std::string excess = describe_excess(scene, summary);
  if (excess.empty()) {
    return 0;
  }
  const bool allowed = scene.simulation.solver.bounded.allow_exceeding;
  fmt::print(stderr,
             "taut: {}: {}. {} may "
             "pull the cloth apart, or more time steps are needed "
             "(solver.max_substeps = {}){}\n",
             allowed ? "warning" : "error", excess,
             scene.surroundings.bodies.empty() ? "Pins" : "Pins, or a body that it is too tight for,",
             scene.simulation.solver.max_substeps,
             allowed ? "" : "; solver.allow_exceeding = \"bound\" accepts such frames");
  return allowed ? 0 : exit_promise_broken;
}

}  // namespace taut::app
