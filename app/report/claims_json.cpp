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

Json claim_json(const Claim& claim) {
  Json json = {{"id", claim.id},
               {"section", claim.section},
               {"claim", claim.claim},
               {"test", claim.test},
               {"threshold", claim.threshold},
               {"measured", Json::array()},
               {"verdict", name_of(claim.verdict)},
               {"remark", claim.remark},
               {"figure", nullptr}};
  for (const MeasuredNumber& number : claim.measured) {
    json["measured"].push_back(number_json(number));
  }
  if (!claim.figure.empty()) {
    json["figure"] = claim.figure;
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
