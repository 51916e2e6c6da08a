#include "app/report/judgements.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "app/figures/axis.hpp"

namespace taut::app {
namespace {

MeasuredNumber percent(std::string name, double fraction) {
  return {std::move(name), 100.0 * fraction, "%", 3};
}

std::string text_of(double value, const std::string& unit) {
  return number_text({"", value, unit, 2});
}

std::string percent_text(double fraction) {
  return text_of(100.0 * fraction, "%");
}

StretchNumbers stretch_of(const Recording& recording) {
  return {recording.last().record.stretch.max, recording.largest_stretch};
}

// The condition goes with the verdict that has one.
Judgement judged(Verdict verdict, std::string condition, std::string finding,
                 std::vector<MeasuredNumber> measured) {
  if (verdict != Verdict::holds_with_condition) {
    condition.clear();
  }
  return {verdict, std::move(condition), std::move(finding), std::move(measured)};
}

std::vector<double> medians_with(const std::vector<FrameTimes>& times, bool one_step) {
  std::vector<double> medians;
  for (const FrameTimes& time : times) {
    if ((time.substeps == 1) == one_step) {
      medians.push_back(time.median_ms());
    }
  }
  return medians;
}

const MethodRun& method_run(const Results& results, std::size_t rate, sim::SolverKind kind) {
  return results.methods[3 * rate + static_cast<std::size_t>(kind)];
}

double unrest_speed(const Results& results, std::size_t rate, sim::SolverKind kind) {
  const auto unrest = measure_unrest(method_run(results, rate, kind));
  return unrest ? unrest->speed_m_per_s : INFINITY;
}

double settled_stretch(const Results& results, sim::SolverKind kind) {
  const auto unrest = measure_unrest(method_run(results, 0, kind));
  return unrest ? unrest->largest_stretch : INFINITY;
}

}  // namespace

std::string number_text(const MeasuredNumber& number) {
  if (!std::isfinite(number.value)) {
    return "diverged";
  }
  std::string digits = fmt::format("{:.{}g}", number.value, number.digits);
  if (std::abs(number.value) >= 10.0 && std::abs(number.value) < 1e6) {
    // Never 8.5e+02, and no noughts behind a number of things.
    const bool is_whole = std::abs(number.value - std::round(number.value)) < 1e-9;
    const int decimals =
        is_whole ? 0 : std::max(0, number.digits - 1 - static_cast<int>(std::log10(std::abs(number.value))));
    digits = fmt::format("{:.{}f}", number.value, decimals);
  }
  const std::size_t e = digits.find('e');
  if (e != std::string::npos) {
    digits = digits.substr(0, e) + " × " + power_of_ten(std::stoi(digits.substr(e + 1)));
  }
  return digits + (number.unit.empty() ? "" : " ") + number.unit;
}

Judgement judge_bound(const Results& results) {
  const StretchNumbers grid = stretch_of(*results.pinned[0]);
  const StretchNumbers shirt = stretch_of(*results.shirts[0]);
  const StretchNumbers wind = stretch_of(*results.shirts[2]);
  std::vector<double> few_sweeps;
  std::vector<MeasuredNumber> measured = {percent("9x9 cloth", grid.at_end),
                                          percent("9x9 cloth, largest on the way", grid.on_the_way)};
  for (const SweepRun& run : results.sweeps) {
    few_sweeps.push_back(run.final_stretch);
    measured.push_back(percent(fmt::format("shirt, 1 step, {} sweeps", run.sweeps), run.final_stretch));
  }
  measured.push_back(percent("shirt, bounded at 1 %", shirt.at_end));
  measured.push_back(percent("the same, largest on the way", shirt.on_the_way));
  measured.push_back(percent("shirt in wind of 10 m/s, bounded at 1 %", wind.at_end));
  measured.push_back(percent("the same, largest on the way", wind.on_the_way));
  const SweepRun& fewest = results.sweeps.front();
  const SweepRun& most = results.sweeps.back();
  return judged(judge_stretch_bound(std::array{grid, shirt, wind}, few_sweeps),
                "at the end of a run, not in every frame; on fine meshes only with short time steps",
                fmt::format("At the end the 9x9 cloth is stretched by {}, the shirt in short steps and with "
                            "a certified bound of "
                            "1 % by {} and in a strong wind by {}; on the way they reach {}, {} and {}. To "
                            "the letter, with one "
                            "step a frame, the shirt ends at {} after {} sweeps a step and at {} after {}.",
                            percent_text(grid.at_end), percent_text(shirt.at_end), percent_text(wind.at_end),
                            percent_text(grid.on_the_way), percent_text(shirt.on_the_way),
                            percent_text(wind.on_the_way), percent_text(fewest.final_stretch), fewest.sweeps,
                            percent_text(most.final_stretch), most.sweeps),
                std::move(measured));
}

Judgement judge_fall(const Results& results) {
  const StepRecording& fall = *results.fall;
  const double peak_m = *std::max_element(fall.moved_m.begin(), fall.moved_m.end());
  const double last_m = fall.moved_m.back();
  return judged(
      judge_convergence(peak_m, last_m, fall.came_to_rest),
      "as far as the run went: the cloth had not come to rest",
      fmt::format("The point moves by {} at most in a step of {}, and by {} in the last of {} steps, "
                  "when the cloth {} come to rest.",
                  text_of(peak_m, "m"), text_of(1e3 * fall.time_step_s, "ms"), text_of(last_m, "m"),
                  fall.moved_m.size(), fall.came_to_rest ? "has" : "has not"),
      {{"largest movement in a step", peak_m, "m", 3},
       {"movement in the last step", last_m, "m", 3},
       {"steps", static_cast<double>(fall.moved_m.size()), "", 6}});
}

Judgement judge_velocity(const Results& results) {
  const RestartRun& restart = results.restart;
  const bool are_equal = restart.uninterrupted_hash == restart.restarted_hash;
  return judged(
      judge_no_velocity(restart.uninterrupted_hash, restart.restarted_hash), "",
      fmt::format("Taken up after {} steps from positions alone, the run {} the uninterrupted one {} "
                  "steps later.",
                  restart.steps_before, are_equal ? "is bit for bit" : "differs from", restart.steps_after),
      {{"runs that differ", are_equal ? 0.0 : 1.0, "", 1}});
}

Judgement judge_speed(const Results& results) {
  const std::vector<double> few = medians_with(results.frame_times, true);
  const std::vector<double> many = medians_with(results.frame_times, false);
  std::vector<MeasuredNumber> measured;
  for (const FrameTimes& time : results.frame_times) {
    measured.push_back({fmt::format("{} triangles, {} x {}", time.triangles, time.substeps, time.sweeps),
                        time.median_ms(), "ms", 3});
  }
  const double slowest_few_ms = *std::max_element(few.begin(), few.end());
  const double slowest_many_ms = *std::max_element(many.begin(), many.end());
  return judged(judge_real_time(few, many),
                slowest_few_ms <= slowest_many_ms
                    ? "with one step a frame, which lets fine models over-stretch"
                    : "with many short steps a frame",
                fmt::format("The slowest model takes {} with 1 step of 10 sweeps, a setting that leaves the "
                            "shirt stretched by {}; and {} with 100 steps of 1 sweep.",
                            text_of(slowest_few_ms, "ms"), percent_text(results.sweeps.front().final_stretch),
                            text_of(slowest_many_ms, "ms")),
                std::move(measured));
}

Judgement judge_cost(const Results& results) {
  const double few = fit_power_law(results.frame_times, 1).exponent;
  const double many = fit_power_law(results.frame_times, 100).exponent;
  return judged(
      judge_growth(std::min(few, many)), "in the levels of refinement, not in the number of triangles",
      fmt::format("Time grows as triangles to the power {:.2f} and {:.2f}: half the edge length, which is "
                  "four times the triangles, takes {:.1f} and {:.1f} times as long.",
                  few, many, std::pow(4.0, few), std::pow(4.0, many)),
      {{"exponent, 1 x 10", few, "", 3}, {"exponent, 100 x 1", many, "", 3}});
}

Judgement judge_any_garment(const Results& results) {
  std::vector<MappingNumbers> numbers;
  std::vector<MeasuredNumber> measured;
  std::size_t edges = 0, structural = 0, flexural = 0, loose = 0;
  for (const MappedModel& model : results.models) {
    numbers.push_back({model.edges, model.structural, model.flexural, model.loose_vertices});
    const auto add = [&](const char* what, std::size_t count) {
      measured.push_back({fmt::format("{}: {}", model.file, what), static_cast<double>(count), "", 6});
    };
    add("structural springs", model.structural);
    add("flexural springs", model.flexural);
    add("loose vertices", model.loose_vertices);
    edges += model.edges;
    structural += model.structural;
    flexural += model.flexural;
    loose += model.loose_vertices;
  }
  return judged(
      judge_mapping(numbers), "",
      fmt::format("The {} edges of {} models give {} structural and {} flexural springs; {} vertices are "
                  "held by none. One shirt at several precisions is evidence, not proof for any garment.",
                  edges, results.models.size(), structural, flexural, loose),
      std::move(measured));
}

Judgement judge_threshold(const Results& results) {
  UnrestNumbers numbers[2];
  std::vector<MeasuredNumber> measured;
  for (const sim::SolverKind kind : {sim::SolverKind::provot, sim::SolverKind::strong}) {
    const bool is_strong = kind == sim::SolverKind::strong;
    const double short_step = unrest_speed(results, 0, kind), long_step = unrest_speed(results, 1, kind);
    numbers[is_strong ? 1 : 0] = {short_step, long_step};
    const std::string name = is_strong ? "strong" : "threshold";
    measured.push_back({name + ", short step", short_step, "m/s", 3});
    measured.push_back({name + ", long step", long_step, "m/s", 3});
  }
  const auto& [threshold, strong] = numbers;
  return judged(
      judge_threshold_vibrates(threshold, strong),
      threshold.long_step_m_per_s > vibration_m_per_s
          ? "only with time steps that are too long for the springs themselves"
          : "only with the short time step",
      fmt::format("With steps of 1/{:.0f} s the cloth with a threshold ends at a speed of {}, with the "
                  "strong constraint {}; with steps of 1/{:.0f} s at {} and {}.",
                  method_rates_hz[0], text_of(threshold.short_step_m_per_s, "m/s"),
                  text_of(strong.short_step_m_per_s, "m/s"), method_rates_hz[1],
                  text_of(threshold.long_step_m_per_s, "m/s"), text_of(strong.long_step_m_per_s, "m/s")),
      std::move(measured));
}

Judgement judge_ideal(const Results& results) {
  const double ideal = settled_stretch(results, sim::SolverKind::ideal);
  const double strong = settled_stretch(results, sim::SolverKind::strong);
  return judged(
      judge_ideal_overstretches(ideal, strong), "for springs as soft as those of the test",
      fmt::format("Ideal springs settle at {}, the strong constraint at {}. By Hooke's law springs {:.1f} "
                  "times as stiff would stay within 5 %.",
                  percent_text(ideal), percent_text(strong), ideal / stretch_bound),
      {percent("ideal", ideal), percent("strong", strong)});
}

}  // namespace taut::app
