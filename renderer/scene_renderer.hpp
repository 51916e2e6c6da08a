#pragma once

#include <memory>

#include "renderer/context/context.hpp"
#include "renderer/frame_view.hpp"
#include "renderer/page/image.hpp"

namespace taut::renderer {

/// Draws frames. Keeps shaders, buffers and render targets between calls, so one renderer should draw a whole
/// sequence. The same frame and settings give the same bytes.
class SceneRenderer {
 public:
  /// The context has to outlive the renderer. Throws ContextError.
  explicit SceneRenderer(Context& context);
  ~SceneRenderer();
  SceneRenderer(const SceneRenderer&) = delete;
  SceneRenderer& operator=(const SceneRenderer&) = delete;

  /// Makes ready what drawing cloth with such settings takes, or (`numbers`) surfaces with scalars: compiling
  /// shaders takes longer than a frame, and need not wait for what is to be drawn. Throws as draw does.
  void prepare(const PictureSettings& settings, bool numbers);

  /// An RGB image of width_px by height_px. Throws std::invalid_argument naming what is wrong with the frame
  /// (lengths that do not match, an index out of range, a position that is not finite) or the settings,
  /// before anything is drawn; ContextError when OpenGL reports an error.
  Image draw(const FrameView& frame, const PictureSettings& settings);

  /// As draw, into a framebuffer object of the caller (0: the window), whose size is settings.width_px by
  /// height_px. The target must not be sRGB-encoding: the bytes written are already encoded. Returns whether
  /// show_kept can show it again: what is drawn straight there, which saves a copy, is not kept.
  bool draw_to(unsigned framebuffer, const FrameView& frame, const PictureSettings& settings);

  /// As draw; the picture stays inside.
  void draw_kept(const FrameView& frame, const PictureSettings& settings);
  /// Copies what was kept last, stretched to this size, to the lower left part of a framebuffer (0: the
  /// window).
  void show_kept(unsigned framebuffer, int width_px, int height_px) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts;
};

}  // namespace taut::renderer
