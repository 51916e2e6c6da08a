#include <algorithm>
#include <cmath>

#include "app/drawing/drawing.hpp"
#include "app/report/report.hpp"

namespace taut::app {
namespace {

int height_in_cell(const renderer::Image& picture, int cell_px) {
  return static_cast<int>(std::lround(static_cast<double>(picture.height_px) * cell_px / picture.width_px));
}

}  // namespace

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
    const auto shortest = std::min_element(bottoms_px.begin(), bottoms_px.end());
    const int column = static_cast<int>(shortest - bottoms_px.begin());
    corners.emplace_back(gap_px + column * (cell_px + gap_px), *shortest);
    *shortest += title_height_px + height_in_cell(figure.picture, cell_px) + gap_px;
  }
  renderer::Canvas canvas = renderer::Canvas::scaled(
      gap_px + columns * (cell_px + gap_px), *std::max_element(bottoms_px.begin(), bottoms_px.end()), scale);
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const auto x_px = static_cast<float>(corners[i].first), y_px = static_cast<float>(corners[i].second);
    canvas.text(x_px, y_px + title_px, figures[i].name, text_style(title_px, palette::ink, true));
    canvas.image(x_px, y_px + static_cast<float>(title_height_px), static_cast<float>(cell_px),
                 static_cast<float>(height_in_cell(figures[i].picture, cell_px)), figures[i].picture);
  }
  return canvas.to_image();
}

}  // namespace taut::app
