#include "app/report/judgements.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace taut::app {
namespace {

std::string models_text(const std::set<int>& models) {
  if (models.empty()) {
    return "none of the models";
  }
  std::string text = models.size() == 1 ? "the model of" : "the models of";
  for (const int triangles : models) {
    const bool is_first = triangles == *models.begin(), is_last = triangles == *models.rbegin();
    text += fmt::format("{} {}", is_first ? "" : is_last ? " and" : ",", triangles);
  }
  return text + " triangles";
}

std::string setting_text(int substeps, int sweeps) {
  return fmt::format("{} step{} x {} sweep{}", substeps, substeps == 1 ? "" : "s", sweeps,
                     sweeps == 1 ? "" : "s");
}

// The cloth as figure 4 draws it is one of them.
std::vector<StrongRun> all_strong_runs(const Results& results) {
  const Recording& cloth = *results.pinned[0];
  const SolverChoice& solver = cloth.scene.simulation.solver;
  std::vector<StrongRun> runs = {{"9x9 cloth, as in figure 4",
                                  false,
                                  solver.substeps.value_or(0),
                                  solver.strong.iterations,
                                  {cloth.last().record.stretch.max, cloth.largest_stretch},
                                  cloth.largest_surface_stretch}};
  runs.insert(runs.end(), results.strong_runs.begin(), results.strong_runs.end());
  return runs;
}

std::string name_of(const StrongRun& run) {
  return fmt::format("{}, {}{}", run.garment, setting_text(run.substeps, run.sweeps),
                     run.is_rigid ? ", rigid both ways" : "");
}

bool is_worse(const StrongRun& a, const StrongRun& b) {
  return a.stretch.on_the_way < b.stretch.on_the_way;
}

const FrameTimes& times_of_finest(const std::vector<FrameTimes>& times) {
  return *std::max_element(times.begin(), times.end(),
                           [](const auto& a, const auto& b) { return a.triangles < b.triangles; });
}

std::string in_wind(const Recording& run) {
  const double speed_m_per_s = run.scene.surroundings.forces.wind.speed_m_per_s;
  return speed_m_per_s > 0.0 ? fmt::format("in a wind of {:g} m/s", speed_m_per_s) : "in still air";
}

Finding bound_of_bounded(const Results& results) {
  Finding finding;
  for (const std::optional<Recording>& run : results.shirts) {
    const std::string name = fmt::format("{}, asked for {:g} %", in_wind(*run),
                                         100.0 * run->scene.simulation.solver.bounded.max_stretch);
    finding.text += fmt::format("{}{} it reaches {}", finding.text.empty() ? "On the shirt " : "; ", name,
                                number_text(percent_number("", run->largest_stretch)));
    finding.measured.push_back(percent_number("shirt " + name, run->largest_stretch));
  }
  const FrameTimes& times = times_of_finest(results.bounded_times);
  finding.text += fmt::format(". A frame of {} triangles takes it {}.", times.triangles,
                              text_of(times.median_ms(), "ms"));
  finding.measured.push_back(
      {fmt::format("a frame of {} triangles, median", times.triangles), times.median_ms(), "ms", 3});
  return finding;
}

std::string told(double springs, const sim::SurfaceStretch& surface) {
  const auto text = [](double fraction) { return number_text(percent_number("", fraction)); };
  return fmt::format("springs {}, the surface {}, 99 of 100 triangles {}", text(springs), text(surface.max),
                     text(surface.p99));
}

void add_surface(const std::string& name, double springs, const sim::SurfaceStretch& surface,
                 Finding& finding) {
  finding.measured.push_back(percent_number(name + ": springs", springs));
  finding.measured.push_back(percent_number("the same, surface", surface.max));
  finding.measured.push_back(percent_number("the same, 99 of 100 triangles", surface.p99));
}

Finding surface_of_bounded(const Results& results) {
  Finding finding;
  for (const std::optional<Recording>& run : results.shirts) {
    const sim::BoundedSettings& asked = run->scene.simulation.solver.bounded;
    const std::string name = fmt::format("{}, asked to keep its {} within {:g} %", in_wind(*run),
                                         sim::name_of(asked.bound), 100.0 * asked.max_stretch);
    finding.text += fmt::format("{}{}: {}", finding.text.empty() ? "The shirt " : "; ", name,
                                told(run->largest_stretch, run->largest_surface_stretch));
    add_surface("shirt " + name, run->largest_stretch, run->largest_surface_stretch, finding);
  }
  finding.text += '.';
  return finding;
}

std::vector<PacedModel> paced_models(const std::vector<FrameTimes>& times) {
  std::vector<PacedModel> models;
  for (const FrameTimes& time : times) {
    models.push_back({time.triangles, time.median_ms(), time.largest_stretch});
  }
  return models;
}

std::set<int> models_in_real_time(const std::vector<PacedModel>& models) {
  std::set<int> in_time;
  for (const PacedModel& model : models) {
    if (is_in_real_time(model)) {
      in_time.insert(model.triangles);
    }
  }
  return in_time;
}

void add_paced(const FrameTimes& time, const std::string& setting, Finding& finding) {
  const std::string name = fmt::format("{} triangles{}", time.triangles, setting);
  finding.measured.push_back({name + ", a frame", time.median_ms(), "ms", 3});
  finding.measured.push_back(percent_number(name + ", largest stretch", time.largest_stretch));
}

Finding pace_of_bounded(const std::vector<FrameTimes>& times) {
  const FrameTimes& finest = times_of_finest(times);
  Finding finding;
  finding.text = fmt::format(
      "In real time and within {:g} %: {}. The finest model takes it {} a frame and is stretched by {}.",
      100.0 * paper_stretch_bound, models_text(models_in_real_time(paced_models(times))),
      text_of(finest.median_ms(), "ms"), number_text(percent_number("", finest.largest_stretch)));
  for (const FrameTimes& time : times) {
    add_paced(time, "", finding);
  }
  return finding;
}

}  // namespace

