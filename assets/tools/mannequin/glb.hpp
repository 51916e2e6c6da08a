#pragma once

#include <cstdint>
#include <vector>

#include "tailor/mannequin/weights.hpp"

namespace taut::tailor {

/// Returns a skinned body as a binary glTF 2.0 file with one mesh, one skin and no animation. Joints are not rotated in
/// the stored pose. Positions and weights are floats, joints bytes, indices 16 bits. Throws std::runtime_error if there
/// are too many vertices for these indices.
std::vector<std::uint8_t> make_glb(const std::string& name, const std::string& origin, const Body& body,
                                   const sim::Mesh& mesh, const std::vector<VertexWeights>& weights);

}  // namespace taut::tailor
