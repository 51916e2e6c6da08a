#include "app/drawing/plots/plot.hpp"

#include "app/base/words.hpp"

namespace taut::app {
namespace {

void append_column(std::vector<glm::vec2> column, std::vector<glm::vec2>& result) {
  if (column.size() <= 4) {
    result.insert(result.end(), column.begin(), column.end());
    return;
  }
  const auto [low, high] = std::ranges::minmax_element(column, [](auto& p, auto& q) { return p.y < q.y; });
  result.push_back(column.front());
  result.push_back(*std::min(low, high));
  result.push_back(*std::max(low, high));
  result.push_back(column.back());
}

// Number of decades above which only some ticks get labels, so that labels do not overlap.
constexpr double max_labelled_decades = 8.0;

std::vector<Tick> linear_ticks(const Axis& axis) {
  const double step = renderer::round_step(axis.maximum - axis.minimum);
  return collect<Tick>(renderer::multiples_within(axis.minimum, axis.maximum, step), [&](double value) {
    return Tick{value, renderer::tick_text(value, step) + axis.suffix};
  });
}

std::vector<Tick> logarithmic_ticks(const Axis& axis) {
  const double decades = std::log10(axis.maximum / axis.minimum);
  const int every = static_cast<int>(std::ceil(decades / max_labelled_decades));
  // Large ranges use powers of ten, whose digits need not be counted.
  const bool in_full = axis.minimum >= 0.0099 && axis.maximum <= 10001.0;
  std::vector<Tick> ticks;
  for (int exponent = static_cast<int>(std::floor(std::log10(axis.minimum) + 1e-9));
       std::pow(10.0, exponent) <= axis.maximum * (1.0 + 1e-9); ++exponent) {
    for (int multiple = 1; multiple <= 9; ++multiple) {
      const double value = multiple * std::pow(10.0, exponent);
      if (value < axis.minimum * (1.0 - 1e-9) || value > axis.maximum * (1.0 + 1e-9)) continue;
      const bool is_labelled =
          decades < 2.0 ? multiple == 1 || multiple == 2 || multiple == 5 : multiple == 1 && exponent % every == 0;
      std::string label;
      if (is_labelled) {
        label = (in_full || decades < 2.0 ? fmt::format("{:g}", value) : power_of_ten(exponent)) + axis.suffix;
      }
      ticks.push_back({value, std::move(label)});
    }
  }
  return ticks;
}

using renderer::Canvas;
using renderer::HorizontalAlign;
using renderer::VerticalAlign;

struct PlotAxes {
  const Plot& plot;
  Area area;

