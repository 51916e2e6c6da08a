#pragma once

#include "prelude.hpp"

struct GladGLContext;  // <glad/gl.h>

namespace taut::renderer {

/// Thrown if no context can be made or OpenGL reports an error.
struct ContextError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// OpenGL 3.3 core context and its functions. Pictures are drawn to framebuffer objects, so a context needs no window.
class Context {
 public:
  virtual ~Context() = default;

  /// Makes the context current in the calling thread. Throws ContextError when the system refuses.
  virtual void make_current() = 0;

  /// Returns the OpenGL functions. Valid while the context lives; call them only while it is current.
  const GladGLContext& gl() const { return *table_; }
  /// Returns GL_RENDERER, e.g. "llvmpipe (LLVM 15.0.6, 256 bits)".
  const std::string& renderer() const { return renderer_; }

 protected:
  using Procedure = void (*)();
  using Lookup = Procedure (*)(const char* name);

  Context();
  /// Loads the OpenGL functions through `lookup`. The context must be current. Throws ContextError when it
  /// offers less than OpenGL 3.3.
  void load(Lookup lookup);

 private:
  std::unique_ptr<GladGLContext, void (*)(GladGLContext*)> table_;
  std::string renderer_;
};

/// Returns the names that create_context accepts besides "auto", in the order "auto" tries them.
std::vector<std::string> context_names();

/// Returns a current context without a window. Needs no display. `name` is one of context_names(), or "auto" for the
/// first that works. Throws ContextError with each attempt and its reason, or with the known names if `name` is
/// unknown.
std::unique_ptr<Context> create_context(std::string_view name = "auto");

}  // namespace taut::renderer
