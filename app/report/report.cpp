#include "app/report/report.hpp"

#include <fmt/core.h>
#include <sys/utsname.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/base/counted.hpp"
#include "app/base/version.hpp"
#include "app/drawing/drawing.hpp"
#include "app/scene/scene.hpp"

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
  // Not the node: reports are passed on.
  return std::string(name.sysname) + ' ' + name.release + ' ' + name.machine;
}

void add_result(const char* figure, const std::optional<Recording>& recording,
                std::vector<PromiseResult>& results) {
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

using Json = nlohmann::ordered_json;

Json number_json(const MeasuredNumber& number) {
  Json json = {{"name", number.name}, {"value", nullptr}, {"unit", number.unit}};
  // JSON has no infinity: a run that diverged has no value.
  if (std::isfinite(number.value)) json["value"] = number.value;
  return json;
}

Json text_or_null(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

Json numbers_json(const Finding& finding) {
  Json json = Json::array();
  for (const MeasuredNumber& number : finding.measured) json.push_back(number_json(number));
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
  if (result.bound) json["bound"] = *result.bound;
  return json;
}

int height_in_cell(const renderer::Image& picture, int cell_px) {
  return static_cast<int>(std::lround(static_cast<double>(picture.height_px) * cell_px / picture.width_px));
}

}  // namespace

Report make_report(const Results& results, std::span<const DrawnFigure> figures,
                   const std::string& gl_renderer) {
  const std::vector<Claim> claims = judge_claims(results);
  const std::vector<PromiseResult> promises = promise_results(results);
  const Machine machine = this_machine(gl_renderer);
  return {report_html(claims, promises, figures, machine, methods_html(results)),
          claims_json(claims, promises, machine)};
}

Machine this_machine(const std::string& gl_renderer) {
  Machine machine;
  machine.processor = processor_name();
  machine.threads = std::thread::hardware_concurrency();
  machine.system = system_name();
  if (::getloadavg(&machine.load, 1) != 1) machine.load = 0.0;
  machine.compiler = compiler_version();
  machine.program = "taut " + program_version();
  machine.gl_renderer = gl_renderer;
  return machine;
}

bool PromiseResult::is_bound_kept() const {
  return bound && counts.stretch.springs <= *bound + bound_rounding;
}

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
  const std::size_t kept_apart =
      count(results, [](const auto& r) { return r.is_apart && r.is_kept_apart(); });
  return fmt::format(
      "{} of {} were checked. A bound on stretch is promised in {} of the scenes and kept in every frame of "
      "{}; "
      "that nothing crosses is promised in {} and kept in every frame of {}. Where contact is off nothing is "
      "promised about it, and {}.",
      counted(frames, "frame"), counted(results.size(), "scene"), bounds, kept, apart, kept_apart,
      pairs_elsewhere == 0
          ? "nothing crosses either"
          : "triangles do cross: " + counted(pairs_elsewhere, "pair") + " in all frames together");
}

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
  for (const Claim& claim : claims) json["claims"].push_back(claim_json(claim));
  for (const PromiseResult& result : promises) json["promises"].push_back(promise_json(result));
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

renderer::Image scaled_to_width(const renderer::Image& picture, int width_px) {
  const int height_px =
      static_cast<int>(std::lround(static_cast<double>(picture.height_px) * width_px / picture.width_px));
  renderer::Canvas canvas(width_px, height_px);
  canvas.image(0.0F, 0.0F, static_cast<float>(width_px), static_cast<float>(height_px), picture);
  return canvas.to_image();
}

renderer::Image contact_sheet(std::span<const DrawnFigure> figures, float scale, const SheetLayout& layout) {
  const auto [columns, cell_px, title_px] = layout;
  const int gap_px = cell_px / 20;
  const int title_height_px = static_cast<int>(std::lround(1.8F * title_px));
  // Each goes to the column that is shortest so far.
  std::vector<int> bottoms_px(static_cast<std::size_t>(columns), gap_px);
  std::vector<std::pair<int, int>> corners;
  for (const DrawnFigure& figure : figures) {
    const auto shortest = std::ranges::min_element(bottoms_px);
    const int column = static_cast<int>(shortest - bottoms_px.begin());
    corners.emplace_back(gap_px + column * (cell_px + gap_px), *shortest);
    *shortest += title_height_px + height_in_cell(figure.picture, cell_px) + gap_px;
  }
  renderer::Canvas canvas = renderer::Canvas::scaled(gap_px + columns * (cell_px + gap_px),
                                                     *std::ranges::max_element(bottoms_px), scale);
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const auto x_px = static_cast<float>(corners[i].first), y_px = static_cast<float>(corners[i].second);
    canvas.text(x_px, y_px + title_px, figures[i].name, text_style(title_px, palette::ink, true));
    canvas.image(x_px, y_px + static_cast<float>(title_height_px), static_cast<float>(cell_px),
                 static_cast<float>(height_in_cell(figures[i].picture, cell_px)), figures[i].picture);
  }
  return canvas.to_image();
}

}  // namespace taut::app
