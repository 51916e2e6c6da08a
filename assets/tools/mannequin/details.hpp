#pragma once

#include "tailor/mannequin/weights.hpp"

namespace taut::tailor {

/// Adds the shape's details to the fitted mesh: splits edges at details and moves vertices to their surface. Vertices
/// away from details keep their numbers and positions, so that cloth there meets the same surface. New vertices follow
/// the joints of the edges that they split.
void add_details(const Shape& shape, FittedBody& fitted, std::vector<VertexWeights>& weights);

}  // namespace taut::tailor
