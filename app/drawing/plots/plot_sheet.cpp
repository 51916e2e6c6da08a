#include "app/drawing/plots/plot_sheet.hpp"

#include <algorithm>

namespace taut::app {
namespace {

// The middle of a plot's data, to the left of which are its numbers.
constexpr float caption_at = 636.0F / 1160.0F;

}  // namespace

Area plot_area(const PlotSheet& sheet, std::size_t number) {
  const auto column = static_cast<float>(number % sheet.columns);
  const auto row = static_cast<float>(number / sheet.columns);
  return {sheet.left_px + column * (sheet.width_px + sheet.gap_px),
          sheet.top_px + row * (sheet.height_px + sheet.caption.height_px() + sheet.row_gap_px),
          sheet.width_px, sheet.height_px};
}

Drawing draw_plot_sheet(std::vector<PlotPanel> panels, const PlotSheet& sheet) {
  const Area last_column = plot_area(sheet, sheet.columns - 1);
  const std::size_t rows = std::max<std::size_t>(1, (panels.size() + sheet.columns - 1) / sheet.columns);
  const Area below = plot_area(sheet, rows * sheet.columns);
  Drawing drawing;
  drawing.width_px = static_cast<int>(last_column.x_px + last_column.width_px + sheet.right_px);
  drawing.height_px = static_cast<int>(below.y_px + sheet.top_px);
  drawing.draw = [panels = std::move(panels), sheet](renderer::Canvas& canvas) {
    for (std::size_t i = 0; i < panels.size(); ++i) {
      const Area area = plot_area(sheet, i);
      draw_plot(canvas, panels[i].plot, area, sheet.plot);
      draw_caption(canvas, panels[i].caption, area.x_px + caption_at * area.width_px,
                   area.y_px + area.height_px, sheet.caption);
    }
  };
  return drawing;
}

}  // namespace taut::app
