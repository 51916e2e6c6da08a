#include "app/viewer/headless_viewer.hpp"

namespace taut::app {

HeadlessViewer::HeadlessViewer(const SceneWithBodies& scene, const SessionStart& start,
                               const std::filesystem::path& keep_folder, const std::string& backend)
    : simulation_(scene, SimulationHost::Runs::when_asked),
      viewer_(simulation_, {start.size, start.scale, keep_folder, start.compared_with, false}),
      context_(renderer::create_context(backend)),
      picture_(*context_),
      target_(*context_) {}

SessionFrame HeadlessViewer::play(const SessionFrame& frame) {
  throw_if_interrupted();
  SessionFrame played = viewer_.update(frame);
  if (viewer_.wants_picture()) viewer_.take_picture(draw_scene());
  if (frame.expected_state && *frame.expected_state != simulation_.state_hash()) {
    throw InputError("the state is {:016x}, the session expects {:016x}", simulation_.state_hash(),
                     *frame.expected_state);
  }
  return played;
}

renderer::Image HeadlessViewer::draw_scene() { return picture_.picture(framebuffer(), window(), 0); }

renderer::Image HeadlessViewer::draw() {
  picture_.draw(framebuffer(), window(), 0, true);
  return renderer::read_framebuffer(*context_, framebuffer(), viewer_.layout().width_px, viewer_.layout().height_px);
}

}  // namespace taut::app
