#include "renderer/gl/picture_target.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "renderer/gl/bindings.hpp"
#include "renderer/page/colour.hpp"

namespace taut::renderer {

namespace {

Image read_pixels(const GladGLContext& gl, GLuint framebuffer, const Image& size) {
  Image image = make_image(size.width_px, size.height_px, size.channels);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl.ReadPixels(0, 0, image.width_px, image.height_px, image.channels == 4 ? GL_RGBA : GL_RGB,
                GL_UNSIGNED_BYTE, image.pixels.data());
  check_errors(gl, "reading the picture");
  // OpenGL's first row is the lowest.
  const std::ptrdiff_t row_bytes = static_cast<std::ptrdiff_t>(image.width_px) * image.channels;
  for (int y = 0; y < image.height_px / 2; ++y) {
    std::swap_ranges(image.at(0, y), image.at(0, y) + row_bytes, image.at(0, image.height_px - 1 - y));
  }
  return image;
}

std::array<float, 256> linear_of_bytes() {
  std::array<float, 256> linear{};
  for (std::size_t i = 0; i < linear.size(); ++i) linear[i] = srgb_to_linear(static_cast<float>(i) / 255.0F);
  return linear;
}

// Only pixels at outlines are between.
void divide_by_alpha(Image& image) {
  const std::array<float, 256> linear = linear_of_bytes();
  for (std::uint8_t* pixel = image.pixels.data(); pixel != image.pixels.data() + image.pixels.size();
       pixel += 4) {
    if (pixel[3] == 0 || pixel[3] == 255) continue;
    for (int i = 0; i < 3; ++i) {
      const float colour = linear[pixel[i]] * 255.0F / static_cast<float>(pixel[3]);
      pixel[i] = static_cast<std::uint8_t>(std::lround(255.0F * linear_to_srgb(colour)));
    }
  }
}

}  // namespace

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

void PictureTarget::clear() const {
  gl_->Disable(GL_SCISSOR_TEST);
  gl_->ClearColor(0.0F, 0.0F, 0.0F, 0.0F);
  gl_->Clear(GL_COLOR_BUFFER_BIT);
}

Image PictureTarget::read() const {
  return read_framebuffer(*gl_, finished_.name(), width_px_, height_px_);
}

Image PictureTarget::read_with_alpha() const {
  Image image = read_pixels(*gl_, finished_.name(), {width_px_, height_px_, 4, {}});
  divide_by_alpha(image);
  return image;
}

void PictureTarget::show(GLuint target, int width_px, int height_px, int left_px) const {
  const bool is_same_size = width_px == width_px_ && height_px == height_px_;
  gl_->BindFramebuffer(GL_READ_FRAMEBUFFER, finished_.name());
  gl_->BindFramebuffer(GL_DRAW_FRAMEBUFFER, target);
  gl_->BlitFramebuffer(0, 0, width_px_, height_px_, left_px, 0, left_px + width_px, height_px,
                       GL_COLOR_BUFFER_BIT, is_same_size ? GL_NEAREST : GL_LINEAR);
  gl_->BindFramebuffer(GL_FRAMEBUFFER, target);
}

Image read_framebuffer(const GladGLContext& gl, GLuint framebuffer, int width_px, int height_px) {
  return read_pixels(gl, framebuffer, {width_px, height_px, 3, {}});
}

}  // namespace taut::renderer
