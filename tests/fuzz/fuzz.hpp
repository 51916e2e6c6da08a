#pragma once

#include <cstddef>
#include <cstdint>

// Every target has a folder of inputs in corpus.
#define TAUT_EACH_TARGET(each) \
  each(arrays) each(bvh) each(checkpoint) each(fabric) each(library) each(mesh) each(obj) each(pattern) \
  each(pc2) each(picture) each(scene) each(session)

namespace taut::test {

// Each takes any bytes. A fault ends the process.
#define TAUT_DECLARE(name) void fuzz_##name(const std::uint8_t* data, std::size_t size);
TAUT_EACH_TARGET(TAUT_DECLARE)
#undef TAUT_DECLARE

}  // namespace taut::test
