#pragma once

#include <string>
#include <vector>

#include "app/figures/experiments/experiments.hpp"
#include "app/report/judgements.hpp"
#include "app/report/machine.hpp"

namespace taut::app {

/// A claim of the paper in our own words, how it is tested and by which rule it is judged. All of it is true
/// whatever comes out.
struct ClaimText {
  std::string id;
  std::string section;  ///< of the paper
  std::string claim;
  std::string test;
  std::string rule;
  std::string remark;  ///< what else to know
  std::string figure;  ///< where it can be seen; empty: nowhere
};

struct Claim {
  ClaimText text;
  Judgement judgement;
};

/// All claims, judged by what was measured.
std::vector<Claim> judge_claims(const Results& results);

/// As one JSON object.
std::string claims_json(const std::vector<Claim>& claims, const Machine& machine);

}  // namespace taut::app
