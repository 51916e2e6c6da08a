#pragma once

#include "app/scene/scene.hpp"

namespace taut::app {

/// Vertices of a part that are pinned.
enum class HungBy {
  /// border at its top that carries it in balance, such as a neckline or a waist; border around the middle of a part
  /// that lies flat
  top_opening,
  highest_band,  ///< vertices in the upper 3 % of its height
  back_edge,     ///< farthest back edge of a part that lies flat
  neck,          ///< narrowest place between a hood and the shoulders
  straps,        ///< tops of its straps
  shoulders,     ///< highest vertices on either side of its centre of mass
  hanger,        ///< no vertices, but bars below its shoulders
};

/// A connected part of a garment and its pins.
struct HungPart {
  HungBy by = HungBy::highest_band;
  std::size_t vertices = 0;
  std::size_t pins = 0;
  double area_m2 = 0.0;
  bool closed = false;  ///< true if it has no border
  bool flat = false;    ///< true if its thickness is at most 2 % of its size
};

/// Pins of a garment whose scene names none.
struct Hanging {
  std::vector<sim::Index> pins;        ///< ascending
  std::vector<HungPart> parts;         ///< ordered by their first vertex
  std::vector<sim::Body> hanger = {};  ///< bars that carry its largest part; empty if pins hold it
};

/// Chooses pins for every connected part by itself, as a hanger would hold it: above its centre of mass, if it has such
/// a place. A part without pins would fall out of the picture.
Hanging hang(const sim::Mesh& mesh, const sim::Adjacency& adjacency);

/// Chooses pins likewise, but puts the largest part on a hanger (hanger.hpp) if it has shoulders, no neckline or waist
/// to hold it by, and space for one.
Hanging hang_as_in_a_shop(const sim::Mesh& mesh, const sim::Adjacency& adjacency);

/// Returns a line for each of at most twelve parts, with remarks on closed and flat parts.
std::vector<std::string> describe(const Hanging& hanging);

/// Hangs a model with its y axis up and with its z axis up for a second each. Returns the axis with which it is higher
/// and its cloth moves less: a garment that hangs the right way up is nearly where it was modelled, and all of it can
/// be seen. Returns -z for a flat pattern that lies if z would have its wider end at the top, or its sleeves below.
/// Empty if both are alike, or if there is nothing to hang it by. Positions are in metres. The function takes the time
/// of 120 frames without contact.
std::optional<ModelAxis> up_by_hanging(const sim::Mesh& model_m);

}  // namespace taut::app
