#include <fmt/core.h>

#include "app/figures/figures.hpp"
#include "app/figures/print.hpp"
#include "renderer/legend.hpp"

namespace taut::app {
namespace {

constexpr PictureSize picture_size = {1180, 1120};

Caption caption_of(const PrintedMoment& moment, char letter) {
  if (moment.shows_stretch) {
    return {
        letter, "the same, coloured by its stretch",
        fmt::format("mean {:.1f} %, 99 of 100 springs below {:.1f} %",
                    100.0 * moment.moment->record.stretch.mean, 100.0 * moment.moment->record.stretch.p99)};
  }
  return {letter, fmt::format("stretched by up to {:.1f} %", 100.0 * moment.moment->record.stretch.max),
          fmt::format("{} sweeps of the constraint in a step; red: at rest length",
                      moment.recording->scene.simulation.solver.iterations)};
}

void draw_stretch_legend(renderer::Canvas& canvas, const SheetStyle& style) {
  const renderer::Legend legend{.title = "",
                                .minimum = 0.0F,
                                .maximum = static_cast<float>(printed_stretch),
                                .factor = 100.0F,
                                .suffix = " %",
                                .bound = 0.05F,
                                .bound_label = ""};
  const glm::vec2 corner = panel_corner(style, picture_size, 3);
  renderer::LegendPlace place;
  place.x_px = corner.x + static_cast<float>(picture_size.width_px) + 34.0F;
  place.y_px = corner.y + 0.12F * static_cast<float>(picture_size.height_px);
  place.bar_width_px = 44.0F;
  place.bar_height_px = 0.76F * static_cast<float>(picture_size.height_px);
  place.text = text_style(style.caption.measured_px);
  renderer::draw_legend(canvas, legend, place);
  // Clear of the number at the top of the bar.
  canvas.text(place.x_px, place.y_px - 1.2F * place.text.size_px, "stretch", place.text);
}

}  // namespace

// Over-stretching: the same cloth, held by its upper corners, with two limits of stretch; below, where.
Drawing draw_figure4(const Results& results, StudioDoor& studio) {
  std::vector<PrintedMoment> moments;
  for (const bool shows_stretch : {false, true}) {
    for (const auto& recording : results.pinned) {
      moments.push_back({&*recording, &recording->last(), shows_stretch, false});
    }
  }
  Prints prints = print_moments(studio.open(), moments, picture_size);
  std::vector<Panel> panels;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    panels.push_back({std::move(prints.pictures[i]),
                      caption_of(moments[i], static_cast<char>('a' + static_cast<int>(i)))});
  }
  const SheetStyle style = {.columns = 2, .right_px = 190.0F};
  Drawing drawing = sheet_of(std::move(panels), style, {0.25F * prints.metre_px, "25 cm"});
  drawing.draw = [panels_drawing = drawing.draw, style](renderer::Canvas& canvas) {
    panels_drawing(canvas);
    draw_stretch_legend(canvas, style);
  };
  return drawing;
}

}  // namespace taut::app
