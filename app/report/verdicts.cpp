#include "app/report/verdicts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace taut::app {
namespace {

bool vibrates(double speed_m_per_s) {
  return !(speed_m_per_s <= vibration_m_per_s);
}

// Of the cases in which a claim could hold; none at all proves nothing.
Verdict all_or_some(std::size_t holding, std::size_t partly, std::size_t all) {
  if (all == 0) {
    return Verdict::does_not_hold;
  }
  if (holding == all) {
    return Verdict::holds;
  }
  return partly == all ? Verdict::holds_in_part : Verdict::does_not_hold;
}

template <class Range, class Predicate>
std::size_t count_if(const Range& range, Predicate predicate) {
  return static_cast<std::size_t>(std::count_if(range.begin(), range.end(), predicate));
}

template <class Predicate>
Verdict all_or_any(std::span<const double> numbers, Predicate predicate) {
  const std::size_t holding = count_if(numbers, predicate);
  return all_or_some(holding, holding > 0 ? numbers.size() : 0, numbers.size());
}

}  // namespace

const char* name_of(Verdict verdict) {
  constexpr std::array names = {"holds", "holds in part", "does not hold"};
  return names[static_cast<std::size_t>(verdict)];
}

Verdict judge_stretch_bound(std::span<const StretchNumbers> runs) {
  // Each asks for both: of a run, the largest stretch can be lost and the last be there.
  const auto always = [](const StretchNumbers& run) {
    return run.on_the_way <= paper_stretch_bound && run.at_end <= paper_stretch_bound;
  };
  const auto at_end = [](const StretchNumbers& run) {
    return std::isfinite(run.on_the_way) && run.at_end <= paper_stretch_bound;
  };
  return all_or_some(count_if(runs, always), count_if(runs, at_end), runs.size());
}

bool exceeds_springs(double surface, double springs) {
  return std::isfinite(surface) && surface > (1.0 + surface_excess) * springs;
}

Verdict judge_free_surface(std::span<const SurfaceNumbers> runs) {
  const auto one_in_a_hundred = [](const SurfaceNumbers& run) {
    return exceeds_springs(run.surface.p99, run.springs) && exceeds_springs(run.surface.max, run.springs);
  };
  const auto the_worst = [](const SurfaceNumbers& run) {
    return exceeds_springs(run.surface.max, run.springs);
  };
  return all_or_some(count_if(runs, one_in_a_hundred), count_if(runs, the_worst), runs.size());
}

Verdict judge_convergence(double peak_m, double last_m, bool came_to_rest) {
  if (came_to_rest || last_m < 1e-3 * peak_m) {
    return Verdict::holds;
  }
  return last_m < 0.1 * peak_m ? Verdict::holds_in_part : Verdict::does_not_hold;
}

Verdict judge_no_velocity(std::uint64_t uninterrupted_hash, std::uint64_t restarted_hash) {
  return uninterrupted_hash == restarted_hash ? Verdict::holds : Verdict::does_not_hold;
}

bool is_in_real_time(const PacedModel& model) {
  return model.frame_ms <= real_time_ms && model.stretch <= paper_stretch_bound;
}

Verdict judge_real_time(std::span<const PacedModel> models) {
  std::set<int> all, in_time;
  for (const PacedModel& model : models) {
    all.insert(model.triangles);
    if (is_in_real_time(model)) {
      in_time.insert(model.triangles);
    }
  }
  const bool are_most = 2 * in_time.size() > all.size();
  return all_or_some(in_time.size(), are_most ? all.size() : 0, all.size());
}

Verdict judge_growth(const TimeGrowth& growth) {
  if (!(growth.exponent > proportional_exponent)) {
    return Verdict::does_not_hold;
  }
  return growth.geometric_misfit < growth.power_misfit ? Verdict::holds : Verdict::holds_in_part;
}

bool is_mapped(const Mapping& mapping) {
  return mapping.edges > 0 && mapping.structural == mapping.edges && mapping.loose_vertices == 0 &&
         mapping.flexural > 0;
}

Verdict judge_any_garment(std::span<const GarmentTrial> trials) {
  const auto keeps_bound = [](const GarmentTrial& trial) {
    return trial.refusal.empty() && is_mapped(trial.mapping) &&
           trial.strong.largest_stretch <= paper_stretch_bound;
  };
  const auto is_simulated = [](const GarmentTrial& trial) {
    return trial.refusal.empty() && is_mapped(trial.mapping) && std::isfinite(trial.strong.largest_stretch);
  };
  return all_or_some(count_if(trials, keeps_bound), count_if(trials, is_simulated), trials.size());
}

Verdict judge_threshold_vibrates(const UnrestNumbers& threshold, const UnrestNumbers& strong) {
  const bool with_short = vibrates(threshold.short_step_m_per_s) && !vibrates(strong.short_step_m_per_s);
  const bool with_long = vibrates(threshold.long_step_m_per_s) && !vibrates(strong.long_step_m_per_s);
  if (with_short && with_long) {
    return Verdict::holds;
  }
  return with_short || with_long ? Verdict::holds_in_part : Verdict::does_not_hold;
}

Verdict judge_ideal_overstretches(std::span<const double> ideal_stretches, double strong_stretch) {
  const std::size_t over =
      count_if(ideal_stretches, [](double stretch) { return stretch > paper_stretch_bound; });
  if (over == 0 || !(strong_stretch <= paper_stretch_bound)) {
    return Verdict::does_not_hold;
  }
  return over == ideal_stretches.size() ? Verdict::holds : Verdict::holds_in_part;
}

Verdict judge_faster(std::span<const double> times_as_long, double least) {
  return all_or_any(times_as_long, [=](double ratio) { return std::isfinite(ratio) && ratio >= least; });
}

Verdict judge_threshold_unrest(double with_threshold_m_per_s, double without_m_per_s) {
  if (vibrates(with_threshold_m_per_s) && !vibrates(without_m_per_s)) {
    return Verdict::holds;
  }
  return with_threshold_m_per_s > 2.0 * without_m_per_s ? Verdict::holds_in_part : Verdict::does_not_hold;
}

Verdict judge_neighbours_stretch(std::span<const double> multiples) {
  return all_or_any(multiples, [](double multiple) {
    return std::isfinite(multiple) && multiple > 1.0 + threshold_excess;
  });
}

Verdict judge_stretch_ignored(std::span<const double> stretches) {
  const std::size_t over = count_if(
      stretches, [](double stretch) { return std::isfinite(stretch) && stretch > paper_stretch_bound; });
  if (2 * over > stretches.size()) {
    return Verdict::holds;
  }
  return over > 0 ? Verdict::holds_in_part : Verdict::does_not_hold;
}

Verdict judge_robust(std::span<const double> stretches) {
  const auto keeps_bound = [](double stretch) { return stretch <= paper_stretch_bound; };
  const auto goes_on = [](double stretch) { return std::isfinite(stretch); };
  return all_or_some(count_if(stretches, keeps_bound), count_if(stretches, goes_on), stretches.size());
}

}  // namespace taut::app
