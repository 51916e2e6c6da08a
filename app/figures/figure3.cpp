#include <fmt/core.h>

#include <algorithm>

#include "app/drawing/drawn_scene.hpp"
#include "app/drawing/plots/plot.hpp"
#include "app/figures/csv.hpp"
#include "app/figures/experiments/moments.hpp"
#include "app/figures/figures.hpp"
#include "app/models/garment_loading.hpp"

namespace taut::app {
namespace {

const std::vector<std::string> columns = {"iteration", "time_s", "moved_m"};

Plot convergence_plot(const StepRecording& fall) {
  Curve curve;
  curve.stroke = {palette::blue, 4.0F, {}};
  for (std::size_t i = 0; i < fall.moved_m.size(); ++i) {
    curve.points.push_back({static_cast<double>(i + 1), fall.moved_m[i]});
  }
  Plot plot;
  plot.x = {"iteration (time step)", 0.0, static_cast<double>(fall.moved_m.size())};
  plot.y = decades_around("|p(t) − p(t − Δt)|  in metres", fall.moved_m);
  plot.curves = {std::move(curve)};
  plot.legend = LegendCorner::none;
  return plot;
}

// The same on a linear axis, as the paper has it.
Plot linear_inset(const Plot& plot, const StepRecording& fall) {
  Plot inset = plot;
  const double largest_mm = 1e3 * *std::max_element(fall.moved_m.begin(), fall.moved_m.end());
  inset.x.label = "iteration";
  inset.x.chosen = {0.0, 5000.0, 10000.0, 15000.0};
  std::erase_if(inset.x.chosen, [&](double value) { return value > inset.x.maximum; });
  inset.y = {"the same in mm, linear", 0.0, 1.05 * largest_mm};
  for (DataPoint& point : inset.curves.front().points) {
    point[1] *= 1e3;
  }
  inset.curves.front().stroke.thickness_px = 2.5F;
  return inset;
}

// The cloth as it was modelled, seen from above, and the point that is followed.
void draw_followed_point(renderer::Canvas& canvas, const StepRecording& fall, const Area& area) {
  constexpr int cells = 8;
  const sim::GridSettings& grid = fall.frames.scene.garment.grid;
  const float side_px = area.width_px;
  for (int i = 0; i <= cells; ++i) {
    const float at_px = side_px * static_cast<float>(i) / cells;
    canvas.line(area.x_px + at_px, area.y_px, area.x_px + at_px, area.y_px + side_px, palette::quiet_ink,
                2.0F);
    canvas.line(area.x_px, area.y_px + at_px, area.x_px + side_px, area.y_px + at_px, palette::quiet_ink,
                2.0F);
  }
  const auto place = [&](sim::Index vertex) {
    return glm::vec2(
        area.x_px +
            side_px * static_cast<float>(vertex % grid.columns) / static_cast<float>(grid.columns - 1),
        area.y_px + side_px * static_cast<float>(vertex / grid.columns) / static_cast<float>(grid.rows - 1));
  };
  for (const sim::Index pin : fall.frames.pins) {
    canvas.fill_rectangle(place(pin).x - 12.0F, place(pin).y - 12.0F, 24.0F, 24.0F, palette::ink);
  }
  const glm::vec2 followed = place(fall.vertex);
  canvas.circle(followed.x, followed.y, 20.0F, renderer::Colour{1.0F});
  canvas.circle(followed.x, followed.y, 16.0F, palette::blue);
  renderer::TextStyle text = text_style(34.0F, palette::quiet_ink);
  text.horizontal = renderer::HorizontalAlign::centre;
  const float centre_px = area.x_px + 0.5F * side_px;
  canvas.text(centre_px, area.y_px - 32.0F, "held corners: squares", text);
  canvas.text(centre_px, area.y_px + side_px + 62.0F, "followed point", text);
}

std::string rest_text(const StepRecording& fall) {
  const auto steps = static_cast<double>(fall.moved_m.size());
  return fmt::format("steps of 1/{:.0f} s; {} after {:.0f} of them, or {:.1f} s", 1.0 / fall.time_step_s,
                     fall.came_to_rest
                         ? fmt::format("at rest (within {:g} mm for {:g} s)", 1e3 * fall_rest_m, fall_rest_s)
                         : "not yet at rest",
                     steps, steps * fall.time_step_s);
}

}  // namespace

std::string figure3_csv(const Results& results) {
  const StepRecording& fall = *results.fall;
  CsvTable table(columns);
  for (std::size_t i = 0; i < fall.moved_m.size(); ++i) {
    table.add(
        {std::to_string(i + 1), cell(static_cast<double>(i + 1) * fall.time_step_s), cell(fall.moved_m[i])});
  }
  return table.text();
}

void read_figure3(const std::filesystem::path& folder, Results& results) {
  const CsvFile table(folder / "fig3.csv", columns);
  results.fall = results.fall ? std::move(results.fall) : StepRecording{};
  StepRecording& fall = *results.fall;
  fall.frames.scene = find_scene(fall_scene, {});
  LoadedGarment loaded = load_garment(fall.frames.scene);
  fall.frames.garment = loaded.garment;
  fall.frames.pins = std::move(loaded.pins);
  fall.vertex = followed_vertex(fall.frames.scene);
  fall.time_step_s = table.number(0, 1);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    fall.moved_m.push_back(table.number(row, 2));
  }
  // A run that is not over at its last frame ends where the cloth is at rest.
  const auto most_steps = static_cast<std::size_t>(
      fall_frames.back() * sim::equal_substeps(solver_settings(fall.frames.scene.simulation.solver)));
  fall.came_to_rest = table.rows() < most_steps;
}

// Iterative convergence of a single mass point of the cloth of figure 2.
Drawing draw_figure3(const Results& results, LazyOffscreenRenderer&) {
  const StepRecording fall = *results.fall;
  const CaptionStyle style;
  const Plot plot = convergence_plot(fall);
  const Plot inset = linear_inset(plot, fall);
  Drawing drawing{2400, 1240 + static_cast<int>(style.height_px()), {}};
  drawing.draw = [=](renderer::Canvas& canvas) {
    draw_plot(canvas, plot, {20.0F, 10.0F, 1640.0F, 1230.0F});
    draw_plot(canvas, inset, {1740.0F, 10.0F, 640.0F, 620.0F}, {.line_px = 2.0F});
    draw_followed_point(canvas, fall, {1920.0F, 760.0F, 340.0F, 340.0F});
    draw_caption(canvas, {'\0', "convergence of one mass point of the cloth of figure 2", rest_text(fall)},
                 1200.0F, 1240.0F, style);
  };
  return drawing;
}

}  // namespace taut::app
