#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/drawing/drawing.hpp"
#include "app/figures/experiments/recording.hpp"
#include "app/figures/lazy_offscreen_renderer.hpp"
#include "renderer/page/image.hpp"

namespace taut::app {

/// Size of a picture in a figure.
struct PictureSize {
  int width_px = 0;
  int height_px = 0;
};

/// One picture of a figure: a moment of a run, in the look of its scene or coloured by stretch.
struct PrintedMoment {
  const Recording* recording = nullptr;
  const Moment* moment = nullptr;
  bool shows_stretch = false;
  bool has_floor = true;  ///< a floor with the shadow on it
};

/// "largest stretch: springs 0.97 %, surface 19 %", with four digits.
std::string largest_stretch_text(const PrintedMoment& moment);

/// Pictures taken with one camera, and the length of a metre in them.
struct Prints {
  /// In the figure. The images have LazyOffscreenRenderer::scale() times as many pixels each way.
  PictureSize size;
  std::vector<renderer::Image> pictures;
  float metre_px = 0.0F;  ///< pixels of the figure per metre, at the distance of the cloth
};

/// Stretch at the end of the colours in pictures with `shows_stretch`, a fraction. More stretch looks the
/// same.
inline constexpr double printed_stretch = 0.2;
/// Nearly white at rest length and darker with more stretch, so that it also works on a grey printer.
inline constexpr renderer::ColourMap printed_stretch_colours = renderer::ColourMap::blue_orange;

/// Draws the moments with one camera, from the direction of the first moment's scene. The camera is as near
/// as all cloths and their shadows on the floor allow. Throws renderer::ContextError.
Prints print_moments(LazyOffscreenRenderer& offscreen, std::span<const PrintedMoment> moments,
                     const PictureSize& size);
/// As above, with images that have `scale` times as many pixels each way.
Prints print_moments(OffscreenRenderer& offscreen, std::span<const PrintedMoment> moments,
                     const PictureSize& size, float scale);

/// A picture in a figure with the caption below it.
struct Panel {
  renderer::Image picture;
  Caption caption;
};

/// A bar of known length, drawn into a picture.
struct ScaleBar {
  float length_px = 0.0F;  ///< 0: no bar
  std::string label;
};

/// How panels are arranged on a page.
struct SheetStyle {
  std::size_t columns = 3;
  float border_px = 24.0F;
  float gap_px = 28.0F;
  CaptionStyle caption = {};
  float right_px = 0.0F;  ///< kept free at the right edge, for a legend
};

/// Arranges the panels in rows. All pictures must have the size `size`. The scale bar is drawn into the first
/// one.
Drawing sheet_of(std::vector<Panel> panels, const PictureSize& size, const SheetStyle& style,
                 const ScaleBar& bar);

/// Upper left corner of the panel with this index, in pixels of the figure.
glm::vec2 panel_corner(const SheetStyle& style, const PictureSize& picture, std::size_t panel);

}  // namespace taut::app
