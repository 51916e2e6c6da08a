#pragma once

#include <vector>

#include "app/fitting/sheets.hpp"

namespace taut::app {

/// Turns sheets so that they face outwards: closed ones by their volume, open ones to where they see less of the garment.
void turn_outwards(Sheets& sheets);

/// By triangle, how far through the material, in m, the other wall of the same cloth is: along the way inwards, facing the other way. Infinite
/// where there is none within some 12 mm. Requires sheets that face outwards.
struct OtherWall {
  std::vector<sim::Index> triangle;  ///< by triangle: the one on the other side, or none
};
OtherWall find_other_walls(const Sheets& sheets);

/// The share of all area that has another wall.
double share_of_two_walls(const Sheets& sheets, const OtherWall& other);

/// Chooses one wall of cloth that has two, and of sheets that lie on each other the larger. Returns 1 for each triangle
/// that is kept. Requires sheets that face outwards.
std::vector<char> choose_walls(const Sheets& sheets, const OtherWall& other);

}  // namespace taut::app
