#pragma once

#include <cstddef>

#include "tailor/flat/random.hpp"
#include "tailor/sewing/shirt.hpp"

namespace taut::tailor {

/// Adds exactly `count` interior points to a panel that has only its outline, irregular but evenly spaced,
/// and triangulates it. `edge_length_m` is the spacing aimed at.
void fill_panel(Panel& panel, std::size_t count, double edge_length_m, Random& random);

}  // namespace taut::tailor
