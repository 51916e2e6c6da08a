#pragma once

#include "app/drawing/drawn_scene.hpp"
#include "app/models/garment_loading.hpp"
#include "renderer/page/canvas.hpp"
#include "renderer/scene_renderer.hpp"

namespace taut::app {

/// A drawing made of lines, text and pictures. `draw` can be called for any kind of canvas, any number of
/// times.
struct Drawing {
  int width_px = 0;
  int height_px = 0;
  std::function<void(renderer::Canvas&)> draw;
};

/// Draws with `scale` times as many pixels each way as the drawing has by itself.
renderer::Image to_image(const Drawing& drawing, float scale = 1.0F);

/// Width of a PDF page: two columns of a paper.
inline constexpr float page_width_inches = 7.0F;

/// The smallest text that can be read in print, in points of 1/72 inch.
inline constexpr float smallest_text_pt = 7.0F;

/// Writes a PDF page in which text and lines stay text and lines. Throws InputError as write_file does.
void write_pdf(const std::filesystem::path& path, const Drawing& drawing, const std::string& title);

/// Colours that readers with any kind of colour vision can tell apart. They also differ in grey (Okabe and
/// Ito 2008). Dark colours come first.
namespace palette {
inline const renderer::Colour ink = renderer::rgb(0x1C1C1C);
inline const renderer::Colour quiet_ink = renderer::rgb(0x5A5A5A);
inline const renderer::Colour hairline = renderer::rgb(0xD9D9D9);
inline const renderer::Colour blue = renderer::rgb(0x0059A0);
inline const renderer::Colour vermilion = renderer::rgb(0xD55E00);
inline const renderer::Colour orange = renderer::rgb(0xE69F00);
inline const renderer::Colour sky = renderer::rgb(0x56B4E9);
inline const renderer::Colour green = renderer::rgb(0x009E73);
inline const renderer::Colour purple = renderer::rgb(0xCC79A7);
}  // namespace palette

/// The font style for text of this height.
renderer::TextStyle text_style(float size_px, const renderer::Colour& colour = palette::ink,
                               bool bold = false);

/// The text centred under a panel of a figure: "(a) what it is", and below it in grey what was measured. An
/// empty text leaves its line out.
struct Caption {
  char letter = 'a';  ///< '\0' for a figure with one panel: no letter
  std::string text;
  std::string measured;
};

/// Sizes of the two lines of a caption.
struct CaptionStyle {
  float text_px = 40.0F;
  float measured_px = 34.0F;

  float height_px() const { return 1.75F * text_px + 1.45F * measured_px; }
};

/// Draws the caption with its centre at `centre_px` and its upper edge at `top_px`.
void draw_caption(renderer::Canvas& canvas, const Caption& caption, float centre_px, float top_px,
                  const CaptionStyle& style = {});

/// An OpenGL context without a window, and the scene renderer in it.
class OffscreenRenderer {
 public:
  /// `backend` as in renderer::create_context. Throws renderer::ContextError.
  explicit OffscreenRenderer(const std::string& backend)
      : context_(renderer::create_context(backend)), renderer_(*context_) {}

  renderer::SceneRenderer& renderer() { return renderer_; }
  /// The name OpenGL gives its renderer (GL_RENDERER).
  const std::string& gl_renderer() const { return context_->renderer(); }

 private:
  std::unique_ptr<renderer::Context> context_;
  renderer::SceneRenderer renderer_;
};

/// Base colours on the triangles of a garment, as renderer::SurfaceView has them. No base colours: those of
/// the cloth. Its texture coordinates, if it has any, say where it is sewn too.
struct DrawnColours {
  std::vector<glm::vec2> corner_coordinates;
  std::vector<renderer::BaseColour> base_colours;
  std::vector<std::uint32_t> base_colour_of_triangle;
  std::vector<std::string> remarks = {};  ///< what of it is missing, one line each
  /// The model whose triangles these are, where it follows the garment; null: they are the garment's own.
  std::shared_ptr<const FollowingModel> following = {};
};

/// Returns what picture.texture asks for: an image over the cloth's colours, or the model's own colours if it
/// names images of them and the scene no outside colour of its own. Throws InputError if the image cannot be
/// read or the garment has no texture coordinates.
DrawnColours drawn_colours(const DrawnScene& scene, const GarmentInScene& loaded);

}  // namespace taut::app
