#pragma once

#include "app/base/stopwatch.hpp"
#include "app/viewer/panel/panel.hpp"
#include "app/viewer/panel/user_interface.hpp"
#include "renderer/gl/colour_target.hpp"
#include "renderer/passes/overlay_pass.hpp"

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

}  // namespace taut::app
