#pragma once

#include <glad/gl.h>

#include "renderer/context/context.hpp"

namespace taut::renderer {

/// Owns an OpenGL object of the kind that Create makes and Delete deletes. The context must be current in the
/// constructor and the destructor.
template <auto Create, auto Delete> class GlObject {
 public:
  explicit GlObject(const GladGLContext& context) : gl_(&context) { (gl_->*Create)(1, &object_); }
  ~GlObject() {
    if (object_ != 0) (gl_->*Delete)(1, &object_);
  }
  GlObject(GlObject&& other) noexcept : gl_(other.gl_), object_(std::exchange(other.object_, 0)) {}
  GlObject& operator=(GlObject&& other) noexcept {
    std::swap(gl_, other.gl_);
    std::swap(object_, other.object_);
    return *this;
  }
  GlObject(const GlObject&) = delete;
  GlObject& operator=(const GlObject&) = delete;

  /// Returns the object's OpenGL name.
  GLuint name() const { return object_; }

 private:
  const GladGLContext* gl_;
  GLuint object_ = 0;
};

using Buffer = GlObject<&GladGLContext::GenBuffers, &GladGLContext::DeleteBuffers>;
using VertexArray = GlObject<&GladGLContext::GenVertexArrays, &GladGLContext::DeleteVertexArrays>;
using Texture = GlObject<&GladGLContext::GenTextures, &GladGLContext::DeleteTextures>;
using Framebuffer = GlObject<&GladGLContext::GenFramebuffers, &GladGLContext::DeleteFramebuffers>;
using Renderbuffer = GlObject<&GladGLContext::GenRenderbuffers, &GladGLContext::DeleteRenderbuffers>;
using Sampler = GlObject<&GladGLContext::GenSamplers, &GladGLContext::DeleteSamplers>;

/// Replaces a buffer's contents. The driver hands out new memory rather than wait for the last picture.
template <typename Value>
void upload(const GladGLContext& gl, GLenum target, const Buffer& buffer, std::span<const Value> values) {
  gl.BindBuffer(target, buffer.name());
  gl.BufferData(target, static_cast<GLsizeiptr>(values.size_bytes()), values.data(), GL_STREAM_DRAW);
}

/// Sets a float attribute of the bound vertex array. Stride and offset are in floats. divisor 1: one value
/// per instance instead of per vertex.
void set_attribute(const GladGLContext& gl, GLuint location, const Buffer& buffer, int components,
                   int stride_floats, int offset_floats, GLuint divisor = 0);

/// Binds a texture to a texture unit, which becomes the active one.
void bind_texture(const GladGLContext& gl, unsigned unit, GLenum target, const Texture& texture);

/// Sets how the bound texture is sampled: filtered so, repeated or not beyond its sides, at its largest level
/// alone.
void set_sampling(const GladGLContext& gl, GLenum target, GLint filter, GLint wrap = GL_CLAMP_TO_EDGE);

/// Makes the context of some objects current, in which they then can be deleted. Names without their context
/// stay: to delete them is undefined, and they go when the process does.
template <class Parts> void delete_in_context(std::unique_ptr<Parts>& parts) {
  try {
    parts->context.make_current();
  } catch (const ContextError&) {
    static_cast<void>(parts.release());
  }
}

/// Begin and end blending with the "over" operator (Porter and Duff 1984): fragments are premultiplied linear
/// light, the framebuffer is sRGB-encoded.
void begin_blending_over(const GladGLContext& gl);
void end_blending_over(const GladGLContext& gl);

/// Throw ContextError naming `stage` when OpenGL has recorded an error, or when the bound framebuffer is
/// incomplete.
void check_errors(const GladGLContext& gl, const char* stage);
void check_framebuffer(const GladGLContext& gl, const char* stage);

}  // namespace taut::renderer
