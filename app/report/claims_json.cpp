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

Json claim_json(const Claim& claim) {
  const auto& [text, judgement] = claim;
  Json json = {{"id", text.id},
               {"section", text.section},
               {"claim", text.claim},
               {"test", text.test},
               {"threshold", text.threshold},
               {"measured", Json::array()},
               {"verdict", name_of(judgement.verdict)},
               {"condition", text_or_null(judgement.condition)},
               {"finding", judgement.finding},
               {"remark", text.remark},
               {"figure", text_or_null(text.figure)}};
  for (const MeasuredNumber& number : judgement.measured) {
    json["measured"].push_back(number_json(number));
  }
  return json;
}

}  // namespace

std::string claims_json(const std::vector<Claim>& claims, const Machine& machine) {
  Json json = {
      {"machine",
       {{"processor", machine.processor},
        {"threads", machine.threads},
        {"system", machine.system},
        {"load_last_minute", machine.load}}},
      {"versions",
       {{"program", machine.program}, {"compiler", machine.compiler}, {"gl_renderer", machine.gl_renderer}}},
      {"claims", Json::array()}};
  for (const Claim& claim : claims) {
    json["claims"].push_back(claim_json(claim));
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace taut::app
