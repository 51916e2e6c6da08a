#pragma once

#include <string>
#include <vector>

#include "app/figures/experiments/experiments.hpp"
#include "app/report/measured_number.hpp"
#include "app/report/verdicts.hpp"

namespace taut::app {

/// A sentence with the numbers it states.
struct Finding {
  std::string text;
  std::vector<MeasuredNumber> measured;
};

/// The result of testing a claim.
struct Judgement {
  Verdict verdict = Verdict::does_not_hold;
  std::string part;  ///< what holds, if the verdict is holds_in_part; otherwise empty
  Finding finding;   ///< the numbers that decide
  /// The result of the solver `bounded` in the same test. It does not decide, because it is not the paper's
  /// method. Its text is empty if `bounded` was not tested.
  Finding bounded;
};

/// Each of these judges one claim by the results of its experiments. The rules are in verdicts.hpp.
Judgement judge_overstretch(const Results& results);
Judgement judge_surface(const Results& results);
Judgement judge_fall(const Results& results);
Judgement judge_velocity(const Results& results);
Judgement judge_speed(const Results& results);
Judgement judge_cost(const Results& results);
Judgement judge_garments(const Results& results);
Judgement judge_threshold(const Results& results);
Judgement judge_ideal(const Results& results);
Judgement judge_large_steps(const Results& results);
Judgement judge_execution(const Results& results);
Judgement judge_threshold_force(const Results& results);
Judgement judge_neighbours(const Results& results);
Judgement judge_others_stretch(const Results& results);
Judgement judge_robustness(const Results& results);

/// Makes a judgement. `part` is dropped unless the verdict is holds_in_part.
Judgement judged(Verdict verdict, std::string part, Finding finding, Finding bounded = {});

}  // namespace taut::app
