#pragma once

#include <vector>

#include "tailor/dressing/body.hpp"
#include "tailor/sewing/shirt.hpp"

namespace taut::tailor {

/// A first guess of where the vertices of the sewn shirt lie around the wearer: front and back bent around
/// half ellipses, sleeves rolled around the arms, and the mean of those wherever pieces meet.
std::vector<Vec3> wrap_shirt(const Shirt& shirt, const Stance& stance);

}  // namespace taut::tailor
