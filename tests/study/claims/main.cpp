#include <CLI/CLI.hpp>

#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/base/words.hpp"
#include "tests/study/claims/report.hpp"

// judge_claims: makes every figure of the paper, figure 8, and a report that judges the paper's claims.

namespace taut::app {
namespace {

std::vector<Figure> list_figures(ClaimResults& results) {
  std::vector<Figure> figures = all_figures(results);
  figures.push_back(make_figure8(results));
  figures.push_back(truth_figure(results.truth));
  figures.push_back(make_figure9(results.truth));
  return figures;
}

// Draws figures from their tables, without experiments.
void draw_from_tables(FiguresOptions options, const std::filesystem::path& folder) {
  ClaimResults results;
  std::vector<Figure> figures = list_figures(results);
  for (Figure& figure : figures) {
    const bool is_asked_for = options.selected_names.empty() ||
                              std::ranges::find(options.selected_names, figure.name) != options.selected_names.end();
    if (!is_asked_for || !figure.csv) continue;
    read_figure(figure.name, folder, results);
    figure.needs.clear();
    figure.measure = nullptr;
  }
  draw_figures(options, std::move(figures), {experiments(results).front()});
}

void draw_and_judge(const FiguresOptions& options) {
  ClaimResults results;
  std::vector<Figure> figures = list_figures(results);
  std::vector<Job> jobs = experiments(results, Checking::promises);
  std::ranges::move(claim_experiments(results), std::back_inserter(jobs));
  std::ranges::move(truth_jobs(results.truth), std::back_inserter(jobs));
  const DrawnFigures drawn = draw_figures(options, std::move(figures), std::move(jobs));
  if (!options.selected_names.empty()) return;
  write_text_file(options.output / "report.html", make_report(results, drawn));
  std::printf("wrote %s\n", (options.output / "report.html").c_str());
}

}  // namespace
}  // namespace taut::app

int main(int argument_count, char** arguments) {
  using namespace taut::app;
  CLI::App app("All figures, and a report that judges the claims of the paper", "judge_claims");
  FiguresOptions options;
  std::filesystem::path data;
  ClaimResults none;
  app.add_option("--only", options.selected_names, "some of the figures; no report")
      ->delimiter(',')
      ->check(CLI::IsMember(collect<std::string>(list_figures(none), &Figure::name)));
  app.add_option("--data", data, "folder with the tables of an earlier run, to draw from; no report");
  app.add_option("-o,--output", options.output, "folder for the pictures")->capture_default_str();
  app.add_option("--scale", options.scale, "pictures this many times as wide and high")->check(CLI::Range(0.1, 4.0));
  CLI11_PARSE(app, argument_count, arguments);
  // Figure 9 is the second page of "truth".
  std::vector<std::string>& selected = options.selected_names;
  if (std::ranges::count(selected, "truth") > 0 && std::ranges::count(selected, "fig9") == 0) {
    selected.emplace_back("fig9");
  }
  try {
    watch_for_interruption();
    data.empty() ? draw_and_judge(options) : draw_from_tables(options, data);
    return 0;
  } catch (const Interrupted& interrupted) {
    end_by_signal(interrupted.signal);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "judge_claims: error: %s\n", error.what());
    return 1;
  }
}
