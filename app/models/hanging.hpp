#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "sim/mesh/adjacency.hpp"
#include "sim/mesh/mesh.hpp"

namespace taut::app {

/// Which vertices of a part are pinned.
enum class HungBy {
  top_opening,   ///< the border loop at its top, such as a neckline or a waist
  highest_band,  ///< the vertices in the upper 3 % of its height
  back_edge,     ///< for a part that lies flat: its edge farthest back
};

/// A connected part of a garment, and how it is pinned.
struct HungPart {
  HungBy by = HungBy::highest_band;
  std::size_t vertices = 0;
  std::size_t pins = 0;
  bool closed = false;  ///< it has no border
  bool flat = false;    ///< its thickness is at most 2 % of its size
};

/// The pins of a garment whose scene names none.
struct Hanging {
  std::vector<sim::Index> pins;  ///< ascending
  std::vector<HungPart> parts;   ///< ordered by their first vertex
};

/// Chooses pins for every connected part by itself. A part without pins would fall out of the picture.
Hanging hang(const sim::Mesh& mesh, const sim::Adjacency& adjacency);

/// One line per part, for at most twelve parts, with remarks on closed and flat parts.
std::vector<std::string> describe(const Hanging& hanging);

}  // namespace taut::app
