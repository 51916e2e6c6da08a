#include "renderer/gl/visibility_buffer.hpp"

#include <algorithm>
#include <array>

#include "renderer/gl/bindings.hpp"

namespace taut::renderer {

VisibilityBuffer::VisibilityBuffer(const GladGLContext& context)
    : gl_(&context), triangle_framebuffer_(context), marks_framebuffer_(context) {
  most_samples_ = 16;
  for (const GLenum limit : {GL_MAX_SAMPLES, GL_MAX_INTEGER_SAMPLES, GL_MAX_COLOR_TEXTURE_SAMPLES}) {
    GLint most = 1;
    gl_->GetIntegerv(limit, &most);
    most_samples_ = std::min(most_samples_, most);
  }
}

// Four is what shaders/surface.frag counts with.
int VisibilityBuffer::usable_samples(int wanted) const {
  return wanted > 1 && most_samples_ >= 4 ? 4 : 1;
}

void VisibilityBuffer::begin(int width_px, int height_px, int wanted_samples) {
  const int usable = usable_samples(wanted_samples);
  if (width_px != width_px_ || height_px != height_px_ || usable != samples_) {
    allocate(width_px, height_px, usable);
  }
  gl_->BindFramebuffer(GL_FRAMEBUFFER, triangle_framebuffer_.name());
  gl_->Viewport(0, 0, width_px, height_px);
  gl_->DepthMask(GL_TRUE);
  constexpr std::array<GLuint, 4> nothing{};
  gl_->ClearBufferuiv(GL_COLOR, 0, nothing.data());
  gl_->Clear(GL_DEPTH_BUFFER_BIT);
}

void VisibilityBuffer::allocate_texture(const Texture& texture, GLenum format) const {
  gl_->ActiveTexture(GL_TEXTURE0 + drawn_unit);
  if (samples_ > 1) {
    gl_->BindTexture(GL_TEXTURE_2D_MULTISAMPLE, texture.name());
    gl_->TexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, samples_, format, width_px_, height_px_, GL_TRUE);
    return;
  }
  const bool whole_numbers = format == GL_R32UI;
  gl_->BindTexture(GL_TEXTURE_2D, texture.name());
  gl_->TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), width_px_, height_px_, 0,
                  whole_numbers ? GL_RED_INTEGER : GL_RGBA,
                  whole_numbers ? GL_UNSIGNED_INT : GL_UNSIGNED_BYTE, nullptr);
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

void VisibilityBuffer::allocate(int width_px, int height_px, int samples) {
  width_px_ = width_px;
  height_px_ = height_px;
  samples_ = samples;
  marks_colour_.reset();
  triangle_ids_.emplace(*gl_);
  depth_.emplace(*gl_);
  allocate_texture(*triangle_ids_, GL_R32UI);
  gl_->BindRenderbuffer(GL_RENDERBUFFER, depth_->name());
  gl_->RenderbufferStorageMultisample(GL_RENDERBUFFER, samples > 1 ? samples : 0, GL_DEPTH_COMPONENT24,
                                      width_px, height_px);
  const GLenum target = samples > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
  gl_->BindFramebuffer(GL_FRAMEBUFFER, triangle_framebuffer_.name());
  gl_->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, target, triangle_ids_->name(), 0);
  gl_->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_->name());
  check_errors(*gl_, "making the visibility buffer");
  check_framebuffer(*gl_, "visibility buffer");
  if (samples > 1) ask_sample_places();
}

void VisibilityBuffer::ask_sample_places() {
  for (int i = 0; i < samples_; ++i) {
    std::array<GLfloat, 2> place{};
    gl_->GetMultisamplefv(GL_SAMPLE_POSITION, static_cast<GLuint>(i), place.data());
    sample_places_x_[i] = place[0];
    sample_places_y_[i] = place[1];
  }
}

void VisibilityBuffer::bind() const {
  bind_texture(*gl_, visibility_unit, samples_ > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D,
               *triangle_ids_);
}

void VisibilityBuffer::begin_marks() {
  gl_->BindFramebuffer(GL_FRAMEBUFFER, marks_framebuffer_.name());
  if (!marks_colour_) {
    marks_colour_.emplace(*gl_);
    allocate_texture(*marks_colour_, GL_SRGB8_ALPHA8);
    const GLenum target = samples_ > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
    gl_->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, target, marks_colour_->name(), 0);
    gl_->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_->name());
    check_errors(*gl_, "making the marks' buffers");
    check_framebuffer(*gl_, "marks");
  }
  gl_->Viewport(0, 0, width_px_, height_px_);
  gl_->ClearColor(0.0F, 0.0F, 0.0F, 0.0F);
  gl_->Clear(GL_COLOR_BUFFER_BIT);
}

}  // namespace taut::renderer
