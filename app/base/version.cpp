#include "app/base/version.hpp"

namespace taut::app {

std::string program_version() { return TAUT_VERSION; }

std::string compiler_version() {
#if defined(__clang__)
  return "Clang " __clang_version__;
#else
  return "GCC " __VERSION__;
#endif
}

}  // namespace taut::app
