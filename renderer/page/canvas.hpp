#pragma once

#include "renderer/page/colour.hpp"
#include "renderer/page/png.hpp"

namespace taut::renderer {

/// Returns value truncated and clamped to lowest..highest; NaN gives lowest. Casting a float that no int can hold is
/// undefined, and positions may be anywhere.
inline int whole_within(float value, int lowest, int highest) {
  if (!(value > static_cast<float>(lowest))) return lowest;
  return value < static_cast<float>(highest) ? static_cast<int>(value) : highest;
}

// Round numbers along a scale, in the scale's own precision, float or double: the last bit of a number can decide the
// pixel of its tick.

/// Returns the tick step for a range above 0: 1, 2 or 5 times a power of ten, with about six ticks.
template <class Number> Number round_step(Number range) {
  const Number rough = range / Number(6.0);
  const Number power = std::pow(Number(10.0), std::floor(std::log10(rough)));
  for (const Number factor : {Number(1.0), Number(2.0), Number(5.0)}) {
    if (factor * power >= rough * Number(0.999)) return factor * power;
  }
  return Number(10.0) * power;
}

/// Returns the multiples of `step` from minimum to maximum, ascending.
template <class Number> std::vector<Number> multiples_within(Number minimum, Number maximum, Number step) {
  const Number slack = Number(0.001);
  std::vector<Number> values;
  for (Number i = std::ceil(minimum / step - slack); i * step <= maximum + slack * step; i += Number(1.0)) {
    values.push_back(i * step);
  }
  return values;
}

/// Returns the text of a multiple of `step`, with as many decimals as the step has, at most 40.
template <class Number> std::string tick_text(Number value, Number step) {
  const int decimals = whole_within(static_cast<float>(std::ceil(-std::log10(step) - Number(0.001))), 0, 40);
  char text[384];
  // Adding zero turns a minus zero into zero.
  std::snprintf(text, sizeof text, "%.*f", decimals, static_cast<double>(value) + 0.0);
  return text;
}

/// Part of a text that lies at its x or y.
enum class HorizontalAlign { left, centre, right };
enum class VerticalAlign { top, middle, baseline, bottom };

/// Style of a text in DejaVu Sans.
struct TextStyle {
  float size_px = 16.0F;  ///< height of the em square, pixels
  Colour colour{0.1F};
  bool bold = false;
  HorizontalAlign horizontal = HorizontalAlign::left;
  VerticalAlign vertical = VerticalAlign::baseline;

  /// Returns the style with another alignment.
  TextStyle with_alignment(HorizontalAlign across, VerticalAlign down = VerticalAlign::baseline) const {
    return {size_px, colour, bold, across, down};
  }
};

/// Size of a line of text by its font, in pixels.
struct TextSize {
  float width_px = 0.0F;    ///< advance width
  float ascent_px = 0.0F;   ///< above the baseline
  float descent_px = 0.0F;  ///< below the baseline, positive
};

/// Two-dimensional canvas for text, lines, rectangles and images, over an image or into a PDF. Coordinates are pixels
/// from the upper left corner, x to the right, y down; whole numbers are pixel edges. Text is one line of UTF-8.
/// Opacity is 0 to 1.
class Canvas {
 public:
  /// Makes a white canvas. `scale` is the number of image pixels per coordinate; the image size is rounded. Throws
  /// std::runtime_error if Cairo cannot make it.
  Canvas(int width_px, int height_px, float scale = 1.0F);
  /// Makes a canvas with a copy of the image, including its alpha channel if any.
  explicit Canvas(const Image& image);
  /// Returns a canvas for a one-page PDF with this title; text stays text. Throws std::runtime_error if Cairo cannot
  /// make it.
  static Canvas pdf(int width_px, int height_px, float pixels_per_inch, const std::string& title);
  ~Canvas();

  /// Return the size in coordinates, before the scale.
  int width_px() const;
  int height_px() const;

  /// Returns the size of the smallest text so far; infinite before the first.
  float min_text_px() const;

  /// Returns the size of a text in this style.
  TextSize measure(std::string_view text, const TextStyle& style) const;
  /// Draws a text with its aligned point at (x_px, y_px).
  void text(float x_px, float y_px, std::string_view text, const TextStyle& style = {});
  /// Draws a line between two points; its middle runs through them.
  void line(float x0_px, float y0_px, float x1_px, float y1_px, Colour colour, float thickness_px = 1.0F);
  /// Draws a line through the points in order. `dashes_px`: lengths of alternating dashes and gaps, which continue
  /// around corners; empty: a solid line.
  void polyline(std::span<const glm::vec2> points, Colour colour, float thickness_px,
                std::span<const double> dashes_px = {});
  /// Draws what `draw` draws on this canvas within the rectangle with this upper left corner.
  void within(float x_px, float y_px, float width_px, float height_px, const std::function<void()>& draw);
  /// Draws the outline of a rectangle with this upper left corner, the line's middle on its border.
  void rectangle(float x_px, float y_px, float width_px, float height_px, Colour colour, float thickness_px = 1.0F);
  /// Fills a rectangle with this upper left corner.
  void fill_rectangle(float x_px, float y_px, float width_px, float height_px, Colour colour, float opacity = 1.0F);
  /// Fills a circle around (x_px, y_px).
  void circle(float x_px, float y_px, float radius_px, Colour colour, float opacity = 1.0F);
  /// Draws an image at its own size, its upper left corner at (x_px, y_px).
  void image(float x_px, float y_px, const Image& image);
  /// Draws an image scaled to width_px by height_px. It is copied without filtering where the sizes agree.
  void image(float x_px, float y_px, float width_px, float height_px, const Image& image);

  /// Returns the picture as RGB. Throws std::logic_error for a PDF.
  Image to_image() const;
  /// Returns the PDF file; nothing more can be drawn. Throws std::runtime_error if Cairo could not make it, and
  /// std::logic_error for an image.
  std::vector<std::uint8_t> finish_pdf();

 private:
  struct Surface;
  explicit Canvas(std::unique_ptr<Surface> canvas_surface);
  std::unique_ptr<Surface> surface_;
};

/// Content of the colour bar of a ScalarColours.
struct Legend {
  std::string title;     ///< e.g. "stretch"
  float minimum = 0.0F;  ///< value at the lower end of the bar
  float maximum = 1.0F;  ///< value at the upper end; above minimum
  ColourMap map = ColourMap::viridis;
  float factor = 1.0F;         ///< factor on printed values, e.g. 100 with suffix " %" for fractions
  std::string suffix;          ///< text behind every value
  std::optional<float> bound;  ///< value to mark on the bar, in the unit of minimum and maximum
  bool more_above = false;     ///< draws an arrow head: some values are above maximum
};

/// Position and size of a legend, in pixels of the canvas.
struct LegendPlace {
  float x_px = 24.0F;  ///< upper left corner of the bar; the title is above, the values are to the right
  float y_px = 48.0F;
  float bar_width_px = 16.0F;
  float bar_height_px = 240.0F;
  TextStyle text;  ///< style of title and values
};

/// Draws a vertical colour bar with ticks at round values.
void draw_legend(Canvas& canvas, const Legend& legend, const LegendPlace& place = {});

}  // namespace taut::renderer
