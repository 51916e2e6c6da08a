#pragma once

#include <glad/gl.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace taut::renderer {

/// An OpenGL name that deletes itself; the context has to be current then. One template for the kinds that
/// are made and deleted alike.
template <auto Create, auto Delete>
class GlObject {
 public:
  explicit GlObject(const GladGLContext& context) : gl(&context) { (gl->*Create)(1, &object); }
  ~GlObject() {
    if (object != 0) (gl->*Delete)(1, &object);
  }
  GlObject(GlObject&& other) noexcept : gl(other.gl), object(std::exchange(other.object, 0)) {}
  GlObject& operator=(GlObject&& other) noexcept {
    std::swap(gl, other.gl);
    std::swap(object, other.object);
    return *this;
  }
  GlObject(const GlObject&) = delete;
  GlObject& operator=(const GlObject&) = delete;

  GLuint name() const { return object; }

 private:
  const GladGLContext* gl;
  GLuint object = 0;
};

using Buffer = GlObject<&GladGLContext::GenBuffers, &GladGLContext::DeleteBuffers>;
using VertexArray = GlObject<&GladGLContext::GenVertexArrays, &GladGLContext::DeleteVertexArrays>;
using Texture = GlObject<&GladGLContext::GenTextures, &GladGLContext::DeleteTextures>;
using Framebuffer = GlObject<&GladGLContext::GenFramebuffers, &GladGLContext::DeleteFramebuffers>;
using Renderbuffer = GlObject<&GladGLContext::GenRenderbuffers, &GladGLContext::DeleteRenderbuffers>;
using Sampler = GlObject<&GladGLContext::GenSamplers, &GladGLContext::DeleteSamplers>;

/// Replaces the contents; the driver hands out new memory instead of waiting for the last frame.
template <typename Value>
void upload(const GladGLContext& gl, GLenum target, const Buffer& buffer, std::span<const Value> values) {
  gl.BindBuffer(target, buffer.name());
  gl.BufferData(target, static_cast<GLsizeiptr>(values.size_bytes()), values.data(), GL_STREAM_DRAW);
}

/// A float attribute of the bound vertex array, read from `buffer` without gaps. divisor 1: one value for
/// each instance.
void set_attribute(const GladGLContext& gl, GLuint location, const Buffer& buffer, int components,
                   int stride_floats, int offset_floats, GLuint divisor = 0);

void bind_texture(const GladGLContext& gl, unsigned unit, GLenum target, const Texture& texture);

/// Between the two, fragments are linear light, premultiplied with alpha, and laid over what an sRGB-encoded
/// framebuffer holds.
void begin_laying_over(const GladGLContext& gl);
void end_laying_over(const GladGLContext& gl);

/// Throws ContextError naming `stage` when OpenGL has recorded an error, or the bound framebuffer is
/// incomplete.
void check_errors(const GladGLContext& gl, const char* stage);
void check_framebuffer(const GladGLContext& gl, const char* stage);

}  // namespace taut::renderer
