#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "renderer/context/window_event.hpp"
#include "renderer/passes/overlay_pass.hpp"

struct ImGuiContext;  // <imgui.h>

namespace taut::app {

/// Dear ImGui between a window's events and triangles. The library keeps its state in a global of its own:
/// there can be one at a time. It reads and writes no file but the font's.
class UserInterface {
 public:
  explicit UserInterface(double scale);
  ~UserInterface();
  UserInterface(const UserInterface&) = delete;
  UserInterface& operator=(const UserInterface&) = delete;

  /// Of the display; makes the letters anew.
  void set_scale(double scale);

  /// Between two frames, at most one change of each button and key.
  void feed(const renderer::WindowEvent& event);
  void begin_frame(int width_px, int height_px, double elapsed_s);
  void end_frame();

  /// What was laid out in the last frame, valid until the next one ends; nothing before the first.
  const renderer::OverlayView& overlay() const { return overlay_; }
  /// The part of it that belongs into a picture of the scene: the windows of this name.
  const renderer::OverlayView& picture_overlay() const { return picture_overlay_; }
  static constexpr const char* in_pictures = "legends";

  /// The letters for renderer::OverlayPass; the number changes when they do.
  struct Letters {
    int width_px = 0;
    int height_px = 0;
    std::span<const std::uint8_t> coverage;
    std::uint64_t number = 0;
  };
  Letters letters() const;

  bool wants_pointer() const;  ///< the pointer is over the panel, or drags something of it
  bool wants_keys() const;     ///< a number is being typed

 private:
  void make_letters();

  ImGuiContext* context_;
  double scale_;
  std::filesystem::path font_;
  std::uint64_t letters_number_ = 0;
  std::vector<renderer::OverlayVertex> vertices_;
  std::vector<std::uint16_t> indices_;
  renderer::OverlayView overlay_;
  renderer::OverlayView picture_overlay_;
};

}  // namespace taut::app
