#pragma once

#include <string>
#include <vector>

#include "app/figures/experiments/experiments.hpp"
#include "app/report/judgements.hpp"
#include "app/report/machine.hpp"
#include "app/report/promises.hpp"

namespace taut::app {

/// A claim of the paper, how it is tested and by which rule it is judged. These texts do not depend on the
/// result.
struct ClaimText {
  std::string id;
  std::string section;  ///< section of the paper
  std::string claim;    ///< in our own words
  std::string test;
  std::string rule;    ///< when the claim holds, holds in part or does not hold
  std::string remark;  ///< what else to know; may be empty
  std::string figure;  ///< name of the figure that shows it; may be empty
};

/// A claim with the result of its test.
struct Claim {
  ClaimText text;
  Judgement judgement;
};

/// Judges all claims by what was measured.
std::vector<Claim> judge_claims(const Results& results);

/// All claims, and what is promised, as one JSON object.
std::string claims_json(const std::vector<Claim>& claims, const std::vector<PromiseResult>& promises,
                        const Machine& machine);

}  // namespace taut::app
