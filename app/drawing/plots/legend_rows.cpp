#include "app/drawing/plots/legend_rows.hpp"

#include "app/drawing/drawing.hpp"

namespace taut::app {

LegendRows::LegendRows(const std::string& heading, const std::vector<Curve>& curves, float width_px,
                       const PlotStyle& style)
    : heading_(heading),
      style_(style),
      between_px_(1.5F * style.text_px),
      row_px_(1.7F * style.text_px) {
  const renderer::Canvas ruler(1, 1);
  heading_px_ =
      heading.empty() ? 0.0F : ruler.measure(heading, text_style(style.text_px)).width_px + between_px_;
  for (const Curve& curve : curves) {
    const float entry_px = legend_entry_width(ruler, curve, style) + between_px_;
    if (rows_.empty() || rows_.back().width_px + entry_px - between_px_ > width_px) {
      rows_.push_back({{}, rows_.empty() ? heading_px_ : 0.0F});
    }
    rows_.back().entries.push_back({curve, entry_px});
    rows_.back().width_px += entry_px;
  }
}

void LegendRows::draw(renderer::Canvas& canvas, float top_px) const {
  renderer::TextStyle text = text_style(style_.text_px);
  text.vertical = renderer::VerticalAlign::middle;
  float middle_px = top_px + 0.5F * row_px_;
  for (const Row& row : rows_) {
    float left_px = 0.5F * (static_cast<float>(canvas.width_px()) - row.width_px + between_px_);
    if (&row == &rows_.front()) {
      canvas.text(left_px, middle_px, heading_, text);
      left_px += heading_px_;
    }
    for (const Entry& entry : row.entries) {
      draw_legend_entry(canvas, entry.curve, left_px, middle_px, style_);
      left_px += entry.width_px;
    }
    middle_px += row_px_;
  }
}

}  // namespace taut::app
