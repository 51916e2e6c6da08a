#include <cmath>
#include <nlohmann/json.hpp>

#include "app/report/claims.hpp"

namespace taut::app {
namespace {

using Json = nlohmann::ordered_json;

Json number_json(const MeasuredNumber& number) {
  Json json = {{"name", number.name}, {"value", nullptr}, {"unit", number.unit}};
  // JSON has no infinity: a run that diverged has no value.
  if (std::isfinite(number.value)) {
    json["value"] = number.value;
  }
  return json;
}

Json text_or_null(const std::string& text) {
  return text.empty() ? Json(nullptr) : Json(text);
}

Json numbers_json(const Finding& finding) {
  Json json = Json::array();
  for (const MeasuredNumber& number : finding.measured) {
    json.push_back(number_json(number));
  }
  return json;
}

Json claim_json(const Claim& claim) {
  const auto& [text, judgement] = claim;
  Json json = {{"id", text.id},
               {"section", text.section},
               {"claim", text.claim},
               {"test", text.test},
               {"rule", text.rule},
               {"measured", numbers_json(judgement.finding)},
               {"verdict", name_of(judgement.verdict)},
               {"part", text_or_null(judgement.part)},
               {"finding", judgement.finding.text},
               {"bounded", nullptr},
               {"remark", text.remark},
               {"figure", text_or_null(text.figure)}};
  if (!judgement.bounded.text.empty()) {
    json["bounded"] = {{"finding", judgement.bounded.text}, {"measured", numbers_json(judgement.bounded)}};
  }
  return json;
}

Json promise_json(const PromiseResult& result) {
  Json json = {{"scene", result.scene},
               {"figure", result.figure},
               {"frames", result.counts.frames},
               {"bound", nullptr},
               {"max_stretch", result.counts.stretch.springs},
               {"max_surface_stretch", result.counts.stretch.surface},
               {"contact", result.is_apart},
               {"crossing_pairs", result.counts.crossing_pairs},
               {"most_crossing_pairs", result.counts.most_pairs},
               {"crossing_frames", result.counts.crossing_frames}};
  if (result.bound) {
    json["bound"] = *result.bound;
  }
  return json;
}

}  // namespace

std::string claims_json(const std::vector<Claim>& claims, const std::vector<PromiseResult>& promises,
                        const Machine& machine) {
  Json json = {
      {"machine",
       {{"processor", machine.processor},
        {"threads", machine.threads},
        {"system", machine.system},
        {"load_last_minute", machine.load}}},
      {"versions",
       {{"program", machine.program}, {"compiler", machine.compiler}, {"gl_renderer", machine.gl_renderer}}},
      {"claims", Json::array()},
      {"promises", Json::array()}};
  for (const Claim& claim : claims) {
    json["claims"].push_back(claim_json(claim));
  }
  for (const PromiseResult& result : promises) {
    json["promises"].push_back(promise_json(result));
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace taut::app
