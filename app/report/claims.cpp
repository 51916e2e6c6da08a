#include "app/report/claims.hpp"

#include <fmt/core.h>
#include <toml++/toml.h>

#include <array>

#include "app/figures/experiments/moments.hpp"
#include "app/report/report_texts.hpp"

namespace taut::app {
namespace {

struct Rule {
  const char* id;
  Judgement (*judge)(const Results&);
};

constexpr std::array<Rule, 15> rules = {{{"stretch-bound", judge_overstretch},
                                         {"free-surface", judge_surface},
                                         {"convergence", judge_fall},
                                         {"no-velocity", judge_velocity},
                                         {"real-time", judge_speed},
                                         {"growth", judge_cost},
                                         {"any-garment", judge_garments},
                                         {"threshold-vibrates", judge_threshold},
                                         {"ideal-overstretches", judge_ideal},
                                         {"large-steps", judge_large_steps},
                                         {"execution-speed", judge_execution},
                                         {"threshold-force", judge_threshold_force},
                                         {"neighbours-stretch", judge_neighbours},
                                         {"others-stretch", judge_others_stretch},
                                         {"robust", judge_robustness}}};

// The numbers of the rules stand in the program alone.
std::string filled(const toml::table& texts, const char* key) {
  return fmt::format(
      fmt::runtime(texts[key].value<std::string>().value()), fmt::arg("rest_mm", 1e3 * fall_rest_m),
      fmt::arg("rest_s", fall_rest_s), fmt::arg("real_time_ms", real_time_ms),
      fmt::arg("surface_excess_percent", 100.0 * surface_excess),
      fmt::arg("proportional_exponent", proportional_exponent), fmt::arg("trial_frames", trial_frames),
      fmt::arg("trial_steps", trial_steps), fmt::arg("trial_sweeps", trial_sweeps),
      fmt::arg("short_step_hz", method_rates_hz[0]), fmt::arg("long_step_hz", method_rates_hz[1]),
      fmt::arg("duration_s", methods_duration_s), fmt::arg("vibration_m_per_s", vibration_m_per_s),
      fmt::arg("faster", significantly_faster), fmt::arg("excess_percent", 100.0 * threshold_excess),
      fmt::arg("asked_percent", 100.0 * trial_max_stretch),
      fmt::arg("timed_frames", TrialLengths{}.timed_frames), fmt::arg("held_s", TrialLengths{}.rest_s),
      fmt::arg("shaken_cm", 100.0 * shaken_by_m), fmt::arg("shaken_s", shaken_s),
      fmt::arg("steps_s", TrialLengths{}.steps_s));
}

}  // namespace

std::vector<Claim> judge_claims(const Results& results) {
  const toml::table texts = toml::parse(claim_texts);
  std::vector<Claim> claims;
  for (const auto& [id, judge] : rules) {
    const toml::table& claim = *texts[id].as_table();
    claims.push_back({{id, filled(claim, "section"), filled(claim, "claim"), filled(claim, "test"),
                       filled(claim, "rule"), filled(claim, "remark"), filled(claim, "figure")},
                      judge(results)});
  }
  return claims;
}

}  // namespace taut::app
