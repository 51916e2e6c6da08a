#pragma once

#include <string>
#include <variant>

namespace taut::renderer {

/// Keys are numbered as GLFW does: letters, digits and signs by the capital ASCII character on a US keyboard,
/// others by the names below.
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

enum class PointerButton { left, right, middle };

struct KeyChanged {
  int key = 0;
  bool down = false;  ///< also told again while a key that is held repeats

  bool operator==(const KeyChanged&) const = default;
};

/// A character that was typed, as the keyboard's layout has it.
struct TextTyped {
  char32_t character = 0;

  bool operator==(const TextTyped&) const = default;
};

/// In pixels of the framebuffer from its upper left corner; outside the window while a button is held.
struct PointerMoved {
  double x_px = 0.0;
  double y_px = 0.0;

  bool operator==(const PointerMoved&) const = default;
};

struct ButtonChanged {
  PointerButton button = PointerButton::left;
  bool down = false;

  bool operator==(const ButtonChanged&) const = default;
};

/// In notches of the wheel, up and right positive.
struct WheelTurned {
  double x = 0.0;
  double y = 0.0;

  bool operator==(const WheelTurned&) const = default;
};

/// A file was dragged onto the window and let go.
struct FileDropped {
  std::string path;

  bool operator==(const FileDropped&) const = default;
};

/// Of the framebuffer; both are 0 while a window is minimised.
struct Resized {
  int width_px = 0;
  int height_px = 0;

  bool operator==(const Resized&) const = default;
};

/// How much larger than on a plain display things have to be drawn to be read as well.
struct ScaleChanged {
  double scale = 1.0;

  bool operator==(const ScaleChanged&) const = default;
};

/// What a person does to a window.
using WindowEvent = std::variant<KeyChanged, TextTyped, PointerMoved, ButtonChanged, WheelTurned, FileDropped,
                                 Resized, ScaleChanged>;

}  // namespace taut::renderer
