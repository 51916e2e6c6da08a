#include "app/figures/figures.hpp"

#include <thread>

#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/base/words.hpp"
#include "app/drawing/plots/plot.hpp"
#include "app/output/picture_record.hpp"

namespace taut::app {
namespace {

// Repeats of each timing, so many that one disturbance does not change their median. Each repeat takes a fraction of a
// second.
constexpr int frame_time_repeats = 15;

void time_strong_shirts(Results& results, const ProgressCallback& report_progress) {
  measure_frame_times(frame_time_repeats, report_progress, results);
}

/// Writes a table of the recordings that are a member of the results.
template <auto write, auto member> std::string write_all(const Results& results) {
  return write(collect<const Recording*>(results.*member, [](const auto& recording) { return &*recording; }));
}

constexpr float panel_px = 1150.0F;

struct KindLook {
  const char* name;
  Stroke stroke;
  float bow;  ///< bends springs that skip a mass point away from the springs that they run along
};

KindLook spring_style(sim::SpringKind kind) {
  return std::array<KindLook, 3>{
      {{"structural", {palette::ink, 8.0F, {}}, 0.0F},
       {"shear", {palette::vermilion, 5.0F, {0.6F, 1.6F}}, 0.0F},
       {"flexural", {palette::sky, 6.0F, {4.0F, 1.6F}}, 0.11F}}}[static_cast<std::size_t>(kind)];
}

// Maps metres to a square on the canvas.
struct SquarePlacement {
  glm::vec2 centre_m;
  glm::vec2 centre_px;
  float px_per_m;

  glm::vec2 operator()(const glm::vec2& point_m) const {
    const glm::vec2 from_centre = (point_m - centre_m) * px_per_m;
    return centre_px + glm::vec2(from_centre.x, -from_centre.y);
  }
};

SquarePlacement fit_to_square(const SpringPatch& patch, const glm::vec2& corner_px) {
  glm::vec2 lower(INFINITY), upper(-INFINITY);
  for (const glm::vec2& point : patch.points_m) {
    lower = glm::min(lower, point);
    upper = glm::max(upper, point);
  }
  const glm::vec2 size = upper - lower;
  return {0.5F * (lower + upper), corner_px + glm::vec2(0.5F * panel_px), 0.86F * panel_px / std::max(size.x, size.y)};
}

void draw_patch(renderer::Canvas& canvas, const SpringPatch& patch, const glm::vec2& corner_px) {
  const SquarePlacement place = fit_to_square(patch, corner_px);
  // Long springs are drawn first, under the springs that they cross.
  for (const sim::SpringKind kind : {sim::SpringKind::flexural, sim::SpringKind::shear, sim::SpringKind::structural}) {
    const KindLook look = spring_style(kind);
    for (const PatchSpring& spring : patch.springs) {
      if (spring.kind == kind) {
        const glm::vec2 a = place(patch.points_m[spring.ends[0]]), b = place(patch.points_m[spring.ends[1]]);
        draw_polyline(canvas, bow(a, b, look.bow), look.stroke);
      }
    }
  }
  for (const glm::vec2& point : patch.points_m) {
    const glm::vec2 at = place(point);
    canvas.circle(at.x, at.y, 20.0F, renderer::Colour{1.0F});
    canvas.circle(at.x, at.y, 16.0F, palette::ink);
  }
}

std::string describe_counts(const SpringPatch& patch) {
  std::string text = fmt::format("{} mass points", patch.points_m.size());
  for (const sim::SpringKind kind : sim::all_spring_kinds) {
    if (patch.count(kind) > 0) text += fmt::format(", {} {}", patch.count(kind), spring_style(kind).name);
  }
  return text + " springs";
}

void draw_legend_row(renderer::Canvas& canvas, float centre_px, float y_px) {
  constexpr float sample_px = 130.0F, space_px = 90.0F, text_px = 40.0F;
  const renderer::TextStyle text =
      text_style(text_px).with_alignment(renderer::HorizontalAlign::left, renderer::VerticalAlign::middle);
  float width_px = -space_px;
  for (const sim::SpringKind kind : sim::all_spring_kinds) {
    width_px +=
        sample_px + 24.0F + canvas.measure(std::string(spring_style(kind).name) + " spring", text).width_px + space_px;
  }
  width_px += space_px + 60.0F + canvas.measure("mass point", text).width_px;
  float x_px = centre_px - 0.5F * width_px;
  for (const sim::SpringKind kind : sim::all_spring_kinds) {
    const KindLook look = spring_style(kind);
    const std::string name = std::string(look.name) + " spring";
    draw_polyline(canvas, bow({x_px, y_px}, {x_px + sample_px, y_px}, -look.bow), look.stroke);
    canvas.text(x_px + sample_px + 24.0F, y_px, name, text);
    x_px += sample_px + 24.0F + canvas.measure(name, text).width_px + space_px;
  }
  canvas.circle(x_px + 16.0F, y_px, 16.0F, palette::ink);
  canvas.text(x_px + 60.0F, y_px, "mass point", text);
}

class FigureWriter {
 public:
  explicit FigureWriter(const FiguresOptions& options)
      : options_(options), offscreen_(options.backend, options.scale) {}

