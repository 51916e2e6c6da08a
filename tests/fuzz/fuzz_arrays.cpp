// Any bytes as what the importing process hands back: they are refused, or mean what encode makes of them, and can be
// used.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "../models/any_arrays.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // Bytes as they are seldom get further than the lengths: others begin with a letter and become arrays first.
  if (size > 0 && data[0] == 'a') {
    taut::test::are_taken_and_used({data + 1, size - 1});
    return 0;
  }
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  try {
    const taut::app::ModelArrays model = taut::app::decode(bytes);
    if (taut::app::encode(model).size() != bytes.size()) {
      std::abort();
    }
    taut::test::use_arrays(model);
  } catch (const std::runtime_error&) {
  }
  return 0;
}
