#pragma once

#include <array>
#include <string>
#include <vector>

#include "tailor/flat/pattern.hpp"

namespace taut::tailor {

/// A part of a piece's outline. All sides with the same seam name are sewn together, point by point. A name
/// that occurs once is an open border.
struct Side {
  std::string seam;
  bool against_seam = false;  ///< the line runs from the seam's end to its start
  std::vector<Vec2> line;     ///< counter-clockwise around the piece
};

/// The pieces of a T-shirt.
enum class PieceKind { front, back, left_sleeve, right_sleeve };
inline constexpr std::size_t piece_count = 4;

/// One piece of cloth in its own plane, in metres, seen from outside.
struct Piece {
  PieceKind kind;
  std::vector<Side> sides;  ///< in order around the piece; each begins where the one before ends

  /// All sides as one closed line, without repeating the first point.
  std::vector<Vec2> outline() const;
};

/// Unfolds the pattern's halves into front, back, left sleeve and right sleeve. Left is the wearer's left. On
/// the front, x points to the wearer's left. On the back, which is seen from behind, it points to the
/// wearer's right.
std::array<Piece, piece_count> cut_pieces(const Pattern& pattern);

}  // namespace taut::tailor
