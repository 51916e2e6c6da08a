#include "../library/any_calls.hpp"

// Calls of the library in any order and with any arguments.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  taut::test::make_any_calls({data, size});
  return 0;
}
