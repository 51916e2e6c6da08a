#include "app/report/promises.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "app/base/counted.hpp"
#include "app/scene/scene.hpp"

namespace taut::app {
namespace {

void add_result(const char* figure, const std::optional<Recording>& recording,
                std::vector<PromiseResult>& results) {
  if (!recording || !recording->promises) {
    return;
  }
  const SolverChoice& solver = recording->scene.simulation.solver;
  PromiseResult result = {figure, recording->scene.name, {}, false, *recording->promises};
  if (solver.kind == sim::SolverKind::bounded) {
    result.bound = solver.bounded.allow_exceeding ? std::nullopt : std::optional(solver.bounded.max_stretch);
    result.is_apart = solver.bounded.contact;
  }
  results.push_back(std::move(result));
}

template <class Predicate>
std::size_t count(const std::vector<PromiseResult>& results, Predicate predicate) {
  return static_cast<std::size_t>(std::count_if(results.begin(), results.end(), predicate));
}

}  // namespace

bool PromiseResult::is_bound_kept() const {
  return bound && counts.stretch.springs <= *bound + bound_rounding;
}

std::vector<PromiseResult> promise_results(const Results& results) {
  std::vector<PromiseResult> all;
  if (results.fall) {
    add_result("fig2", results.fall->frames, all);
  }
  for (const auto& recording : results.pinned) {
    add_result("fig4", recording, all);
  }
  for (const auto& recording : results.shirts) {
    add_result("fig5", recording, all);
  }
  return all;
}

std::string describe(const std::vector<PromiseResult>& results) {
  int frames = 0;
  std::size_t pairs_elsewhere = 0;
  for (const PromiseResult& result : results) {
    frames += result.counts.frames;
    pairs_elsewhere += result.is_apart ? 0 : result.counts.crossing_pairs;
  }
  const std::size_t bounds = count(results, [](const auto& r) { return r.bound.has_value(); });
  const std::size_t kept = count(results, [](const auto& r) { return r.is_bound_kept(); });
  const std::size_t apart = count(results, [](const auto& r) { return r.is_apart; });
  const std::size_t kept_apart =
      count(results, [](const auto& r) { return r.is_apart && r.is_kept_apart(); });
  return fmt::format(
      "{} of {} were checked. A bound on stretch is promised in {} of the scenes and kept in every frame of "
      "{}; "
      "that nothing crosses is promised in {} and kept in every frame of {}. Where contact is off nothing is "
      "promised about it, and {}.",
      counted(frames, "frame"), counted(results.size(), "scene"), bounds, kept, apart, kept_apart,
      pairs_elsewhere == 0
          ? "nothing crosses either"
          : "triangles do cross: " + counted(pairs_elsewhere, "pair") + " in all frames together");
}

}  // namespace taut::app
