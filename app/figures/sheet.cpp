#include "app/figures/sheet.hpp"

#include <algorithm>
#include <cmath>

namespace taut::app {
namespace {

const renderer::Colour ink = renderer::rgb(0x1C1C1C);
const renderer::Colour quiet_ink = renderer::rgb(0x5A5A5A);

renderer::TextStyle text_style(float size_px, const renderer::Colour& colour, bool bold = false) {
  renderer::TextStyle style;
  style.size_px = size_px;
  style.colour = colour;
  style.bold = bold;
  return style;
}

float text_height(const std::vector<Panel>& panels, const SheetStyle& style) {
  const bool has_measured =
      std::any_of(panels.begin(), panels.end(), [](const Panel& panel) { return !panel.measured.empty(); });
  return 1.7F * style.caption_px + (has_measured ? 1.45F * style.measured_px : 0.0F);
}

void write_caption(renderer::Canvas& canvas, const Panel& panel, char letter, float centre_px, float top_px,
                   const SheetStyle& style) {
  const std::string label = std::string("(") + letter + ") ";
  const renderer::TextStyle bold = text_style(style.caption_px, ink, true);
  const renderer::TextStyle plain = text_style(style.caption_px, ink);
  const float label_px = canvas.measure(label, bold).width_px;
  const float left_px = centre_px - 0.5F * (label_px + canvas.measure(panel.caption, plain).width_px);
  const float baseline_px = top_px + 1.3F * style.caption_px;
  canvas.text(left_px, baseline_px, label, bold);
  canvas.text(left_px + label_px, baseline_px, panel.caption, plain);
  renderer::TextStyle grey = text_style(style.measured_px, quiet_ink);
  grey.horizontal = renderer::HorizontalAlign::centre;
  if (!panel.measured.empty()) {
    canvas.text(centre_px, baseline_px + 1.45F * style.measured_px, panel.measured, grey);
  }
}

int whole_px(float length_px) {
  return static_cast<int>(std::lround(length_px));
}

}  // namespace

renderer::Image compose_sheet(const std::vector<Panel>& panels, const SheetStyle& style) {
  const auto columns = static_cast<float>(std::min(style.columns, panels.size()));
  const auto rows = std::ceil(static_cast<float>(panels.size()) / columns);
  const auto panel_width_px = static_cast<float>(panels.front().picture.width_px);
  const auto panel_height_px = static_cast<float>(panels.front().picture.height_px);
  const float row_px = panel_height_px + text_height(panels, style);
  renderer::Canvas canvas(
      whole_px(2.0F * style.border_px + columns * panel_width_px + (columns - 1.0F) * style.gap_px),
      whole_px(2.0F * style.border_px + rows * row_px + (rows - 1.0F) * style.gap_px));
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const auto column = static_cast<float>(i % style.columns);
    const auto row = static_cast<float>(i / style.columns);
    const float x_px = style.border_px + column * (panel_width_px + style.gap_px);
    const float y_px = style.border_px + row * (row_px + style.gap_px);
    canvas.image(x_px, y_px, panels[i].picture);
    write_caption(canvas, panels[i], static_cast<char>('a' + static_cast<int>(i)),
                  x_px + 0.5F * panel_width_px, y_px + panel_height_px, style);
  }
  return canvas.to_image();
}

}  // namespace taut::app
