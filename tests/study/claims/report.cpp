#include "tests/study/claims/report.hpp"

#include <sys/utsname.h>

#include <fstream>
#include <thread>

#include "app/base/words.hpp"
#include "renderer/page/png.hpp"

namespace taut::app {
namespace {

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

std::string system_name() {
  utsname name = {};
  if (::uname(&name) != 0) return "unknown";
  // The node name is left out, because reports are passed on.
  return std::string(name.sysname) + ' ' + name.release + ' ' + name.machine;
}

void add_result(const char* figure, const std::optional<Recording>& recording, std::vector<PromiseResult>& results) {
  if (!recording || !recording->promises) return;
  const SolverChoice& solver = recording->scene.simulation.solver;
  PromiseResult result = {figure, recording->scene.name, {}, false, *recording->promises};
  if (solver.kind == sim::SolverKind::bounded) {
    result.bound = solver.bounded.allow_exceeding ? std::nullopt : std::optional(solver.bounded.max_stretch);
    result.is_apart = solver.bounded.contact;
  }
  results.push_back(std::move(result));
}

template <class Predicate> std::size_t count(const std::vector<PromiseResult>& results, Predicate predicate) {
  return static_cast<std::size_t>(std::ranges::count_if(results, predicate));
}

// Sharp on a high-density screen at the width of the text, and small enough to mail.
constexpr int picture_width_px = 1600;

constexpr const char* bounded_label = "<i>With the solver bounded instead, which is not the paper&rsquo;s:</i> ";

std::string escape_html(const std::string& text) {
  constexpr std::string_view special = "&<>\"";
  constexpr std::array names = {"&amp;", "&lt;", "&gt;", "&quot;"};
  std::string result;
  for (const char letter : text) {
    const std::size_t place = special.find(letter);
    result += place == special.npos ? std::string(1, letter) : names[place];
  }
  return result;
}

const char* css_class(Verdict verdict) {
  constexpr std::array classes = {"holds", "part", "fails"};
  return classes[static_cast<std::size_t>(verdict)];
}

std::string verdict_text(const Claim& claim) {
  return !claim.is_check ? to_name(claim.verdict) : claim.verdict == Verdict::holds ? "check: passed" : "check: failed";
}

std::string summary_html(std::span<const Claim> claims) {
  std::string html = "<table>\n<tr><th>claim</th><th>section</th><th>verdict</th></tr>\n";
  for (const Claim& claim : claims) {
    const std::string part = claim.text("part"), bounded = claim.text("bounded");
    html += fmt::format("<tr class=\"{}\"><td><a href=\"#{}\">{}</a></td><td>{}</td><td><b>{}</b>{}</td></tr>\n",
                        css_class(claim.verdict), claim.id, escape_html(claim.text("claim")),
                        escape_html(claim.text("section")), verdict_text(claim),
                        part.empty() ? "" : ":<br><span class=\"small\">" + escape_html(part) + "</span>");
    if (!bounded.empty()) {
      html +=
          fmt::format("<tr class=\"small\"><td colspan=\"3\">{}{}</td></tr>\n", bounded_label, escape_html(bounded));
    }
  }
  return html + "</table>\n";
}

std::string numbers_html(const std::vector<MeasuredNumber>& numbers) {
  std::string html = "<table>\n";
  for (const MeasuredNumber& number : numbers) {
    html += fmt::format("<tr><td>{}</td><td class=\"number\">{}</td></tr>\n", escape_html(number.name),
                        number_text(number));
  }
  return html + "</table>\n";
}

std::string claim_html(const Claim& claim) {
  const auto text = [&](const char* key) { return escape_html(claim.text(key)); };
  std::string html = fmt::format(
      "<section class=\"claim {}\" id=\"{}\">\n<h3>{}</h3>\n"
      "<p><span class=\"verdict\">{}</span> {} <span class=\"small\">(section {} of the paper",
      css_class(claim.verdict), claim.id, text("claim"), verdict_text(claim), text("part"), text("section"));
  if (!text("figure").empty()) html += fmt::format("; see <a href=\"#{0}\">{0}</a>", text("figure"));
  html += fmt::format(
      ")</span></p>\n<p>{}</p>\n<p class=\"small\">Test: {}</p>\n{}<p class=\"small\">Rule: {}.</p>\n<p>{}</p>\n",
      text("finding"), text("test"), numbers_html(claim.numbers), text("rule"), text("remark"));
  if (!text("bounded").empty()) {
    html += fmt::format("<p>{}{}</p>\n{}", bounded_label, text("bounded"), numbers_html(claim.bounded_numbers));
  }
  return html + "</section>\n";
}

std::string verdict_html(bool is_promised, bool is_kept) {
  return !is_promised ? "not promised" : is_kept ? "<b>kept</b>" : "<b>broken</b>";
}

std::string crossings_text(const PromiseCounts& counts) {
  return counts.crossing_frames == 0 ? "0"
                                     : fmt::format("{} in {} of the frames, {} at most", counts.crossing_pairs,
                                                   counts.crossing_frames, counts.max_pairs);
}

std::string promise_html(const PromiseResult& result) {
  const bool is_broken = (result.bound && !result.is_bound_kept()) || (result.is_apart && !result.is_kept_apart());
  const bool is_any = result.bound || result.is_apart;
  return fmt::format(
      "<tr class=\"{}\"><td><a href=\"#{}\">{}</a></td><td class=\"number\">{}</td><td "
      "class=\"number\">{}</td><td class=\"number\">{}</td><td>{}</td><td "
      "class=\"number\">{}</td><td>{}</td></tr>\n",
      is_broken ? "fails"
      : is_any  ? "holds"
                : "part",
      result.figure, escape_html(result.scene), result.counts.frames,
      number_text({"", 100.0 * result.counts.stretch.springs, "%"}),
      result.bound ? fmt::format("{:g} %", 100.0 * *result.bound) : "none",
      verdict_html(result.bound.has_value(), result.is_bound_kept()), crossings_text(result.counts),
      verdict_html(result.is_apart, result.is_kept_apart()));
}

std::string promises_html(const std::vector<PromiseResult>& promises) {
  if (promises.empty()) return "<p>No frame was checked.</p>\n";
  std::string html = fmt::format(
      "<p>{}</p>\n<table>\n<tr><th>scene</th><th>frames</th><th>largest "
      "stretch</th><th>bound</th><th></th><th>crossing pairs</th><th></th></tr>\n",
      escape_html(describe(promises)));
  for (const PromiseResult& result : promises) html += promise_html(result);
  return html + "</table>\n";
}

// Scales the picture without changing its proportions.
renderer::Image scaled_to_width(const renderer::Image& picture, int width_px) {
  const int height_px =
      static_cast<int>(std::lround(static_cast<double>(picture.height_px) * width_px / picture.width_px));
  renderer::Canvas canvas(width_px, height_px);
  canvas.image(0.0F, 0.0F, static_cast<float>(width_px), static_cast<float>(height_px), picture);
  return canvas.to_image();
}

std::string png_url(const renderer::Image& picture) {
  return "data:image/png;base64," + base64(renderer::encode_png(picture));
}

std::string figure_html(const DrawnFigure& figure) {
  return fmt::format(
      "<figure id=\"{0}\">\n<img alt=\"{1}\" src=\"{2}\">\n"
      "<figcaption>{0}. {1}. Also as <a href=\"{0}.png\">{0}.png</a> and, with text and lines that scale, <a "
      "href=\"{0}.pdf\">{0}.pdf</a>{3}.</figcaption>\n"
      "</figure>\n",
      figure.name, escape_html(figure.title), png_url(scaled_to_width(figure.picture, picture_width_px)),
      figure.has_table ? fmt::format("; its numbers: <a href=\"{0}.csv\">{0}.csv</a>", figure.name) : "");
}

std::string machine_html(const std::string& gl_renderer) {
  double load = 0.0;
  if (::getloadavg(&load, 1) != 1) load = 0.0;
  return fmt::format(
      "<p class=\"small\">Measured on {} ({} threads; {}), load {:.1f}; taut {}, built with {}; drawn with {}.</p>\n",
      escape_html(processor_name()), std::thread::hardware_concurrency(), escape_html(system_name()), load,
      program_version(), escape_html(compiler_version()), escape_html(gl_renderer));
}

std::string cell_html(const std::string& text) { return fmt::format("<td class=\"number\">{}</td>", text); }

std::string percent(double fraction) {
  return cell_html(std::isfinite(fraction) ? number_text({"", 100.0 * fraction, "%"}) : "lost");
}

std::string row_html(const ClaimResults& results, sim::SolverKind kind) {
  const MethodTrial& fine = find_trial(results.trials_of(MethodTest::time), kind, trial_meshes.back());
  const MethodTrials& steps = results.trials_of(MethodTest::steps);
  const MethodTrial& usual = find_trial(steps, kind);
  const MethodTrial& longest = find_trial(steps, kind, trial_shirt_triangles, trial_step_factors.back());
  const double speed_m_per_s = find_trial(results.trials_of(MethodTest::rest), kind).last_speed_m_per_s();
  return fmt::format("<tr><td>{}</td>", to_name(kind)) + cell_html(std::to_string(fine.substeps)) +
         cell_html(number_text({"", fine.ranked_ms(0.5), ""})) +
         cell_html(number_text({"", fine.ranked_ms(0.25), ""}) + " to " + number_text({"", fine.ranked_ms(0.75), ""})) +
         percent(fine.max_stretch_seen()) + percent(fine.max_surface_stretch()) +
         cell_html(std::isfinite(speed_m_per_s) ? fmt::format("{:.1f}", 1e3 * speed_m_per_s) : "lost") +
         percent(longest.max_stretch_seen()) +
         cell_html(usual.is_lost ? "lost" : fmt::format("{:.1f}", 1e2 * usual.frames.back().sunk_m)) + "</tr>\n";
}

}  // namespace

std::string base64(std::span<const std::uint8_t> bytes) {
  constexpr const char* letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) group = (group << 8U) | (k < count ? bytes[i + k] : 0U);
    for (std::size_t k = 0; k < 4; ++k) text += k <= count ? letters[(group >> (18U - 6U * k)) & 63U] : '=';
  }
  return text;
}

