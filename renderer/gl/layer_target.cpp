#include "renderer/gl/layer_target.hpp"

#include <algorithm>
#include <array>

#include "renderer/gl/bindings.hpp"

namespace taut::renderer {

LayerTarget::LayerTarget(const GladGLContext& context)
    : gl(&context), seen_framebuffer(context), marks_framebuffer(context) {
  most_samples = 16;
  for (const GLenum limit : {GL_MAX_SAMPLES, GL_MAX_INTEGER_SAMPLES, GL_MAX_COLOR_TEXTURE_SAMPLES}) {
    GLint most = 1;
    gl->GetIntegerv(limit, &most);
    most_samples = std::min(most_samples, most);
  }
}

// Four is what shaders/surface.frag counts with.
int LayerTarget::usable_samples(int wanted) const {
  return wanted > 1 && most_samples >= 4 ? 4 : 1;
}

void LayerTarget::begin(int width_px, int height_px, int wanted_samples) {
  const int usable = usable_samples(wanted_samples);
  if (width_px != layer_width_px || height_px != layer_height_px || usable != layer_samples) {
    allocate(width_px, height_px, usable);
  }
  gl->BindFramebuffer(GL_FRAMEBUFFER, seen_framebuffer.name());
  gl->Viewport(0, 0, width_px, height_px);
  gl->DepthMask(GL_TRUE);
  constexpr std::array<GLuint, 4> nothing{};
  gl->ClearBufferuiv(GL_COLOR, 0, nothing.data());
  gl->Clear(GL_DEPTH_BUFFER_BIT);
}

void LayerTarget::allocate_texture(const Texture& texture, GLenum format) const {
  gl->ActiveTexture(GL_TEXTURE0 + drawn_unit);
  if (layer_samples > 1) {
    gl->BindTexture(GL_TEXTURE_2D_MULTISAMPLE, texture.name());
    gl->TexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, layer_samples, format, layer_width_px,
                              layer_height_px, GL_TRUE);
    return;
  }
  const bool whole_numbers = format == GL_R32UI;
  gl->BindTexture(GL_TEXTURE_2D, texture.name());
  gl->TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), layer_width_px, layer_height_px, 0,
                 whole_numbers ? GL_RED_INTEGER : GL_RGBA, whole_numbers ? GL_UNSIGNED_INT : GL_UNSIGNED_BYTE,
                 nullptr);
  gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

void LayerTarget::allocate(int width_px, int height_px, int samples) {
  layer_width_px = width_px;
  layer_height_px = height_px;
  layer_samples = samples;
  marks_colour.reset();
  seen.emplace(*gl);
  depth.emplace(*gl);
  allocate_texture(*seen, GL_R32UI);
  gl->BindRenderbuffer(GL_RENDERBUFFER, depth->name());
  gl->RenderbufferStorageMultisample(GL_RENDERBUFFER, samples > 1 ? samples : 0, GL_DEPTH_COMPONENT24,
                                     width_px, height_px);
  const GLenum target = samples > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
  gl->BindFramebuffer(GL_FRAMEBUFFER, seen_framebuffer.name());
  gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, target, seen->name(), 0);
  gl->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth->name());
  check_errors(*gl, "making the layer's buffers");
  check_framebuffer(*gl, "layer");
  if (samples > 1) ask_sample_places();
}

void LayerTarget::ask_sample_places() {
  for (int i = 0; i < layer_samples; ++i) {
    std::array<GLfloat, 2> place{};
    gl->GetMultisamplefv(GL_SAMPLE_POSITION, static_cast<GLuint>(i), place.data());
    sample_places_x[i] = place[0];
    sample_places_y[i] = place[1];
  }
}

void LayerTarget::bind_seen() const {
  bind_texture(*gl, seen_unit, layer_samples > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D, *seen);
}

void LayerTarget::begin_marks() {
  gl->BindFramebuffer(GL_FRAMEBUFFER, marks_framebuffer.name());
  if (!marks_colour) {
    marks_colour.emplace(*gl);
    allocate_texture(*marks_colour, GL_SRGB8_ALPHA8);
    const GLenum target = layer_samples > 1 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D;
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, target, marks_colour->name(), 0);
    gl->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth->name());
    check_errors(*gl, "making the marks' buffers");
    check_framebuffer(*gl, "marks");
  }
  gl->Viewport(0, 0, layer_width_px, layer_height_px);
  gl->ClearColor(0.0F, 0.0F, 0.0F, 0.0F);
  gl->Clear(GL_COLOR_BUFFER_BIT);
}

}  // namespace taut::renderer
