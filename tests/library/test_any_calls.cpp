#include <gtest/gtest.h>

#include <chrono>
#include <random>
#include <vector>

#include "any_calls.hpp"

namespace taut::test {
namespace {

// Random calls for one second; tests/fuzz/fuzz_library.cpp searches further.
TEST(Library, AnyCallsWithAnyArgumentsEndInAResult) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(1);
  CallsMade all;
  for (unsigned seed = 1; seed <= 2000 && std::chrono::steady_clock::now() < end; ++seed) {
    std::mt19937 random(seed);
    std::vector<std::uint8_t> bytes(20000);
    for (std::uint8_t& byte : bytes) {
      byte = static_cast<std::uint8_t>(random());
    }
    const CallsMade some = make_any_calls(bytes);
    all.calls += some.calls;
    all.successes += some.successes;
  }
  RecordProperty("calls", all.calls);
  EXPECT_GT(all.successes, all.calls / 5);
  EXPECT_LT(all.successes, all.calls);
}

}  // namespace
}  // namespace taut::test