std::string make_report(const ClaimResults& results, const DrawnFigures& drawn) {
  return report_html(judge_claims(results), promise_results(results), drawn.figures, machine_html(drawn.gl_renderer),
                     methods_html(results), truth_html(calm_experiments(), results.truth),
                     truth_html(wind_experiments(), results.truth));
}

bool PromiseResult::is_bound_kept() const { return bound && counts.stretch.springs <= *bound + bound_rounding; }

std::vector<PromiseResult> promise_results(const Results& results) {
  std::vector<PromiseResult> all;
  if (results.fall) add_result("fig2", results.fall->frames, all);
  for (const auto& recording : results.pinned) add_result("fig4", recording, all);
  for (const auto& recording : results.shirts) add_result("fig5", recording, all);
  return all;
}

std::string describe(const std::vector<PromiseResult>& results) {
  int frames = 0;
  std::size_t pairs_elsewhere = 0;
  for (const PromiseResult& result : results) {
    frames += result.counts.frames;
    pairs_elsewhere += result.is_apart ? 0 : result.counts.crossing_pairs;
  }
  const std::size_t bounds = count(results, [](const auto& r) { return r.bound.has_value(); });
  const std::size_t kept = count(results, [](const auto& r) { return r.is_bound_kept(); });
  const std::size_t apart = count(results, [](const auto& r) { return r.is_apart; });
  const std::size_t kept_apart = count(results, [](const auto& r) { return r.is_apart && r.is_kept_apart(); });
  return fmt::format(
      "{} of {} were checked. A bound on stretch is promised in {} of the scenes and kept in every frame of "
      "{}; that nothing crosses is promised in {} and kept in every frame of {}. Where contact is off "
      "nothing is promised about it, and {}.",
      count_text(frames, "frame"), count_text(results.size(), "scene"), bounds, kept, apart, kept_apart,
      pairs_elsewhere == 0 ? "nothing crosses either"
                           : "triangles do cross: " + count_text(pairs_elsewhere, "pair") + " in all frames together");
}

