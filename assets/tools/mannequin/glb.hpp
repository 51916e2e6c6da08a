#pragma once

#include <cstdint>
#include <vector>

#include "tailor/mannequin/weights.hpp"

namespace taut::tailor {

/// Returns a skinned body as a binary glTF 2.0 file: one mesh, one skin, no animation. Joints are not turned
/// against each other in the pose as stored. Positions and weights are float, joints bytes, indices of 16
/// bit. Throws std::runtime_error if there are more vertices than those can tell apart.
std::vector<std::uint8_t> make_glb(const std::string& name, const std::string& origin, const Body& body,
                                   const sim::Mesh& mesh, const std::vector<VertexWeights>& weights);

}  // namespace taut::tailor
