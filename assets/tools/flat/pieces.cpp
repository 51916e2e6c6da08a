#include "tailor/flat/pieces.hpp"

#include <algorithm>

namespace taut::tailor {
namespace {

/// The same line on the other half of the piece, turned round so that it stays counter-clockwise.
std::vector<Vec2> mirrored(const std::vector<Vec2>& line) {
  std::vector<Vec2> result;
  for (auto point = line.rbegin(); point != line.rend(); ++point) {
    result.emplace_back(-point->x, point->y);
  }
  return result;
}

std::vector<Vec2> joined(std::vector<Vec2> first, const std::vector<Vec2>& second) {
  first.insert(first.end(), second.begin() + 1, second.end());
  return first;
}

Piece cut_body(PieceKind kind, const HalfBody& half) {
  const bool is_front = kind == PieceKind::front;
  const std::string name = is_front ? "front" : "back";
  // The half with positive x lies on this side of the wearer.
  const std::string plus = is_front ? "left" : "right";
  const std::string minus = is_front ? "right" : "left";
  // Every seam has a direction: side seams from the hem up, armholes from the armpit up, shoulder seams from
  // the armhole to the neck. Around one of two pieces sewn together it is walked against that direction.
  return {kind,
          {{name + "_hem", false, joined(mirrored(half.hem), half.hem)},
           {plus + "_side_seam", false, half.side_seam},
           {plus + "_" + name + "_armhole", false, half.armhole},
           {plus + "_shoulder_seam", false, half.shoulder_seam},
           {name + "_neckline", false, joined(half.neckline, mirrored(half.neckline))},
           {minus + "_shoulder_seam", true, mirrored(half.shoulder_seam)},
           {minus + "_" + name + "_armhole", true, mirrored(half.armhole)},
           {minus + "_side_seam", true, mirrored(half.side_seam)}}};
}

Piece cut_right_sleeve(const RightSleeve& sleeve) {
  return {PieceKind::right_sleeve,
          {{"right_cuff", false, sleeve.cuff},
           {"right_underarm", false, sleeve.underarm_front},
           {"right_front_armhole", false, sleeve.cap_front},
           {"right_back_armhole", true, sleeve.cap_back},
           {"right_underarm", true, sleeve.underarm_back}}};
}

Piece cut_left_sleeve(const RightSleeve& sleeve) {
  return {PieceKind::left_sleeve,
          {{"left_cuff", false, mirrored(sleeve.cuff)},
           {"left_underarm", false, mirrored(sleeve.underarm_back)},
           {"left_back_armhole", false, mirrored(sleeve.cap_back)},
           {"left_front_armhole", true, mirrored(sleeve.cap_front)},
           {"left_underarm", true, mirrored(sleeve.underarm_front)}}};
}

}  // namespace

std::vector<Vec2> Piece::outline() const {
  std::vector<Vec2> polygon;
  for (const Side& side : sides) {
    polygon.insert(polygon.end(), side.line.begin(), side.line.end() - 1);
  }
  return polygon;
}

std::array<Piece, piece_count> cut_pieces(const Pattern& pattern) {
  return {cut_body(PieceKind::front, pattern.front), cut_body(PieceKind::back, pattern.back),
          cut_left_sleeve(pattern.sleeve), cut_right_sleeve(pattern.sleeve)};
}

}  // namespace taut::tailor
