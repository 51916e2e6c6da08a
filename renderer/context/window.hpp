#pragma once

#include "renderer/context/context.hpp"
#include "renderer/context/window_event.hpp"

namespace taut::renderer {

/// Title and first size of a window.
struct WindowSettings {
  std::string title;
  int width = 1280;  ///< screen coordinates; equal to pixels unless the display is scaled
  int height = 720;  ///< as width
};

/// A window on the display, made with GLFW. GLFW is global: there may be one window at a time, and only the
/// thread that opened it may use it.
class Window : public Context {
 public:
  /// Returns the size of framebuffer 0 in pixels; 0 by 0 while the window is minimised.
  virtual Resized framebuffer_size() const = 0;
  /// Returns the display's scale: 1 on a plain display, 2 where text needs twice the pixels.
  virtual double content_scale() const = 0;

  /// Returns the events since the last call, oldest first. Waits up to timeout_s seconds for the first; 0
  /// does not wait.
  virtual std::vector<WindowEvent> wait_events(double timeout_s) = 0;
  /// Swaps buffers: shows what was drawn to framebuffer 0. Waits for the display's refresh.
  virtual void present() = 0;

  /// Returns whether the window's content was damaged since the last call and has to be presented again.
  virtual bool take_damage() = 0;

  /// Returns whether the user has asked to close the window.
  virtual bool is_asked_to_close() const = 0;
  /// Returns whether the driver has reset the context. Nothing can be drawn with it any more.
  virtual bool is_lost() const = 0;
  /// Sets the title; UTF-8.
  virtual void set_title(const std::string& title) = 0;
  /// Puts UTF-8 text on the system clipboard.
  virtual void set_clipboard(const std::string& text) = 0;
};

/// Opens a window with a current OpenGL 3.3 core context. Throws ContextError when there is no display or no
/// such OpenGL.
std::unique_ptr<Window> open_window(const WindowSettings& settings);

}  // namespace taut::renderer
