#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace taut::test {

/// Makes calls of libtaut in an order and with arguments that the bytes say: null and stale and made up
/// handles, numbers that are none, sizes that no array has. Returns how many calls were made and how many
/// succeeded. That nothing crashes is the test.
struct CallsMade {
  int calls = 0;
  int successes = 0;
};
CallsMade make_any_calls(std::span<const std::uint8_t> bytes);

}  // namespace taut::test
