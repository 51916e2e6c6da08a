#pragma once

#include <array>
#include <string>
#include <vector>

#include "tailor/flat/pattern.hpp"

namespace taut::tailor {

/// A stretch of a piece's outline. All stretches with the same seam name are sewn together, point by point;
/// a name that occurs once is an open border.
struct Side {
  std::string seam;
  bool against_seam = false;  ///< walked from the seam's end to its start
  std::vector<Vec2> line;     ///< counter-clockwise around the piece
};

enum class PieceKind { front, back, left_sleeve, right_sleeve };
inline constexpr std::size_t piece_count = 4;

/// One piece of cloth in its own plane, in metres, seen from the outside.
struct Piece {
  PieceKind kind;
  std::vector<Side> sides;  ///< in order around the piece, each beginning where the last one ended

  std::vector<Vec2> outline() const;
};

/// Front, back, left and right sleeve, unfolded from the pattern's halves. Left is the wearer's left. On the
/// front, x runs to the wearer's left; on the back, seen from behind, to the wearer's right.
std::array<Piece, piece_count> cut_pieces(const Pattern& pattern);

}  // namespace taut::tailor
