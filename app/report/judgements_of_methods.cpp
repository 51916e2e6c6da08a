#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "app/report/judgements.hpp"

namespace taut::app {
namespace {

using enum sim::SolverKind;

/// Methods that the paper argues with: neither its own method nor this program's.
constexpr std::array others = {ideal, provot, implicit, vassilev, fast_projection};

const MethodTrials& timed(const Results& results) {
  return results.trials_of(MethodTest::time);
}

double median_ms(const Results& results, sim::SolverKind kind, int triangles) {
  return trial_of(timed(results), kind, triangles).ranked_ms(0.5);
}

void append(std::string& list, const std::string& entry) {
  list += (list.empty() ? "" : ", ") + entry;
}

std::string mesh_name(int triangles) {
  return triangles == trial_grid_triangles ? "the 9x9 cloth" : fmt::format("{} triangles", triangles);
}

/// How many times as long as `own` the fastest of the `slower` takes, per mesh, with what says so.
struct Speeds {
  std::vector<double> times_as_long;
  std::string text, enough;  ///< `enough`: the meshes on which it is at least `least`
  Finding finding;
};

Speeds speeds_of(const Results& results, sim::SolverKind own, std::span<const sim::SolverKind> slower,
                 double least) {
  Speeds speeds;
  for (const int triangles : trial_meshes) {
    const double own_ms = median_ms(results, own, triangles);
    double fastest_ms = INFINITY;
    for (const sim::SolverKind kind : slower) {
      fastest_ms = std::min(fastest_ms, median_ms(results, kind, triangles));
    }
    speeds.times_as_long.push_back(fastest_ms / own_ms);
    append(speeds.text, fmt::format("{:.2g} on {}", speeds.times_as_long.back(), mesh_name(triangles)));
    if (speeds.times_as_long.back() >= least) {
      append(speeds.enough, mesh_name(triangles));
    }
    speeds.finding.measured.push_back({mesh_name(triangles) + ", a frame", own_ms, "ms", 3});
    speeds.finding.measured.push_back({"the same, the fastest compared with", fastest_ms, "ms", 3});
  }
  return speeds;
}

Finding pace_of_bounded(const Results& results) {
  Finding finding;
  std::string times;
  for (const int triangles : trial_meshes) {
    const double ms = median_ms(results, bounded, triangles);
    append(times, fmt::format("{} on {}", text_of(ms, "ms"), mesh_name(triangles)));
    finding.measured.push_back({mesh_name(triangles) + ", a frame", ms, "ms", 3});
  }
  finding.text = "It takes " + times + ".";
  return finding;
}

void add_speed(const MethodTrial& trial, Finding& finding) {
  finding.measured.push_back(
      {std::string(name_of(trial.kind)) + ", at the end", trial.last_speed_m_per_s(), "m/s", 3});
}

/// The largest stretch for each of the lengths of a time step; they are told after what is told already.
std::vector<double> stretches_by_step(const Results& results, sim::SolverKind kind, Finding& finding) {
  std::vector<double> stretches;
  std::string told;
  for (const int factor : trial_step_factors) {
    const MethodTrial& trial =
        trial_of(results.trials_of(MethodTest::steps), kind, trial_shirt_triangles, factor);
    stretches.push_back(trial.largest_stretch());
    append(told, percent_text(stretches.back()));
    finding.measured.push_back(
        percent_number(fmt::format("{}, step times {}", name_of(kind), factor), stretches.back()));
  }
  finding.text += fmt::format("{} {} {}", finding.text.ends_with(':') ? "" : ";", name_of(kind), told);
  return stretches;
}

}  // namespace

Judgement judge_large_steps(const Results& results) {
  Speeds speeds = speeds_of(results, implicit, std::array{ideal}, significantly_faster);
  speeds.finding.text = fmt::format(
      "Explicit steps with ideal springs take so many times as long as implicit ones: {}.", speeds.text);
  return judged(judge_faster(speeds.times_as_long, significantly_faster), "on " + speeds.enough,
                std::move(speeds.finding), pace_of_bounded(results));
}

Judgement judge_execution(const Results& results) {
  Speeds speeds = speeds_of(results, strong, others, 1.0);
  speeds.finding.text = fmt::format(
      "The fastest of the others takes so many times as long: {}. The edges of the finest shirt are "
      "stretched by {} meanwhile.",
      speeds.text, percent_text(trial_of(timed(results), strong, trial_meshes.back()).largest_stretch()));
  return judged(judge_faster(speeds.times_as_long, 1.0), "on " + speeds.enough, std::move(speeds.finding),
                pace_of_bounded(results));
}

Judgement judge_threshold_force(const Results& results) {
  const MethodTrials& trials = results.trials_of(MethodTest::rest);
  const double with = trial_of(trials, vassilev).last_speed_m_per_s();
  const double without = trial_of(trials, ideal).last_speed_m_per_s();
  Finding finding, of_bounded;
  for (const sim::SolverKind kind : others) {
    add_speed(trial_of(trials, kind), finding);
  }
  add_speed(trial_of(trials, strong), finding);
  finding.text =
      fmt::format("With Vassilev's threshold it moves at {}, with the same springs and none at {}.",
                  text_of(with, "m/s"), text_of(without, "m/s"));
  add_speed(trial_of(trials, bounded), of_bounded);
  of_bounded.text =
      fmt::format("It moves at {}.", text_of(trial_of(trials, bounded).last_speed_m_per_s(), "m/s"));
  return judged(judge_threshold_unrest(with, without),
                "it moves more than twice as fast as without a threshold, but less than can be seen",
                std::move(finding), std::move(of_bounded));
}

Judgement judge_neighbours(const Results& results) {
  std::vector<double> multiples;
  std::string exceeding, told;
  Finding finding;
  for (const sim::SolverKind kind : {provot, fast_projection}) {
    double least = INFINITY, most = 0.0;
    for (const int triangles : trial_meshes) {
      const double stretch = trial_of(timed(results), kind, triangles).largest_stretch();
      least = std::min(least, stretch);
      most = std::max(most, stretch);
      finding.measured.push_back(
          percent_number(fmt::format("{}, {}", name_of(kind), mesh_name(triangles)), stretch));
    }
    multiples.push_back(least / trial_max_stretch);
    append(told, fmt::format("{} {} to {}", name_of(kind), percent_text(least), percent_text(most)));
    if (multiples.back() > 1.0 + threshold_excess) {
      append(exceeding, name_of(kind));
    }
  }
  finding.text = fmt::format("Asked for {:g} %, the most stretched edge of the meshes reaches with {}.",
                             100.0 * trial_max_stretch, told);
  return judged(judge_neighbours_stretch(multiples), "with " + exceeding, std::move(finding));
}

Judgement judge_others_stretch(const Results& results) {
  std::vector<double> stretches;
  std::string told;
  Finding finding;
  for (const sim::SolverKind kind : others) {
    stretches.push_back(trial_of(timed(results), kind, trial_meshes.back()).largest_stretch());
    append(told, fmt::format("{} {}", name_of(kind), percent_text(stretches.back())));
    finding.measured.push_back(percent_number(name_of(kind), stretches.back()));
  }
  const double own = trial_of(timed(results), strong, trial_meshes.back()).largest_stretch();
  finding.measured.push_back(percent_number(name_of(strong), own));
  finding.text = fmt::format("{}. The paper's own method, with 20 steps of 4 sweeps a frame, {}.", told,
                             percent_text(own));
  const auto over = std::count_if(stretches.begin(), stretches.end(),
                                  [](double stretch) { return stretch > paper_stretch_bound; });
  const double of_bounded = trial_of(timed(results), bounded, trial_meshes.back()).largest_stretch();
  return judged(judge_stretch_ignored(stretches), fmt::format("of {} of {}", over, stretches.size()),
                std::move(finding),
                {fmt::format("It reaches {}.", number_text(percent_number("", of_bounded))),
                 {percent_number(name_of(bounded), of_bounded)}});
}

Judgement judge_robustness(const Results& results) {
  Finding finding = {"With its own time step, and with 2 and 5 times that:", {}};
  Finding of_bounded = finding;
  const std::vector<double> stretches = stretches_by_step(results, strong, finding);
  for (const sim::SolverKind kind : others) {
    stretches_by_step(results, kind, finding);
  }
  stretches_by_step(results, bounded, of_bounded);
  finding.text += '.';
  of_bounded.text += '.';
  return judged(judge_robust(stretches), "it is never lost, but does not keep 5 %", std::move(finding),
                std::move(of_bounded));
}

}  // namespace taut::app