  float x_of(double value) const { return area.x_px + area.width_px * static_cast<float>(position_on(plot.x, value)); }
  float y_of(double value) const {
    return area.y_px + area.height_px * (1.0F - static_cast<float>(position_on(plot.y, value)));
  }
  bool has_place(const DataPoint& point) const {
    return std::isfinite(x_of(point[0])) && std::isfinite(y_of(point[1]));
  }
};

float max_label_width_px(const Canvas& canvas, const Axis& axis, const PlotStyle& style) {
  float max_width_px = 0.0F;
  for (const Tick& tick : make_ticks(axis)) {
    max_width_px = std::max(max_width_px, canvas.measure(tick.label, text_style(style.text_px)).width_px);
  }
  return max_width_px;
}

/// Draws the ticks of the axis below the data, or of the one to its left, with their labels and lines across the data.
void draw_ticks(Canvas& canvas, const PlotAxes& axes, const PlotStyle& style, bool is_below) {
  const renderer::TextStyle text = text_style(style.text_px)
                                       .with_alignment(is_below ? HorizontalAlign::centre : HorizontalAlign::right,
                                                       is_below ? VerticalAlign::top : VerticalAlign::middle);
  const auto [left_px, top_px, width_px, height_px] = axes.area;
  const glm::vec2 outwards = is_below ? glm::vec2(0.0F, 1.0F) : glm::vec2(-1.0F, 0.0F);
  const float gap_px = style.tick_px + (is_below ? 0.15F : 0.3F) * style.text_px;
  for (const Tick& tick : make_ticks(is_below ? axes.plot.x : axes.plot.y)) {
    const glm::vec2 at =
        is_below ? glm::vec2(axes.x_of(tick.value), top_px + height_px) : glm::vec2(left_px, axes.y_of(tick.value));
    const glm::vec2 across = is_below ? glm::vec2(at.x, top_px) : glm::vec2(left_px + width_px, at.y);
    const float length_px = tick.label.empty() ? 0.5F * style.tick_px : style.tick_px;
    if (!tick.label.empty()) canvas.line(at.x, at.y, across.x, across.y, palette::hairline, 0.6F * style.line_px);
    const glm::vec2 end = at + length_px * outwards, text_at = at + gap_px * outwards;
    canvas.line(at.x, at.y, end.x, end.y, palette::ink, style.line_px);
    canvas.text(text_at.x, text_at.y, tick.label, text);
  }
}

void draw_line(Canvas& canvas, const Curve& curve, const PlotAxes& axes) {
  std::vector<glm::vec2> run;
  const auto draw_run = [&] {
    draw_polyline(canvas, thin_out(run), curve.stroke);
    run.clear();
  };
  for (const DataPoint& point : curve.points) {
    if (axes.has_place(point)) {
      run.emplace_back(axes.x_of(point[0]), axes.y_of(point[1]));
    } else {
      draw_run();
    }
  }
  draw_run();
}

void draw_marker(Canvas& canvas, float x_px, float y_px, const Curve& curve, float radius_px) {
  const renderer::Colour& colour = curve.stroke.colour;
  const bool is_ring = curve.marker == Marker::ring;
  if (is_ring || curve.marker == Marker::disc) canvas.circle(x_px, y_px, radius_px, colour);
  if (is_ring) canvas.circle(x_px, y_px, 0.55F * radius_px, renderer::Colour{1.0F});
  if (curve.marker == Marker::square) {
    canvas.fill_rectangle(x_px - 0.9F * radius_px, y_px - 0.9F * radius_px, 1.8F * radius_px, 1.8F * radius_px, colour);
  }
  if (curve.marker == Marker::cross) {
    for (const float rise_px : {radius_px, -radius_px}) {
      canvas.line(x_px - radius_px, y_px + rise_px, x_px + radius_px, y_px - rise_px, colour, 0.5F * radius_px);
    }
  }
}

void draw_points(Canvas& canvas, const Curve& curve, const PlotAxes& axes, const PlotStyle& style) {
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    if (!axes.has_place(curve.points[i])) continue;
    const float x_px = axes.x_of(curve.points[i][0]);
    if (i < curve.bars.size()) {
      const float low_px = axes.y_of(curve.bars[i][0]), high_px = axes.y_of(curve.bars[i][1]);
      canvas.line(x_px, low_px, x_px, high_px, curve.stroke.colour, 1.2F * style.line_px);
      for (const float end_px : {low_px, high_px}) {
        canvas.line(x_px - style.marker_px, end_px, x_px + style.marker_px, end_px, curve.stroke.colour,
                    1.2F * style.line_px);
      }
    }
    draw_marker(canvas, x_px, axes.y_of(curve.points[i][1]), curve, style.marker_px);
  }
}

void draw_levels(Canvas& canvas, const PlotAxes& axes, const PlotStyle& style) {
  const renderer::TextStyle text =
      text_style(0.9F * style.text_px, palette::quiet_ink).with_alignment(HorizontalAlign::right);
  for (const LegendLevel& level : axes.plot.levels) {
    const float y_px = axes.y_of(level.y);
    const float right_px = axes.area.x_px + axes.area.width_px;
    draw_polyline(canvas, std::vector<glm::vec2>{{axes.area.x_px, y_px}, {right_px, y_px}},
                  {palette::quiet_ink, 1.2F * style.line_px, {2.0F, 4.0F}});
    canvas.text(right_px - 0.5F * style.text_px, y_px - 0.35F * style.text_px, level.label, text);
  }
}

void draw_legend_lines(Canvas& canvas, const PlotAxes& axes, const PlotStyle& style) {
  const renderer::TextStyle text = text_style(style.text_px);
  const float sample_px = 2.6F * style.text_px, row_px = 1.5F * style.text_px;
  float width_px = 0.0F, rows = 0.0F;
  for (const Curve& curve : axes.plot.curves) {
    width_px = std::max(width_px, canvas.measure(curve.name, text).width_px);
    rows += curve.name.empty() ? 0.0F : 1.0F;
  }
  width_px += sample_px + 1.3F * style.text_px;
  const float height_px = rows * row_px + 0.5F * style.text_px;
  const LegendCorner corner = axes.plot.legend;
  const bool is_right = corner == LegendCorner::upper_right || corner == LegendCorner::lower_right;
  const bool is_lower = corner == LegendCorner::lower_left || corner == LegendCorner::lower_right;
  const float inset_px = 0.5F * style.text_px;
  const Area& area = axes.area;
  const float x_px = is_right ? area.x_px + area.width_px - width_px - inset_px : area.x_px + inset_px;
  float y_px = is_lower ? area.y_px + area.height_px - height_px - inset_px : area.y_px + inset_px;
  canvas.fill_rectangle(x_px, y_px, width_px, height_px, renderer::Colour{1.0F}, 0.88F);
  y_px += 0.25F * style.text_px;
  for (const Curve& curve : axes.plot.curves) {
    if (curve.name.empty()) continue;
    draw_legend_entry(canvas, curve, x_px + 0.4F * style.text_px, y_px + 0.5F * row_px, style);
    y_px += row_px;
  }
}

// Middle of a plot's data area, as a fraction of the plot's width; the numbers are to its left.
constexpr float caption_centre_fraction = 636.0F / 1160.0F;

}  // namespace

