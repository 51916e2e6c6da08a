#include "app/drawing/drawing.hpp"

#include "app/base/files.hpp"

namespace taut::app {

renderer::Image to_image(const Drawing& drawing, float scale) {
  renderer::Canvas canvas(drawing.width_px, drawing.height_px, scale);
  drawing.draw(canvas);
  return canvas.to_image();
}

void write_pdf(const std::filesystem::path& path, const Drawing& drawing, const std::string& title) {
  renderer::Canvas canvas = renderer::Canvas::pdf(drawing.width_px, drawing.height_px,
                                                  static_cast<float>(drawing.width_px) / page_width_inches, title);
  drawing.draw(canvas);
  write_file(path, canvas.finish_pdf());
}

renderer::TextStyle text_style(float size_px, const renderer::Colour& colour, bool bold) {
  return {size_px, colour, bold};
}

void draw_caption(renderer::Canvas& canvas, const Caption& caption, float centre_px, float top_px,
                  const CaptionStyle& style) {
  const std::string label = caption.letter == '\0' ? "" : std::string("(") + caption.letter + ") ";
  const renderer::TextStyle bold = text_style(style.text_px, palette::ink, true);
  const renderer::TextStyle plain = text_style(style.text_px);
  const float label_px = canvas.measure(label, bold).width_px;
  const float left_px = centre_px - 0.5F * (label_px + canvas.measure(caption.text, plain).width_px);
  const float baseline_px = top_px + 1.3F * style.text_px;
  canvas.text(left_px, baseline_px, label, bold);
  canvas.text(left_px + label_px, baseline_px, caption.text, plain);
  if (!caption.measured.empty()) {
    const renderer::TextStyle grey =
        text_style(style.measured_px, palette::quiet_ink).with_alignment(renderer::HorizontalAlign::centre);
    canvas.text(centre_px, baseline_px + 1.45F * style.measured_px, caption.measured, grey);
  }
}

}  // namespace taut::app
