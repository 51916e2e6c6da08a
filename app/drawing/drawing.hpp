#pragma once

#include <filesystem>
#include <functional>

#include "renderer/page/canvas.hpp"
#include "renderer/page/image.hpp"

namespace taut::app {

/// A figure, composed once and replayed on whatever canvas it is wanted on.
struct Drawing {
  int width_px = 0;
  int height_px = 0;
  std::function<void(renderer::Canvas&)> draw;
};

/// `scale` times as many pixels each way.
renderer::Image to_image(const Drawing& drawing, float scale = 1.0F);

/// Text and lines stay what they are; the page is as wide as the two columns of a paper.
void write_pdf(const std::filesystem::path& path, const Drawing& drawing);

/// Colours that readers with any kind of colour vision tell apart and that differ in grey as well (Okabe and
/// Ito 2008), dark first.
namespace palette {
inline const renderer::Colour ink = renderer::rgb(0x1C1C1C);
inline const renderer::Colour quiet_ink = renderer::rgb(0x5A5A5A);
inline const renderer::Colour hairline = renderer::rgb(0xD9D9D9);
inline const renderer::Colour blue = renderer::rgb(0x0059A0);
inline const renderer::Colour vermilion = renderer::rgb(0xD55E00);
inline const renderer::Colour orange = renderer::rgb(0xE69F00);
inline const renderer::Colour sky = renderer::rgb(0x56B4E9);
}  // namespace palette

renderer::TextStyle text_style(float size_px, const renderer::Colour& colour = palette::ink,
                               bool bold = false);

/// "(a) what it is", and below it, in grey, what was measured; centred under a panel. Empty lines: none.
struct Caption {
  char letter = 'a';  ///< '\0': the only panel, without a letter
  std::string text;
  std::string measured;
};

struct CaptionStyle {
  float text_px = 40.0F;
  float measured_px = 34.0F;

  float height_px() const { return 1.75F * text_px + 1.45F * measured_px; }
};

void draw_caption(renderer::Canvas& canvas, const Caption& caption, float centre_px, float top_px,
                  const CaptionStyle& style = {});

}  // namespace taut::app
