#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

struct GladGLContext;  // <glad/gl.h>

namespace taut::renderer {

/// No context could be made, or OpenGL reported an error.
struct ContextError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// An OpenGL 3.3 core context and the functions that belong to it. Nothing is drawn to the context itself:
/// pictures are made in framebuffer objects, so a context without a window is as good as one with.
class Context {
 public:
  virtual ~Context() = default;
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  /// Binds the context to the calling thread. Throws ContextError.
  virtual void make_current() = 0;

  /// The function table, valid while the context lives.
  const GladGLContext& gl() const { return *table; }
  /// The loader that made it: "osmesa", ...
  virtual std::string_view loader() const = 0;
  /// GL_RENDERER, e.g. "llvmpipe (LLVM 15.0.6, 256 bits)".
  const std::string& renderer() const { return renderer_string; }
  /// GL_VERSION, e.g. "4.5 (Core Profile) Mesa 22.3.6".
  const std::string& version() const { return version_string; }

 protected:
  using Procedure = void (*)();
  using Lookup = Procedure (*)(const char* name);

  Context();
  /// Fills the table and the strings; the context has to be current. Throws ContextError when a function of
  /// OpenGL 3.3 is missing.
  void load(Lookup lookup);

 private:
  std::unique_ptr<GladGLContext, void (*)(GladGLContext*)> table;
  std::string renderer_string;
  std::string version_string;
};

/// Names create_context takes apart from "auto", best first.
std::vector<std::string> context_names();

/// A current context without a window, by the name of its loader; "auto" takes the first that works. Needs no
/// display. Throws ContextError saying what was tried and why each failed.
std::unique_ptr<Context> create_context(std::string_view name = "auto");

}  // namespace taut::renderer