void draw_polyline(renderer::Canvas& canvas, std::span<const glm::vec2> points, const Stroke& stroke) {
  if (!(stroke.thickness_px > 0.0F)) return;  // Cairo takes no dashes without length
  const auto to_px = [&](float dash) { return double{dash * stroke.thickness_px}; };
  canvas.polyline(points, stroke.colour, stroke.thickness_px, collect<double>(stroke.dashes, to_px));
}

std::vector<glm::vec2> bow(const glm::vec2& a, const glm::vec2& b, float sideways) {
  constexpr int pieces = 16;
  const glm::vec2 along = b - a;
  const glm::vec2 across(-along.y, along.x);
  std::vector<glm::vec2> points;
  for (int i = 0; i <= pieces; ++i) {
    const float t = static_cast<float>(i) / pieces;
    points.push_back(a + t * along + 4.0F * t * (1.0F - t) * sideways * across);
  }
  return points;
}

std::vector<glm::vec2> thin_out(std::span<const glm::vec2> points) {
  std::vector<glm::vec2> result;
  std::vector<glm::vec2> column;
  for (const glm::vec2& point : points) {
    if (!column.empty() && std::floor(point.x) != std::floor(column.front().x)) {
      append_column(std::move(column), result);
      column.clear();
    }
    column.push_back(point);
  }
  append_column(std::move(column), result);
  return result;
}

std::vector<Tick> make_ticks(const Axis& axis) {
  if (!axis.chosen.empty()) {
    return collect<Tick>(axis.chosen, [&](double value) {
      return Tick{value, fmt::format("{:g}", value) + axis.suffix};
    });
  }
  return axis.logarithmic ? logarithmic_ticks(axis) : linear_ticks(axis);
}

double position_on(const Axis& axis, double value) {
  if (axis.logarithmic) return std::log(value / axis.minimum) / std::log(axis.maximum / axis.minimum);
  return (value - axis.minimum) / (axis.maximum - axis.minimum);
}

