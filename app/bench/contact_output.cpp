#include "app/bench/contact_output.hpp"

#include <fmt/core.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/bench/bench_output.hpp"

namespace taut::app {
namespace {

using Json = nlohmann::ordered_json;

// What lies beyond what was searched has no distance.
std::string millimetres(double distance_m) {
  return std::isfinite(distance_m) ? fmt::format("{:.4f}", 1e3 * distance_m) : "-";
}

std::string row_of(const ContactTrial& trial) {
  const ContactFacts facts = facts_of(trial.runs);
  return fmt::format(
      "{:<30}{:>6}{:>8}{:>9.1f}{:>8.0f}{:>8.0f}{:>8.0f}{:>8.1f}{:>8.1f}{:>9}{:>10}{:>10.5f}{:>7}{:>10}{:>8}  "
      "{}\n",
      trial.scene, trial.triangles, facts.frames, facts.median_ms, facts.p99_ms, facts.worst_ms,
      100.0 * facts.search_share, facts.detections, facts.partial_detections, facts.most_pairs,
      millimetres(facts.smallest_distance_m), 100.0 * facts.stretch, percent(trial.bound),
      facts.crossing_pairs, facts.broken_frames, fmt::format("{} of {}", facts.passed, trial.runs.size()));
}

std::string start_of(const ContactRun& run) {
  return run.seed == 0 ? "" : fmt::format(", start {}", run.seed);
}

std::string failures_of(const ContactTrial& trial) {
  std::string text;
  for (const ContactRun& run : trial.runs) {
    if (!run.first_broken.empty()) {
      text += fmt::format("  {}{}: {}\n", trial.scene, start_of(run), run.first_broken);
    }
  }
  return text;
}

Json facts_json(const ContactFacts& facts) {
  Json json = {{"frames", facts.frames},
               {"median_ms", facts.median_ms},
               {"p99_ms", facts.p99_ms},
               {"worst_ms", facts.worst_ms},
               {"search_share", facts.search_share},
               {"detections", facts.detections},
               {"partial_detections", facts.partial_detections},
               {"contact_pairs", facts.most_pairs},
               {"smallest_distance_m", nullptr},
               {"max_stretch", facts.stretch},
               {"crossing_pairs", facts.crossing_pairs},
               {"broken_frames", facts.broken_frames},
               {"passed", facts.passed}};
  if (std::isfinite(facts.smallest_distance_m)) {
    json["smallest_distance_m"] = facts.smallest_distance_m;
  }
  return json;
}

Json run_json(const ContactRun& run) {
  Json json = {{"seed", run.seed}};
  json.update(facts_json(facts_of({&run, 1})));
  json["passed"] = run.first_broken.empty();
  json["first_broken"] = run.first_broken.empty() ? Json() : Json(run.first_broken);
  return json;
}

Json trial_json(const ContactTrial& trial) {
  Json json = {{"scene", trial.scene}, {"triangles", trial.triangles}, {"bound", trial.bound}};
  json.update(facts_json(facts_of(trial.runs)));
  json["runs"] = Json::array();
  for (const ContactRun& run : trial.runs) {
    json["runs"].push_back(run_json(run));
  }
  return json;
}

}  // namespace

std::string contact_head(const std::string& vector_unit) {
  return "Processor time of a frame with contact, of all threads, with " + vector_unit +
         ". Of several runs the median of their medians, and the worst 99th percentile and frame.\n"
         "Searches for what is near: their part of the time, and how many a frame, through all and around "
         "single "
         "vertices.\n"
         "Pairs: the most that were kept apart at a time. Distance: the smallest of these pairs when a frame "
         "began, as the solver measured it.\n"
         "Stretch and crossing pairs: of every frame, the start included, by a way that shares nothing with "
         "the "
         "solver.\n\n"
         "                                 tri-               ms a frame           searches           most  "
         "distance   "
         "stretch         crossing  broken  runs\n"
         "scene                          angles  frames   median    99 %   worst       %     all  around    "
         "pairs        "
         "mm         %  bound     pairs  frames  passed\n";
}

std::string contact_row(const ContactTrial& trial) {
  return row_of(trial) + failures_of(trial);
}

std::string contact_json(std::span<const ContactTrial> trials, const Machine& machine) {
  Json json = {{"machine", machine_json(machine)}, {"jitter", jitter_part}, {"scenes", Json::array()}};
  for (const ContactTrial& trial : trials) {
    json["scenes"].push_back(trial_json(trial));
  }
  return json.dump(2) + "\n";
}

}  // namespace taut::app
