#pragma once

#include <array>
#include <string>
#include <vector>

#include "sim/mesh/mesh.hpp"
#include "tailor/flat/pieces.hpp"

namespace taut::tailor {

using sim::Index;
using sim::Triangle;
using sim::Vec3;

/// A seam or an open border. It is sampled once for all pieces that meet there.
struct Seam {
  std::string name;
  std::vector<double> fractions;  ///< of the seam's length, ascending from 0 to 1
  std::vector<Index> vertices;    ///< of the shirt, one per fraction
};

/// A triangulated piece. Its points count from 0; the outline comes first, in order.
struct Panel {
  PieceKind kind;
  std::vector<Vec2> flat_m;         ///< per point: its place in the flat piece
  std::vector<Index> vertices;      ///< per point: the vertex of the shirt that it became
  std::size_t outline_count = 0;    ///< points on the outline
  std::vector<Triangle> triangles;  ///< indices of points, counter-clockwise seen from outside
};

/// The sewn shirt: triangles and flat lengths, but no positions in space.
struct Shirt {
  std::vector<Seam> seams;
  std::array<Panel, piece_count> panels;
  std::size_t vertex_count = 0;

  /// Triangles of all panels in order, as indices of vertices of the shirt.
  std::vector<Triangle> triangles() const;

  /// The seam with this name. Throws std::out_of_range if there is none.
  const Seam& seam(const std::string& name) const;
};

}  // namespace taut::tailor
