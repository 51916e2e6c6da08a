#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "sim/mesh/adjacency.hpp"
#include "sim/mesh/mesh.hpp"

namespace taut::app {

enum class HungBy {
  top_opening,   ///< the border loop at its top: a neckline, a waist
  highest_band,  ///< what is in the upper 3 % of its height
  back_edge,     ///< it lies flat, so there is no top: its edge farthest back
};

/// A part of a garment that nothing joins to the others, and how it is held.
struct HungPart {
  HungBy by = HungBy::highest_band;
  std::size_t vertices = 0;
  std::size_t pins = 0;
  bool closed = false;  ///< no border anywhere
  bool flat = false;    ///< as thin as a piece of cloth on a table
};

struct Hanging {
  std::vector<sim::Index> pins;  ///< ascending
  std::vector<HungPart> parts;   ///< by their first vertex
};

/// How a garment of which nothing else is known is held: every part by itself, since a part that is not held
/// would fall out of the picture.
Hanging hang(const sim::Mesh& mesh, const sim::Adjacency& adjacency);

/// A line for every part, for at most a dozen of them, and for what a tailor should know.
std::vector<std::string> describe(const Hanging& hanging);

}  // namespace taut::app
