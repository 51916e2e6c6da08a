#pragma once

#include <cstddef>
#include <cstdint>

namespace taut::test {

// Each takes any bytes. A fault ends the process.
void fuzz_arrays(const std::uint8_t* data, std::size_t size);
void fuzz_bvh(const std::uint8_t* data, std::size_t size);
void fuzz_checkpoint(const std::uint8_t* data, std::size_t size);
void fuzz_fabric(const std::uint8_t* data, std::size_t size);
void fuzz_library(const std::uint8_t* data, std::size_t size);
void fuzz_mesh(const std::uint8_t* data, std::size_t size);
void fuzz_obj(const std::uint8_t* data, std::size_t size);
void fuzz_pattern(const std::uint8_t* data, std::size_t size);
void fuzz_pc2(const std::uint8_t* data, std::size_t size);
void fuzz_picture(const std::uint8_t* data, std::size_t size);
void fuzz_scene(const std::uint8_t* data, std::size_t size);
void fuzz_session(const std::uint8_t* data, std::size_t size);

}  // namespace taut::test
