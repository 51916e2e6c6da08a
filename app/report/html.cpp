#include <fmt/core.h>

#include "app/base/base64.hpp"
#include "app/report/report.hpp"
#include "app/report/report_texts.hpp"
#include "app/scene/scene.hpp"
#include "renderer/page/png.hpp"

namespace taut::app {
namespace {

// Sharp on a high-density screen at the width of the text, and small enough to mail.
constexpr int picture_width_px = 1600;

constexpr const char* bounded_label =
    "<i>With the solver bounded instead, which is not the paper&rsquo;s:</i> ";

std::string escaped(const std::string& text) {
  constexpr std::string_view special = "&<>\"";
  constexpr std::array names = {"&amp;", "&lt;", "&gt;", "&quot;"};
  std::string result;
  for (const char letter : text) {
    const std::size_t place = special.find(letter);
    result += place == special.npos ? std::string(1, letter) : names[place];
  }
  return result;
}

const char* class_of(Verdict verdict) {
  constexpr std::array classes = {"holds", "part", "fails"};
  return classes[static_cast<std::size_t>(verdict)];
}

std::string summary_html(std::span<const Claim> claims) {
  std::string html = "<table>\n<tr><th>claim</th><th>section</th><th>verdict</th></tr>\n";
  for (const auto& [text, judgement] : claims) {
    html += fmt::format(
        "<tr class=\"{}\"><td><a href=\"#{}\">{}</a></td><td>{}</td><td><b>{}</b>{}</td></tr>\n",
        class_of(judgement.verdict), text.id, escaped(text.claim), escaped(text.section),
        name_of(judgement.verdict),
        judgement.part.empty() ? "" : ":<br><span class=\"small\">" + escaped(judgement.part) + "</span>");
    if (!judgement.bounded.text.empty()) {
      html += fmt::format("<tr class=\"small\"><td colspan=\"3\">{}{}</td></tr>\n", bounded_label,
                          escaped(judgement.bounded.text));
    }
  }
  return html + "</table>\n";
}

std::string numbers_html(const std::vector<MeasuredNumber>& numbers) {
  std::string html = "<table>\n";
  for (const MeasuredNumber& number : numbers) {
    html += fmt::format("<tr><td>{}</td><td class=\"number\">{}</td></tr>\n", escaped(number.name),
                        number_text(number));
  }
  return html + "</table>\n";
}

std::string claim_html(const Claim& claim) {
  const auto& [text, judgement] = claim;
  std::string html = fmt::format("<section class=\"claim {}\" id=\"{}\">\n<h3>{}</h3>\n",
                                 class_of(judgement.verdict), text.id, escaped(text.claim));
  html +=
      fmt::format("<p><span class=\"verdict\">{}</span> {} <span class=\"small\">(section {} of the paper",
                  name_of(judgement.verdict), escaped(judgement.part), escaped(text.section));
  if (!text.figure.empty()) html += fmt::format("; see <a href=\"#{0}\">{0}</a>", text.figure);
  html += fmt::format(")</span></p>\n<p>{}</p>\n<p class=\"small\">Test: {}</p>\n{}",
                      escaped(judgement.finding.text), escaped(text.test),
                      numbers_html(judgement.finding.measured));
  html +=
      fmt::format("<p class=\"small\">Rule: {}.</p>\n<p>{}</p>\n", escaped(text.rule), escaped(text.remark));
  if (!judgement.bounded.text.empty()) {
    html += fmt::format("<p>{}{}</p>\n{}", bounded_label, escaped(judgement.bounded.text),
                        numbers_html(judgement.bounded.measured));
  }
  return html + "</section>\n";
}

std::string verdict_html(bool is_promised, bool is_kept) {
  return !is_promised ? "not promised" : is_kept ? "<b>kept</b>" : "<b>broken</b>";
}

std::string crossings_text(const PromiseCounts& counts) {
  return counts.crossing_frames == 0
             ? "0"
             : fmt::format("{} in {} of the frames, {} at most", counts.crossing_pairs,
                           counts.crossing_frames, counts.most_pairs);
}

std::string promise_html(const PromiseResult& result) {
  const bool is_broken =
      (result.bound && !result.is_bound_kept()) || (result.is_apart && !result.is_kept_apart());
  const bool is_any = result.bound || result.is_apart;
  return fmt::format(
      "<tr class=\"{}\"><td><a href=\"#{}\">{}</a></td><td class=\"number\">{}</td>"
      "<td class=\"number\">{:.4f} %</td><td class=\"number\">{}</td><td>{}</td>"
      "<td class=\"number\">{}</td><td>{}</td></tr>\n",
      is_broken ? "fails"
      : is_any  ? "holds"
                : "part",
      result.figure, escaped(result.scene), result.counts.frames, 100.0 * result.counts.stretch.springs,
      result.bound ? fmt::format("{:g} %", 100.0 * *result.bound) : "none",
      verdict_html(result.bound.has_value(), result.is_bound_kept()), crossings_text(result.counts),
      verdict_html(result.is_apart, result.is_kept_apart()));
}

std::string promises_html(const std::vector<PromiseResult>& promises) {
  if (promises.empty()) return "<p>No frame was checked.</p>\n";
  std::string html = fmt::format(
      "<p>{}</p>\n<table>\n<tr><th>scene</th><th>frames</th><th>largest stretch</th><th>bound</th><th></th>"
      "<th>crossing pairs</th><th></th></tr>\n",
      escaped(describe(promises)));
  for (const PromiseResult& result : promises) html += promise_html(result);
  return html + "</table>\n";
}

std::string png_url(const renderer::Image& picture) {
  return "data:image/png;base64," + base64(renderer::encode_png(picture));
}

std::string figure_html(const DrawnFigure& figure) {
  return fmt::format(
      "<figure id=\"{0}\">\n<img alt=\"{1}\" src=\"{2}\">\n"
      "<figcaption>{0}. {1}. Also as <a href=\"{0}.png\">{0}.png</a> and, with text and lines that scale, "
      "<a href=\"{0}.pdf\">{0}.pdf</a>.</figcaption>\n"
      "</figure>\n",
      figure.name, escaped(figure.title), png_url(scaled_to_width(figure.picture, picture_width_px)));
}

std::string machine_html(const Machine& machine) {
  return fmt::format(
      "<p class=\"small\">Measured on {} ({} threads; {}), load {:.1f}; {}, built with {}; drawn with "
      "{}.</p>\n",
      escaped(machine.processor), machine.threads, escaped(machine.system), machine.load,
      escaped(machine.program), escaped(machine.compiler), escaped(machine.gl_renderer));
}

std::string cell_html(const std::string& text) { return fmt::format("<td class=\"number\">{}</td>", text); }

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

std::string report_html(std::span<const Claim> claims, const std::vector<PromiseResult>& promises,
                        std::span<const DrawnFigure> figures, const Machine& machine,
                        const std::string& methods) {
  std::string html = report_page;
  const auto put = [&html](const std::string& place, const std::string& text) {
    html.replace(html.find(place), place.size(), text);
  };
  std::string claims_html = summary_html(claims);
  for (const Claim& claim : claims) claims_html += claim_html(claim);
  std::string figures_html;
  for (const DrawnFigure& figure : figures) figures_html += figure_html(figure);
  put("<!--machine-->\n", machine_html(machine));
  put("<!--claims-->\n", claims_html);
  put("<!--promises-->\n", promises_html(promises));
  put("<!--figures-->\n", figures_html);
  put("<!--methods-->\n", methods);
  return html;
}

std::string methods_html(const Results& results) {
  std::string html = methods_text;
  const std::string place = "<!--rows-->\n";
  std::string rows;
  for (const sim::SolverKind kind : trial_methods) rows += row_html(results, kind);
  html.replace(html.find(place), place.size(), rows);
  return html;
}

}  // namespace taut::app
