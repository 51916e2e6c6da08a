#include "renderer/context/context.hpp"

#include <glad/gl.h>

#include "renderer/context/loaders.hpp"

namespace taut::renderer {

namespace {

struct Loader {
  std::string_view name;
  std::unique_ptr<Context> (*create)();
};

// Best first: "auto" tries them in this order.
constexpr Loader loaders[] = {{"osmesa", create_osmesa_context}, {"egl", create_egl_context}};

std::string gl_string(const GladGLContext& gl, GLenum name) {
  const auto* text = reinterpret_cast<const char*>(gl.GetString(name));
  return text != nullptr ? text : "unknown";
}

}  // namespace

Context::Context() : table_(new GladGLContext{}, [](GladGLContext* gl) { delete gl; }) {}

void Context::load(Lookup lookup) {
  const int version = gladLoadGLContext(table_.get(), lookup);
  if (version < GLAD_MAKE_VERSION(3, 3)) {
    throw ContextError("OpenGL 3.3 is needed, this context has " +
                       std::to_string(GLAD_VERSION_MAJOR(version)) + "." +
                       std::to_string(GLAD_VERSION_MINOR(version)));
  }
  renderer_ = gl_string(*table_, GL_RENDERER);
  version_ = gl_string(*table_, GL_VERSION);
}

std::vector<std::string> context_names() {
  std::vector<std::string> names;
  for (const Loader& loader : loaders) names.emplace_back(loader.name);
  return names;
}

std::unique_ptr<Context> create_context(std::string_view name) {
  std::string tried;
  for (const Loader& loader : loaders) {
    if (name != "auto" && name != loader.name) continue;
    try {
      return loader.create();
    } catch (const ContextError& error) {
      tried += std::string(tried.empty() ? "" : "; ") + std::string(loader.name) + ": " + error.what();
    }
  }
  if (!tried.empty()) throw ContextError("no OpenGL context (" + tried + ")");
  std::string known = "auto";
  for (const Loader& loader : loaders) known += ", " + std::string(loader.name);
  throw ContextError("unknown OpenGL context '" + std::string(name) + "', expected one of: " + known);
}

}  // namespace taut::renderer
