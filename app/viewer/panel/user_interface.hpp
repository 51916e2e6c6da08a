#pragma once

#include <filesystem>

#include "app/models/surface_colours.hpp"
#include "renderer/context/window.hpp"
#include "renderer/passes/overlay_pass.hpp"

struct ImGuiContext;  // <imgui.h>

namespace taut::app {

/// Dear ImGui, from events of the window to triangles. The library has global state, so only one object may
/// exist at a time. It reads no file except the font and writes none.
class UserInterface {
 public:
  explicit UserInterface(double scale);
  ~UserInterface();
  UserInterface(const UserInterface&) = delete;
  UserInterface& operator=(const UserInterface&) = delete;

  /// Sets the scale of the display and renders the font again.
  void set_scale(double scale);

  /// Takes an event. Between two frames each button and each key may change at most once.
  void feed(const renderer::WindowEvent& event);
  void begin_frame(int width_px, int height_px, double elapsed_s);
  void end_frame();

  /// The triangles of the last frame, valid until the next end_frame. Empty before the first frame.
  const renderer::OverlayView& overlay() const { return overlay_; }
  /// The part of it that belongs in a picture of the scene.
  const renderer::OverlayView& picture_overlay() const { return picture_overlay_; }
  /// The prefix of the names of ImGui windows that belong in a picture of the scene.
  static constexpr const char* in_pictures = "legends";

  /// Sets small pictures that are kept beside the letters, which are made anew.
  void set_thumbnails(TextureImage thumbnails);

  /// The font and the thumbnails as an image, for renderer::OverlayPass. `number` changes when the image changes.
  struct Letters {
    int width_px = 0;
    int height_px = 0;
    std::span<const std::uint8_t> rgba;
    std::uint64_t number = 0;
  };
  Letters letters() const;

  bool wants_pointer() const;  ///< the pointer is over the panel, or drags one of its items
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
