#include "app/drawing/picking.hpp"
#include "app/drawing/picture_quality.hpp"
#include "app/library/border.hpp"
#include "app/library/drawing.hpp"
#include "app/library/web/engine/web_context.hpp"

// Draws a cloth with the program's renderer on the page's canvas.
namespace taut::library {

/// Canvas of the page.
struct PageStage : Stage {
  using Stage::Stage;
  app::QualityControl quality{0};
};

namespace {

// Drawn pixels per shaded one: the page shrinks the canvas by this factor, which smooths outlines.
constexpr int shading_px = 2;
// Longest pause after a picture, as a multiple of its time. More leaves the cloth more of the processors.
constexpr double max_rest_ratio = 2.0;

renderer::PictureSettings canvas_settings(int width_px, int height_px, const app::PictureQuality& quality) {
  renderer::PictureSettings settings;
  quality.apply(settings);
  settings.width_px = width_px;
  settings.height_px = height_px;
  settings.samples = 1;
  settings.shading_px = shading_px;
  return settings;
}

}  // namespace
}  // namespace taut::library

using namespace taut;
using namespace taut::library;

extern "C" {

/// Returns the stage of the WebGL context that is current, or NULL.
TAUT_API PageStage* taut_page_stage() {
  try {
    return new PageStage(std::make_unique<WebContext>());  // stays for the life of the page
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return nullptr;
  }
}

/// Dresses the stage in the cloth, as its scene draws it or with its stretch as colours.
TAUT_API TautResult taut_page_dress(TautCloth cloth, PageStage* stage, int is_stretch) {
  return with(cloth, [&](const Session& session) {
    app::DrawnScene drawn = session.scene();
    drawn.picture.surface = is_stretch != 0 ? app::SurfaceLook::stretch : app::SurfaceLook::shaded;
    drawn.picture.show_pins = false;
    stage->dress(session, drawn);
  });
}

/// Draws the cloth. `view`: the eye and what it looks at in metres, and the vertical angle of view in radians. `level`:
/// index into picture_qualities.
TAUT_API TautResult taut_page_draw(TautCloth cloth, PageStage* stage, const float* view, int width_px, int height_px,
                                   std::size_t level) {
  return with(cloth, [&](const Session& session) {
    require(stage->painter.has_value(), "expected a stage that is dressed");
    require(level < app::picture_qualities.size(), "expected a level from 0 to 5");
    const renderer::Camera camera{
        .eye = {view[0], view[1], view[2]}, .target = {view[3], view[4], view[5]}, .vertical_fov_rad = view[6]};
    const app::PictureQuality& quality = app::picture_qualities[level];
    stage->painter->look_from(camera, quality.min_edge_px);
    stage->renderer.draw_to(0, stage->view(session), canvas_settings(width_px, height_px, quality));
  });
}

/// Gets the level of the next picture and the pause before it in ms, by app::QualityControl.
TAUT_API TautResult taut_page_next_picture(TautCloth cloth, PageStage* stage, double picture_ms, double given_up_ms,
                                           double* next) {
  return with(cloth, [&](const Session&) {
    stage->quality.note(picture_ms, given_up_ms);
    next[0] = static_cast<double>(stage->quality.level());
    next[1] = max_rest_ratio * picture_ms * stage->quality.rest_ms() / app::QualityControl::max_rest_ms;
  });
}

/// Gets the vertex of the cloth that a ray meets first and the point in metres; -1 if it meets a body before or
/// nothing. `ray`: its start and its direction.
TAUT_API TautResult taut_page_pick(TautCloth cloth, const double* ray, double* found) {
  return with(cloth, [&](const Session& session) {
    const app::Ray seen{{ray[0], ray[1], ray[2]}, {ray[3], ray[4], ray[5]}};
    const sim::Simulation& simulation = session.simulation();
    const auto hit = app::pick(seen, simulation.state().current, simulation.garment().mesh.triangles);
    bool is_hidden = false;
    for (const sim::Body& body : simulation.surroundings().bodies) {
      const auto* mesh = std::get_if<sim::BodyMesh>(&body.shape);
      if (mesh == nullptr || !hit) continue;
      std::vector<sim::Vec3> positions_m(mesh->data->positions_m.size());
      sim::positions_at(body, simulation.state().time_s, positions_m);
      const auto front = app::pick(seen, positions_m, mesh->data->triangles);
      is_hidden = is_hidden || (front && front->distance_m < hit->distance_m);
    }
    found[0] = -1.0;
    if (!hit || is_hidden) return;
    found[0] = hit->vertex;
    for (int axis = 0; axis < 3; ++axis) found[1 + axis] = hit->point_m[axis];
  });
}
}
