#pragma once

#include "app/drawing/garment_painter.hpp"
#include "app/figures/experiments/experiments.hpp"

namespace taut::app {

/// Makes the offscreen renderer when it is first needed. Diagrams and plots do not need it.
class LazyOffscreenRenderer {
 public:
  /// `backend`: see renderer::create_context. `scale` multiplies the width and height of the figures' pictures.
  LazyOffscreenRenderer(std::string backend, float scale) : backend_(std::move(backend)), scale_(scale) {}

  /// Returns the renderer. The first call makes it and may throw renderer::ContextError.
  OffscreenRenderer& open() {
    if (!offscreen_) offscreen_ = std::make_unique<OffscreenRenderer>(backend_);
    return *offscreen_;
  }
  float scale() const { return scale_; }
  /// Returns OpenGL's name of its renderer; empty before the first `open`.
  std::string gl_renderer() const { return offscreen_ ? offscreen_->gl_renderer() : ""; }

 private:
  std::string backend_;
  float scale_;
  std::unique_ptr<OffscreenRenderer> offscreen_;
};

/// A picture of a figure: a moment of a run, in the scene's style or coloured by stretch.
struct PrintedMoment {
  const Recording* recording = nullptr;
  const Moment* moment = nullptr;
  bool shows_stretch = false;
  bool has_floor = true;  ///< draws a floor with the shadow
};

/// Returns "largest stretch: springs 0.97 %, surface 19 %", with four digits.
std::string largest_stretch_text(const PrintedMoment& moment);

/// Pictures taken with one camera, and their scale.
struct Prints {
  /// Width and height in the figure. The images have LazyOffscreenRenderer::scale() times this size.
  glm::ivec2 size_px{0};
  std::vector<renderer::Image> pictures;
  float metre_px = 0.0F;  ///< pixels of the figure per metre, at the distance of the cloth
};

/// Stretch at both ends of the colours in pictures with `shows_stretch`, a fraction. More stretch looks the same.
inline constexpr double max_printed_stretch = 0.2;
/// Nearly white at rest length and darker with more stretch, so that a grey printer shows it too.
inline constexpr renderer::ColourMap printed_stretch_colours = renderer::ColourMap::blue_orange;

/// A picture in a figure, with its caption.
struct Panel {
  renderer::Image picture;
  Caption caption;
};

/// A bar of known length, drawn into a picture.
struct ScaleBar {
  float length_px = 0.0F;  ///< 0: no bar
  std::string label;
};

/// Arrangement of panels on a page.
struct SheetStyle {
  std::size_t columns = 3;
  float border_px = 24.0F;
  float gap_px = 28.0F;
  CaptionStyle caption = {};
  float right_px = 0.0F;  ///< free space at the right edge, for a legend
};

/// Arranges the panels in rows. All pictures must have the size `size`. The scale bar is drawn into the first one.
Drawing make_sheet(std::vector<Panel> panels, const glm::ivec2& size, const SheetStyle& style, const ScaleBar& bar);

/// Names of the columns of figures' tables, separated by commas.
inline constexpr const char* moment_columns =
    "panel,scene,frame,time_s,at_rest,max_stretch,p99_stretch,max_surface_stretch,p99_surface_stretch,mean_stretch";
inline constexpr const char* shape_columns = "panel,vertex,x_m,y_m,z_m";
inline constexpr const char* figure3_columns = "iteration,time_s,moved_m";
inline constexpr const char* figure6_columns = "triangles,substeps,sweeps,repeat,frame_ms";
inline constexpr const char* figure7_columns = "method,time_step_s,time_s,max_stretch,moved_rms_m";

/// Returns a table with one row per moment: its letter (from a), its scene and its measurements.
std::string moments_csv(std::span<const Recording* const> recordings);

/// Returns a table with one row per vertex of each moment: its position in metres.
std::string shapes_csv(std::span<const Recording* const> recordings);

/// Returns `scene` in the fabric of this name or file, which its title then names. Throws UsageError if there is no
/// such fabric.
DrawnScene set_fabric(DrawnScene scene, const std::string& fabric);

/// Draws the last moments of all recordings, with captions.
Drawing sheet_of_last(std::span<const Recording> recordings, std::span<const Caption> captions, const glm::ivec2& size,
                      const SheetStyle& style, bool has_floor, LazyOffscreenRenderer& offscreen);

}  // namespace taut::app
