#include "app/report/report.hpp"

namespace taut::app {

Report make_report(const Results& results, const Film& film, std::span<const DrawnFigure> figures,
                   const std::string& gl_renderer) {
  const std::vector<Claim> claims = judge_claims(results);
  const std::vector<PromiseResult> promises = promise_results(results);
  const Machine machine = this_machine(gl_renderer);
  return {
      report_html(claims, promises, figures, machine, film_html(film, *results.film), methods_html(results)),
      claims_json(claims, promises, machine)};
}

}  // namespace taut::app
