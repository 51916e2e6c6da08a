#include "app/drawing/fit_picture.hpp"

#include <fmt/core.h>

#include "app/bodies/wearing.hpp"
#include "app/drawing/drawing.hpp"
#include "app/drawing/framing.hpp"
#include "app/drawing/garment_painter.hpp"
#include "app/drawing/inspection_marks.hpp"
#include "app/drawing/offscreen_renderer.hpp"
#include "renderer/page/legend.hpp"

namespace taut::app {
namespace {

constexpr float border_px = 40.0F;
constexpr float gap_px = 20.0F;
constexpr float panel_px = 700.0F;
constexpr float panel_height_px = 860.0F;
constexpr float legend_px = 275.0F;
constexpr float text_px = 26.0F;
constexpr float row_px = 1.7F * text_px;
constexpr float header_px = border_px + 3.4F * text_px;
constexpr float page_px = 2.0F * border_px + 2.0F * panel_px + gap_px + legend_px;

/// `turned_rad` is how far the camera goes around from the front.
renderer::Image draw_side(OffscreenRenderer& offscreen, const WornGarment& worn, float turned_rad) {
  DrawnScene scene = worn.scene;
  const sim::Vec3 front = front_of_dressed(scene);
  renderer::Framing& framing = scene.camera.framing;
  framing.azimuth_rad = static_cast<float>(std::atan2(front.x, front.z)) + turned_rad;
  framing.elevation_rad = 0.05F;
  framing.vertical_fov_rad = 0.35F;
  scene.camera.eye.reset();
  scene.camera.box = renderer::bounding_box(to_float(worn.positions_m));
  PictureStyle& style = scene.picture;
  style.settings.width_px = static_cast<int>(panel_px);
  style.settings.height_px = static_cast<int>(panel_height_px);
  style.settings.supersampling = 2;
  style.surface = SurfaceLook::stretch;
  style.ground.kind = GroundKind::none;
  style.legend = false;
  style.show_pins = false;
  return draw_marked(offscreen.renderer(), scene, worn.garment, {}, worn.positions_m, worn.time_s, {}, true);
}

void draw_table(renderer::Canvas& canvas, const WornGarment& worn, float top_px) {
  const std::span<const FitRow> rows = worn.fit;
  constexpr std::array columns_px = {0.0F, 420.0F, 640.0F, 860.0F, 930.0F};
  const float end_px = border_px + 1130.0F;
  const auto line = [&](float y_px, const std::array<std::string, 5>& cells,
                        const renderer::TextStyle& look) {
    for (std::size_t c = 0; c < cells.size(); ++c) {
      renderer::TextStyle style = look;
      const bool is_number = c > 0 && c < 4;
      style.horizontal = is_number ? renderer::HorizontalAlign::right : renderer::HorizontalAlign::left;
      canvas.text(border_px + columns_px[c], y_px, cells[c], style);
    }
    canvas.line(border_px, y_px + 0.45F * text_px, end_px, y_px + 0.45F * text_px, palette::hairline);
  };
  line(top_px + text_px, {"", "body", "garment", "ease", ""}, text_style(text_px, palette::quiet_ink));
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const FitRow& row = rows[r];
    const auto cm = [](double length_m) { return fmt::format("{:.1f} cm", 100.0 * length_m); };
    const bool is_short = row.ease_m() < too_small_below_m;
    line(top_px + text_px + static_cast<float>(r + 1) * row_px,
         {row.name, cm(row.body_m), cm(row.garment_m), fmt::format("{:+.1f} cm", 100.0 * row.ease_m()),
          fit_word(row)},
         text_style(text_px, is_short ? palette::vermilion : palette::ink));
  }
  const std::string words = rows.empty() ? "no girth of the garment goes all around the body"
                                         : "ease below 0: too small; " + fit_thresholds();
  canvas.text(border_px, top_px + text_px + static_cast<float>(rows.size() + 1) * row_px, words,
              text_style(0.75F * text_px, palette::quiet_ink));
  canvas.text(border_px, top_px + text_px + static_cast<float>(rows.size() + 2) * row_px, worn.tightness,
              text_style(0.85F * text_px, palette::ink));
}

}  // namespace

renderer::Image draw_fit(const WornGarment& worn, const std::string& backend) {
  OffscreenRenderer offscreen(backend);
  const float caption_px = 1.6F * row_px;
  const float table_px = header_px + panel_height_px + caption_px;
  // As long as a body is thin, what is about it says nothing of how it fits.
  const bool has_table = worn.time_s >= 0.0;
  const float rows = has_table ? static_cast<float>(worn.fit.size() + 3) : 0.0F;
  renderer::Canvas canvas(static_cast<int>(page_px), static_cast<int>(table_px + rows * row_px + border_px));
  canvas.text(border_px, border_px + text_px, worn.title, text_style(1.4F * text_px, palette::ink, true));
  canvas.text(border_px, border_px + text_px + row_px, worn.measured,
              text_style(0.85F * text_px, palette::quiet_ink));
  renderer::TextStyle caption = text_style(text_px);
  caption.horizontal = renderer::HorizontalAlign::centre;
  float x_px = border_px;
  for (const auto& [name, turned_rad] :
       {std::pair("from the front", 0.0F), {"from behind", std::numbers::pi_v<float>}}) {
    canvas.image(x_px, header_px, draw_side(offscreen, worn, turned_rad));
    canvas.text(x_px + 0.5F * panel_px, header_px + panel_height_px + row_px, name, caption);
    x_px += panel_px + gap_px;
  }
  renderer::LegendPlace place{.x_px = x_px + gap_px,
                              .y_px = header_px + 80.0F,
                              .bar_width_px = 24.0F,
                              .bar_height_px = 420.0F,
                              .text = text_style(0.85F * text_px)};
  renderer::draw_legend(canvas, stretch_legend(worn.scene), place);
  if (has_table) {
    draw_table(canvas, worn, table_px);
  }
  return canvas.to_image();
}

}  // namespace taut::app
