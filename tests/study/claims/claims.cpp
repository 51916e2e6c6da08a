#include "tests/study/claims/claims.hpp"

#include <fmt/args.h>
#include <toml++/toml.h>

#include "app/base/words.hpp"
#include "app/drawing/plots/plot.hpp"
#include "tests/study/claims/report.hpp"

namespace taut::app {
namespace {

using Cases = std::vector<Case>;
using enum sim::SolverKind;

// Cases of a claim's test by the paper's method, and by `bounded`.
struct Tested {
  Cases cases;
  Cases bounded = {};
};

MeasuredNumber percent(const char* name, double fraction) { return {name, 100.0 * fraction, "%"}; }

bool keeps(double stretch) { return stretch <= paper_stretch_bound; }

bool vibrates(double speed_m_per_s) { return !(speed_m_per_s <= vibration_m_per_s); }

bool exceeds_springs(double surface, double springs) {
  return std::isfinite(surface) && surface > (1.0 + surface_excess) * springs;
}

std::string setting_text(int substeps, int sweeps) {
  return substeps == 0 ? "" : fmt::format(", {} x {}", count_text(substeps, "step"), count_text(sweeps, "sweep"));
}

// Returns all runs of the paper's method, with the cloth of figure 4 first.
std::vector<StrongRun> all_strong_runs(const ClaimResults& results) {
  const Recording& cloth = *results.pinned[0];
  const SolverChoice& solver = cloth.scene.simulation.solver;
  std::vector<StrongRun> runs = {{"9x9 cloth, as in figure 4",
                                  false,
                                  solver.substeps.value_or(0),
                                  solver.strong.iterations,
                                  {cloth.last().record.stretch.max, cloth.max_stretch_seen},
                                  cloth.max_surface_stretch}};
  runs.insert(runs.end(), results.strong_runs.begin(), results.strong_runs.end());
  return runs;
}

std::string make_title(const StrongRun& run) {
  return run.garment + setting_text(run.substeps, run.sweeps) + (run.is_rigid ? ", rigid both ways" : "");
}

std::string make_title(const Recording& shirt) {
  const double speed_m_per_s = shirt.scene.surroundings.forces.wind.speed_m_per_s;
  const sim::BoundedSettings& asked = shirt.scene.simulation.solver.bounded;
  return fmt::format(
      "{}, asked to keep its {} within {:g} %",
      speed_m_per_s > 0.0 ? fmt::format("shirt in a wind of {:g} m/s", speed_m_per_s) : "shirt in still air",
      sim::to_name(asked.bound), 100.0 * asked.max_stretch);
}

std::vector<MeasuredNumber> surface_numbers(double springs, const sim::SurfaceStretch& surface) {
  return {percent("springs", springs), percent("the surface", surface.max),
          percent("99 of 100 triangles", surface.p99)};
}

// `bounded` alone knows contact, which is on in these frames.
Cases make_cases(const std::vector<FrameTimes>& times) {
  Cases cases;
  for (const FrameTimes& time : times) {
    cases.push_back({fmt::format("{} triangles{}", time.triangles, setting_text(time.substeps, time.sweeps)),
                     {{time.substeps == 0 ? "a frame with contact" : "a frame", time.median_ms(), "ms"},
                      percent("largest stretch", time.max_stretch_seen)},
                     time.median_ms() <= real_time_ms && keeps(time.max_stretch_seen)});
  }
  return cases;
}

Tested test_stretch_bound(const ClaimResults& results) {
  Tested tested;
  for (const StrongRun& run : all_strong_runs(results)) {
    const auto& [at_end, on_the_way] = run.stretch;
    tested.cases.push_back({make_title(run),
                            {percent("on the way", on_the_way), percent("at the end", at_end)},
                            keeps(on_the_way) && keeps(at_end),
                            std::isfinite(on_the_way) && keeps(at_end)});
  }
  for (const std::optional<Recording>& shirt : results.shirts) {
    tested.bounded.push_back({make_title(*shirt), {percent("largest stretch of springs", shirt->max_stretch_seen)}});
  }
  tested.bounded.push_back(make_cases(results.bounded_times).back());
  return tested;
}

Tested test_free_surface(const ClaimResults& results) {
  Tested tested;
  for (const StrongRun& run : all_strong_runs(results)) {
    const double springs = run.stretch.on_the_way;
    const bool has_worst = exceeds_springs(run.surface.max, springs);
    tested.cases.push_back({make_title(run), surface_numbers(springs, run.surface),
                            has_worst && exceeds_springs(run.surface.p99, springs), has_worst});
  }
  for (const std::optional<Recording>& shirt : results.shirts) {
    tested.bounded.push_back(
        {make_title(*shirt), surface_numbers(shirt->max_stretch_seen, shirt->max_surface_stretch)});
  }
  return tested;
}

Tested test_convergence(const ClaimResults& results) {
  const StepRecording& fall = *results.fall;
  const double peak_m = *std::ranges::max_element(fall.moved_m);
  const double last_m = fall.moved_m.back();
  return {{{"",
            {{"largest movement in a step", peak_m, "m"},
             {"movement in the last step", last_m, "m"},
             {"steps", static_cast<double>(fall.moved_m.size()), "", 6}},
            fall.came_to_rest || last_m < 1e-3 * peak_m,
            last_m < 0.1 * peak_m}}};
}

Tested test_no_velocity(const ClaimResults& results) {
  const RestartRun& restart = results.restart;
  const bool are_equal = restart.uninterrupted_hash == restart.restarted_hash;
  return {{{fmt::format("taken up after {} steps, {} steps later", restart.steps_before, restart.steps_after),
            {{"runs that differ", are_equal ? 0.0 : 1.0, ""}},
            are_equal}}};
}

// Only one setting per model must be in time.
Tested test_real_time(const ClaimResults& results) {
  Tested tested = {make_cases(results.frame_times), make_cases(results.bounded_times)};
  std::map<int, bool> in_time;
  for (std::size_t i = 0; i < tested.cases.size(); ++i) {
    tested.cases[i].is_judged = false;
    bool& is_in_time = in_time[results.frame_times[i].triangles];
    is_in_time = is_in_time || tested.cases[i].holds;
  }
  for (const auto& [triangles, is_in_time] : in_time) {
    tested.cases.push_back({fmt::format("{} triangles", triangles), {}, is_in_time});
  }
  return tested;
}

Tested test_growth(const ClaimResults& results) {
  Tested tested;
  for (const int substeps : {1, 100}) {
    const TimeGrowth growth = measure_growth(results.frame_times, substeps);
    const bool is_steeper = growth.exponent > proportional_exponent;
    tested.cases.push_back({substeps == 1 ? "1 x 10" : "100 x 1",
                            {{"exponent of the power", growth.exponent, ""},
                             {"misfit of the power, in ln of the time", growth.power_misfit, "", 2},
                             {"misfit of a geometric law", growth.geometric_misfit, "", 2}},
                            is_steeper && growth.geometric_misfit < growth.power_misfit,
                            is_steeper});
  }
  tested.bounded = {{"", {{"exponent of the power", measure_growth(results.bounded_times, 0).exponent, ""}}}};
  return tested;
}

Case make_case(const GarmentTrial& trial) {
  const Mapping& mapping = trial.mapping;
  const bool is_mapped = trial.refusal.empty() && mapping.edges > 0 && mapping.structural == mapping.edges &&
                         mapping.loose_vertices == 0 && mapping.flexural > 0;
  if (!trial.refusal.empty()) return {fmt::format("{} was refused: {}", trial.file, trial.refusal), {}};
  return {fmt::format("{}: {}, {} triangles; {} structural and {} flexural springs{}", trial.file, trial.kind,
                      mapping.triangles, mapping.structural, mapping.flexural,
                      is_mapped ? ""
                                : fmt::format(" for {}, {}", count_text(mapping.edges, "edge"),
                                              count_text(mapping.loose_vertices, "loose vertex", "loose vertices"))),
          {percent("stretched by", trial.strong.max_stretch_seen)},
          is_mapped && keeps(trial.strong.max_stretch_seen),
          is_mapped && std::isfinite(trial.strong.max_stretch_seen)};
}

Tested test_any_garment(const ClaimResults& results) {
  Tested tested;
  for (const GarmentTrial& trial : results.garments) {
    tested.cases.push_back(make_case(trial));
    if (trial.refusal.empty()) {
      tested.bounded.push_back({trial.file,
                                {percent("largest stretch", trial.bounded.max_stretch_seen),
                                 {"a frame with contact", trial.bounded.median_ms, "ms"}},
                                trial.bounded.max_stretch_seen <= trial_bound});
    }
  }
  return tested;
}

const MethodRun& method_run(const ClaimResults& results, std::size_t rate, sim::SolverKind kind) {
  return results.methods[3 * rate + static_cast<std::size_t>(kind)];
}

Tested test_threshold_vibrates(const ClaimResults& results) {
  Tested tested;
  for (std::size_t rate = 0; rate < method_rates_hz.size(); ++rate) {
    const auto speed_of = [&](sim::SolverKind kind) {
      const auto unrest = measure_unrest(method_run(results, rate, kind));
      return unrest ? unrest->speed_m_per_s : INFINITY;
    };
    tested.cases.push_back({fmt::format("steps of 1/{:.0f} s", method_rates_hz[rate]),
                            {{"threshold", speed_of(provot), "m/s"}, {"strong constraint", speed_of(strong), "m/s"}},
                            vibrates(speed_of(provot)) && !vibrates(speed_of(strong))});
  }
  return tested;
}

Tested test_ideal_overstretches(const ClaimResults& results) {
  const auto settled_stretch = [](const MethodRun& run) {
    const auto unrest = measure_unrest(run);
    return unrest ? unrest->max_stretch_seen : INFINITY;
  };
  const double of_strong = settled_stretch(method_run(results, 0, strong));
  Tested tested;
  for (const MethodRun& run : results.ideal_stiffnesses) {
    tested.cases.push_back({fmt::format("springs of {:g} N/m", run.stiffness_n_per_m),
                            {percent("largest stretch", settled_stretch(run))},
                            settled_stretch(run) > paper_stretch_bound && keeps(of_strong)});
  }
  tested.cases.push_back({"strong constraint", {percent("largest stretch", of_strong)}, false, false, false});
  return tested;
}

// Methods that the paper argues with: neither the paper's method nor this program's.
constexpr std::array others = {ideal, provot, implicit, vassilev, fast_projection};

const MethodTrial& find_timed(const ClaimResults& results, sim::SolverKind kind, int triangles) {
  return find_trial(results.trials_of(MethodTest::time), kind, triangles);
}

std::string mesh_name(int triangles) {
  return triangles == trial_grid_triangles ? "the 9x9 cloth" : fmt::format("{} triangles", triangles);
}

// Tests, for each mesh, whether the fastest of the `slower` methods takes at least `least` times as long as `own`.
Tested test_speed(const ClaimResults& results, sim::SolverKind own, std::span<const sim::SolverKind> slower,
                  double least) {
  Tested tested;
  for (const int triangles : trial_meshes) {
    const auto ms_of = [&](sim::SolverKind kind) { return find_timed(results, kind, triangles).ranked_ms(0.5); };
    double fastest_ms = INFINITY;
    for (const sim::SolverKind kind : slower) fastest_ms = std::min(fastest_ms, ms_of(kind));
    const double ratio = fastest_ms / ms_of(own);
    tested.cases.push_back({mesh_name(triangles),
                            {{"a frame", ms_of(own), "ms"}, {"compared with", fastest_ms, "ms"}},
                            std::isfinite(ratio) && ratio >= least});
    tested.bounded.push_back({mesh_name(triangles), {{"a frame without contact", ms_of(bounded), "ms"}}});
  }
  return tested;
}

Tested test_large_steps(const ClaimResults& results) {
  return test_speed(results, implicit, std::array{ideal}, significantly_faster);
}

// Times are judged only for similar stretch, because a method that lets cloth stretch has less to do.
Tested test_execution_speed(const ClaimResults& results) {
  Tested tested = test_speed(results, strong, others, 1.0);
  for (std::size_t i = 0; i < trial_meshes.size(); ++i) {
    const auto ms_of = [&](sim::SolverKind kind) { return find_timed(results, kind, trial_meshes[i]).ranked_ms(0.5); };
    const sim::SolverKind fastest = *std::ranges::min_element(others, {}, ms_of);
    const double own = find_timed(results, strong, trial_meshes[i]).max_stretch_seen();
    const double other = find_timed(results, fastest, trial_meshes[i]).max_stretch_seen();
    tested.cases[i].is_judged = own <= std::max(paper_stretch_bound, (1.0 + threshold_excess) * other);
    tested.cases[i].numbers.push_back(percent("stretched by", own));
    tested.cases[i].numbers.push_back(percent("the other by", other));
  }
  return tested;
}

Tested test_threshold_force(const ClaimResults& results) {
  const auto speed_of = [&](sim::SolverKind kind) {
    return find_trial(results.trials_of(MethodTest::rest), kind).last_speed_m_per_s();
  };
  const double with = speed_of(vassilev), without = speed_of(ideal);
  Tested tested = {{{"",
                     {{"with Vassilev's threshold", with, "m/s"}, {"with the same springs and none", without, "m/s"}},
                     vibrates(with) && !vibrates(without),
                     with > 2.0 * without}},
                   {{"bounded", {{"at the end", speed_of(bounded), "m/s"}}}}};
  for (const sim::SolverKind kind : {provot, implicit, fast_projection, strong}) {
    tested.cases.push_back({to_name(kind), {{"at the end", speed_of(kind), "m/s"}}, false, false, false});
  }
  return tested;
}

Tested test_neighbours_stretch(const ClaimResults& results) {
  Tested tested;
  for (const sim::SolverKind kind : {provot, fast_projection}) {
    Case one = {to_name(kind), {}};
    double least = INFINITY;
    for (const int triangles : trial_meshes) {
      const double stretch = find_timed(results, kind, triangles).max_stretch_seen();
      least = std::min(least, stretch);
      one.numbers.push_back(percent(mesh_name(triangles).c_str(), stretch));
    }
    one.holds = std::isfinite(least) && least / trial_max_stretch > 1.0 + threshold_excess;
    tested.cases.push_back(std::move(one));
  }
  return tested;
}

Tested test_others_stretch(const ClaimResults& results) {
  const auto stretch_of = [&](sim::SolverKind kind) {
    return find_timed(results, kind, trial_meshes.back()).max_stretch_seen();
  };
  Tested tested = {{}, {{"bounded", {percent("largest stretch", stretch_of(bounded))}}}};
  for (const sim::SolverKind kind : others) {
    tested.cases.push_back({to_name(kind),
                            {percent("largest stretch", stretch_of(kind))},
                            std::isfinite(stretch_of(kind)) && !keeps(stretch_of(kind))});
  }
  tested.cases.push_back(
      {"the paper's own method", {percent("largest stretch", stretch_of(strong))}, false, false, false});
  return tested;
}

Tested test_robust(const ClaimResults& results) {
  Tested tested;
  for (const sim::SolverKind kind : trial_methods) {
    for (const int factor : trial_step_factors) {
      const double stretch =
          find_trial(results.trials_of(MethodTest::steps), kind, trial_shirt_triangles, factor).max_stretch_seen();
      Cases& cases = kind == bounded ? tested.bounded : tested.cases;
      cases.push_back({fmt::format("{}, step times {}", to_name(kind), factor),
                       {percent("largest stretch", stretch)},
                       keeps(stretch),
                       std::isfinite(stretch),
                       kind == strong});
    }
  }
  return tested;
}

struct Rule {
  const char* id;
  Quorum quorum;
  Tested (*test)(const ClaimResults&);
};

constexpr std::array<Rule, 15> rules = {{{"stretch-bound", Quorum::all, test_stretch_bound},
                                         {"free-surface", Quorum::all, test_free_surface},
                                         {"convergence", Quorum::all, test_convergence},
                                         {"no-velocity", Quorum::all, test_no_velocity},
                                         {"real-time", Quorum::most, test_real_time},
                                         {"growth", Quorum::all, test_growth},
                                         {"any-garment", Quorum::all, test_any_garment},
                                         {"threshold-vibrates", Quorum::some, test_threshold_vibrates},
                                         {"ideal-overstretches", Quorum::some, test_ideal_overstretches},
                                         {"large-steps", Quorum::some, test_large_steps},
                                         {"execution-speed", Quorum::some, test_execution_speed},
                                         {"threshold-force", Quorum::all, test_threshold_force},
                                         {"neighbours-stretch", Quorum::some, test_neighbours_stretch},
                                         {"others-stretch", Quorum::half, test_others_stretch},
                                         {"robust", Quorum::all, test_robust}}};

// Returns the case in a sentence, with the digits of the tables.
std::string describe_case(const Case& one) {
  const auto describe = [](const MeasuredNumber& number) { return number.name + ' ' + number_text(number); };
  const std::string text = join(collect<std::string>(one.numbers, describe));
  return one.name + (one.name.empty() || text.empty() ? "" : ": ") + text;
}

template <class Predicate> std::string join_cases(std::span<const Case> cases, bool has_numbers, Predicate predicate) {
  std::string text;
  for (const Case& one : cases) {
    if (predicate(one)) text += (text.empty() ? "" : "; ") + (has_numbers ? describe_case(one) : one.name);
  }
  return text.empty() ? "none" : text;
}

std::vector<MeasuredNumber> list_numbers(std::span<const Case> cases) {
  std::vector<MeasuredNumber> numbers;
  for (const Case& one : cases) {
    for (std::size_t i = 0; i < one.numbers.size(); ++i) {
      MeasuredNumber& number = numbers.emplace_back(one.numbers[i]);
      const std::string& place = i == 0 || one.name.empty() ? one.name : "the same";
      number.name = place + (place.empty() ? "" : ", ") + number.name;
    }
  }
  return numbers;
}

using Texts = fmt::dynamic_format_arg_store<fmt::format_context>;

// Returns the numbers of the rules, which only the program defines.
Texts rule_texts() {
  Texts texts;
  const auto put = [&texts](const char* name, double value) { texts.push_back(fmt::arg(name, value)); };
  put("rest_mm", 1e3 * fall_rest_m);
  put("rest_s", fall_rest_s);
  put("real_time_ms", real_time_ms);
  put("surface_excess_percent", 100.0 * surface_excess);
  put("proportional_exponent", proportional_exponent);
  put("trial_frames", trial_frames);
  put("trial_steps", trial_steps);
  put("trial_sweeps", trial_sweeps);
  put("short_step_hz", method_rates_hz[0]);
  put("long_step_hz", method_rates_hz[1]);
  put("duration_s", methods_duration_s);
  put("vibration_m_per_s", vibration_m_per_s);
  put("faster", significantly_faster);
  put("excess_percent", 100.0 * threshold_excess);
  put("asked_percent", 100.0 * trial_max_stretch);
  put("timed_frames", TrialLengths{}.timed_frames);
  put("held_s", TrialLengths{}.rest_s);
  put("shaken_cm", 100.0 * shaken_by_m);
  put("shaken_s", shaken_s);
  put("steps_s", TrialLengths{}.steps_s);
  return texts;
}

// Adds the fields of texts: {cases}, {holding}: counts; {held}, {others}: names of the cases that hold or do not,
// {failing} with their numbers; {all}, {first}, {most}, {least}: cases with their numbers, the latter two by the first
// number.
void put_cases(std::span<const Case> cases, Texts& texts) {
  std::vector<Case> judged(cases.begin(), cases.end());
  std::erase_if(judged, [](const Case& one) { return !one.is_judged; });
  const auto holds = [](const Case& one) { return one.is_judged && one.holds; };
  const auto fails = [](const Case& one) { return one.is_judged && !one.holds; };
  const auto is_less = [](const Case& a, const Case& b) {
    return !a.numbers.empty() && !b.numbers.empty() && a.numbers[0].value < b.numbers[0].value;
  };
  texts.push_back(fmt::arg("cases", judged.size()));
  texts.push_back(fmt::arg("holding", std::ranges::count_if(cases, holds)));
  texts.push_back(fmt::arg("held", join_cases(cases, false, holds)));
  texts.push_back(fmt::arg("others", join_cases(cases, false, fails)));
  texts.push_back(fmt::arg("failing", join_cases(cases, true, fails)));
  texts.push_back(fmt::arg("all", join_cases(cases, true, [](const Case& one) { return !one.numbers.empty(); })));
  if (!judged.empty()) {
    texts.push_back(fmt::arg("first", describe_case(judged.front())));
    texts.push_back(fmt::arg("most", describe_case(*std::ranges::max_element(judged, is_less))));
    texts.push_back(fmt::arg("least", describe_case(*std::ranges::min_element(judged, is_less))));
  }
}

}  // namespace

std::string number_text(const MeasuredNumber& number) {
  if (!std::isfinite(number.value)) return "diverged";
  // Counts have no decimals; 0.970 and 1.00 keep their zeros.
  const bool is_whole = std::abs(number.value - std::round(number.value)) < 1e-9;
  std::string digits =
      is_whole ? fmt::format("{:g}", number.value) : fmt::format("{:#.{}g}", number.value, number.digits);
  if (std::abs(number.value) >= 10.0 && std::abs(number.value) < 1e6) {
    // Avoids 8.5e+02.
    const int decimals =
        is_whole ? 0 : std::max(0, number.digits - 1 - static_cast<int>(std::log10(std::abs(number.value))));
    digits = fmt::format("{:.{}f}", number.value, decimals);
  }
  const std::size_t e = digits.find('e');
  if (e != std::string::npos) digits = digits.substr(0, e) + " × " + power_of_ten(std::stoi(digits.substr(e + 1)));
  return digits + (number.unit.empty() ? "" : " ") + number.unit;
}

const char* to_name(Verdict verdict) {
  constexpr std::array names = {"holds", "holds in part", "does not hold"};
  return names[static_cast<std::size_t>(verdict)];
}

Verdict judge(std::span<const Case> cases, Quorum quorum) {
  std::size_t all = 0, holding = 0, at_least_in_part = 0;
  for (const Case& one : cases) {
    all += one.is_judged ? 1 : 0;
    holding += one.is_judged && one.holds ? 1 : 0;
    at_least_in_part += one.is_judged && (one.holds || one.holds_in_part) ? 1 : 0;
  }
  const bool are_most = 2 * holding > all;
  if (all > 0 && (quorum == Quorum::half ? are_most : holding == all)) return Verdict::holds;
  const bool is_in_part = quorum == Quorum::all    ? at_least_in_part == all
                          : quorum == Quorum::most ? are_most
                                                   : holding > 0;
  return all > 0 && is_in_part ? Verdict::holds_in_part : Verdict::does_not_hold;
}

std::vector<Claim> judge_claims(const ClaimResults& results) {
  const toml::table all_texts = toml::parse(claim_texts);
  std::vector<Claim> claims;
  for (const auto& [id, quorum, test] : rules) {
    const toml::table& templates = *all_texts[id].as_table();
    const Tested tested = test(results);
    Claim& claim = claims.emplace_back(Claim{id,
                                             {},
                                             templates["is_check"].value_or(false),
                                             judge(tested.cases, quorum),
                                             list_numbers(tested.cases),
                                             list_numbers(tested.bounded)});
    Texts texts = rule_texts(), of_bounded;
    put_cases(tested.cases, texts);
    put_cases(tested.bounded, of_bounded);
    for (const auto& [key, text] : templates) {
      const bool applies = text.is_string() && (key != "part" || claim.verdict == Verdict::holds_in_part);
      if (applies)
        claim.texts[key.data()] = fmt::vformat(text.ref<std::string>(), key == "bounded" ? of_bounded : texts);
    }
  }
  return claims;
}

}  // namespace taut::app
