#include "renderer/page/legend.hpp"

#include "renderer/page/ticks.hpp"

namespace taut::renderer {

namespace {

void draw_bar(Canvas& canvas, const Legend& legend, const LegendPlace& place) {
  const int rows = static_cast<int>(std::ceil(place.bar_height_px));
  // Rows need not lie on whole pixels: each goes on below, and the bar to under its frame, so that what is
  // behind shines through no seam.
  constexpr float under_border = 0.5F;
  for (int row = 0; row < rows; ++row) {
    const float y = static_cast<float>(row);
    const float t = 1.0F - (y + 0.5F) / place.bar_height_px;
    const float top = row == 0 ? -under_border : y;
    canvas.fill_rectangle(place.x_px - under_border, place.y_px + top, place.bar_width_px + 2.0F * under_border,
                          place.bar_height_px - top + under_border, colour_at(legend.map, t));
  }
  canvas.rectangle(place.x_px - 0.5F, place.y_px - 0.5F, place.bar_width_px + 1.0F, place.bar_height_px + 1.0F,
                   place.text.colour);
}

// A small triangle on the bar says that larger values exist and take the last colour.
void draw_arrow(Canvas& canvas, const Legend& legend, const LegendPlace& place) {
  const float height = 0.6F * place.bar_width_px;
  for (float y = 0.0F; y < height; y += 1.0F) {
    const float half = 0.5F * place.bar_width_px * (1.0F - (y + 0.5F) / height);
    // Into the row below, which is wider, so that no seam shows between the two.
    const float depth = y > 0.0F ? 2.0F : 1.0F;
    canvas.fill_rectangle(place.x_px + 0.5F * place.bar_width_px - half, place.y_px - 2.0F - y, 2.0F * half, depth,
                          colour_at(legend.map, 1.0F));
  }
}

struct Scale {
  const Legend& legend;
  const LegendPlace& place;
  float y_of(float value) const {
    const float t = (value - legend.minimum) / (legend.maximum - legend.minimum);
    return place.y_px + (1.0F - t) * place.bar_height_px;
  }
};

void draw_ticks(Canvas& canvas, const Legend& legend, const Scale& scale, const TextStyle& text) {
  const LegendPlace& place = scale.place;
  const float right = place.x_px + place.bar_width_px + 1.0F;
  const float low = legend.minimum * legend.factor;
  const float high = legend.maximum * legend.factor;
  const float step = round_step(high - low);
  for (const float shown : multiples_within(low, high, step)) {
    const float value = shown / legend.factor;
    const float y = std::floor(scale.y_of(value)) + 0.5F;
    const bool hidden = legend.bound && std::abs(scale.y_of(*legend.bound) - y) < 1.1F * text.size_px;
    canvas.line(right, y, right + 4.0F, y, text.colour);
    if (!hidden) canvas.text(right + 8.0F, y, tick_text(shown, step) + legend.suffix, text);
  }
}

void draw_bound(Canvas& canvas, const Legend& legend, const Scale& scale, TextStyle text) {
  const LegendPlace& place = scale.place;
  const float y = std::round(scale.y_of(*legend.bound));
  const float right = place.x_px + place.bar_width_px;
  // White under black: visible on every colour of the map.
  canvas.line(place.x_px - 4.0F, y, right + 6.0F, y, Colour{1.0F}, 4.0F);
  canvas.line(place.x_px - 4.0F, y, right + 6.0F, y, text.colour, 2.0F);
  const float range = (legend.maximum - legend.minimum) * legend.factor;
  const float shown = *legend.bound * legend.factor;
  // One digit more than the ticks where the bound falls between them.
  const float step = round_step(range);
  const bool on_tick = std::abs(shown / step - std::round(shown / step)) < 0.01F;
  text.bold = true;
  canvas.text(right + 9.0F, y,
              tick_text(shown, on_tick ? step : 0.1F * step) + legend.suffix + " " + legend.bound_label, text);
}

}  // namespace

void draw_legend(Canvas& canvas, const Legend& legend, const LegendPlace& place) {
  if (!(legend.maximum > legend.minimum)) return;
  const Scale scale{legend, place};
  TextStyle text = place.text;
  text.horizontal = HorizontalAlign::left;
  text.vertical = VerticalAlign::middle;
  draw_bar(canvas, legend, place);
  if (legend.more_above) draw_arrow(canvas, legend, place);
  draw_ticks(canvas, legend, scale, text);
  if (legend.bound && *legend.bound >= legend.minimum && *legend.bound <= legend.maximum) {
    draw_bound(canvas, legend, scale, text);
  }
  TextStyle title = place.text;
  title.horizontal = HorizontalAlign::left;
  title.vertical = VerticalAlign::bottom;
  const float lift = legend.more_above ? 0.6F * place.bar_width_px + 8.0F : 8.0F;
  canvas.text(place.x_px, place.y_px - lift, legend.title, title);
}

}  // namespace taut::renderer
