#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace taut::test {

/// Makes calls of libtaut whose order and arguments come from the bytes: handles that are null, stale or invented,
/// numbers that are not finite, impossible sizes of arrays. The test is that nothing crashes.
struct CallsMade {
  int calls = 0;
  int successes = 0;
};
CallsMade make_any_calls(std::span<const std::uint8_t> bytes);

}  // namespace taut::test