  void write(const Figure& figure) {
    throw_if_interrupted();
    const Drawing drawing = figure.draw(offscreen_);
    renderer::Image picture = to_image(drawing, options_.scale);
    const std::vector<renderer::PngText> texts = {program_text()};
    const std::filesystem::path stem = choose_stem(figure.name);
    std::vector<std::filesystem::path> written;
    const auto file = [&](const char* ending) { return written.emplace_back(stem).concat(ending); };
    write_file(file(".png"), renderer::encode_png(picture, texts));
    write_pdf(file(".pdf"), drawing, figure.title);
    if (figure.csv) write_text_file(file(".csv"), figure.csv());
    if (figure.shapes_csv) write_text_file(file("_shapes.csv"), figure.shapes_csv());
    drawn_.push_back({figure.name, figure.title, std::move(picture), figure.csv != nullptr});
    std::ranges::sort(drawn_, [](auto& a, auto& b) { return a.name < b.name; });
    for (const std::filesystem::path& path : written) fmt::print("wrote {}\n", path.string());
    std::fflush(stdout);
  }

  DrawnFigures finish() && { return {std::move(drawn_), offscreen_.gl_renderer()}; }

 private:
  /// Returns the path of a figure's files, without extension. Existing files of a figure may be replaced if its picture
  /// was made by this program.
  std::filesystem::path choose_stem(const std::string& name) const {
    const std::filesystem::path stem = options_.output / name;
    const bool own = is_own_picture(options_.output / (name + ".png"));
    return choose_free_stem(stem, own, {".png", ".pdf", ".csv", "_shapes.csv"});
  }

  const FiguresOptions& options_;
  LazyOffscreenRenderer offscreen_;
  std::vector<DrawnFigure> drawn_;
};

// Draws every figure as soon as all its experiments are done.
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

std::vector<Figure> all_figures(Results& results) {
  const auto of = [&results](auto function) { return std::bind_front(function, std::ref(results)); };
  return {
      {"fig1",
       "The mass-spring model and its types of springs, as the mapping makes them",
       {"mapping"},
       of(draw_figure1)},
      {"fig2",
       "A cloth falls under gravity, held by two corners",
       {fall_scene},
       of(draw_figure2),
       of([](const Results& all) { return moments_csv(std::array{&all.fall->frames}); }),
       of([](const Results& all) { return shapes_csv(std::array{&all.fall->frames}); })},
      {"fig3", "One mass point converges", {fall_scene}, of(draw_figure3), of(figure3_csv)},
      {"fig4",
       "Over-stretch of up to 5 % and up to 20 %, and where it is",
       {pinned_scenes.begin(), pinned_scenes.end()},
       of(draw_figure4),
       of(write_all<moments_csv, &Results::pinned>),
       of(write_all<shapes_csv, &Results::pinned>)},
      {"fig5",
       "The T-shirt under gravity and in two winds",
       {shirt_scenes.begin(), shirt_scenes.end()},
       of(draw_figure5),
       of(write_all<moments_csv, &Results::shirts>),
       of(write_all<shapes_csv, &Results::shirts>)},
      {"fig6",
       "What a frame costs for models of different precision",
       {},
       of(draw_figure6),
       of(figure6_csv),
       {},
       of(time_strong_shirts)},
      {"fig7",
       "Ideal springs, a threshold and the strong constraint: stretch and unrest",
       {"methods"},
       of(draw_figure7),
       of(figure7_csv)},
  };
}

std::vector<std::string> figure_names() {
  Results none;
  return collect<std::string>(all_figures(none), &Figure::name);
}

// Figure 1: the mass-spring model and its three types of springs on a regular grid and on a patch of a triangle model.
Drawing draw_figure1(const Results& results, LazyOffscreenRenderer&) {
  const CaptionStyle style;
  const float legend_px = 100.0F, gap_px = 60.0F;
  Drawing drawing;
  drawing.width_px = static_cast<int>(2.0F * panel_px + gap_px) + 60;
  drawing.height_px = static_cast<int>(legend_px + panel_px + style.height_px());
  const SpringPatch grid = results.grid_patch, shirt = results.shirt_patch;
  drawing.draw = [=](renderer::Canvas& canvas) {
    const float left_px = 30.0F, right_px = left_px + panel_px + gap_px;
    draw_legend_row(canvas, 0.5F * static_cast<float>(canvas.width_px()), 60.0F);
    draw_patch(canvas, grid, {left_px, legend_px});
    draw_patch(canvas, shirt, {right_px, legend_px});
    draw_caption(canvas, {'a', "regular grid", describe_counts(grid)}, left_px + 0.5F * panel_px, legend_px + panel_px,
                 style);
    draw_caption(canvas, {'b', "patch of the T-shirt: flexural springs by angle", describe_counts(shirt)},
                 right_px + 0.5F * panel_px, legend_px + panel_px, style);
  };
  return drawing;
}

DrawnFigures draw_figures(const FiguresOptions& options, std::vector<Figure> figures, std::vector<Job> experiments) {
  prepare_parent_folder(options.output / "fig.png");
  std::erase_if(figures, [&](const Figure& figure) {
    return !options.selected_names.empty() &&
           std::ranges::find(options.selected_names, figure.name) == options.selected_names.end();
  });
  FigureWriter writer(options);
  if (!options.selected_names.empty()) {
    std::erase_if(experiments, [&](const Job& job) {
      return std::ranges::none_of(figures, [&](const Figure& figure) { return figure.does_need(job.name); });
    });
  }
  simulate_and_draw(figures, experiments, writer);
  for (const Figure& figure : figures) {
    // Times are measured last, because other threads would slow the measured code down.
    if (figure.measure) figure.measure([](double) { throw_if_interrupted(); });
    if (figure.measure || figure.needs.empty()) writer.write(figure);
  }
  return std::move(writer).finish();
}

}  // namespace taut::app
