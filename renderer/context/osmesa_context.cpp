#include <glad/gl.h>

#include <array>

#include "renderer/context/loaders.hpp"

namespace taut::renderer {

namespace {

// From Mesa's <GL/osmesa.h>, which newer distributions no longer ship.
constexpr int osmesa_format = 0x22;
constexpr int osmesa_depth_bits = 0x30;
constexpr int osmesa_profile = 0x33;
constexpr int osmesa_core_profile = 0x34;
constexpr int osmesa_major_version = 0x36;
constexpr int osmesa_minor_version = 0x37;

using Handle = struct OsMesaHandle*;
using Procedure = void (*)();

struct Library {
  Handle (*create)(const int* attributes, Handle share) = nullptr;
  void (*destroy)(Handle) = nullptr;
  unsigned char (*make_current)(Handle, void* buffer, unsigned type, int width_px, int height_px) = nullptr;
  Procedure (*lookup)(const char* name) = nullptr;
};

Library load_library() {
  void* library = open_library({"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"});
  Library functions;
  find_function(library, "OSMesaCreateContextAttribs", functions.create);
  find_function(library, "OSMesaDestroyContext", functions.destroy);
  find_function(library, "OSMesaMakeCurrent", functions.make_current);
  find_function(library, "OSMesaGetProcAddress", functions.lookup);
  return functions;
}

class OsMesaContext final : public Context {
 public:
  OsMesaContext() : library_(load_library()) {
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
  Library library_;
  Handle handle_ = nullptr;
};

}  // namespace

std::unique_ptr<Context> create_osmesa_context() {
  return std::make_unique<OsMesaContext>();
}

}  // namespace taut::renderer
