#include <dlfcn.h>
#include <link.h>

#include "app/base/files.hpp"

namespace taut::app {

std::filesystem::path own_file() {
  Dl_info info{};
  void* map = nullptr;
  const bool is_known = ::dladdr1(reinterpret_cast<void*>(&own_file), &info, &map, RTLD_DL_LINKMAP) != 0;
  // The loader leaves the name of the program itself empty.
  const char* name = is_known && map != nullptr ? static_cast<link_map*>(map)->l_name : "";
  std::error_code error;
  return std::filesystem::canonical(*name != '\0' ? name : "/proc/self/exe", error);
}

}  // namespace taut::app
