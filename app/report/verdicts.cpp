#include "app/report/verdicts.hpp"

#include <algorithm>

namespace taut::app {
namespace {

bool all_within(std::span<const double> values, double bound) {
  return std::all_of(values.begin(), values.end(), [&](double value) { return value <= bound; });
}

bool vibrates(double speed_m_per_s) {
  return !(speed_m_per_s <= vibration_m_per_s);
}

}  // namespace

const char* name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::holds:
      return "holds";
    case Verdict::holds_with_condition:
      return "holds with a condition";
    case Verdict::does_not_hold:
      return "does not hold";
  }
  return "";
}

Verdict judge_stretch_bound(std::span<const StretchNumbers> kept, std::span<const double> few_sweeps) {
  const auto all_keep = [&](double at_end, double on_the_way) {
    return std::all_of(kept.begin(), kept.end(), [=](const StretchNumbers& run) {
      return run.at_end <= at_end && run.on_the_way <= on_the_way;
    });
  };
  if (all_keep(stretch_bound, stretch_bound) && all_within(few_sweeps, stretch_bound)) {
    return Verdict::holds;
  }
  return all_keep(stretch_bound, 2.0 * stretch_bound) ? Verdict::holds_with_condition
                                                      : Verdict::does_not_hold;
}

Verdict judge_convergence(double peak_m, double last_m, bool came_to_rest) {
  if (came_to_rest || last_m < 1e-3 * peak_m) {
    return Verdict::holds;
  }
  return last_m < 0.1 * peak_m ? Verdict::holds_with_condition : Verdict::does_not_hold;
}

Verdict judge_no_velocity(std::uint64_t uninterrupted_hash, std::uint64_t restarted_hash) {
  return uninterrupted_hash == restarted_hash ? Verdict::holds : Verdict::does_not_hold;
}

Verdict judge_real_time(std::span<const double> few_sweeps_ms, std::span<const double> short_steps_ms) {
  const bool few_hold = all_within(few_sweeps_ms, real_time_ms);
  const bool short_hold = all_within(short_steps_ms, real_time_ms);
  if (few_hold && short_hold) {
    return Verdict::holds;
  }
  return few_hold || short_hold ? Verdict::holds_with_condition : Verdict::does_not_hold;
}

Verdict judge_growth(double exponent) {
  if (exponent > proportional_exponent) {
    return Verdict::holds;
  }
  return exponent >= 0.8 ? Verdict::holds_with_condition : Verdict::does_not_hold;
}

Verdict judge_mapping(std::span<const MappingNumbers> models) {
  const bool all_hold = !models.empty() && std::all_of(models.begin(), models.end(), [](const auto& model) {
    return model.structural == model.edges && model.loose_vertices == 0 && model.flexural > 0;
  });
  return all_hold ? Verdict::holds : Verdict::does_not_hold;
}

Verdict judge_threshold_vibrates(const UnrestNumbers& threshold, const UnrestNumbers& strong) {
  const bool with_short = vibrates(threshold.short_step_m_per_s) && !vibrates(strong.short_step_m_per_s);
  const bool with_long = vibrates(threshold.long_step_m_per_s) && !vibrates(strong.long_step_m_per_s);
  if (with_short && with_long) {
    return Verdict::holds;
  }
  return with_short || with_long ? Verdict::holds_with_condition : Verdict::does_not_hold;
}

Verdict judge_ideal_overstretches(double ideal_stretch, double strong_stretch) {
  return ideal_stretch > stretch_bound && strong_stretch <= stretch_bound ? Verdict::holds_with_condition
                                                                          : Verdict::does_not_hold;
}

}  // namespace taut::app
