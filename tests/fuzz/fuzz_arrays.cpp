// Any bytes as what the importing process hands back: they are refused, or mean what encode makes of them.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>

#include "app/models/model_arrays.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  try {
    const taut::app::ModelArrays model = taut::app::decode(bytes);
    if (taut::app::encode(model).size() != bytes.size()) {
      std::abort();
    }
  } catch (const std::runtime_error&) {
  }
  return 0;
}
