#include "renderer/gl/picture_target.hpp"

#include <algorithm>

#include "renderer/gl/bindings.hpp"

namespace taut::renderer {

PictureTarget::PictureTarget(const GladGLContext& context, GLenum stored_as)
    : gl(&context), format(stored_as), finished(context) {}

void PictureTarget::begin(int width_px, int height_px) {
  if (width_px != picture_width_px || height_px != picture_height_px) allocate(width_px, height_px);
  bind();
}

void PictureTarget::bind() const {
  gl->BindFramebuffer(GL_FRAMEBUFFER, finished.name());
  gl->Viewport(0, 0, picture_width_px, picture_height_px);
}

void PictureTarget::allocate(int width_px, int height_px) {
  picture_width_px = picture_height_px = 0;
  colour.emplace(*gl);
  bind_texture(*gl, drawn_unit, GL_TEXTURE_2D, *colour);
  gl->TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), width_px, height_px, 0, GL_RGBA,
                 GL_UNSIGNED_BYTE, nullptr);
  gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  gl->BindFramebuffer(GL_FRAMEBUFFER, finished.name());
  gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour->name(), 0);
  check_errors(*gl, "making the picture's buffers");
  check_framebuffer(*gl, "finished picture");
  picture_width_px = width_px;
  picture_height_px = height_px;
}

Image PictureTarget::read() const {
  return read_framebuffer(*gl, finished.name(), picture_width_px, picture_height_px);
}

void PictureTarget::show(GLuint target, int width_px, int height_px) const {
  const bool is_same_size = width_px == picture_width_px && height_px == picture_height_px;
  gl->BindFramebuffer(GL_READ_FRAMEBUFFER, finished.name());
  gl->BindFramebuffer(GL_DRAW_FRAMEBUFFER, target);
  gl->BlitFramebuffer(0, 0, picture_width_px, picture_height_px, 0, 0, width_px, height_px,
                      GL_COLOR_BUFFER_BIT, is_same_size ? GL_NEAREST : GL_LINEAR);
  gl->BindFramebuffer(GL_FRAMEBUFFER, target);
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
