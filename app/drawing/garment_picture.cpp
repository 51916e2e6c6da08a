#include "app/drawing/garment_painter.hpp"

// Apart from the painter, because libtaut has no canvas for texts.
namespace taut::app {

renderer::Image GarmentPainter::draw(const std::vector<sim::Vec3>& positions, double time_s,
                                     const std::vector<sim::Vec3>& shown_m) {
  renderer::Image image = renderer_.draw(view(positions, time_s, shown_m), style_.settings);
  if (style_.surface != SurfaceLook::stretch || !style_.legend) return image;
  const auto height = static_cast<float>(image.height_px);
  renderer::Canvas canvas(image);
  renderer::draw_legend(canvas, legend_,
                        {.x_px = 0.04F * height,
                         .y_px = 0.1F * height,
                         .bar_width_px = 0.022F * height,
                         .bar_height_px = 0.35F * height,
                         .text = {.size_px = 0.025F * height}});
  return canvas.to_image();
}

}  // namespace taut::app
