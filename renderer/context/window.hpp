#pragma once

#include <memory>
#include <string>
#include <vector>

#include "renderer/context/context.hpp"
#include "renderer/context/window_event.hpp"

namespace taut::renderer {

struct WindowSettings {
  std::string title;
  int width = 1280;  ///< in the display's units, which are pixels unless the display is scaled
  int height = 720;
};

/// A window on the display. GLFW keeps state for the whole program: there can be one at a time, used by the
/// thread that made it.
class Window : public Context {
 public:
  /// How many pixels there are to draw to.
  virtual Resized framebuffer_size() const = 0;
  virtual double content_scale() const = 0;

  /// What happened since the last call; waits for something to happen, but no longer than the timeout.
  virtual std::vector<WindowEvent> wait_events(double timeout_s) = 0;
  /// Shows what was drawn to framebuffer 0.
  virtual void present() = 0;

  /// Whether the display has lost what was shown, so that it has to be presented again; once.
  virtual bool take_damage() = 0;

  virtual bool is_asked_to_close() const = 0;
  /// The driver has thrown the context away; nothing can be drawn with it any more.
  virtual bool is_lost() const = 0;
  virtual void set_title(const std::string& title) = 0;
  virtual void set_clipboard(const std::string& text) = 0;
};

/// Opens a window with a current OpenGL 3.3 context. Throws ContextError saying what is missing: a display,
/// or OpenGL.
std::unique_ptr<Window> open_window(const WindowSettings& settings);

}  // namespace taut::renderer