Axis decades_around(std::string label, const std::vector<double>& values) {
  double low = INFINITY, high = 0.0;
  for (const double value : values) {
    if (value > 0.0) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  if (high <= 0.0) low = high = 1.0;
  Axis axis{std::move(label), std::pow(10.0, std::floor(std::log10(low))), std::pow(10.0, std::ceil(std::log10(high))),
            true};
  if (!(axis.maximum > axis.minimum)) axis.maximum = 10.0 * axis.minimum;
  return axis;
}

std::string power_of_ten(int exponent) {
  constexpr const char* raised[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string label = exponent < 0 ? "10⁻" : "10";
  for (const char digit : std::to_string(std::abs(exponent))) label += raised[digit - '0'];
  return label;
}

std::string scientific(double value) {
  if (!(std::abs(value) > 0.0) || !std::isfinite(value)) return fmt::format("{}", value);
  if (std::abs(value) >= 0.1 && std::abs(value) < 1000.0) return fmt::format("{:.2g}", value);
  const std::string digits = fmt::format("{:.1e}", value);
  const std::size_t e = digits.find('e');
  return digits.substr(0, e) + " × " + power_of_ten(std::stoi(digits.substr(e + 1)));
}

void draw_legend_entry(Canvas& canvas, const Curve& curve, float left_px, float middle_px, const PlotStyle& style) {
  // A marker without a line takes only its own width.
  const float sample_px = curve.stroke.thickness_px > 0.0F ? 2.6F * style.text_px : 2.0F * style.marker_px;
  if (curve.stroke.thickness_px > 0.0F) {
    draw_polyline(canvas, std::vector<glm::vec2>{{left_px, middle_px}, {left_px + sample_px, middle_px}}, curve.stroke);
  }
  draw_marker(canvas, left_px + 0.5F * sample_px, middle_px, curve, style.marker_px);
  const renderer::TextStyle name =
      text_style(style.text_px).with_alignment(HorizontalAlign::left, VerticalAlign::middle);
  canvas.text(left_px + sample_px + 0.5F * style.text_px, middle_px, curve.name, name);
}

Area compute_data_area(const Canvas& canvas, const Plot& plot, const Area& area, const PlotStyle& style) {
  // The first and the last label of the x axis are centred under their ticks, so half of each stands out.
  const float half_px = 0.5F * max_label_width_px(canvas, plot.x, style);
  const float left_px =
      std::max(max_label_width_px(canvas, plot.y, style) + style.tick_px + 0.5F * style.text_px, half_px);
  const float right_px = half_px + style.line_px;
  const float top_px = 1.9F * style.text_px;
  const float bottom_px = style.tick_px + 2.9F * style.text_px;
  return {area.x_px + left_px, area.y_px + top_px, area.width_px - left_px - right_px,
          area.height_px - top_px - bottom_px};
}

void draw_plot(Canvas& canvas, const Plot& plot, const Area& area, const PlotStyle& style) {
  const PlotAxes axes{plot, compute_data_area(canvas, plot, area, style)};
  draw_ticks(canvas, axes, style, true);
  draw_ticks(canvas, axes, style, false);
  canvas.text(axes.area.x_px + 0.5F * axes.area.width_px,
              axes.area.y_px + axes.area.height_px + style.tick_px + 1.5F * style.text_px, plot.x.label,
              text_style(style.text_px).with_alignment(HorizontalAlign::centre, VerticalAlign::top));
  // The label is horizontal above the axis, to be read without turning the head.
  canvas.text(area.x_px, axes.area.y_px - 0.75F * style.text_px, plot.y.label, text_style(style.text_px));
  draw_levels(canvas, axes, style);
  for (const Curve& curve : plot.curves) {
    const float thickness_px = curve.stroke.thickness_px;
    // A line along the edge of the area is drawn in its full thickness.
    canvas.within(axes.area.x_px - 0.5F * thickness_px, axes.area.y_px - 0.5F * thickness_px,
                  axes.area.width_px + thickness_px, axes.area.height_px + thickness_px,
                  [&] { draw_line(canvas, curve, axes); });
    draw_points(canvas, curve, axes, style);
  }
  canvas.rectangle(axes.area.x_px, axes.area.y_px, axes.area.width_px, axes.area.height_px, palette::ink,
                   style.line_px);
  if (plot.legend != LegendCorner::none) draw_legend_lines(canvas, axes, style);
}

Area plot_area(const PlotSheet& sheet, std::size_t number) {
  const auto column = static_cast<float>(number % sheet.columns);
  const auto row = static_cast<float>(number / sheet.columns);
  return {sheet.left_px + column * (sheet.width_px + sheet.gap_px),
          sheet.top_px + row * (sheet.height_px + sheet.caption.height_px() + sheet.row_gap_px), sheet.width_px,
          sheet.height_px};
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
      draw_caption(canvas, panels[i].caption, area.x_px + caption_centre_fraction * area.width_px,
                   area.y_px + area.height_px, sheet.caption);
    }
  };
  return drawing;
}

}  // namespace taut::app
