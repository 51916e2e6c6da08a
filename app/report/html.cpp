#include <fmt/core.h>

#include <cmath>

#include "app/report/report.hpp"
#include "renderer/page/png.hpp"

namespace taut::app {
namespace {

// Sharp on a high-density screen at the width of the text, and small enough to mail.
constexpr int picture_width_px = 1600;

constexpr const char* bounded_label =
    "<i>With the solver bounded instead, which is not the paper&rsquo;s:</i> ";

constexpr const char* head = R"(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Strong constraint dynamics of garments: figures and claims</title>
<style>
body { max-width: 56rem; margin: 3rem auto; padding: 0 1.5rem; color: #1c1c1c; background: #fff;
  font: 1.05rem/1.55 Charter, "Bitstream Charter", "Sitka Text", Cambria, Georgia, serif; }
h1 { font-size: 1.9rem; line-height: 1.2; margin: 0 0 1rem; }
h2 { font-size: 1.35rem; margin: 3rem 0 1rem; }
h3 { font-size: 1.1rem; margin: 0 0 .4rem; }
figure { margin: 2.5rem 0; }
figure img { width: 100%; height: auto; border: 1px solid #e4e4e4; }
figcaption, .small { font-size: .92rem; color: #4a4a4a; }
section.claim { border-left: .3rem solid #999; padding: .1rem 0 .1rem 1.1rem; margin: 2rem 0; }
section.holds { border-color: #0059a0; }
section.part { border-color: #e69f00; }
section.fails { border-color: #b03a00; }
.verdict { font: 600 .82rem/1 "DejaVu Sans", Verdana, sans-serif; letter-spacing: .02em;
  padding: .3rem .55rem; border-radius: .25rem; color: #fff; background: #0059a0; white-space: nowrap; }
.part .verdict { background: #e69f00; color: #1c1c1c; }
.fails .verdict { background: #b03a00; }
table { border-collapse: collapse; margin: .6rem 0; font-size: .95rem; }
th, td { text-align: left; padding: .2rem 1.4rem .2rem 0; border-bottom: 1px solid #e4e4e4; vertical-align: top; }
td.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
p { margin: .5rem 0; }
a { color: #0059a0; text-decoration-thickness: 1px; text-underline-offset: .15em; }
tr.holds b { color: #0059a0; } tr.part b { color: #8a5a00; } tr.fails b { color: #b03a00; }
</style>
</head>
<body>
)";

std::string escaped(const std::string& text) {
  std::string result;
  for (const char letter : text) {
    switch (letter) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += letter;
    }
  }
  return result;
}

const char* class_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::holds:
      return "holds";
    case Verdict::holds_in_part:
      return "part";
    case Verdict::does_not_hold:
      return "fails";
  }
  return "";
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
  if (!text.figure.empty()) {
    html += fmt::format("; see <a href=\"#{0}\">{0}</a>", text.figure);
  }
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

std::string figure_html(const DrawnFigure& figure) {
  const std::vector<std::uint8_t> png = renderer::encode_png(
      scaled_to_width(figure.picture, picture_width_px), {}, {.deflate_level = 6, .filter = 4});
  return fmt::format(
      "<figure id=\"{0}\">\n<img alt=\"{1}\" src=\"data:image/png;base64,{2}\">\n"
      "<figcaption>{0}. {1}. Also as {0}.png and, with text and lines that scale, {0}.pdf.</figcaption>\n"
      "</figure>\n",
      figure.name, escaped(figure.title), base64(png));
}

std::string machine_html(const Machine& machine) {
  return fmt::format(
      "<p class=\"small\">Measured on {} ({} threads; {}), load {:.1f}; {}, built with {}; drawn with "
      "{}.</p>\n",
      escaped(machine.processor), machine.threads, escaped(machine.system), machine.load,
      escaped(machine.program), escaped(machine.compiler), escaped(machine.gl_renderer));
}

}  // namespace

std::string base64(std::span<const std::uint8_t> bytes) {
  constexpr const char* letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = (group << 8U) | (k < count ? bytes[i + k] : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += k <= count ? letters[(group >> (18U - 6U * k)) & 63U] : '=';
    }
  }
  return text;
}

std::string report_html(std::span<const Claim> claims, std::span<const DrawnFigure> figures,
                        const Machine& machine) {
  std::string html = head;
  html +=
      "<h1>Strong constraint dynamics of garments: figures and claims</h1>\n"
      "<p>Zheng-Dong Liu&rsquo;s &ldquo;Strong Constraint Dynamic Simulation Method for 3D Garment "
      "Models&rdquo; maps the triangles of a garment to springs, moves them by Verlet&rsquo;s rule and "
      "corrects "
      "every spring after each step. Its figures are drawn again here, and its claims are put to the test. "
      "Every number on this page was measured in the run that wrote it.</p>\n"
      "<p>Each claim is judged by a rule that stands in the program before anything is measured, and by the "
      "paper&rsquo;s own method alone: the solver <i>strong</i>. What the solver <i>bounded</i> of this "
      "program "
      "reaches in the same test stands on a line of its own and decides nothing. What no number can decide, "
      "such as whether cloth looks real or a method is easy to build in, is left out.</p>\n";
  html += machine_html(machine) + "<h2>Claims</h2>\n" + summary_html(claims);
  for (const Claim& claim : claims) {
    html += claim_html(claim);
  }
  html += "<h2>Figures</h2>\n";
  for (const DrawnFigure& figure : figures) {
    html += figure_html(figure);
  }
  return html + "</body>\n</html>\n";
}

}  // namespace taut::app
