#pragma once

#include "renderer/context/context.hpp"
#include "renderer/frame_view.hpp"
#include "renderer/page/png.hpp"

namespace taut::renderer {

/// Renderer of frames. Shaders, buffers and render targets are kept between calls, so use one renderer for a whole
/// sequence. The same frame and settings give the same bytes.
class SceneRenderer {
 public:
  /// Makes the context current. The context must outlive the renderer. Throws ContextError.
  explicit SceneRenderer(Context& context);
  ~SceneRenderer();

  /// Compiles the shaders that these settings need, so that the first picture does not wait for them. `scalars`: for
  /// surfaces with scalars instead of cloth. Throws as draw does.
  void prepare(const PictureSettings& settings, bool scalars);

  /// Returns an image of settings.width_px by settings.height_px: RGB, or RGBA if the backdrop is transparent. Throws
  /// std::invalid_argument as check() does, before anything is drawn. Throws ContextError if OpenGL reports an error,
  /// ShaderError if a shader does not compile.
  Image draw(const FrameView& frame, const PictureSettings& settings);

  /// Draws to a framebuffer of the caller (0: the window) of settings.width_px by settings.height_px. The written bytes
  /// are sRGB-encoded already, so the framebuffer must be a plain RGBA8 one. Returns whether show_kept can show the
  /// picture again; a picture drawn straight to the framebuffer is not kept.
  bool draw_to(unsigned framebuffer, const FrameView& frame, const PictureSettings& settings);

  /// Sets the function that is called after each pass of a picture of many, with the number of finished passes and of
  /// all; it may throw to give the picture up. Without one nothing is called.
  void set_pass_report(std::function<void(int done, int all)> report);

  /// Draws and keeps the picture on the graphics card for show_kept.
  void draw_kept(const FrameView& frame, const PictureSettings& settings);
  /// Copies the kept picture, stretched to width_px by height_px, to the bottom of a framebuffer (0: the
  /// window), left_px from its left side. Throws ContextError.
  void show_kept(unsigned framebuffer, int width_px, int height_px, int left_px = 0) const;

 private:
  struct RendererResources;
  std::unique_ptr<RendererResources> parts_;
};

}  // namespace taut::renderer
