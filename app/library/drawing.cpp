#include "app/library/drawing.hpp"

namespace taut::library {
namespace {

std::unique_ptr<renderer::Context> open_context() {
  try {
    return renderer::create_context();
  } catch (const renderer::ContextError& error) {
    throw app::InputError(
        "cannot draw: there is no OpenGL without a window; expected libOSMesa.so.8 (apt install libosmesa6) or EGL: {}",
        error.what());
  }
}

/// Places the camera so that the cloth, drawn at `shown_m`, and the bodies fill the picture, as for a single picture of
/// `taut render`.
void fit_camera(const Session& session, const std::vector<sim::Vec3>& shown_m, app::DrawnScene& drawn) {
  if (!app::is_fitted(drawn)) return;
  const sim::State& state = session.simulation().state();
  app::FittedView fitted(drawn, session.simulation().garment(), session.bodies());
  fitted.add(state.current, shown_m, state.time_s);
  fitted.place_camera(drawn);
}

}  // namespace

void Stage::dress(const Session& session, const app::DrawnScene& drawn) {
  painter.emplace(renderer, drawn, session.simulation().garment(), session.bodies(),
                  session.simulation().pins().vertices, app::drawn_colours(drawn, session.garment()));
}

const renderer::FrameView& Stage::view(const Session& session, const std::vector<sim::Vec3>& shown_m) {
  const sim::State& state = session.simulation().state();
  return painter->view(state.current, state.time_s, shown_m);
}

renderer::Image draw(const Session& session, int width_px, int height_px) {
  app::DrawnScene drawn = session.scene();
  drawn.picture.settings.width_px = width_px;
  drawn.picture.settings.height_px = height_px;
  // A model that follows is shaped once, for the camera and the picture.
  const std::vector<sim::Vec3> shown_m = session.garment().shown_m(session.simulation().state().current);
  fit_camera(session, shown_m, drawn);
  Stage stage(open_context());
  stage.dress(session, drawn);
  return stage.renderer.draw(stage.view(session, shown_m), app::to_picture_settings(drawn.picture));
}

}  // namespace taut::library
