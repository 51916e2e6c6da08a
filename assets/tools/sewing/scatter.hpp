#pragma once

#include <cstddef>

#include "tailor/flat/random.hpp"
#include "tailor/sewing/shirt.hpp"

namespace taut::tailor {

/// Adds exactly `count` interior points to a panel that has only its outline, and triangulates it. The points
/// are irregular but evenly spaced. `edge_length_m` is the intended distance between them.
void fill_panel(Panel& panel, std::size_t count, double edge_length_m, Random& random);

}  // namespace taut::tailor
