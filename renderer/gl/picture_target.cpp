#include "renderer/gl/picture_target.hpp"

#include <algorithm>

#include "renderer/gl/bindings.hpp"

namespace taut::renderer {

PictureTarget::PictureTarget(const GladGLContext& context, GLenum stored_as)
    : gl_(&context), format_(stored_as), finished_(context) {}

void PictureTarget::begin(int width_px, int height_px) {
  if (width_px != width_px_ || height_px != height_px_) allocate(width_px, height_px);
  bind();
}

void PictureTarget::bind() const {
  gl_->BindFramebuffer(GL_FRAMEBUFFER, finished_.name());
  gl_->Viewport(0, 0, width_px_, height_px_);
}

void PictureTarget::allocate(int width_px, int height_px) {
  width_px_ = height_px_ = 0;
  colour_.emplace(*gl_);
  bind_texture(*gl_, drawn_unit, GL_TEXTURE_2D, *colour_);
  gl_->TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format_), width_px, height_px, 0, GL_RGBA,
                  GL_UNSIGNED_BYTE, nullptr);
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  gl_->BindFramebuffer(GL_FRAMEBUFFER, finished_.name());
  gl_->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour_->name(), 0);
  check_errors(*gl_, "making the picture's buffers");
  check_framebuffer(*gl_, "finished picture");
  width_px_ = width_px;
  height_px_ = height_px;
}

Image PictureTarget::read() const {
  return read_framebuffer(*gl_, finished_.name(), width_px_, height_px_);
}

void PictureTarget::show(GLuint target, int width_px, int height_px) const {
  const bool is_same_size = width_px == width_px_ && height_px == height_px_;
  gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, finished_.name());
  gl_->BindFramebuffer(GL_DRAW_FRAMEBUFFER, target);
  gl_->BlitFramebuffer(0, 0, width_px_, height_px_, 0, 0, width_px, height_px, GL_COLOR_BUFFER_BIT,
                       is_same_size ? GL_NEAREST : GL_LINEAR);
  gl_->BindFramebuffer(GL_FRAMEBUFFER, target);
}

Image read_framebuffer(const GladGLContext& gl, GLuint framebuffer, int width_px, int height_px) {
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

}  // namespace taut::renderer
