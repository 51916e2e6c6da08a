#pragma once

#include "app/drawing/garment_painter.hpp"
#include "app/figures/experiments/experiments.hpp"

namespace taut::app {

/// Makes the offscreen renderer when it is first needed. Diagrams and plots do not need it.
class LazyOffscreenRenderer {
 public:
  /// `backend` is as in renderer::create_context. Pictures get `scale` times as many pixels each way as the
  /// figures ask for.
  LazyOffscreenRenderer(std::string backend, float scale) : backend_(std::move(backend)), scale_(scale) {}

  /// The renderer. The first call makes it and may throw renderer::ContextError.
  OffscreenRenderer& open() {
    if (!offscreen_) offscreen_ = std::make_unique<OffscreenRenderer>(backend_);
    return *offscreen_;
  }
  float scale() const { return scale_; }
  /// The name OpenGL gives its renderer. Empty before the first `open`.
  std::string gl_renderer() const { return offscreen_ ? offscreen_->gl_renderer() : ""; }

 private:
  std::string backend_;
  float scale_;
  std::unique_ptr<OffscreenRenderer> offscreen_;
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
  /// Width and height in the figure. The images have LazyOffscreenRenderer::scale() times as many pixels each way.
  glm::ivec2 size_px{0};
  std::vector<renderer::Image> pictures;
  float metre_px = 0.0F;  ///< pixels of the figure per metre, at the distance of the cloth
};

/// Stretch at the end of the colours in pictures with `shows_stretch`, a fraction. More stretch looks the
/// same.
inline constexpr double printed_stretch = 0.2;
/// Nearly white at rest length and darker with more stretch, so that it also works on a grey printer.
inline constexpr renderer::ColourMap printed_stretch_colours = renderer::ColourMap::blue_orange;

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
Drawing sheet_of(std::vector<Panel> panels, const glm::ivec2& size, const SheetStyle& style, const ScaleBar& bar);

/// A table with one row per moment: its letter (from a), the scene and what was measured.
std::string moments_csv(std::span<const Recording* const> recordings);

/// A table with one row per vertex of each moment: its position in metres.
std::string shapes_csv(std::span<const Recording* const> recordings);

/// Returns `scene`, named in its title, made of a fabric of this name or file. Throws UsageError if there is
/// none.
DrawnScene made_of(DrawnScene scene, const std::string& fabric);

/// Pictures of all last moments with the captions below.
Drawing sheet_of_last(std::span<const Recording> recordings, std::span<const Caption> captions, const glm::ivec2& size,
                      const SheetStyle& style, bool has_floor, LazyOffscreenRenderer& offscreen);

}  // namespace taut::app
