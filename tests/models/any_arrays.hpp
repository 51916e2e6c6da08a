#pragma once

#include <cstdint>
#include <span>

#include "app/models/reading/model_arrays.hpp"

namespace taut::test {

/// Makes small models with joints, animations and colours from these bytes. Almost every index and number may be wrong.
app::ModelArrays any_arrays(std::span<const std::uint8_t> bytes);

/// Uses arrays of another process as the program does: as a garment and as a body. Throws only exceptions that the
/// program catches.
void use_arrays(const app::ModelArrays& arrays);

/// Encodes arrays made of the bytes, decodes them, and uses them if they are accepted. Returns whether they were.
bool are_taken_and_used(std::span<const std::uint8_t> bytes);

}  // namespace taut::test
