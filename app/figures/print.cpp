#include "app/figures/print.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <memory>

#include "app/drawing/drawn_bodies.hpp"
#include "app/drawing/framing.hpp"
#include "app/drawing/garment_painter.hpp"

namespace taut::app {
namespace {

// Fraction of the picture's width and height that stays free around everything.
constexpr float print_margin = 0.045F;

DrawnScene scene_for_print(const PrintedMoment& moment, const PictureSize& size) {
  DrawnScene scene = moment.recording->scene;
  renderer::PictureSettings& settings = scene.picture.settings;
  settings.width_px = size.width_px;
  settings.height_px = size.height_px;
  scene.picture.show_wind = true;
  scene.picture.quality = DrawingQuality::high;
  scene.picture.background = {BackgroundKind::colour, renderer::rgb(0xFFFFFF)};
  if (!moment.has_floor) {
    scene.picture.ground.kind = GroundKind::none;
  }
  if (moment.shows_stretch) {
    scene.picture.surface = SurfaceLook::stretch;
    scene.picture.stretch_of = StretchOf::springs;  // as the paper has it
    scene.picture.stretch_range = std::array{-printed_stretch, printed_stretch};
    scene.picture.stretch_colours = printed_stretch_colours;
    scene.picture.legend = false;
  }
  return scene;
}

// Points that the camera has to see: every vertex and where the key light throws its shadow.
void add_points(const PrintedMoment& moment, const glm::vec3& towards_light, std::optional<float> ground_m,
                std::vector<glm::vec3>& points) {
  for (const glm::vec3& point : to_float(moment.moment->positions)) {
    points.push_back(point);
    if (ground_m) {
      points.push_back(point - towards_light * ((point.y - *ground_m) / towards_light.y));
    }
  }
}

renderer::Camera camera_for(std::span<const PrintedMoment> moments, const PictureSize& size) {
  DrawnScene scene = scene_for_print(moments.front(), size);
  scene.camera.framing.margin = print_margin;
  const renderer::Box reach =
      expected_reach(scene, *moments.front().recording->garment, moments.front().recording->pins);
  const float aspect = aspect_of(scene.picture.settings);
  const glm::vec3 towards_light = renderer::studio_lighting(scene_camera(scene, reach, aspect)).towards_key;
  std::vector<glm::vec3> points;
  for (const PrintedMoment& moment : moments) {
    const std::vector<glm::vec3> arrows = wind_arrows(moment.recording->scene.surroundings.forces.wind,
                                                      moment.recording->garment->mesh.positions);
    points.insert(points.end(), arrows.begin(), arrows.end());
    add_points(moment, towards_light, ground_height(scene, reach), points);
  }
  return renderer::fit_camera_to_points(points, framing_of(scene, reach), aspect);
}

void draw_scale_bar(renderer::Canvas& canvas, const ScaleBar& bar, const glm::vec2& at, float text_px) {
  const float end_px = at.x + bar.length_px;
  canvas.line(at.x, at.y, end_px, at.y, palette::ink, 4.0F);
  for (const float x_px : {at.x, end_px}) {
    canvas.line(x_px, at.y - 9.0F, x_px, at.y + 9.0F, palette::ink, 4.0F);
  }
  renderer::TextStyle text = text_style(text_px);
  text.horizontal = renderer::HorizontalAlign::centre;
  canvas.text(0.5F * (at.x + end_px), at.y - 0.5F * text_px, bar.label, text);
}

}  // namespace

std::string largest_stretch_text(const PrintedMoment& moment) {
  return fmt::format("largest stretch: springs {:.4g} %, surface {:.4g} %",
                     100.0 * moment.moment->record.stretch.max,
                     100.0 * moment.moment->record.surface_stretch.max);
}

Prints print_moments(LazyOffscreenRenderer& offscreen, std::span<const PrintedMoment> moments,
                     const PictureSize& size) {
  return print_moments(offscreen.open(), moments, size, offscreen.scale());
}

Prints print_moments(OffscreenRenderer& offscreen, std::span<const PrintedMoment> moments,
                     const PictureSize& size, float scale) {
  const auto scaled = [&](int length_px) {
    return std::max(1, static_cast<int>(std::lround(static_cast<float>(length_px) * scale)));
  };
  const renderer::Camera camera = camera_for(moments, size);
  Prints prints;
  prints.size = size;
  for (const PrintedMoment& moment : moments) {
    DrawnScene scene = scene_for_print(moment, {scaled(size.width_px), scaled(size.height_px)});
    scene.camera.eye = camera.eye;
    scene.camera.target = camera.target;
    GarmentPainter painter(offscreen.renderer(), scene, *moment.recording->garment, moment.recording->pins);
    prints.pictures.push_back(painter.draw(moment.moment->positions, moment.moment->record.time_s));
  }
  const float seen_m =
      2.0F * glm::distance(camera.eye, camera.target) * std::tan(0.5F * camera.vertical_fov_rad);
  prints.metre_px = static_cast<float>(size.height_px) / seen_m;
  return prints;
}

glm::vec2 panel_corner(const SheetStyle& style, const PictureSize& picture, std::size_t panel) {
  const auto column = static_cast<float>(panel % style.columns);
  const auto row = static_cast<float>(panel / style.columns);
  return {style.border_px + column * (static_cast<float>(picture.width_px) + style.gap_px),
          style.border_px +
              row * (static_cast<float>(picture.height_px) + style.caption.height_px() + style.gap_px)};
}

Drawing sheet_of(std::vector<Panel> panels, const PictureSize& size, const SheetStyle& style,
                 const ScaleBar& bar) {
  const std::size_t columns = std::min(style.columns, panels.size());
  const glm::vec2 last_in_row = panel_corner(style, size, columns - 1);
  const glm::vec2 last = panel_corner(style, size, panels.size() - 1);
  Drawing drawing;
  drawing.width_px = size.width_px + static_cast<int>(last_in_row.x + style.right_px + style.border_px);
  drawing.height_px =
      size.height_px + static_cast<int>(last.y + style.caption.height_px() + 0.5F * style.border_px);
  const auto shared = std::make_shared<const std::vector<Panel>>(std::move(panels));
  drawing.draw = [shared, style, size, bar](renderer::Canvas& canvas) {
    for (std::size_t i = 0; i < shared->size(); ++i) {
      const Panel& panel = (*shared)[i];
      const glm::vec2 corner = panel_corner(style, size, i);
      canvas.image(corner.x, corner.y, static_cast<float>(size.width_px), static_cast<float>(size.height_px),
                   panel.picture);
      draw_caption(canvas, panel.caption, corner.x + 0.5F * static_cast<float>(size.width_px),
                   corner.y + static_cast<float>(size.height_px), style.caption);
    }
    if (bar.length_px > 0.0F) {
      const float inset_px = 0.045F * static_cast<float>(size.width_px);
      const glm::vec2 corner = panel_corner(style, size, 0);
      draw_scale_bar(canvas, bar,
                     {corner.x + inset_px, corner.y + static_cast<float>(size.height_px) - inset_px},
                     style.caption.measured_px);
    }
  };
  return drawing;
}

}  // namespace taut::app
