#include "../library/any_calls.hpp"
#include "fuzz.hpp"

// Calls of the library in any order and with any arguments.
void taut::test::fuzz_library(const std::uint8_t* data, std::size_t size) { taut::test::make_any_calls({data, size}); }
