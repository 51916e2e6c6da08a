#include <glad/gl.h>

#include <array>
#include <cstdint>

#include "renderer/context/loaders.hpp"

namespace taut::renderer {

namespace {

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

using Handle = void*;
using Procedure = void (*)();

struct Library {
  Handle (*get_platform_display)(unsigned platform, void* native, const std::intptr_t* attributes) = nullptr;
  unsigned (*initialize)(Handle display, std::int32_t* major, std::int32_t* minor) = nullptr;
  unsigned (*terminate)(Handle display) = nullptr;
  unsigned (*bind_api)(unsigned api) = nullptr;
  unsigned (*choose_config)(Handle display, const std::int32_t* attributes, Handle* configs,
                            std::int32_t capacity, std::int32_t* count) = nullptr;
  Handle (*create_context)(Handle display, Handle config, Handle share,
                           const std::int32_t* attributes) = nullptr;
  unsigned (*destroy_context)(Handle display, Handle context) = nullptr;
  unsigned (*make_current)(Handle display, Handle draw, Handle read, Handle context) = nullptr;
  Procedure (*lookup)(const char* name) = nullptr;
};

Library load_library() {
  void* library = open_library({"libEGL.so.1", "libEGL.so"});
  Library functions;
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

/// Without any surface: Mesa's own rasteriser or a graphics card, whichever the system offers.
class EglContext final : public Context {
 public:
  EglContext() : library_(load_library()) {
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
    if (library_.bind_api(egl_opengl_api) == 0 ||
        library_.make_current(display_, nullptr, nullptr, handle_) == 0) {
      throw ContextError("eglMakeCurrent failed");
    }
  }

  std::string_view loader() const override { return "egl"; }

 private:
  void create() {
    const std::array<std::int32_t, 5> config_attributes{egl_surface_type, 0, egl_renderable_type,
                                                        egl_opengl_bit, egl_none};
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

  Library library_;
  Handle display_ = nullptr;
  Handle handle_ = nullptr;
};

}  // namespace

std::unique_ptr<Context> create_egl_context() {
  return std::make_unique<EglContext>();
}

}  // namespace taut::renderer
