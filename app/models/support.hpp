#pragma once

#include <vector>

#include "app/models/garment_parts.hpp"

namespace taut::app {

/// The openings that are no holes or faults, for as long as the part is there.
std::vector<const Opening*> large_openings(const GarmentPart& part);

/// Returns whether the part hangs in balance when it is held over this range: its centre of mass lies within,
/// seen from above, or hardly beside.
bool carries(const GarmentPart& part, const sim::Extent& held);

/// Returns whether an opening is as far out as cuffs are when arms are stretched out.
bool has_sleeves(const GarmentPart& part);

/// Returns the highest level opening that carries an upright part; nullptr if there is none. The only border
/// of a part is its outline and no opening.
const Opening* top_opening(const GarmentPart& part);

/// Returns the waist of a part that lies flat, which is the narrowest opening that carries it; nullptr if
/// there is none.
const Opening* inner_opening(const GarmentPart& part);

/// Returns the vertices of the two highest openings that carry the part together, such as the armholes of a
/// dress with straps. Empty if there are none.
std::vector<sim::Index> pair_of_openings(const GarmentPart& part);

}  // namespace taut::app
