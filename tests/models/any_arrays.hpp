#pragma once

#include <cstdint>
#include <span>

#include "app/models/model_arrays.hpp"

namespace taut::test {

/// Arrays made of these bytes: small models with joints, animations and colours in which hardly anything is certain.
app::ModelArrays any_arrays(std::span<const std::uint8_t> bytes);

/// Does with arrays that came from another process what the program does: as a garment and as a body.
/// Throws what the program catches.
void use_arrays(const app::ModelArrays& arrays);

/// Encodes such arrays, decodes them, and uses them if they are taken. Returns whether they were.
bool are_taken_and_used(std::span<const std::uint8_t> bytes);

}  // namespace taut::test
