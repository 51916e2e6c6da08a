#pragma once

#include <vector>

#include "tailor/dressing/body.hpp"
#include "tailor/sewing/shirt.hpp"

namespace taut::tailor {

/// A first guess for positions on the wearer, in metres, per vertex of the shirt. Front and back lie on half
/// ellipses, sleeves are rolled around the arms. Where pieces meet it is the mean of both.
std::vector<Vec3> wrap_shirt(const Shirt& shirt, const Stance& stance);

}  // namespace taut::tailor
