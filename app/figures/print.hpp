#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/drawing/drawing.hpp"
#include "app/figures/experiments/recording.hpp"
#include "app/figures/lazy_offscreen_renderer.hpp"
#include "renderer/page/image.hpp"

namespace taut::app {

struct PictureSize {
  int width_px = 0;
  int height_px = 0;
};

/// One picture to be printed: a moment of a run in the look of its scene, or with its stretch as colours.
struct PrintedMoment {
  const Recording* recording = nullptr;
  const Moment* moment = nullptr;
  bool shows_stretch = false;
  bool has_floor = true;  ///< and a shadow on it
};

/// Pictures from one camera, and how long a metre is in them at the distance of what they show.
struct Prints {
  PictureSize size;  ///< in the figure; pictures have LazyOffscreenRenderer::scale() times as many pixels
  std::vector<renderer::Image> pictures;
  float metre_px = 0.0F;
};

/// Largest stretch that pictures with `shows_stretch` tell from more, and their colours: nearly white where
/// springs are as long as at rest, darker the longer they are, so that paper and grey printers show it too.
inline constexpr double printed_stretch = 0.2;
inline constexpr renderer::ColourMap printed_stretch_colours = renderer::ColourMap::blue_orange;

/// Draws the moments from the direction of the first one's scene, as large as all of them and their shadows
/// on the floor allow.
Prints print_moments(LazyOffscreenRenderer& offscreen, std::span<const PrintedMoment> moments,
                     const PictureSize& size);

/// A picture in a figure, with its text below.
struct Panel {
  renderer::Image picture;
  Caption caption;
};

struct ScaleBar {
  float length_px = 0.0F;  ///< 0: none
  std::string label;
};

struct SheetStyle {
  std::size_t columns = 3;
  float border_px = 24.0F;
  float gap_px = 28.0F;
  CaptionStyle caption = {};
  float right_px = 0.0F;  ///< kept free on the right, for a legend
};

/// The panels in rows, their pictures of one size. The scale bar goes into the first.
Drawing sheet_of(std::vector<Panel> panels, const PictureSize& size, const SheetStyle& style,
                 const ScaleBar& bar);

/// The upper left corner of a panel.
glm::vec2 panel_corner(const SheetStyle& style, const PictureSize& picture, std::size_t panel);

}  // namespace taut::app
