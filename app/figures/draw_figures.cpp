#include "app/figures/draw_figures.hpp"

#include <fmt/core.h>

#include <thread>

#include "app/base/files.hpp"
#include "app/base/interruption.hpp"
#include "app/base/version.hpp"
#include "renderer/page/png.hpp"

namespace taut::app {
namespace {

int height_in_cell(const renderer::Image& picture, int cell_px) {
  return static_cast<int>(std::lround(static_cast<double>(picture.height_px) * cell_px / picture.width_px));
}

class FigureWriter {
 public:
  explicit FigureWriter(const FiguresOptions& options)
      : options_(options), offscreen_(options.backend, options.scale) {}

  void write(const Figure& figure) {
    throw_if_interrupted();
    const Drawing drawing = figure.draw(offscreen_);
    renderer::Image picture = to_image(drawing, options_.scale);
    const std::vector<renderer::PngText> texts = {{"Software", "taut " + program_version()}};
    write_file(noted(figure.name + ".png"), renderer::encode_png(picture, texts));
    write_pdf(noted(figure.name + ".pdf"), drawing, figure.title);
    if (figure.csv) write_text_file(noted(figure.name + ".csv"), figure.csv());
    if (figure.shapes_csv) {
      write_text_file(noted(figure.name + "_shapes.csv"), figure.shapes_csv());
    }
    drawn_.push_back({figure.name, figure.title, std::move(picture), figure.csv != nullptr});
    std::ranges::sort(drawn_, [](auto& a, auto& b) { return a.name < b.name; });
    tell();
  }

  void write_contact_sheet() {
    write_file(noted("contact_sheet.png"), renderer::encode_png(contact_sheet(drawn_, options_.scale)));
    tell();
  }

  DrawnFigures finish() && { return {std::move(drawn_), offscreen_.gl_renderer()}; }

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

// Reads all before the first is drawn: a table that is missing shall not cost minutes.
void read_and_draw(std::span<const Figure> figures, const std::filesystem::path& folder, FigureWriter& writer) {
  for (const Figure& figure : figures) {
    if (figure.read) figure.read(folder);
  }
  for (const Figure& figure : figures) {
    if (figure.read) writer.write(figure);
  }
}

// Draws every figure as soon as the last of what it needs is there.
void simulate_and_draw(std::span<const Figure> figures, std::span<const Job> experiments, FigureWriter& writer) {
  std::set<std::string> done;
  run_jobs(experiments, std::thread::hardware_concurrency(), [&](std::size_t job) {
    const std::string& name = experiments[job].name;
    done.insert(name);
    for (const Figure& figure : figures) {
      const bool is_ready = !figure.measure && figure.does_need(name) &&
                            std::ranges::all_of(figure.needs, [&](auto& need) { return done.contains(need); });
      if (is_ready) writer.write(figure);
    }
  });
}

}  // namespace

bool Figure::does_need(const std::string& experiment) const {
  return std::ranges::find(needs, experiment) != needs.end();
}

DrawnFigures draw_figures(const FiguresOptions& options, std::vector<Figure> figures, std::vector<Job> experiments) {
  prepare_folder_of(options.output / "fig.png");
  std::erase_if(figures, [&](const Figure& figure) {
    return !options.only.empty() && std::ranges::find(options.only, figure.name) == options.only.end();
  });
  const bool are_several = figures.size() > 1;
  FigureWriter writer(options);
  if (!options.data.empty()) {
    read_and_draw(figures, options.data, writer);
    std::erase_if(figures, [](const Figure& figure) { return figure.read != nullptr; });
  }
  if (!options.only.empty() || !options.data.empty()) {
    std::erase_if(experiments, [&](const Job& job) {
      return std::ranges::none_of(figures, [&](const Figure& figure) { return figure.does_need(job.name); });
    });
  }
  simulate_and_draw(figures, experiments, writer);
  for (const Figure& figure : figures) {
    if (figure.measure) {
      // Only now, with every other thread gone: they would take from what is measured.
      figure.measure([](double) { throw_if_interrupted(); });
      writer.write(figure);
    }
  }
  if (are_several) writer.write_contact_sheet();
  return std::move(writer).finish();
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
  renderer::Canvas canvas =
      renderer::Canvas::scaled(gap_px + columns * (cell_px + gap_px), *std::ranges::max_element(bottoms_px), scale);
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const auto x_px = static_cast<float>(corners[i].first), y_px = static_cast<float>(corners[i].second);
    canvas.text(x_px, y_px + title_px, figures[i].name, text_style(title_px, palette::ink, true));
    canvas.image(x_px, y_px + static_cast<float>(title_height_px), static_cast<float>(cell_px),
                 static_cast<float>(height_in_cell(figures[i].picture, cell_px)), figures[i].picture);
  }
  return canvas.to_image();
}

}  // namespace taut::app
