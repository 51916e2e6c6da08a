#pragma once

#include "sim/garment.hpp"
#include "sim/solvers/bounded/layout.hpp"

namespace taut::sim::bounded {

/// By row, each vertex's tether to a pin. All pins move alike.
struct Tethers {
  std::vector<Index> pin;  ///< row of the pin
  Lanes<Tether> lanes;
};

/// Long-range attachments (Kim, Chentanez and Mueller-Fischer 2012): no point of the cloth can be further
/// from the nearest pin than the way along the cloth is long. What a sweep hands down from spring to spring,
/// one a step, a tether brings to every vertex at once.
///
/// A bound on stretch lets tethers be a little longer.
Tethers make_tethers(const Garment& garment, const Layout& layout, double max_stretch);

/// Sets where each vertex is from its pin when a frame begins.
void start_tethers(const StartRows& start, Tethers& tethers);

}  // namespace taut::sim::bounded
