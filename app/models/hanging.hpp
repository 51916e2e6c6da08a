#pragma once

#include "app/scene/scene.hpp"

namespace taut::app {

/// Which vertices of a part are pinned.
enum class HungBy {
  /// the border at its top that carries it in balance, such as a neckline or a waist; of a part that lies
  /// flat the one around its middle
  top_opening,
  highest_band,  ///< the vertices in the upper 3 % of its height
  back_edge,     ///< for a part that lies flat: its edge farthest back
  neck,          ///< the narrowest place between a hood and the shoulders
  straps,        ///< the tops of its straps
  shoulders,     ///< the highest vertices on either side of its centre of mass
  hanger,        ///< no vertices, but bars below its shoulders
};

/// A connected part of a garment, and how it is pinned.
struct HungPart {
  HungBy by = HungBy::highest_band;
  std::size_t vertices = 0;
  std::size_t pins = 0;
  double area_m2 = 0.0;
  bool closed = false;  ///< it has no border
  bool flat = false;    ///< its thickness is at most 2 % of its size
};

/// The pins of a garment whose scene names none.
struct Hanging {
  std::vector<sim::Index> pins;        ///< ascending
  std::vector<HungPart> parts;         ///< ordered by their first vertex
  std::vector<sim::Body> hanger = {};  ///< bars that carry its largest part; empty: it is held by pins
};

/// Chooses pins for every connected part by itself, as a hanger would hold it: what is held lies above the
/// centre of mass seen from above, where the part has such a place. A part without pins would fall out of the
/// picture.
Hanging hang(const sim::Mesh& mesh, const sim::Adjacency& adjacency);

/// As above, but puts the largest part on a hanger (hanger.hpp) if it has shoulders and no neckline or waist
/// to hold it by, and if there is room for one.
Hanging hang_as_in_a_shop(const sim::Mesh& mesh, const sim::Adjacency& adjacency);

/// One line per part, for at most twelve parts, with remarks on closed and flat parts.
std::vector<std::string> describe(const Hanging& hanging);

/// Hangs a model with its y axis up and with its z axis up for a second each, and returns the axis with which
/// it is higher and its cloth moved less: a garment that hangs the right way up is nearly where it was
/// modelled, and all of it can be seen. Of a flat pattern that lies, -z if it is the wider end that z would
/// have at the top. Empty if both are alike, or if there is nothing to hang it by. In metres; takes the time
/// of 120 frames without contact.
std::optional<ModelAxis> up_by_hanging(const sim::Mesh& model_m);

}  // namespace taut::app
