#include "app/library/web/engine/web_context.hpp"

#include <GLES3/gl3.h>

extern "C" void* emscripten_GetProcAddress(const char* name);

namespace taut::library {
namespace {

// Constants of OpenGL 3.3 that OpenGL ES 3.0 lacks.
constexpr GLenum max_integer_samples = 0x9110;
constexpr GLenum max_colour_texture_samples = 0x910E;

using Procedure = void (*)();

bool is_known(GLenum capability) {
  constexpr std::array known{GL_BLEND,        GL_CULL_FACE,    GL_DEPTH_TEST,        GL_POLYGON_OFFSET_FILL,
                             GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_RASTERIZER_DISCARD};
  return std::find(known.begin(), known.end(), static_cast<int>(capability)) != known.end();
}

void enable(GLenum capability) {
  if (is_known(capability)) glEnable(capability);
}

void disable(GLenum capability) {
  if (is_known(capability)) glDisable(capability);
}

void bind_texture(GLenum target, GLuint texture) {
  if (target == GL_TEXTURE_2D || target == GL_TEXTURE_2D_ARRAY) glBindTexture(target, texture);
}

void get_integers(GLenum name, GLint* value) {
  if (name == max_integer_samples || name == max_colour_texture_samples) {
    *value = 1;
  } else {
    glGetIntegerv(name, value);
  }
}

const GLubyte* get_string(GLenum name) {
  return name == GL_VERSION ? reinterpret_cast<const GLubyte*>("3.3 by WebGL 2") : glGetString(name);
}

// An answer would wait for the graphics processor, and the simulation with it. The browser reports errors itself.
GLenum get_error() { return GL_NO_ERROR; }

void polygon_mode(GLenum /*face*/, GLenum /*mode*/) {}
void clear_depth(double depth) { glClearDepthf(static_cast<float>(depth)); }
void draw_buffer(GLenum buffer) { glDrawBuffers(1, &buffer); }

// OpenGL ES wants empty textures of floats to be described as floats.
void set_image(GLenum target, GLint level, GLint stored_as, GLsizei width, GLsizei height, GLint border, GLenum format,
               GLenum type, const void* pixels) {
  if (stored_as == GL_R16F) format = GL_RED;
  if (stored_as == GL_R8) format = GL_RED;
  if (stored_as == GL_R16F || stored_as == GL_RGBA16F) type = GL_HALF_FLOAT;
  if (stored_as == GL_RGBA32F) type = GL_FLOAT;
  glTexImage2D(target, level, stored_as, width, height, border, format, type, pixels);
}

Procedure find_procedure(const char* name) {
  const auto found = [](auto* function) { return reinterpret_cast<Procedure>(function); };
  const std::pair<std::string_view, Procedure> own[] = {{"glEnable", found(enable)},
                                                        {"glDisable", found(disable)},
                                                        {"glBindTexture", found(bind_texture)},
                                                        {"glGetIntegerv", found(get_integers)},
                                                        {"glGetString", found(get_string)},
                                                        {"glGetError", found(get_error)},
                                                        {"glPolygonMode", found(polygon_mode)},
                                                        {"glClearDepth", found(clear_depth)},
                                                        {"glDrawBuffer", found(draw_buffer)},
                                                        {"glTexImage2D", found(set_image)}};
  for (const auto& [known, procedure] : own) {
    if (known == name) return procedure;
  }
  return reinterpret_cast<Procedure>(emscripten_GetProcAddress(name));
}

}  // namespace

WebContext::WebContext() { load(find_procedure); }

}  // namespace taut::library
