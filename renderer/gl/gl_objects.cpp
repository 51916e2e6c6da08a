#include "renderer/gl/gl_objects.hpp"

namespace taut::renderer {

namespace {

std::string hexadecimal(GLenum value) {
  char text[16];
  std::snprintf(text, sizeof text, "0x%04X", value);
  return text;
}

}  // namespace

void set_attribute(const GladGLContext& gl, GLuint location, const Buffer& buffer, int components,
                   int stride_floats, int offset_floats, GLuint divisor) {
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer.name());
  gl.EnableVertexAttribArray(location);
  const auto offset = static_cast<std::uintptr_t>(offset_floats) * sizeof(float);
  gl.VertexAttribPointer(location, components, GL_FLOAT, GL_FALSE,
                         stride_floats * static_cast<GLsizei>(sizeof(float)),
                         reinterpret_cast<const void*>(offset));
  gl.VertexAttribDivisor(location, divisor);
}

void bind_texture(const GladGLContext& gl, unsigned unit, GLenum target, const Texture& texture) {
  gl.ActiveTexture(GL_TEXTURE0 + unit);
  gl.BindTexture(target, texture.name());
}

void set_sampling(const GladGLContext& gl, GLenum target, GLint filter, GLint wrap) {
  gl.TexParameteri(target, GL_TEXTURE_MAX_LEVEL, 0);
  gl.TexParameteri(target, GL_TEXTURE_MIN_FILTER, filter);
  gl.TexParameteri(target, GL_TEXTURE_MAG_FILTER, filter);
  gl.TexParameteri(target, GL_TEXTURE_WRAP_S, wrap);
  gl.TexParameteri(target, GL_TEXTURE_WRAP_T, wrap);
}

void begin_blending_over(const GladGLContext& gl) {
  gl.Enable(GL_FRAMEBUFFER_SRGB);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

void end_blending_over(const GladGLContext& gl) {
  gl.Disable(GL_BLEND);
  gl.Disable(GL_FRAMEBUFFER_SRGB);
}

void check_errors(const GladGLContext& gl, const char* stage) {
  const GLenum error = gl.GetError();
  if (error == GL_NO_ERROR) return;
  while (gl.GetError() != GL_NO_ERROR) {
  }
  throw ContextError(std::string("OpenGL error ") + hexadecimal(error) + " in " + stage);
}

void check_framebuffer(const GladGLContext& gl, const char* stage) {
  const GLenum status = gl.CheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE) {
    throw ContextError(std::string("OpenGL cannot draw to the ") + stage + ", status " + hexadecimal(status));
  }
}

}  // namespace taut::renderer
