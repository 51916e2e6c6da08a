#pragma once

#include <string>
#include <vector>

#include "app/figures/experiments/experiments.hpp"
#include "app/report/measured_number.hpp"
#include "app/report/verdicts.hpp"

namespace taut::app {

/// Numbers, and the sentence that they make.
struct Finding {
  std::string text;
  std::vector<MeasuredNumber> measured;
};

/// What came out of the test of a claim.
struct Judgement {
  Verdict verdict = Verdict::does_not_hold;
  std::string part;  ///< in which it holds; empty unless it holds in part
  Finding finding;   ///< what decides
  /// What the solver `bounded` reaches in the same test. It decides nothing: it is not the paper's method.
  /// Without text where it was not tried.
  Finding bounded;
};

Judgement judge_bound(const Results& results);
Judgement judge_fall(const Results& results);
Judgement judge_velocity(const Results& results);
Judgement judge_speed(const Results& results);
Judgement judge_cost(const Results& results);
Judgement judge_garments(const Results& results);
Judgement judge_threshold(const Results& results);
Judgement judge_ideal(const Results& results);

/// A judgement of which the part is said only where the verdict has one.
Judgement judged(Verdict verdict, std::string part, Finding finding, Finding bounded = {});

}  // namespace taut::app
