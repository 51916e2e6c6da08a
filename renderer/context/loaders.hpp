#pragma once

#include <dlfcn.h>

#include <initializer_list>
#include <memory>
#include <string>

#include "renderer/context/context.hpp"

namespace taut::renderer {

// Each function returns a new context, current in the calling thread, or throws ContextError with the reason.

/// Returns a context of libOSMesa, Mesa's off-screen library. Mesa 25.1 removed it, so it may be absent.
std::unique_ptr<Context> create_osmesa_context();
/// Returns a context of EGL without a surface. Needs neither a display nor a window system.
std::unique_ptr<Context> create_egl_context();

/// Opens the first of these shared libraries that the dynamic linker finds and returns its handle. Throws
/// ContextError with the linker's reason for the first name. The library is never closed: Mesa leaves
/// thread-local destructors behind that run when the program ends.
inline void* open_library(std::initializer_list<const char*> names) {
  std::string reason;
  for (const char* name : names) {
    if (void* library = dlopen(name, RTLD_NOW | RTLD_LOCAL)) return library;
    if (reason.empty()) reason = dlerror();
  }
  throw ContextError(reason);
}

/// Sets `function` to a function of an open library. Throws ContextError when it has none of that name.
template <typename Function>
void find_function(void* library, const char* name, Function& function) {
  function = reinterpret_cast<Function>(dlsym(library, name));
  if (function == nullptr) throw ContextError(std::string("the library has no ") + name);
}

}  // namespace taut::renderer
