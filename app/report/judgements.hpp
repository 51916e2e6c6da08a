#pragma once

#include <string>
#include <vector>

#include "app/figures/experiments.hpp"
#include "app/report/verdicts.hpp"

namespace taut::app {

struct MeasuredNumber {
  std::string name;
  double value = 0.0;  ///< not finite: lost in a run that diverged
  std::string unit;
  int digits = 3;  ///< significant ones, for people
};

/// "3.84 %", "6.08 × 10⁻⁷ m", "diverged".
std::string number_text(const MeasuredNumber& number);

/// What came out of the test of a claim.
struct Judgement {
  Verdict verdict = Verdict::does_not_hold;
  std::string condition;  ///< under which it holds; empty unless the verdict names one
  std::string finding;    ///< the numbers that decide, as a sentence
  std::vector<MeasuredNumber> measured;
};

Judgement judge_bound(const Results& results);
Judgement judge_fall(const Results& results);
Judgement judge_velocity(const Results& results);
Judgement judge_speed(const Results& results);
Judgement judge_cost(const Results& results);
Judgement judge_any_garment(const Results& results);
Judgement judge_threshold(const Results& results);
Judgement judge_ideal(const Results& results);

}  // namespace taut::app
