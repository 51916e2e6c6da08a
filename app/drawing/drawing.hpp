#pragma once

#include <filesystem>

#include "renderer/page/canvas.hpp"

namespace taut::app {

/// A drawing of lines, text and pictures. `draw` works for any kind of canvas and may be called several times.
struct Drawing {
  int width_px = 0;
  int height_px = 0;
  std::function<void(renderer::Canvas&)> draw;
};

/// Draws an image with `scale` times the drawing's width and height.
renderer::Image to_image(const Drawing& drawing, float scale = 1.0F);

/// Width of a PDF page, which spans two columns of a paper.
inline constexpr float page_width_inches = 7.0F;

/// Writes a PDF page that keeps lines and text as vectors. Throws InputError as write_file does.
void write_pdf(const std::filesystem::path& path, const Drawing& drawing, const std::string& title);

/// Colours that readers with any kind of colour vision can distinguish. They also differ in grey (Okabe and Ito 2008).
/// Dark colours come first.
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

/// Returns the font style for text of this height.
renderer::TextStyle text_style(float size_px, const renderer::Colour& colour = palette::ink, bool bold = false);

/// Text centred under a panel of a figure: "(a) title", and below it measurements in grey. An empty text leaves its
/// line out.
struct Caption {
  char letter = 'a';  ///< '\0' in a figure with one panel: no letter
  std::string text;
  std::string measured;
};

/// Text heights of the two lines of a caption.
struct CaptionStyle {
  float text_px = 40.0F;
  float measured_px = 34.0F;

  float height_px() const { return 1.75F * text_px + 1.45F * measured_px; }
};

/// Draws the caption with its centre at `centre_px` and its upper edge at `top_px`.
void draw_caption(renderer::Canvas& canvas, const Caption& caption, float centre_px, float top_px,
                  const CaptionStyle& style = {});

}  // namespace taut::app