Judgement judged(Verdict verdict, std::string part, Finding finding, Finding bounded) {
  if (verdict != Verdict::holds_in_part) {
    part.clear();
  }
  return {verdict, std::move(part), std::move(finding), std::move(bounded)};
}

Judgement judge_overstretch(const Results& results) {
  const std::vector<StrongRun> runs = all_strong_runs(results);
  std::vector<StretchNumbers> numbers;
  Finding finding;
  int kept = 0;
  for (const StrongRun& run : runs) {
    numbers.push_back(run.stretch);
    kept += judge_stretch_bound({&run.stretch, 1}) == Verdict::holds ? 1 : 0;
    finding.measured.push_back(percent_number(name_of(run) + ": at the end", run.stretch.at_end));
    finding.measured.push_back(percent_number("the same, on the way", run.stretch.on_the_way));
  }
  const StrongRun& worst = *std::max_element(runs.begin(), runs.end(), is_worse);
  const StrongRun& best = *std::min_element(runs.begin(), runs.end(), is_worse);
  const auto told = [](const StretchNumbers& stretch) {
    return fmt::format("{} on the way and {} at the end", percent_text(stretch.on_the_way),
                       percent_text(stretch.at_end));
  };
  finding.text = fmt::format(
      "{} of {} runs keep 5 % in every frame. The cloth of figure 4 reaches {}. The run that stretches most "
      "({}) reaches {}, the one that stretches least ({}) {}.",
      kept, runs.size(), told(runs.front().stretch), name_of(worst), told(worst.stretch), name_of(best),
      told(best.stretch));
  return judged(judge_stretch_bound(numbers), "at the end of every run, not in every frame", finding,
                bound_of_bounded(results));
}

Judgement judge_surface(const Results& results) {
  const std::vector<StrongRun> runs = all_strong_runs(results);
  std::vector<SurfaceNumbers> numbers;
  Finding finding;
  int most_stretched = 0, one_in_a_hundred = 0;
  for (const StrongRun& run : runs) {
    const double springs = run.stretch.on_the_way;
    numbers.push_back({springs, run.surface});
    most_stretched += exceeds_springs(run.surface.max, springs) ? 1 : 0;
    one_in_a_hundred += exceeds_springs(run.surface.p99, springs) ? 1 : 0;
    add_surface(name_of(run), springs, run.surface, finding);
  }
  const StrongRun& best = *std::min_element(runs.begin(), runs.end(), is_worse);
  finding.text = fmt::format(
      "The most stretched triangle exceeds the most stretched spring by more than {:g} % in {} of {} runs, "
      "one "
      "triangle in a hundred in {}. The cloth of figure 4: {}. The run whose springs stretch least ({}): {}.",
      100.0 * surface_excess, most_stretched, runs.size(), one_in_a_hundred,
      told(runs.front().stretch.on_the_way, runs.front().surface), name_of(best),
      told(best.stretch.on_the_way, best.surface));
  return judged(judge_free_surface(numbers), "the most stretched triangle of every run, not one in a hundred",
                finding, surface_of_bounded(results));
}

