#include "renderer/gl_objects.hpp"

#include <cstdio>
#include <string>

#include "renderer/context/context.hpp"

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

void allocate_depth(const GladGLContext& gl, const Texture& texture, int width_px, int height_px) {
  gl.BindTexture(GL_TEXTURE_2D, texture.name());
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, width_px, height_px, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                nullptr);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
}

void attach_depth(const GladGLContext& gl, const Framebuffer& framebuffer, const Texture& texture) {
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, texture.name(), 0);
  gl.DrawBuffer(GL_NONE);
  gl.ReadBuffer(GL_NONE);
  check_framebuffer(gl, "depth map");
}

void bind_texture(const GladGLContext& gl, unsigned unit, GLenum target, const Texture& texture) {
  gl.ActiveTexture(GL_TEXTURE0 + unit);
  gl.BindTexture(target, texture.name());
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
