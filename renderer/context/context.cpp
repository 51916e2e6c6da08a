#include "renderer/context/context.hpp"

#include <dlfcn.h>
#include <glad/gl.h>

namespace taut::renderer {
namespace {

using Handle = void*;
using Procedure = void (*)();

// Opens the first of these shared libraries that the dynamic linker finds and returns its handle. Throws
// ContextError with the linker's reason for the first name. The library is never closed: Mesa leaves
// thread-local destructors behind that run when the program ends.
void* open_library(std::initializer_list<const char*> names) {
  std::string reason;
  for (const char* name : names) {
    if (void* library = dlopen(name, RTLD_NOW | RTLD_LOCAL)) return library;
    if (reason.empty()) reason = dlerror();
  }
  throw ContextError(reason);
}

// Sets `function` to a function of an open library. Throws ContextError when it has none of that name.
template <typename Function> void find_function(void* library, const char* name, Function& function) {
  function = reinterpret_cast<Function>(dlsym(library, name));
  if (function == nullptr) throw ContextError(std::string("the library has no ") + name);
}

// From Khronos' <EGL/egl.h> and <EGL/eglext.h>, so that no EGL is needed where the program is built.
constexpr unsigned egl_platform_surfaceless = 0x31DD;
constexpr unsigned egl_opengl_api = 0x30A2;
constexpr std::int32_t egl_surface_type = 0x3033;
constexpr std::int32_t egl_renderable_type = 0x3040;
constexpr std::int32_t egl_opengl_bit = 0x0008;
constexpr std::int32_t egl_context_major_version = 0x3098;
constexpr std::int32_t egl_context_minor_version = 0x30FB;
constexpr std::int32_t egl_context_profile_mask = 0x30FD;
constexpr std::int32_t egl_context_core_profile_bit = 0x0001;
constexpr std::int32_t egl_none = 0x3038;

struct EglLibrary {
  Handle (*get_platform_display)(unsigned platform, void* native, const std::intptr_t* attributes) = nullptr;
  unsigned (*initialize)(Handle display, std::int32_t* major, std::int32_t* minor) = nullptr;
  unsigned (*terminate)(Handle display) = nullptr;
  unsigned (*bind_api)(unsigned api) = nullptr;
  unsigned (*choose_config)(Handle display, const std::int32_t* attributes, Handle* configs, std::int32_t capacity,
                            std::int32_t* count) = nullptr;
  Handle (*create_context)(Handle display, Handle config, Handle share, const std::int32_t* attributes) = nullptr;
  unsigned (*destroy_context)(Handle display, Handle context) = nullptr;
  unsigned (*make_current)(Handle display, Handle draw, Handle read, Handle context) = nullptr;
  Procedure (*lookup)(const char* name) = nullptr;
};

EglLibrary load_egl() {
  void* library = open_library({"libEGL.so.1", "libEGL.so"});
  EglLibrary functions;
  find_function(library, "eglGetPlatformDisplay", functions.get_platform_display);
  find_function(library, "eglInitialize", functions.initialize);
  find_function(library, "eglTerminate", functions.terminate);
  find_function(library, "eglBindAPI", functions.bind_api);
  find_function(library, "eglChooseConfig", functions.choose_config);
  find_function(library, "eglCreateContext", functions.create_context);
  find_function(library, "eglDestroyContext", functions.destroy_context);
  find_function(library, "eglMakeCurrent", functions.make_current);
  find_function(library, "eglGetProcAddress", functions.lookup);
  return functions;
}

// Without any surface: Mesa's own rasteriser or a graphics card, whichever the system offers.
class EglContext final : public Context {
 public:
  EglContext() : library_(load_egl()) {
    display_ = library_.get_platform_display(egl_platform_surfaceless, nullptr, nullptr);
    if (display_ == nullptr || library_.initialize(display_, nullptr, nullptr) == 0) {
      throw ContextError("EGL offers no display without a surface");
    }
    try {
      create();
      make_current();
      load(library_.lookup);
    } catch (...) {
      release();
      throw;
    }
  }

  ~EglContext() override { release(); }

  void make_current() override {
    // The API is a setting of the thread, not of the context.
    if (library_.bind_api(egl_opengl_api) == 0 || library_.make_current(display_, nullptr, nullptr, handle_) == 0) {
      throw ContextError("eglMakeCurrent failed");
    }
  }

  std::string_view loader() const override { return "egl"; }

 private:
  void create() {
    const std::array<std::int32_t, 5> config_attributes{egl_surface_type, 0, egl_renderable_type, egl_opengl_bit,
                                                        egl_none};
    const std::array<std::int32_t, 7> context_attributes{
        egl_context_major_version,    3,       egl_context_minor_version, 3, egl_context_profile_mask,
        egl_context_core_profile_bit, egl_none};
    Handle config = nullptr;
    std::int32_t count = 0;
    if (library_.bind_api(egl_opengl_api) == 0 ||
        library_.choose_config(display_, config_attributes.data(), &config, 1, &count) == 0 || count == 0) {
      throw ContextError("EGL offers no configuration for OpenGL");
    }
    handle_ = library_.create_context(display_, config, nullptr, context_attributes.data());
    if (handle_ == nullptr) throw ContextError("EGL offers no OpenGL 3.3 core context");
  }

  void release() {
    if (handle_ != nullptr) {
      library_.make_current(display_, nullptr, nullptr, nullptr);
      library_.destroy_context(display_, handle_);
    }
    library_.terminate(display_);
  }

  EglLibrary library_;
  Handle display_ = nullptr;
  Handle handle_ = nullptr;
};

// From Mesa's <GL/osmesa.h>, which newer distributions no longer ship.
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

  std::string_view loader() const override { return "osmesa"; }

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

std::string gl_string(const GladGLContext& gl, GLenum name) {
  const auto* text = reinterpret_cast<const char*>(gl.GetString(name));
  return text != nullptr ? text : "unknown";
}

}  // namespace

Context::Context() : table_(new GladGLContext{}, [](GladGLContext* gl) { delete gl; }) {}

void Context::load(Lookup lookup) {
  const int version = gladLoadGLContext(table_.get(), lookup);
  if (version < GLAD_MAKE_VERSION(3, 3)) {
    throw ContextError("OpenGL 3.3 is needed, this context has " + std::to_string(GLAD_VERSION_MAJOR(version)) + "." +
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
