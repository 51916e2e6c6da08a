#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "app/drawing/plots/axis.hpp"
#include "app/drawing/plots/strokes.hpp"
#include "renderer/page/canvas.hpp"

namespace taut::app {

using DataPoint = std::array<double, 2>;

enum class Marker { none, disc, square, ring };

struct Curve {
  std::string name;  ///< in the legend; empty: not there
  std::vector<DataPoint> points;
  Stroke stroke;  ///< thickness 0: the markers alone
  Marker marker = Marker::none;
  std::vector<DataPoint> bars = {};  ///< smallest and largest y of every point; empty: none
};

/// A horizontal line across the plot, labelled at its end.
struct Level {
  double y = 0.0;
  std::string label;
};

enum class LegendCorner { none, upper_left, upper_right, lower_left, lower_right };

struct Plot {
  Axis x;
  Axis y;
  std::vector<Curve> curves;
  std::vector<Level> levels = {};
  LegendCorner legend = LegendCorner::upper_right;
};

/// A part of a canvas.
struct Area {
  float x_px = 0.0F;
  float y_px = 0.0F;
  float width_px = 0.0F;
  float height_px = 0.0F;
};

struct PlotStyle {
  float text_px = 34.0F;
  float line_px = 2.5F;
  float tick_px = 12.0F;
  float marker_px = 11.0F;  ///< radius
};

/// Draws the plot, its numbers and labels within the area. Curves end at the frame; points that have no place
/// on a logarithmic axis, or are not finite, leave a gap.
void draw_plot(renderer::Canvas& canvas, const Plot& plot, const Area& area, const PlotStyle& style = {});

/// Where the frame lies within the area draw_plot is given.
Area frame_of(const renderer::Canvas& canvas, const Plot& plot, const Area& area,
              const PlotStyle& style = {});

/// The part of the segment within a rectangle, if there is one (Liang and Barsky 1984).
std::optional<std::array<glm::vec2, 2>> clipped(const glm::vec2& a, const glm::vec2& b, const Area& area);

}  // namespace taut::app