std::string report_html(std::span<const Claim> claims, const std::vector<PromiseResult>& promises,
                        std::span<const DrawnFigure> figures, const std::string& machine, const std::string& methods,
                        const std::string& truth, const std::string& wind) {
  std::string html = report_page;
  const auto put = [&html](const std::string& place, const std::string& text) {
    html.replace(html.find(place), place.size(), text);
  };
  // Each figure stands where it is first spoken of, the rest with the promises.
  std::vector<DrawnFigure> left(figures.begin(), figures.end());
  const auto take = [&left](const std::string& name) {
    const auto found = std::ranges::find(left, name, &DrawnFigure::name);
    if (found == left.end()) return std::string();
    const std::string figure = figure_html(*found);
    left.erase(found);
    return figure;
  };
  const std::string first_html = take("fig1");
  std::string claims_html = summary_html(claims), figures_html;
  for (const Claim& claim : claims) claims_html += claim_html(claim) + take(claim.text("figure"));
  put("<!--machine-->\n", machine);
  put("<!--first-->\n", first_html);
  put("<!--claims-->\n", claims_html);
  put("<!--promises-->\n", promises_html(promises));
  put("<!--methods-->\n", methods);
  put("<!--truth-->\n", truth + take("truth"));
  put("<!--wind-->\n", wind + take("fig9"));
  for (const DrawnFigure& figure : left) figures_html += figure_html(figure);
  put("<!--figures-->\n", figures_html);
  return html;
}

std::string methods_html(const ClaimResults& results) {
  std::string html = methods_text;
  const std::string place = "<!--rows-->\n";
  std::string rows;
  for (const sim::SolverKind kind : trial_methods) rows += row_html(results, kind);
  html.replace(html.find(place), place.size(), rows);
  return html;
}

}  // namespace taut::app
