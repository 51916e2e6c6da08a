#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "app/base/counted.hpp"
#include "app/report/judgements.hpp"

namespace taut::app {
namespace {

const MethodRun& method_run(const Results& results, std::size_t rate, sim::SolverKind kind) {
  return results.methods[3 * rate + static_cast<std::size_t>(kind)];
}

double unrest_speed(const Results& results, std::size_t rate, sim::SolverKind kind) {
  const auto unrest = measure_unrest(method_run(results, rate, kind));
  return unrest ? unrest->speed_m_per_s : INFINITY;
}

double settled_stretch(const MethodRun& run) {
  const auto unrest = measure_unrest(run);
  return unrest ? unrest->largest_stretch : INFINITY;
}

std::size_t count(const std::vector<GarmentTrial>& trials, bool (*predicate)(const GarmentTrial&)) {
  return static_cast<std::size_t>(std::count_if(trials.begin(), trials.end(), predicate));
}

Finding garments_of_bounded(const std::vector<GarmentTrial>& trials) {
  const std::size_t kept = count(trials, [](const GarmentTrial& trial) {
    return trial.refusal.empty() && trial.bounded.largest_stretch <= trial_bound;
  });
  Finding finding;
  double slowest_ms = 0.0;
  for (const GarmentTrial& trial : trials) {
    if (!trial.refusal.empty()) {
      continue;
    }
    slowest_ms = std::max(slowest_ms, trial.bounded.median_ms);
    finding.measured.push_back(percent_number(trial.file, trial.bounded.largest_stretch));
  }
  finding.text = fmt::format(
      "Asked for {:g} %, it keeps it in every frame of {} of {} garments, at {} a frame for the "
      "slowest, while other experiments ran.",
      100.0 * trial_bound, kept, trials.size(), text_of(slowest_ms, "ms"));
  return finding;
}

std::string refused_text(const std::vector<GarmentTrial>& trials) {
  std::string text;
  for (const GarmentTrial& trial : trials) {
    if (!trial.refusal.empty()) {
      text += fmt::format(" {} was refused: {}.", trial.file, trial.refusal);
    } else if (!is_mapped(trial.mapping)) {
      text += fmt::format(" {} has {} and {}, {}, {}.", trial.file, counted(trial.mapping.edges, "edge"),
                          counted(trial.mapping.structural, "structural spring"),
                          counted(trial.mapping.flexural, "flexural spring"),
                          counted(trial.mapping.loose_vertices, "loose vertex", "loose vertices"));
    }
  }
  return text;
}

}  // namespace

Judgement judge_garments(const Results& results) {
  const std::vector<GarmentTrial>& trials = results.garments;
  const std::size_t mapped =
      count(trials, [](const GarmentTrial& trial) { return is_mapped(trial.mapping); });
  const std::size_t simulated = count(trials, [](const GarmentTrial& trial) {
    return trial.refusal.empty() && std::isfinite(trial.strong.largest_stretch);
  });
  const std::size_t kept = count(trials, [](const GarmentTrial& trial) {
    return trial.refusal.empty() && trial.strong.largest_stretch <= paper_stretch_bound;
  });
  std::set<std::string> formats;
  Finding finding;
  for (const GarmentTrial& trial : trials) {
    formats.insert(trial.file.substr(trial.file.rfind('.') + 1));
    if (!trial.refusal.empty()) {
      continue;
    }
    finding.measured.push_back(percent_number(
        fmt::format("{}: {}, {} triangles; {} structural and {} flexural springs, stretched by", trial.file,
                    trial.kind, trial.mapping.triangles, trial.mapping.structural, trial.mapping.flexural),
        trial.strong.largest_stretch));
  }
  finding.text = fmt::format(
      "Of {} garments in {} formats {} are mapped to springs, {} simulated to the end, and {} of them within "
      "{:g} % in every frame.{} A sample is evidence, not proof for any garment.",
      trials.size(), formats.size(), mapped, simulated, kept, 100.0 * paper_stretch_bound,
      refused_text(trials));
  return judged(judge_any_garment(trials),
                fmt::format("all are mapped and simulated, {} of {} within the bound", kept, trials.size()),
                finding, garments_of_bounded(trials));
}

Judgement judge_threshold(const Results& results) {
  UnrestNumbers numbers[2];
  Finding finding;
  for (const sim::SolverKind kind : {sim::SolverKind::provot, sim::SolverKind::strong}) {
    const bool is_strong = kind == sim::SolverKind::strong;
    const double short_step = unrest_speed(results, 0, kind), long_step = unrest_speed(results, 1, kind);
    numbers[is_strong ? 1 : 0] = {short_step, long_step};
    const std::string name = is_strong ? "strong" : "threshold";
    finding.measured.push_back({name + ", short step", short_step, "m/s", 3});
    finding.measured.push_back({name + ", long step", long_step, "m/s", 3});
  }
  const auto& [threshold, strong] = numbers;
  finding.text = fmt::format(
      "With steps of 1/{:.0f} s the cloth with a threshold ends at a speed of {}, with the "
      "strong constraint {}; with steps of 1/{:.0f} s at {} and {}.",
      method_rates_hz[0], text_of(threshold.short_step_m_per_s, "m/s"),
      text_of(strong.short_step_m_per_s, "m/s"), method_rates_hz[1],
      text_of(threshold.long_step_m_per_s, "m/s"), text_of(strong.long_step_m_per_s, "m/s"));
  const bool is_with_long =
      judge_threshold_vibrates({threshold.long_step_m_per_s, threshold.long_step_m_per_s},
                               {strong.long_step_m_per_s, strong.long_step_m_per_s}) == Verdict::holds;
  return judged(judge_threshold_vibrates(threshold, strong),
                fmt::format("with steps of 1/{:.0f} s, not with those of 1/{:.0f} s",
                            method_rates_hz[is_with_long ? 1 : 0], method_rates_hz[is_with_long ? 0 : 1]),
                finding);
}

Judgement judge_ideal(const Results& results) {
  const double strong = settled_stretch(method_run(results, 0, sim::SolverKind::strong));
  std::vector<double> ideal;
  std::string settled, soft, stiff;
  Finding finding;
  for (const MethodRun& run : results.ideal_stiffnesses) {
    ideal.push_back(settled_stretch(run));
    std::string& group = ideal.back() > paper_stretch_bound ? soft : stiff;
    group += fmt::format("{}{:g}", group.empty() ? "" : ", ", run.stiffness_n_per_m);
    settled += fmt::format("{}{} with {:g} N/m", settled.empty() ? "" : ", ", percent_text(ideal.back()),
                           run.stiffness_n_per_m);
    finding.measured.push_back(
        percent_number(fmt::format("ideal, {:g} N/m", run.stiffness_n_per_m), ideal.back()));
  }
  finding.measured.push_back(percent_number("strong", strong));
  finding.text =
      fmt::format("Ideal springs settle at {}; the strong constraint at {}.", settled, percent_text(strong));
  return judged(judge_ideal_overstretches(ideal, strong),
                fmt::format("with springs of {} N/m, not with those of {} N/m", soft, stiff), finding);
}

}  // namespace taut::app
