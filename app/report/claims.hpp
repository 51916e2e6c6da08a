#pragma once

#include <string>
#include <vector>

#include "app/figures/experiments.hpp"
#include "app/report/machine.hpp"
#include "app/report/verdicts.hpp"

namespace taut::app {

struct MeasuredNumber {
  std::string name;
  double value = 0.0;
  std::string unit;
  int digits = 3;  ///< significant ones, for people
};

/// A claim of the paper in our own words, how it was tested, and what came out.
struct Claim {
  std::string id;
  std::string section;  ///< of the paper
  std::string claim;
  std::string test;
  std::string threshold;
  std::vector<MeasuredNumber> measured;
  Verdict verdict = Verdict::does_not_hold;
  std::string remark;  ///< the condition, or what else to know
  std::string figure;  ///< where it can be seen; empty: nowhere
};

/// All claims, judged by what was measured.
std::vector<Claim> judge_claims(const Results& results);

/// As one JSON object.
std::string claims_json(const std::vector<Claim>& claims, const Machine& machine);

}  // namespace taut::app
