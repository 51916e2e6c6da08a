#include "app/report/claims.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "app/figures/moments.hpp"

namespace taut::app {
namespace {

MeasuredNumber percent(std::string name, double fraction) {
  return {std::move(name), 100.0 * fraction, "%", 3};
}

double final_stretch(const Recording& recording) {
  return recording.last().record.stretch.max;
}

Claim judge_bound(const Results& results) {
  const Recording& grid = *results.pinned[0];
  const Recording& shirt = *results.shirts[0];
  const Recording& wind = *results.shirts[2];
  Claim claim;
  claim.id = "stretch-bound";
  claim.section = "III";
  claim.claim = "The strong constraint keeps over-stretch within 5 %.";
  claim.test =
      "A 9x9 cloth held by two corners (one step of 1/64 s a frame, 8 sweeps); the shirt of 10600 triangles "
      "with one step a frame and 10, 50 and 200 sweeps after 0.75 s; and the same shirt with 100 steps a "
      "frame of one sweep each after 4 s. Judged by the largest stretch of any structural spring at the end.";
  claim.threshold = "at most 5 % at the end of a run";
  claim.measured = {percent("9x9 cloth", final_stretch(grid)),
                    percent("9x9 cloth, largest on the way", grid.largest_stretch)};
  std::vector<double> few;
  for (const SweepRun& run : results.sweeps) {
    few.push_back(run.final_stretch);
    claim.measured.push_back(percent(fmt::format("shirt, 1 step, {} sweeps", run.sweeps), run.final_stretch));
  }
  claim.measured.push_back(percent("shirt, 100 steps of 1 sweep", final_stretch(shirt)));
  claim.measured.push_back(percent("the same, largest on the way", shirt.largest_stretch));
  claim.measured.push_back(percent("shirt in wind of 10 m/s, 200 steps", final_stretch(wind)));
  claim.measured.push_back(percent("the same, largest on the way", wind.largest_stretch));
  claim.verdict = judge_stretch_bound(final_stretch(grid), few, final_stretch(shirt));
  claim.remark =
      "Sweeps hand a correction on by one spring each, so that fine meshes need very many of them or short "
      "time "
      "steps: a hundred a frame do for the shirt. Sudden starts go beyond the bound for a moment.";
  claim.figure = "fig4";
  return claim;
}

Claim judge_fall(const Results& results) {
  const StepRecording& fall = *results.fall;
  const double peak_m = *std::max_element(fall.moved_m.begin(), fall.moved_m.end());
  Claim claim;
  claim.id = "convergence";
  claim.section = "II";
  claim.claim = "The iteration converges: a mass point's coordinate becomes stable.";
  claim.test = fmt::format(
      "How far the middle of the free edge of the falling 33x33 cloth moves in each of {} steps of {:.2f} "
      "ms.",
      fall.moved_m.size(), 1e3 * fall.time_step_s);
  claim.threshold = fmt::format(
      "the cloth slows down to {} m/s (root mean square) for half a second, or the point moves by less than "
      "a "
      "thousandth of its peak",
      fall_rest_m_per_s);
  claim.measured = {{"largest movement in a step", peak_m, "m", 3},
                    {"movement in the last step", fall.moved_m.back(), "m", 3},
                    {"steps", static_cast<double>(fall.moved_m.size()), "", 6}};
  claim.verdict = judge_convergence(peak_m, fall.moved_m.back(), fall.came_to_rest);
  claim.remark = "Not monotonically: the cloth swings, and the air stops it rather than the method.";
  claim.figure = "fig3";
  return claim;
}

Claim judge_velocity(const Results& results) {
  const RestartRun& restart = results.restart;
  Claim claim;
  claim.id = "no-velocity";
  claim.section = "II";
  claim.claim =
      "Previous, current and predicted positions are all there is to a mass point; no velocity is kept.";
  claim.test = fmt::format(
      "A run is copied after {} steps as nothing but its current and previous positions and the length of a "
      "step; copy and original go on for {} steps and are compared bit by bit.",
      restart.steps_before, restart.steps_after);
  claim.threshold = "equal hashes of all positions";
  claim.measured = {
      {"runs that differ", restart.uninterrupted_hash == restart.restarted_hash ? 0.0 : 1.0, "", 1}};
  claim.verdict = judge_no_velocity(restart.uninterrupted_hash, restart.restarted_hash);
  claim.remark = "The velocity is implied: it is the difference of two positions over the time step.";
  return claim;
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

Claim judge_speed(const Results& results) {
  Claim claim;
  claim.id = "real-time";
  claim.section = "IV";
  claim.claim = "Garments of these sizes are simulated in real time.";
  claim.test = fmt::format(
      "Median of {} frames of 1/60 s of each shirt under gravity, with 1 step of 10 sweeps a frame (1 x 10) "
      "and "
      "100 steps of 1 sweep (100 x 1); simulation alone, on one thread while nothing else of this program "
      "ran.",
      results.frame_times.front().frame_ms.size());
  claim.threshold = "at most 16.7 ms a frame";
  for (const FrameTimes& time : results.frame_times) {
    claim.measured.push_back(
        {fmt::format("{} triangles, {} x {}", time.triangles, time.substeps, time.sweeps), time.median_ms(),
         "ms", 3});
  }
  claim.verdict =
      judge_real_time(medians_with(results.frame_times, true), medians_with(results.frame_times, false));
  claim.remark =
      "The cheap setting of one step a frame is the one that over-stretches on fine models; the setting that "
      "keeps the bound costs many times as much.";
  claim.figure = "fig6";
  return claim;
}

Claim judge_cost(const Results& results) {
  const double few = fit_power_law(results.frame_times, 1).exponent;
  const double many = fit_power_law(results.frame_times, 100).exponent;
  Claim claim;
  claim.id = "growth";
  claim.section = "IV";
  claim.claim = "Computation grows geometrically as the model is refined.";
  claim.test =
      "A power of the number of triangles is fitted to the shortest times of a frame of the three shirts, "
      "for "
      "each of two settings: 1 step of 10 sweeps a frame, 100 steps of 1 sweep. The larger exponent is "
      "judged.";
  claim.threshold =
      fmt::format("above {:.1f}: faster than in proportion to the triangles; 0.8 to {:.1f}: in proportion",
                  proportional_exponent, proportional_exponent);
  claim.measured = {{"exponent, 1 x 10", few, "", 3}, {"exponent, 100 x 1", many, "", 3}};
  claim.verdict = judge_growth(std::max(few, many));
  claim.remark =
      "At fixed settings time grows about in proportion to the triangles. It is a geometric sequence only in "
      "the levels of refinement (half the edge length, four times the triangles); and a finer model needs "
      "more "
      "steps as well if its stretch is to stay the same.";
  claim.figure = "fig6";
  return claim;
}

Claim judge_any_garment(const Results& results) {
  Claim claim;
  claim.id = "any-garment";
  claim.section = "I, V";
  claim.claim = "Any garment made of triangles maps to springs, regular or not.";
  claim.test =
      "Three shirts of irregular triangles are mapped: structural springs have to be exactly the edges, "
      "every "
      "vertex has to be held by one, and there have to be flexural springs.";
  claim.threshold = "no edge without a spring, no loose vertex, some flexural springs, in all three";
  std::vector<MappingNumbers> numbers;
  for (const MappedModel& model : results.models) {
    numbers.push_back({model.edges, model.structural, model.flexural, model.loose_vertices});
    claim.measured.push_back(
        {fmt::format("{}: structural springs", model.file), static_cast<double>(model.structural), "", 6});
    claim.measured.push_back(
        {fmt::format("{}: flexural springs", model.file), static_cast<double>(model.flexural), "", 6});
    claim.measured.push_back(
        {fmt::format("{}: loose vertices", model.file), static_cast<double>(model.loose_vertices), "", 6});
  }
  claim.verdict = judge_mapping(numbers);
  claim.remark =
      "Triangles have no diagonals, so a triangle model has no shear springs; its edges do their work.";
  claim.figure = "fig1";
  return claim;
}

const MethodRun& method_run(const Results& results, std::size_t rate, sim::SolverKind kind) {
  return results.methods[3 * rate + static_cast<std::size_t>(kind)];
}

std::optional<double> unrest_speed(const MethodRun& run) {
  const auto unrest = measure_unrest(run);
  return unrest ? std::optional(unrest->speed_m_per_s) : std::nullopt;
}

Claim judge_threshold(const Results& results) {
  Claim claim;
  claim.id = "threshold-vibrates";
  claim.section = "I, III";
  claim.claim = "Pulling springs back to a threshold makes them vibrate; the strong constraint does not.";
  claim.test = fmt::format(
      "The 9x9 cloth with springs of 50 N/m and a threshold of 5 %, against 8 sweeps of the strong "
      "constraint, "
      "with steps of 1/{:.0f} s and 1/{:.0f} s: root mean square speed over the last quarter of 10 s.",
      method_rates_hz[0], method_rates_hz[1]);
  claim.threshold = fmt::format("vibrates above {} m/s, or where it diverges", vibration_m_per_s);
  UnrestNumbers numbers[2];
  for (const sim::SolverKind kind : {sim::SolverKind::provot, sim::SolverKind::strong}) {
    UnrestNumbers& unrest = numbers[kind == sim::SolverKind::strong ? 1 : 0];
    unrest = {unrest_speed(method_run(results, 0, kind)), unrest_speed(method_run(results, 1, kind))};
    const std::string name = kind == sim::SolverKind::strong ? "strong" : "threshold";
    claim.measured.push_back({name + ", short step", unrest.short_step_m_per_s.value_or(INFINITY), "m/s", 3});
    claim.measured.push_back({name + ", long step", unrest.long_step_m_per_s.value_or(INFINITY), "m/s", 3});
  }
  claim.verdict = judge_threshold_vibrates(numbers[0], numbers[1]);
  claim.remark =
      "With steps short enough for the springs themselves to be stable (about 1/255 s here) the threshold "
      "method "
      "settles like the others. With longer ones the springs blow up, the threshold only bounds the damage, "
      "and "
      "the cloth shakes for good. The strong constraint has no such limit.";
  claim.figure = "fig7";
  return claim;
}

Claim judge_ideal(const Results& results) {
  const auto ideal = measure_unrest(method_run(results, 0, sim::SolverKind::ideal));
  const auto strong = measure_unrest(method_run(results, 0, sim::SolverKind::strong));
  Claim claim;
  claim.id = "ideal-overstretches";
  claim.section = "III";
  claim.claim = "An ideal mass-spring model over-stretches where the strong constraint does not.";
  claim.test = fmt::format(
      "The same cloth with ideal springs of 50 N/m and with the strong constraint, steps of 1/{:.0f} s: the "
      "largest stretch over the last quarter of 10 s.",
      method_rates_hz[0]);
  claim.threshold = "ideal above 5 %, strong at most 5 %";
  const double ideal_stretch = ideal ? ideal->largest_stretch : INFINITY;
  const double strong_stretch = strong ? strong->largest_stretch : INFINITY;
  claim.measured = {percent("ideal", ideal_stretch), percent("strong", strong_stretch)};
  claim.verdict = judge_ideal_overstretches(ideal_stretch, strong_stretch);
  claim.remark = "Stiffer springs stretch less, at the price of shorter steps.";
  claim.figure = "fig7";
  return claim;
}

}  // namespace

std::vector<Claim> judge_claims(const Results& results) {
  return {judge_bound(results), judge_fall(results),        judge_velocity(results),  judge_speed(results),
          judge_cost(results),  judge_any_garment(results), judge_threshold(results), judge_ideal(results)};
}

}  // namespace taut::app
