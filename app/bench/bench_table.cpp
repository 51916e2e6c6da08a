#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "app/bench/bench_output.hpp"
#include "app/bench/engines/bullet_engine.hpp"

namespace taut::app {
namespace {

std::string line_of(const Run& run, double bound, double strong_speed, double sweep_speed) {
  const RunFacts facts = facts_of(run);
  const std::string against_strong =
      strong_speed > 0.0 ? fmt::format("{:8.1f}x", facts.projections_per_s / strong_speed) : "        -";
  return fmt::format(
      "{:8.2f} {:8.2f} {:9.3f} {:9.3f} {:9.3f} {:9.3f} {:9.3f} {:6} {:6} {:8.0f} {:6.1f}% {}  {}\n",
      facts.median_ms, facts.mean_ms, 100.0 * facts.raw_stretch, 100.0 * facts.stretch,
      100.0 * facts.p99_stretch, 100.0 * facts.surface_stretch, 100.0 * facts.p99_surface_stretch,
      frames_over(run, bound), facts.not_certified, 1e-6 * facts.projections_per_s,
      100.0 * facts.projections_per_s / sweep_speed, against_strong, run.entrant.settings);
}

std::string failure_of(const Run& run) {
  const std::string end = run.end == RunEnd::finished
                              ? ""
                              : fmt::format(", {} after {} frames", name_of(run.end), run.frames.size());
  const RunFacts facts = facts_of(run);
  return fmt::format(
      "   none of its settings keeps it; closest: worst edge {:.3g} %, p99 {:.3g} %, surface {:.3g} %, its "
      "p99 {:.3g} % at {:.3g} ms, {}{}\n",
      100.0 * facts.stretch, 100.0 * facts.p99_stretch, 100.0 * facts.surface_stretch,
      100.0 * facts.p99_surface_stretch, facts.median_ms, run.entrant.settings, end);
}

std::string cell_line(const Heat& heat, const std::string& engine, double bound) {
  const std::string head = fmt::format("  {:>6}  {:<8}", percent(bound), title_of_engine(engine));
  const Run* best = best_run(heat, engine, bound);
  if (best != nullptr) {
    return head + line_of(*best, bound, strong_projections_per_s(heat), heat.sweeps.back().springs_per_s);
  }
  const Run* closest = closest_run(heat, engine, bound);
  if (closest == nullptr) {
    return head + "   did not get to its first frame\n";
  }
  // An engine that was asked for the bound shows what it did instead; one that was not shows how close it
  // came.
  return head +
         (closest->entrant.bound && closest->end == RunEnd::finished
              ? line_of(*closest, bound, strong_projections_per_s(heat), heat.sweeps.back().springs_per_s)
              : failure_of(*closest));
}

std::string heat_table(const BenchResults& results, const Heat& heat) {
  std::string text = fmt::format(
      "\n{}, {} triangles: {}\n"
      "   bound  engine     median     mean    before     worst       p99   surface   surface "
      "frames   not   million  of the   times\n"
      "                   ms/frame ms/frame  corr., %   edge, %         %   max., %    p99, %   "
      "over certif.   proj./s sweep  strong  setting\n",
      heat.scene.name, heat.size.triangles, heat.scene.meaning);
  for (const double bound : results.bounds) {
    for (const std::string& engine : engines_in(results)) {
      text += cell_line(heat, engine, bound);
    }
  }
  return text;
}

std::string ratio_lines(const Heat& heat) {
  std::string text;
  for (const std::string peer : {"bullet", "strong"}) {
    for (const StretchMeasure measure : stretch_measures) {
      if (const auto ratio = speed_ratio(heat, 0.01, peer, 0.05, measure)) {
        text += fmt::format(
            "  {}, {} triangles, by {}: bounded at 1 % ({:.2f} ms) is {:.1f} times faster than {} at 5 % "
            "({:.1f} ms, {})\n",
            heat.scene.name, heat.size.triangles, name_of(measure), ratio->bounded_ms, ratio->ratio(),
            title_of_engine(peer), ratio->peer_ms, ratio->peer_settings);
      }
    }
  }
  return text;
}

std::string growth_lines(const BenchResults& results) {
  std::string text;
  for (const std::string& scene : bench_scene_names()) {
    for (const double bound : results.bounds) {
      for (const std::string& engine : engines_in(results)) {
        if (const auto growth = growth_of(results, scene, engine, bound)) {
          text += fmt::format("  {:<8} {:>6}  {:<8} triangles to the power {:.2f} ({} sizes)\n", scene,
                              percent(bound), title_of_engine(engine), growth->exponent, growth->sizes);
        }
      }
    }
  }
  return text;
}

std::string sweep_lines(const BenchResults& results) {
  std::string text;
  for (const Heat& heat : results.heats) {
    for (const SweepSpeed& sweep : heat.sweeps) {
      text += fmt::format("  {:<8} {:>6} triangles  {:<7} {:6.0f} million springs per second\n",
                          heat.scene.name, heat.size.triangles, sweep.unit, 1e-6 * sweep.springs_per_s);
    }
  }
  return text;
}

std::string titled(const std::string& title, const std::string& lines) {
  return lines.empty() ? "" : "\n" + title + "\n" + lines;
}

}  // namespace

std::string percent(double fraction) {
  return fmt::format("{:g} %", 100.0 * fraction);
}

std::string title_of_engine(const std::string& engine) {
  return engine == "bullet" ? "Bullet" : engine;
}

double strong_projections_per_s(const Heat& heat) {
  double most = 0.0;
  for (const Run& run : heat.runs) {
    if (run.entrant.engine == "strong") {
      most = std::max(most, facts_of(run).projections_per_s);
    }
  }
  return most;
}

std::string bench_table(const BenchResults& results) {
  std::string text = fmt::format(
      "{} frames of 1/{:g} s, engines in turns; processor time. For each bound the fastest setting whose "
      "worst edge keeps it in every frame.\n"
      "Of every engine: the worst edge of all frames, and p99, which 99 of 100 edges of no frame exceed, "
      "both measured from its positions.\n"
      "Surface: the same two of the triangles, along the direction that is stretched most. It ranks no "
      "engine.\n"
      "Projections a second are of springs, or of triangles where those are held; the sweep is that of "
      "springs.\n",
      results.frames, results.frame_rate_hz);
  if (bullet_version().empty()) {
    text += "Bullet was not there when this program was built: it is not compared.\n";
  }
  std::string ratios;
  for (const Heat& heat : results.heats) {
    text += heat_table(results, heat);
    ratios += ratio_lines(heat);
  }
  text += titled("How much faster", ratios);
  text += titled("How time grows", growth_lines(results));
  return text + titled("What the sweep of bounded alone corrects, one core", sweep_lines(results));
}

}  // namespace taut::app
