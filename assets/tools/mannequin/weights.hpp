#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tailor/mannequin/body.hpp"

namespace taut::tailor {

/// Joints that a vertex follows, the strongest first, with float weights whose sum is 1. Unused entries are joint 0
/// with weight 0.
struct VertexWeights {
  std::array<std::uint8_t, 4> joints{};
  std::array<float, 4> weights{};
};

/// Returns the weights of every vertex of the whole body. Mirror images have mirrored weights.
std::vector<VertexWeights> make_weights(const Body& body, const FittedBody& fitted);

}  // namespace taut::tailor