Judgement judge_fall(const Results& results) {
  const StepRecording& fall = *results.fall;
  const double peak_m = *std::max_element(fall.moved_m.begin(), fall.moved_m.end());
  const double last_m = fall.moved_m.back();
  return judged(
      judge_convergence(peak_m, last_m, fall.came_to_rest),
      "the movement has shrunk to less than a tenth, the cloth had not come to rest",
      {fmt::format("The point moves by {} at most in a step of {}, and by {} in the last of {} steps, "
                   "when the cloth {} come to rest.",
                   text_of(peak_m, "m"), text_of(1e3 * fall.time_step_s, "ms"), text_of(last_m, "m"),
                   fall.moved_m.size(), fall.came_to_rest ? "has" : "has not"),
       {{"largest movement in a step", peak_m, "m", 3},
        {"movement in the last step", last_m, "m", 3},
        count_number("steps", fall.moved_m.size())}});
}

Judgement judge_velocity(const Results& results) {
  const RestartRun& restart = results.restart;
  const bool are_equal = restart.uninterrupted_hash == restart.restarted_hash;
  return judged(
      judge_no_velocity(restart.uninterrupted_hash, restart.restarted_hash), "",
      {fmt::format("Taken up after {} steps from positions alone, the run {} the uninterrupted one {} "
                   "steps later.",
                   restart.steps_before, are_equal ? "is bit for bit" : "differs from", restart.steps_after),
       {count_number("runs that differ", are_equal ? 0 : 1)}});
}

Judgement judge_speed(const Results& results) {
  Finding finding;
  for (const FrameTimes& time : results.frame_times) {
    add_paced(time, ", " + setting_text(time.substeps, time.sweeps), finding);
  }
  const std::vector<PacedModel> models = paced_models(results.frame_times);
  const std::string in_time = models_text(models_in_real_time(models));
  const int finest = times_of_finest(results.frame_times).triangles;
  finding.text = fmt::format("In real time and within {:g} %: {}. The finest model",
                             100.0 * paper_stretch_bound, in_time);
  for (std::size_t i = 0; i < models.size(); ++i) {
    if (models[i].triangles == finest) {
      finding.text +=
          fmt::format("{} {} a frame with {} and is stretched by {}",
                      finding.text.ends_with("model") ? " takes" : ";", text_of(models[i].frame_ms, "ms"),
                      setting_text(results.frame_times[i].substeps, results.frame_times[i].sweeps),
                      percent_text(models[i].stretch));
    }
  }
  finding.text += '.';
  return judged(judge_real_time(models), "for " + in_time, finding, pace_of_bounded(results.bounded_times));
}

Judgement judge_cost(const Results& results) {
  const TimeGrowth few = measure_growth(results.frame_times, 1);
  const TimeGrowth many = measure_growth(results.frame_times, 100);
  const double bounded = measure_growth(results.bounded_times, 0).exponent;
  const auto fit_of = [](const TimeGrowth& growth) {
    return growth.geometric_misfit < growth.power_misfit ? "a geometric law" : "a power";
  };
  Finding finding = {
      fmt::format("Time grows as triangles to the power {:.2f} with 1 x 10 and {:.2f} with 100 x 1. The law "
                  "that fits better is {} with the first and {} with the second. Four times the triangles, "
                  "which is half the edge length, take {:.1f} and {:.1f} times as long.",
                  few.exponent, many.exponent, fit_of(few), fit_of(many), std::pow(4.0, few.exponent),
                  std::pow(4.0, many.exponent)),
      {}};
  for (const auto& [name, growth] : {std::pair("1 x 10", few), std::pair("100 x 1", many)}) {
    finding.measured.push_back({fmt::format("{}: exponent of the power", name), growth.exponent, "", 3});
    finding.measured.push_back({"misfit of the power, in ln of the time", growth.power_misfit, "", 2});
    finding.measured.push_back({"misfit of a geometric law", growth.geometric_misfit, "", 2});
  }
  return judged(std::max(judge_growth(few), judge_growth(many)),
                "faster than in proportion to the triangles, but not by a geometric law with both settings",
                finding,
                {fmt::format("Its time grows as triangles to the power {:.2f}.", bounded),
                 {{"exponent of the power", bounded, "", 3}}});
}

}  // namespace taut::app
