#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "renderer/page/colour.hpp"
#include "renderer/page/image.hpp"

namespace taut::renderer {

enum class HorizontalAlign { left, centre, right };
enum class VerticalAlign { top, middle, baseline, bottom };

/// DejaVu Sans.
struct TextStyle {
  float size_px = 16.0F;  ///< of the em square
  Colour colour{0.1F};
  bool bold = false;
  HorizontalAlign horizontal = HorizontalAlign::left;
  VerticalAlign vertical = VerticalAlign::baseline;
};

/// What a line of text occupies, measured from the font, in pixels.
struct TextSize {
  float width_px = 0.0F;   ///< how far the pen advances
  float ascent_px = 0.0F;  ///< above the baseline
  float descent_px = 0.0F;
};

/// Two-dimensional drawing: text, lines, rectangles and pictures, over an image or into a PDF. The origin is
/// the upper left corner, x to the right, y down, in pixels; whole numbers are pixel edges. Text is UTF-8,
/// one line.
class Canvas {
 public:
  Canvas(int width_px, int height_px, Colour background = Colour{1.0F});
  explicit Canvas(const Image& image);
  /// What is drawn on this canvas is that of a canvas of this width and height, on `scale` times as many
  /// pixels each way, rounded.
  static Canvas scaled(int width_px, int height_px, float scale);
  /// One page; text stays text. Throws std::runtime_error where Cairo cannot make it.
  static Canvas pdf(int width_px, int height_px, float pixels_per_inch = 300.0F);
  ~Canvas();
  Canvas(Canvas&&) noexcept;
  Canvas& operator=(Canvas&&) noexcept;

  int width_px() const;
  int height_px() const;

  TextSize measure(std::string_view text, const TextStyle& style) const;
  void text(float x_px, float y_px, std::string_view text, const TextStyle& style = {});
  void line(float x0_px, float y0_px, float x1_px, float y1_px, Colour colour, float thickness_px = 1.0F);
  void rectangle(float x_px, float y_px, float width_px, float height_px, Colour colour,
                 float thickness_px = 1.0F);
  void fill_rectangle(float x_px, float y_px, float width_px, float height_px, Colour colour,
                      float opacity = 1.0F);
  void circle(float x_px, float y_px, float radius_px, Colour colour, float opacity = 1.0F);
  /// At its own size, its upper left corner at x, y.
  void image(float x_px, float y_px, const Image& image);
  /// Scaled to the given size; pixel by pixel where it has that many of them.
  void image(float x_px, float y_px, float width_px, float height_px, const Image& image);

  /// The pixels so far, as RGB. Not for a PDF (throws std::logic_error).
  Image to_image() const;
  /// The PDF file, after which nothing more can be drawn. Throws std::runtime_error where Cairo could not
  /// make it, and std::logic_error for an image.
  std::vector<std::uint8_t> finish_pdf();

 private:
  struct Surface;
  explicit Canvas(std::unique_ptr<Surface> made);
  std::unique_ptr<Surface> surface;
};

}  // namespace taut::renderer
