#pragma once

#include <functional>
#include <memory>

#include "app/viewer/picture/viewer_picture.hpp"
#include "app/viewer/simulation/simulation_host.hpp"
#include "app/viewer/viewer.hpp"
#include "renderer/gl/colour_target.hpp"

namespace taut::app {

/// A place to draw that can be made anew when its context is lost.
class DrawingPlace {
 public:
  using MakeContext = std::function<std::unique_ptr<renderer::Context>()>;

  /// Throws renderer::ContextError.
  explicit DrawingPlace(MakeContext make_context);
  ~DrawingPlace();

  renderer::Context& context() { return *context_; }
  ViewerPicture& picture() { return *picture_; }

  /// A new context with all that was in the old one. Throws renderer::ContextError.
  void renew();

 private:
  MakeContext make_context_;
  std::unique_ptr<renderer::Context> context_;
  std::unique_ptr<ViewerPicture> picture_;
};

/// Opens a window and lets a person play until it is closed. `record_to` may be empty.
/// Throws renderer::ContextError without a display or OpenGL, InputError where a file cannot be written,
/// Interrupted.
void view_in_window(const DrawnScene& scene, const SessionStart& start,
                    const std::filesystem::path& keep_folder, const std::filesystem::path& record_to);

/// A window that is not there: plays sessions and draws what the window would show.
class HeadlessViewer {
 public:
  /// Throws InputError where the garment cannot be loaded, renderer::ContextError.
  HeadlessViewer(const DrawnScene& scene, const SessionStart& start, const std::filesystem::path& keep_folder,
                 const std::string& backend);

  /// One frame of the window; drawn where a picture is wanted. Throws InputError where the state is not what
  /// the session expects, naming both hashes.
  SessionFrame play(const SessionFrame& frame);
  /// What the window shows, at best quality; the size must not be 0.
  renderer::Image draw();
  /// The scene alone, as screenshots and recordings have it.
  renderer::Image draw_scene();

  Viewer& viewer() { return viewer_; }
  std::uint64_t state_hash() { return simulation_->state_hash(); }
  const std::string& gl_renderer() { return place_.context().renderer(); }

 private:
  std::unique_ptr<SimulationHost> simulation_;
  Viewer viewer_;
  DrawingPlace place_;
  std::unique_ptr<renderer::ColourTarget> target_;
};

}  // namespace taut::app
