#pragma once

#include "app/base/stopwatch.hpp"
#include "app/viewer/panel/panel.hpp"
#include "app/viewer/panel/user_interface.hpp"
#include "app/viewer/picture/scene_picture.hpp"
#include "renderer/gl/picture_target.hpp"

namespace taut::app {

/// Draws the user interface in an OpenGL context. The panel has thousands of small triangles and changes in
/// every simulated frame. Therefore it is kept as a picture, which is renewed a few times per second.
class InterfacePicture {
 public:
  /// The context must outlive it. Throws renderer::ContextError or renderer::ShaderError.
  explicit InterfacePicture(renderer::Context& context);

  /// Draws over a framebuffer of the window's size; framebuffer 0 is the window. If `is_urgent`, as after
  /// input, the panel is up to date; else it may be `longest_s` old. Throws renderer::ContextError.
  void draw(unsigned framebuffer, const WindowLayout& layout, const UserInterface::Letters& letters,
            const renderer::OverlayView& overlay, bool is_urgent);

  /// Draws `overlay` over the framebuffer, without the kept panel.
  void draw_over(unsigned framebuffer, const WindowLayout& layout, const UserInterface::Letters& letters,
                 const renderer::OverlayView& overlay);

  /// Whether `overlay` is what was drawn last.
  bool is_drawn(const renderer::OverlayView& overlay) const;

  /// Largest age of the panel's picture. A larger value saves drawing, and the panel's curves move less
  /// smoothly.
  static constexpr double longest_s = 0.2;

 private:
  bool take_letters(const UserInterface::Letters& letters);
  void draw_panel(const WindowLayout& layout, const renderer::OverlayView& panel);

  renderer::Context& context_;
  renderer::OverlayPass pass_;
  renderer::ColourTarget panel_target_;
  std::uint64_t letters_number_ = 0;
  std::uint64_t drawn_ = 0;       ///< hash of what was drawn, the panel included
  std::uint64_t panel_look_ = 0;  ///< hash of what is in `panel_target_`
  renderer::Resized panel_size_;  ///< of the window that it was drawn for
  Stopwatch since_panel_;
};

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
  renderer::Image picture(unsigned framebuffer, const ViewerState& state, const WindowLayout& layout, std::size_t level,
                          const UserInterface::Letters& letters, const renderer::OverlayView& legends);

  /// Whether `draw` would give the same result as the last one.
  bool is_drawn(const ViewerState& state, const WindowLayout& layout, std::size_t level,
                const renderer::OverlayView& overlay) const;

  /// Whether the last `draw`, or the `picture` before it, drew the scene, which takes most of the time. A
  /// scene that did not change since it was drawn at the same or a better level is only copied.
  bool drew_scene() const { return drew_scene_; }

 private:
  bool draw_scenes(unsigned framebuffer, const ViewerState& state, const WindowLayout& layout, std::size_t level,
                   bool anew);

  renderer::Context& context_;
  ScenePicture first_;
  std::optional<ScenePicture> second_;  ///< while two garments are compared
  InterfacePicture interface_;
  bool drew_scene_ = false;
  bool has_picture_ = false;  ///< `picture` has drawn the scene that the next `draw` shows
};

/// An OpenGL context with the viewer's objects in it. It can be renewed after the driver has lost the
/// context.
class ViewerContext {
 public:
  using MakeContext = std::function<std::unique_ptr<renderer::Context>()>;

  /// Makes the first context. Throws renderer::ContextError.
  explicit ViewerContext(MakeContext make_context);
  ~ViewerContext();

  renderer::Context& context() { return *context_; }
  ViewerPicture& picture() { return *picture_; }

  /// Replaces the context and makes all objects again. References to the old ones become invalid. Throws
  /// renderer::ContextError.
  void renew();

 private:
  MakeContext make_context_;
  std::unique_ptr<renderer::Context> context_;
  std::unique_ptr<ViewerPicture> picture_;
};

}  // namespace taut::app
