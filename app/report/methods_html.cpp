#include <fmt/core.h>

#include <cmath>

#include "app/report/report.hpp"
#include "app/report/report_texts.hpp"

namespace taut::app {
namespace {

std::string cell_html(const std::string& text) {
  return fmt::format("<td class=\"number\">{}</td>", text);
}

std::string percent(double fraction) {
  return cell_html(std::isfinite(fraction) ? fmt::format("{:.3g} %", 100.0 * fraction) : "lost");
}

std::string row_html(const Results& results, sim::SolverKind kind) {
  const MethodTrial& fine = trial_of(results.trials_of(MethodTest::time), kind, trial_meshes.back());
  const MethodTrials& steps = results.trials_of(MethodTest::steps);
  const MethodTrial& usual = trial_of(steps, kind);
  const MethodTrial& longest = trial_of(steps, kind, trial_shirt_triangles, trial_step_factors.back());
  const double speed_m_per_s = trial_of(results.trials_of(MethodTest::rest), kind).last_speed_m_per_s();
  return fmt::format("<tr><td>{}</td>", name_of(kind)) + cell_html(std::to_string(fine.substeps)) +
         cell_html(fmt::format("{:.3g}", fine.ranked_ms(0.5))) +
         cell_html(fmt::format("{:.3g} to {:.3g}", fine.ranked_ms(0.25), fine.ranked_ms(0.75))) +
         percent(fine.largest_stretch()) + percent(fine.largest_surface_stretch()) +
         cell_html(std::isfinite(speed_m_per_s) ? fmt::format("{:.1f}", 1e3 * speed_m_per_s) : "lost") +
         percent(longest.largest_stretch()) +
         cell_html(usual.is_lost ? "lost" : fmt::format("{:.1f}", 1e2 * usual.frames.back().sunk_m)) +
         "</tr>\n";
}

}  // namespace

std::string methods_html(const Results& results) {
  std::string html = methods_text;
  const std::string place = "<!--rows-->\n";
  std::string rows;
  for (const sim::SolverKind kind : trial_methods) {
    rows += row_html(results, kind);
  }
  html.replace(html.find(place), place.size(), rows);
  return html;
}

}  // namespace taut::app
