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

/// A seam or an open border, sampled once for all pieces that meet there.
struct Seam {
  std::string name;
  std::vector<double> fractions;  ///< of its length, ascending from 0 to 1
  std::vector<Index> vertices;    ///< of the shirt, one per fraction
};

/// A triangulated piece. Its points are numbered from 0, those of the outline first and in order.
struct Panel {
  PieceKind kind;
  std::vector<Vec2> flat_m;     ///< where each point lies in the flat piece
  std::vector<Index> vertices;  ///< which vertex of the shirt each point became
  std::size_t outline_count = 0;
  std::vector<Triangle> triangles;  ///< of points, counter-clockwise seen from outside
};

/// Which triangles and which flat lengths, but not yet where: the topology of the sewn shirt.
struct Shirt {
  std::vector<Seam> seams;
  std::array<Panel, piece_count> panels;
  std::size_t vertex_count = 0;

  /// Of all panels in order, as vertices of the shirt.
  std::vector<Triangle> triangles() const;

  /// Throws std::out_of_range.
  const Seam& seam(const std::string& name) const;
};

}  // namespace taut::tailor
