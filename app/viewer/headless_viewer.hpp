#pragma once

#include "app/viewer/picture/viewer_picture.hpp"
#include "app/viewer/viewer.hpp"

namespace taut::app {

/// The viewer without a window. It plays sessions and draws what the window would show.
class HeadlessViewer {
 public:
  /// `backend`: see renderer::create_context. Throws InputError if the garment cannot be loaded;
  /// renderer::ContextError.
  HeadlessViewer(const SceneWithBodies& scene, const SessionStart& start, const std::filesystem::path& keep_folder,
                 const std::string& backend);

  /// Plays one frame of a session, and draws it only if a screenshot or a recording needs it. Throws InputError with
  /// both hashes if the state differs from the session's expected state; Interrupted.
  SessionFrame play(const SessionFrame& frame);
  /// Draws the whole window at best quality. Width and height must not be 0.
  renderer::Image draw();
  /// Draws only the scene, for screenshots and recordings.
  renderer::Image draw_scene();

  Viewer& viewer() { return viewer_; }
  /// Returns the hash of the simulation's newest state.
  std::uint64_t state_hash() { return simulation_.state_hash(); }
  const std::string& gl_renderer() { return context_->renderer(); }

 private:
  WindowView window() const { return {viewer_.state(), viewer_.interface(), viewer_.layout()}; }
  unsigned framebuffer() { return target_.framebuffer(viewer_.layout().width_px, viewer_.layout().height_px); }

  SimulationHost simulation_;
  Viewer viewer_;
  std::unique_ptr<renderer::Context> context_;
  ViewerPicture picture_;
  renderer::ColourTarget target_;
};

}  // namespace taut::app
