#include "app/bench/findings.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "app/base/ranking.hpp"
#include "app/figures/experiments/power_law.hpp"

namespace taut::app {
namespace {

bool was_asked_for(const Run& run, double bound) {
  return !run.entrant.bound || *run.entrant.bound == bound;
}

}  // namespace

RunFacts facts_of(const Run& run) {
  RunFacts facts;
  if (run.frames.empty()) {
    return facts;
  }
  std::vector<double> times_ms;
  std::vector<int> substeps;
  double projections = 0.0;
  for (const FrameSample& frame : run.frames) {
    times_ms.push_back(frame.cost.cpu_ms);
    substeps.push_back(frame.cost.substeps);
    projections += frame.cost.projections;
    facts.raw_stretch = std::max(facts.raw_stretch, frame.raw_stretch);
    facts.stretch = std::max(facts.stretch, frame.stretch);
    facts.p99_stretch = std::max(facts.p99_stretch, frame.p99_stretch);
    facts.surface_stretch = std::max(facts.surface_stretch, frame.surface.max);
    facts.p99_surface_stretch = std::max(facts.p99_surface_stretch, frame.surface.p99);
    facts.not_certified += frame.cost.is_certified ? 0 : 1;
  }
  const double sum_ms = std::accumulate(times_ms.begin(), times_ms.end(), 0.0);
  facts.median_ms = ranked(times_ms, 0.5);
  facts.mean_ms = sum_ms / static_cast<double>(times_ms.size());
  facts.p99_ms = ranked(times_ms, 0.99);
  facts.median_substeps = ranked(substeps, 0.5);
  facts.most_substeps = ranked(substeps, 1.0);
  facts.projections_per_s = 1e3 * projections / sum_ms;
  return facts;
}

const char* name_of(StretchMeasure measure) {
  return measure == StretchMeasure::worst_edge ? "worst edge" : "99th percentile";
}

double stretch_by(StretchMeasure measure, const RunFacts& facts) {
  return measure == StretchMeasure::worst_edge ? facts.stretch : facts.p99_stretch;
}

int frames_over(const Run& run, double bound, StretchMeasure measure) {
  return static_cast<int>(std::count_if(run.frames.begin(), run.frames.end(), [&](const FrameSample& frame) {
    return !((measure == StretchMeasure::worst_edge ? frame.stretch : frame.p99_stretch) <= bound);
  }));
}

bool keeps(const Run& run, double bound, StretchMeasure measure) {
  return run.end == RunEnd::finished && !run.frames.empty() && frames_over(run, bound, measure) == 0;
}

const Run* best_run(const Heat& heat, const std::string& engine, double bound, StretchMeasure measure) {
  const Run* best = nullptr;
  double best_ms = std::numeric_limits<double>::infinity();
  for (const Run& run : heat.runs) {
    if (run.entrant.engine == engine && was_asked_for(run, bound) && keeps(run, bound, measure)) {
      const double ms = facts_of(run).median_ms;
      if (ms < best_ms) {
        best = &run;
        best_ms = ms;
      }
    }
  }
  return best;
}

const Run* closest_run(const Heat& heat, const std::string& engine, double bound) {
  const Run* closest = nullptr;
  for (const Run& run : heat.runs) {
    if (run.entrant.engine != engine || !was_asked_for(run, bound) || run.frames.empty()) {
      continue;
    }
    const bool first = run.end == RunEnd::finished;
    const bool last = closest != nullptr && closest->end == RunEnd::finished;
    if (closest == nullptr || (first && !last) ||
        (first == last && facts_of(run).stretch < facts_of(*closest).stretch)) {
      closest = &run;
    }
  }
  return closest;
}

std::vector<std::size_t> pareto_front(std::span<const DataPoint> points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return points[a] < points[b]; });
  std::vector<std::size_t> front;
  for (const std::size_t i : order) {
    if (front.empty() || points[i][1] < points[front.back()][1]) {
      front.push_back(i);
    }
  }
  return front;
}

std::optional<Growth> growth_of(const BenchResults& results, const std::string& scene,
                                const std::string& engine, double bound) {
  std::vector<DataPoint> points;
  for (const Heat& heat : results.heats) {
    const Run* best = heat.scene.name == scene ? best_run(heat, engine, bound) : nullptr;
    if (best != nullptr) {
      points.push_back({static_cast<double>(heat.size.triangles), facts_of(*best).median_ms});
    }
  }
  if (points.size() < 2) {
    return std::nullopt;
  }
  return Growth{fit_power_law(points).exponent, static_cast<int>(points.size())};
}

std::vector<std::string> engines_in(const BenchResults& results) {
  std::vector<std::string> engines;
  for (const Heat& heat : results.heats) {
    for (const Run& run : heat.runs) {
      if (std::find(engines.begin(), engines.end(), run.entrant.engine) == engines.end()) {
        engines.push_back(run.entrant.engine);
      }
    }
  }
  return engines;
}

std::optional<SpeedRatio> speed_ratio(const Heat& heat, double bound, const std::string& peer,
                                      double peer_bound, StretchMeasure measure) {
  const Run* bounded = best_run(heat, "bounded", bound, measure);
  const Run* other = best_run(heat, peer, peer_bound, measure);
  if (bounded == nullptr || other == nullptr) {
    return std::nullopt;
  }
  return SpeedRatio{facts_of(*bounded).median_ms, facts_of(*other).median_ms, other->entrant.settings};
}

}  // namespace taut::app
