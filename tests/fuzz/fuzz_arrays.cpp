// Any bytes as the output of the importing process. They are refused, or they are exactly the encoding of a model
// that can be used.
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "../models/any_arrays.hpp"
#include "fuzz.hpp"

void taut::test::fuzz_arrays(const std::uint8_t* data, std::size_t size) {
  // Raw bytes seldom pass the checks of lengths. Bytes that begin with 'a' are therefore turned into arrays first.
  if (size > 0 && data[0] == 'a') {
    taut::test::are_taken_and_used({data + 1, size - 1});
    return;
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
}
