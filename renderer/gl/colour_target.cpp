#include "renderer/gl/colour_target.hpp"

#include "renderer/gl/picture_target.hpp"

namespace taut::renderer {

struct ColourTarget::Parts {
  Context& context;
  PictureTarget picture;

  explicit Parts(Context& made) : context(made), picture(made.gl(), GL_RGBA8) {}
};

ColourTarget::ColourTarget(Context& context) {
  context.make_current();
  parts_ = std::make_unique<Parts>(context);
}

ColourTarget::~ColourTarget() {
  try {
    parts_->context.make_current();
  } catch (const ContextError&) {
    // Deleting names without their context is undefined; they go when the process does.
    static_cast<void>(parts_.release());
  }
}

unsigned ColourTarget::framebuffer(int width_px, int height_px) {
  parts_->picture.begin(width_px, height_px);
  return parts_->picture.framebuffer();
}

void ColourTarget::copy_part_to(unsigned framebuffer, int x_px, int y_px, int width_px, int height_px) const {
  const GladGLContext& gl = parts_->context.gl();
  gl.Disable(GL_SCISSOR_TEST);
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, parts_->picture.framebuffer());
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
  gl.BlitFramebuffer(x_px, y_px, x_px + width_px, y_px + height_px, x_px, y_px, x_px + width_px,
                     y_px + height_px, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  check_errors(gl, "copying a picture");
}

Image read_framebuffer(Context& context, unsigned framebuffer, int width_px, int height_px) {
  return read_framebuffer(context.gl(), framebuffer, width_px, height_px);
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
