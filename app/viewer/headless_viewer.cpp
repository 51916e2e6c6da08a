#include "app/viewer/headless_viewer.hpp"

namespace taut::app {

HeadlessViewer::HeadlessViewer(const DrawnScene& scene, const SessionStart& start,
                               const std::filesystem::path& keep_folder, const std::string& backend)
    : simulation_(scene, SimulationHost::Runs::when_asked),
      viewer_(simulation_, {start.size, start.scale, keep_folder, start.compared_with, false}),
      context_([backend] { return renderer::create_context(backend); }),
      target_(std::make_unique<renderer::ColourTarget>(context_.context())) {}

SessionFrame HeadlessViewer::play(const SessionFrame& frame) {
  throw_if_interrupted();
  const bool loses_context =
      std::ranges::any_of(frame.events, [](const auto& event) { return std::holds_alternative<ContextLost>(event); });
  if (loses_context) {
    target_.reset();
    context_.renew();
    target_ = std::make_unique<renderer::ColourTarget>(context_.context());
    viewer_.tell("the graphics driver lost the picture; it was made anew", true);
  }
  SessionFrame played = viewer_.update(frame);
  if (viewer_.wants_picture()) viewer_.take_picture(draw_scene());
  if (frame.expected_state && *frame.expected_state != simulation_.state_hash()) {
    throw InputError("the state is {:016x}, the session expects {:016x}", simulation_.state_hash(),
                     *frame.expected_state);
  }
  return played;
}

renderer::Image HeadlessViewer::draw_scene() {
  const WindowLayout layout = viewer_.layout();
  const unsigned framebuffer = target_->framebuffer(layout.width_px, layout.height_px);
  return context_.picture().picture(framebuffer, viewer_.state(), layout, 0, viewer_.letters(),
                                    viewer_.picture_overlay());
}

renderer::Image HeadlessViewer::draw() {
  const WindowLayout layout = viewer_.layout();
  const unsigned framebuffer = target_->framebuffer(layout.width_px, layout.height_px);
  context_.picture().draw(framebuffer, viewer_.state(), layout, 0, viewer_.letters(), viewer_.overlay(), true);
  return renderer::read_framebuffer(context_.context(), framebuffer, layout.width_px, layout.height_px);
}

}  // namespace taut::app
