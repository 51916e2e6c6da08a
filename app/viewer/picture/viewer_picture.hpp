#pragma once

#include <optional>

#include "app/viewer/panel/panel.hpp"
#include "app/viewer/picture/interface_picture.hpp"
#include "app/viewer/picture/scene_picture.hpp"
#include "app/viewer/state/viewer_state.hpp"

namespace taut::app {

/// Everything of the viewer that lives in an OpenGL context. It is made again if the context is lost.
class ViewerPicture {
 public:
  /// The context must outlive it. Throws renderer::ContextError or renderer::ShaderError.
  explicit ViewerPicture(renderer::Context& context);

  /// Draws the scene and the user interface to a framebuffer of the window's size; framebuffer 0 is the
  /// window. `level` is an index into picture_qualities. `is_urgent` is as in InterfacePicture::draw. Throws
  /// renderer::ContextError.
  void draw(unsigned framebuffer, const ViewerState& state, const WindowLayout& layout, std::size_t level,
            const UserInterface::Letters& letters, const renderer::OverlayView& overlay, bool is_urgent);

  /// Returns the scene as `draw` shows it, with its legends and without the rest of the user interface. It
  /// uses the same framebuffer, so call it before `draw`. Throws renderer::ContextError.
  renderer::Image picture(unsigned framebuffer, const ViewerState& state, const WindowLayout& layout,
                          std::size_t level, const UserInterface::Letters& letters,
                          const renderer::OverlayView& legends);

  /// Whether `draw` would give the same result as the last one.
  bool is_drawn(const ViewerState& state, const WindowLayout& layout, std::size_t level,
                const renderer::OverlayView& overlay) const;

  /// Whether the last `draw`, or the `picture` before it, drew the scene, which takes most of the time. A
  /// scene that did not change since it was drawn at the same or a better level is only copied.
  bool drew_scene() const { return drew_scene_; }

 private:
  bool draw_scenes(unsigned framebuffer, const ViewerState& state, const WindowLayout& layout,
                   std::size_t level, bool anew);

  renderer::Context& context_;
  ScenePicture first_;
  std::optional<ScenePicture> second_;  ///< while two garments are compared
  InterfacePicture interface_;
  bool drew_scene_ = false;
  bool has_picture_ = false;  ///< `picture` has drawn the scene that the next `draw` shows
};

}  // namespace taut::app
