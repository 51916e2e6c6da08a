#pragma once

#include <filesystem>

#include "app/models/reading/surface_colours.hpp"
#include "renderer/context/window.hpp"
#include "renderer/passes/overlay_pass.hpp"

struct ImGuiContext;  // <imgui.h>

namespace taut::app {

/// Converts window events to the triangles of the user interface with Dear ImGui, which has global state: only one
/// object may exist at a time. It reads no file except the font and writes none.
class UserInterface {
 public:
  explicit UserInterface(double scale);
  ~UserInterface();
  UserInterface(const UserInterface&) = delete;
  UserInterface& operator=(const UserInterface&) = delete;

  /// Sets the display's scale and renders the font again.
  void set_scale(double scale);

  /// Handles an event. Each button and each key may change at most once between two frames.
  void feed(const renderer::WindowEvent& event);
  void begin_frame(int width_px, int height_px, double elapsed_s);
  void end_frame();

  /// Returns the triangles of the last frame, valid until the next end_frame; empty before the first frame.
  const renderer::OverlayView& overlay() const { return overlay_; }
  /// Returns the part of the overlay that belongs in a picture of the scene.
  const renderer::OverlayView& picture_overlay() const { return picture_overlay_; }
  /// Name prefix of the ImGui windows that belong in a picture of the scene.
  static constexpr const char* in_pictures = "legends";

  /// Adds small pictures to the image of the letters, which is made again.
  void set_thumbnails(TextureImage thumbnails);

  /// Image of the font and the thumbnails, for renderer::OverlayPass. `number` changes when the image changes.
  struct Letters {
    int width_px = 0;
    int height_px = 0;
    std::span<const std::uint8_t> rgba;
    std::uint64_t number = 0;
  };
  Letters letters() const;

  bool wants_pointer() const;  ///< the pointer is over the panel or drags one of its items
  bool wants_keys() const;     ///< the user is typing a number

 private:
  void make_letters();

  ImGuiContext* context_;
  double scale_;
  std::filesystem::path font_;
  TextureImage thumbnails_;
  std::uint64_t letters_number_ = 0;
  std::vector<renderer::OverlayVertex> vertices_;
  std::vector<std::uint16_t> indices_;
  renderer::OverlayView overlay_;
  renderer::OverlayView picture_overlay_;
};

}  // namespace taut::app
