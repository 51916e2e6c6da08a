#pragma once

#include "tailor/mannequin/weights.hpp"

namespace taut::tailor {

/// Puts the details of the shape on the fitted mesh: splits edges where details are, and moves vertices to
/// their surface. Vertices away from details keep their numbers and places, so that cloth there meets what it
/// met without them. New vertices follow the joints of the edges that they were put on.
void add_details(const Shape& shape, FittedBody& fitted, std::vector<VertexWeights>& weights);

}  // namespace taut::tailor
