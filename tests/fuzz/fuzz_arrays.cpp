// Any bytes as the output of the importing process. They are refused, or they are exactly the encoding of a model
// that can be used.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "../models/any_arrays.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // Raw bytes seldom pass the checks of lengths. Bytes that begin with 'a' are therefore turned into arrays first.
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
