#pragma once

#include "sim/garment.hpp"
#include "sim/solvers/bounded/layout.hpp"

namespace taut::sim::bounded {

/// The tethers of a cloth: one entry per row, spare rows included. Where pins go ways of their own, tethers
/// are left out of the step.
struct Tethers {
  std::vector<Index> pin;  ///< the row of the pin
  Lanes<Tether> lanes;
};

/// Makes the tethers of a cloth: long-range attachments (Kim, Chentanez and Mueller-Fischer 2012). A vertex
/// cannot be farther from its nearest pin than the way along the cloth, made longer by the part `slack` of
/// it. A sweep hands a correction on by one spring per step; a tether corrects every
/// vertex at once.
Tethers make_tethers(const Garment& garment, const Layout& layout, double slack);

/// Sets the vectors from the pins to the vertices at the start of a frame.
void start_tethers(const StartRows& start, Tethers& tethers);

}  // namespace taut::sim::bounded
