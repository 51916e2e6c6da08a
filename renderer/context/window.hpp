#pragma once

#include "renderer/context/context.hpp"

namespace taut::renderer {

/// Key codes of GLFW. Printable keys have the ASCII code of the capital letter on a US keyboard; others are below.
namespace keys {
inline constexpr int space = 32;
inline constexpr int period = 46;
inline constexpr int escape = 256;
inline constexpr int enter = 257;
inline constexpr int tab = 258;
inline constexpr int backspace = 259;
inline constexpr int insert = 260;
inline constexpr int del = 261;
inline constexpr int right = 262;
inline constexpr int left = 263;
inline constexpr int down = 264;
inline constexpr int up = 265;
inline constexpr int page_up = 266;
inline constexpr int page_down = 267;
inline constexpr int home = 268;
inline constexpr int end = 269;
inline constexpr int f10 = 299;
inline constexpr int f12 = 301;
inline constexpr int left_shift = 340;
inline constexpr int left_control = 341;
inline constexpr int left_alt = 342;
inline constexpr int right_shift = 344;
inline constexpr int right_control = 345;
inline constexpr int right_alt = 346;
inline constexpr int last = 348;
}  // namespace keys

/// A mouse button.
enum class PointerButton { left, right, middle };

/// A key was pressed, repeated or released.
struct KeyChanged {
  int key = 0;        ///< one of `keys`, or an ASCII code
  bool down = false;  ///< true for a press and for every repeat

  bool operator==(const KeyChanged&) const = default;
};

/// A character was typed.
struct TextTyped {
  char32_t character = 0;  ///< Unicode code point

  bool operator==(const TextTyped&) const = default;
};

/// The pointer moved. Position in framebuffer pixels from the upper left corner; beyond the window while a button is
/// down.
struct PointerMoved {
  double x_px = 0.0;
  double y_px = 0.0;

  bool operator==(const PointerMoved&) const = default;
};

/// A mouse button was pressed or released.
struct ButtonChanged {
  PointerButton button = PointerButton::left;
  bool down = false;

  bool operator==(const ButtonChanged&) const = default;
};

/// The wheel was turned, in notches; right (x) and up (y) are positive.
struct WheelTurned {
  double x = 0.0;
  double y = 0.0;

  bool operator==(const WheelTurned&) const = default;
};

/// A file was dropped on the window.
struct FileDropped {
  std::string path;  ///< UTF-8

  bool operator==(const FileDropped&) const = default;
};

/// The framebuffer has a new size in pixels; 0 by 0 while the window is minimised.
struct Resized {
  int width_px = 0;
  int height_px = 0;

  bool operator==(const Resized&) const = default;
};

/// The display's scale changed; see Window::content_scale.
struct ScaleChanged {
  double scale = 1.0;

  bool operator==(const ScaleChanged&) const = default;
};

/// One event of a window.
using WindowEvent =
    std::variant<KeyChanged, TextTyped, PointerMoved, ButtonChanged, WheelTurned, FileDropped, Resized, ScaleChanged>;

/// Title and first size of a window.
struct WindowSettings {
  std::string title;
  int width = 1280;  ///< screen coordinates; equal to pixels unless the display is scaled
  int height = 720;  ///< see width
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
  /// Shows framebuffer 0 by a swap of buffers. Waits for the display's refresh.
  virtual void present() = 0;

  /// Returns whether the window's content was damaged since the last call and needs to be presented again.
  virtual bool take_damage() = 0;

  /// Returns whether the user has asked to close the window.
  virtual bool is_asked_to_close() const = 0;
  /// Sets the title; UTF-8.
  virtual void set_title(const std::string& title) = 0;
};

/// Opens a window with a current OpenGL 3.3 core context. Throws ContextError without a display or such an OpenGL.
std::unique_ptr<Window> open_window(const WindowSettings& settings);

}  // namespace taut::renderer
