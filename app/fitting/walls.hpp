#pragma once

#include "app/fitting/sheets.hpp"

namespace taut::app {

/// Turns sheets so that they face outwards: closed ones by their volume, open ones to where they see less of
/// the garment.
void turn_outwards(Sheets& sheets);

/// By triangle, the triangle of the other wall of the same cloth: within some 12 mm on the way inwards,
/// facing the other way; none where there is one wall. Requires sheets that face outwards.
using OtherWalls = std::vector<sim::Index>;
OtherWalls find_other_walls(const Sheets& sheets);

/// The share of all area that has another wall.
double share_of_two_walls(const Sheets& sheets, const OtherWalls& other);

/// Chooses one wall of cloth that has two, and of sheets that lie on each other the larger. Returns 1 for
/// each triangle that is kept. Requires sheets that face outwards.
std::vector<char> choose_walls(const Sheets& sheets, const OtherWalls& other);

}  // namespace taut::app
