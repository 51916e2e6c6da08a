#include "renderer/context/context.hpp"

#include <dlfcn.h>
#include <glad/egl.h>
#include <glad/gl.h>

namespace taut::renderer {
namespace {

using Handle = void*;
using Procedure = void (*)();

// Opens the first of these shared libraries that the dynamic linker finds and returns its handle. Throws ContextError
// with the linker's reason for the first name. The library is never closed: Mesa leaves thread-local destructors behind
// that run when the program ends.
void* open_library(std::initializer_list<const char*> names) {
  std::string reason;
  for (const char* name : names) {
    if (void* library = dlopen(name, RTLD_NOW | RTLD_LOCAL)) return library;
    if (reason.empty()) reason = dlerror();
  }
  throw ContextError(reason);
}

// Sets `function` to a function of an open library. Throws ContextError if the library has none of that name.
template <typename Function> void find_function(void* library, const char* name, Function& function) {
  function = reinterpret_cast<Function>(dlsym(library, name));
  if (function == nullptr) throw ContextError(std::string("the library has no ") + name);
}

// Context without a surface: Mesa's own rasteriser or a graphics card, whichever the system offers.
class EglContext final : public Context {
 public:
  EglContext() {
    if (gladLoaderLoadEGL(EGL_NO_DISPLAY) == 0) throw ContextError("there is no libEGL.so.1");
    // Only functions of EGL 1.0 are loaded before a display exists.
    const auto get_display = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYPROC>(eglGetProcAddress("eglGetPlatformDisplay"));
    if (get_display != nullptr) display_ = get_display(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
    if (display_ == EGL_NO_DISPLAY || eglInitialize(display_, nullptr, nullptr) == EGL_FALSE ||
        gladLoaderLoadEGL(display_) < GLAD_MAKE_VERSION(1, 5)) {
      throw ContextError("EGL offers no display without a surface");
    }
    try {
      create();
      make_current();
      load(eglGetProcAddress);
    } catch (...) {
      release();
      throw;
    }
  }

  ~EglContext() override { release(); }

  void make_current() override {
    // The API is a setting of the thread, not of the context.
    if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE ||
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, handle_) == EGL_FALSE) {
      throw ContextError("eglMakeCurrent failed");
    }
  }

 private:
  void create() {
    constexpr std::array<EGLint, 5> of_config{EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    constexpr std::array<EGLint, 7> of_context{
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE ||
        eglChooseConfig(display_, of_config.data(), &config, 1, &count) == EGL_FALSE || count == 0) {
      throw ContextError("EGL offers no configuration for OpenGL");
    }
    handle_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, of_context.data());
    if (handle_ == EGL_NO_CONTEXT) throw ContextError("EGL offers no OpenGL 3.3 core context");
  }

  void release() {
    if (handle_ != EGL_NO_CONTEXT) {
      eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
      eglDestroyContext(display_, handle_);
    }
    eglTerminate(display_);
  }

  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext handle_ = EGL_NO_CONTEXT;
};

// Values of Mesa's <GL/osmesa.h>, which newer distributions no longer ship.
constexpr int osmesa_format = 0x22;
constexpr int osmesa_depth_bits = 0x30;
constexpr int osmesa_profile = 0x33;
constexpr int osmesa_core_profile = 0x34;
constexpr int osmesa_major_version = 0x36;
constexpr int osmesa_minor_version = 0x37;

struct OsMesaLibrary {
  Handle (*create)(const int* attributes, Handle share) = nullptr;
  void (*destroy)(Handle) = nullptr;
  unsigned char (*make_current)(Handle, void* buffer, unsigned type, int width_px, int height_px) = nullptr;
  Procedure (*lookup)(const char* name) = nullptr;
};

OsMesaLibrary load_osmesa() {
  void* library = open_library({"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"});
  OsMesaLibrary functions;
  find_function(library, "OSMesaCreateContextAttribs", functions.create);
  find_function(library, "OSMesaDestroyContext", functions.destroy);
  find_function(library, "OSMesaMakeCurrent", functions.make_current);
  find_function(library, "OSMesaGetProcAddress", functions.lookup);
  return functions;
}

class OsMesaContext final : public Context {
 public:
  OsMesaContext() : library_(load_osmesa()) {
    const std::array<int, 11> attributes{osmesa_format,
                                         GL_RGBA,
                                         osmesa_depth_bits,
                                         0,
                                         osmesa_profile,
                                         osmesa_core_profile,
                                         osmesa_major_version,
                                         3,
                                         osmesa_minor_version,
                                         3,
                                         0};
    handle_ = library_.create(attributes.data(), nullptr);
    if (handle_ == nullptr) throw ContextError("OSMesa offers no OpenGL 3.3 core context");
    try {
      make_current();
      load(library_.lookup);
    } catch (...) {
      library_.destroy(handle_);
      throw;
    }
  }

  ~OsMesaContext() override { library_.destroy(handle_); }

  void make_current() override {
    if (library_.make_current(handle_, pixels_.data(), GL_UNSIGNED_BYTE, side_px, side_px) == 0) {
      throw ContextError("OSMesaMakeCurrent failed");
    }
  }

 private:
  // OSMesa insists on memory to draw to; everything is drawn in framebuffer objects instead.
  static constexpr int side_px = 16;
  std::array<unsigned char, 4 * side_px * side_px> pixels_{};
  OsMesaLibrary library_;
  Handle handle_ = nullptr;
};

struct Loader {
  std::string_view name;
  std::unique_ptr<Context> (*create)();
};

// Best first: "auto" tries them in this order.
constexpr Loader loaders[] = {
    {"osmesa", []() -> std::unique_ptr<Context> { return std::make_unique<OsMesaContext>(); }},
    {"egl", []() -> std::unique_ptr<Context> { return std::make_unique<EglContext>(); }}};

}  // namespace

Context::Context() : table_(new GladGLContext{}, [](GladGLContext* gl) { delete gl; }) {}

void Context::load(Lookup lookup) {
  const int version = gladLoadGLContext(table_.get(), lookup);
  if (version < GLAD_MAKE_VERSION(3, 3)) {
    throw ContextError("OpenGL 3.3 is needed, this context has " + std::to_string(GLAD_VERSION_MAJOR(version)) + "." +
                       std::to_string(GLAD_VERSION_MINOR(version)));
  }
  const auto* renderer = reinterpret_cast<const char*>(table_->GetString(GL_RENDERER));
  renderer_ = renderer != nullptr ? renderer : "unknown";
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
