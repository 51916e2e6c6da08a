#pragma once

#include <dlfcn.h>

#include <initializer_list>
#include <string>

#include "renderer/context/context.hpp"

namespace taut::renderer {

/// The first of the names that the system's linker finds. Throws ContextError with the linker's reason for
/// the first. Never closed: Mesa leaves thread-local destructors behind that run when the program ends.
inline void* open_library(std::initializer_list<const char*> names) {
  std::string reason;
  for (const char* name : names) {
    if (void* library = dlopen(name, RTLD_NOW | RTLD_LOCAL)) return library;
    if (reason.empty()) reason = dlerror();
  }
  throw ContextError(reason);
}

/// Throws ContextError when the library has no such function.
template <typename Function>
void find_function(void* library, const char* name, Function& function) {
  function = reinterpret_cast<Function>(dlsym(library, name));
  if (function == nullptr) throw ContextError(std::string("the library has no ") + name);
}

}  // namespace taut::renderer
