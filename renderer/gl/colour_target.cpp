#include "renderer/gl/colour_target.hpp"

#include <algorithm>
#include <optional>

#include "renderer/gl/gl_objects.hpp"

namespace taut::renderer {

struct ColourTarget::Parts {
  Context& context;
  std::optional<Texture> colour;
  Framebuffer drawn;
  int width_px = 0;
  int height_px = 0;

  explicit Parts(Context& made) : context(made), drawn(made.gl()) {}
};

ColourTarget::ColourTarget(Context& context) {
  context.make_current();
  parts = std::make_unique<Parts>(context);
}

ColourTarget::~ColourTarget() {
  try {
    parts->context.make_current();
  } catch (const ContextError&) {
    // Deleting names without their context is undefined; they go when the process does.
    static_cast<void>(parts.release());
  }
}

unsigned ColourTarget::framebuffer(int width_px, int height_px) {
  const GladGLContext& gl = parts->context.gl();
  if (width_px == parts->width_px && height_px == parts->height_px) return parts->drawn.name();
  parts->width_px = parts->height_px = 0;
  parts->colour.emplace(gl);
  gl.BindTexture(GL_TEXTURE_2D, parts->colour->name());
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width_px, height_px, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  gl.BindTexture(GL_TEXTURE_2D, 0);
  gl.BindFramebuffer(GL_FRAMEBUFFER, parts->drawn.name());
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, parts->colour->name(), 0);
  check_errors(gl, "making a picture to draw to");
  check_framebuffer(gl, "picture to draw to");
  parts->width_px = width_px;
  parts->height_px = height_px;
  return parts->drawn.name();
}

void ColourTarget::copy_part_to(unsigned framebuffer, int x_px, int y_px, int width_px, int height_px) const {
  const GladGLContext& gl = parts->context.gl();
  gl.Disable(GL_SCISSOR_TEST);
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, parts->drawn.name());
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
  gl.BlitFramebuffer(x_px, y_px, x_px + width_px, y_px + height_px, x_px, y_px, x_px + width_px,
                     y_px + height_px, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  check_errors(gl, "copying a picture");
}

Image read_framebuffer(Context& context, unsigned framebuffer, int width_px, int height_px) {
  const GladGLContext& gl = context.gl();
  Image image = make_image(width_px, height_px);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl.ReadPixels(0, 0, width_px, height_px, GL_RGB, GL_UNSIGNED_BYTE, image.pixels.data());
  check_errors(gl, "reading the picture");
  // OpenGL's first row is the lowest.
  for (int y = 0; y < height_px / 2; ++y) {
    std::swap_ranges(image.at(0, y), image.at(0, y) + static_cast<std::ptrdiff_t>(width_px) * 3,
                     image.at(0, height_px - 1 - y));
  }
  return image;
}

void clear_framebuffer(Context& context, unsigned framebuffer, int width_px, int height_px, float grey) {
  const GladGLContext& gl = context.gl();
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.Viewport(0, 0, width_px, height_px);
  gl.Disable(GL_SCISSOR_TEST);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl.ClearColor(grey, grey, grey, 1.0F);
  gl.Clear(GL_COLOR_BUFFER_BIT);
}

void finish_drawing(Context& context) {
  context.gl().Finish();
}

}  // namespace taut::renderer
