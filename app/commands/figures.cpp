#include "app/figures/figures.hpp"

#include <fmt/core.h>

#include <thread>

#include "app/base/files.hpp"
#include "app/base/interruption.hpp"
#include "app/base/job_runner.hpp"
#include "app/base/version.hpp"
#include "app/commands/options.hpp"
#include "app/report/report.hpp"
#include "renderer/page/png.hpp"

namespace taut::app {
namespace {

class FigureWriter {
 public:
  explicit FigureWriter(const FiguresOptions& options)
      : options_(options), offscreen_(options.backend, options.scale) {}

  void write(const Figure& figure, const Results& results) {
    throw_if_interrupted();
    const Drawing drawing = figure.draw(results, offscreen_);
    renderer::Image picture = to_image(drawing, options_.scale);
    const std::vector<renderer::PngText> texts = {{"Software", "taut " + program_version()}};
    write_file(noted(figure.name + ".png"), renderer::encode_png(picture, texts));
    write_pdf(noted(figure.name + ".pdf"), drawing, figure.title);
    if (figure.csv != nullptr) write_text_file(noted(figure.name + ".csv"), figure.csv(results));
    if (figure.shapes_csv != nullptr) {
      write_text_file(noted(figure.name + "_shapes.csv"), figure.shapes_csv(results));
    }
    drawn_.push_back({figure.name, figure.title, std::move(picture)});
    std::ranges::sort(drawn_, [](auto& a, auto& b) { return a.name < b.name; });
    tell();
  }

  void write_report(const Results& results) {
    const Report report = make_report(results, drawn_, offscreen_.gl_renderer());
    write_text_file(noted("claims.json"), report.claims_json);
    write_text_file(noted("report.html"), report.html);
    tell();
  }

  void write_contact_sheet() {
    write_file(noted("contact_sheet.png"), renderer::encode_png(contact_sheet(drawn_, options_.scale)));
    tell();
  }

 private:
  std::filesystem::path noted(const std::string& name) {
    written_.push_back(options_.output / name);
    return written_.back();
  }

  // Over the line of progress, if there is one.
  void tell() {
    for (const std::filesystem::path& path : written_) fmt::print("wrote {}\n", path.string());
    std::fflush(stdout);
    written_.clear();
  }

  const FiguresOptions& options_;
  LazyOffscreenRenderer offscreen_;
  std::vector<DrawnFigure> drawn_;
  std::vector<std::filesystem::path> written_;
};

std::vector<Figure> wanted_figures(const std::vector<std::string>& only) {
  std::vector<Figure> wanted;
  for (const Figure& figure : all_figures()) {
    if (only.empty() || std::ranges::find(only, figure.name) != only.end()) wanted.push_back(figure);
  }
  return wanted;
}

std::vector<Experiment> experiments_for(const std::vector<Figure>& figures, bool with_report) {
  std::set<Experiment> needed;
  for (const Figure& figure : figures) needed.insert(figure.needs.begin(), figure.needs.end());
  if (with_report) {
    needed.insert({Experiment::stiffnesses, Experiment::strong_runs, Experiment::garments, Experiment::restart});
  }
  return {needed.begin(), needed.end()};
}

// Reads all before the first is drawn: a table that is missing shall not cost minutes.
void read_and_draw(const std::vector<Figure>& figures, const std::filesystem::path& folder, Results& results,
                   FigureWriter& writer) {
  for (const Figure& figure : figures) {
    if (figure.read != nullptr) figure.read(folder, results);
  }
  for (const Figure& figure : figures) {
    if (figure.read != nullptr) writer.write(figure, results);
  }
}

// Draws every figure as soon as the last of what it needs is there.
void simulate_and_draw(const std::vector<Figure>& figures, const std::vector<Experiment>& experiments, Results& results,
                       FigureWriter& writer) {
  std::vector<Job> jobs;
  for (const Experiment experiment : experiments) jobs.push_back(job_of(experiment, results));
  std::set<Experiment> done;
  run_jobs(jobs, std::thread::hardware_concurrency(), [&](std::size_t job) {
    done.insert(experiments[job]);
    for (const Figure& figure : figures) {
      const bool is_ready = figure.measure == nullptr &&
                            std::ranges::find(figure.needs, experiments[job]) != figure.needs.end() &&
                            std::ranges::all_of(figure.needs, [&](Experiment e) { return done.contains(e); });
      if (is_ready) writer.write(figure, results);
    }
  });
}

}  // namespace

int run(const FiguresOptions& options) {
  prepare_folder_of(options.output / "fig.png");
  const bool with_report = options.only.empty() && options.data.empty();
  std::vector<Figure> figures = wanted_figures(options.only);
  const bool are_several = figures.size() > 1;
  Results results;
  FigureWriter writer(options);
  if (!options.data.empty()) {
    read_and_draw(figures, options.data, results, writer);
    std::erase_if(figures, [](const Figure& figure) { return figure.read != nullptr; });
  }
  simulate_and_draw(figures, experiments_for(figures, with_report), results, writer);
  for (const Figure& figure : figures) {
    if (figure.measure != nullptr) {
      // Only now, with every other thread gone: they would take from what is measured.
      figure.measure([](double) { throw_if_interrupted(); }, results);
      writer.write(figure, results);
    }
  }
  if (with_report) writer.write_report(results);
  if (are_several) writer.write_contact_sheet();
  return 0;
}

}  // namespace taut::app
