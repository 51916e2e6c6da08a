#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tailor/flat/planar.hpp"

namespace taut::tailor {

/// The outlines a pattern file holds, in metres, y up (the file is in millimetres, y down, as patterns are
/// drafted). Every line runs counter-clockwise around its piece, seen from the outside of the cloth.
struct HalfBody {
  std::vector<Vec2> hem, side_seam, armhole, shoulder_seam, neckline;  ///< from the fold, x = 0, to the fold
};

struct RightSleeve {
  std::vector<Vec2> cuff, underarm_front, cap_front, cap_back, underarm_back;
};

struct Pattern {
  HalfBody front;
  HalfBody back;
  RightSleeve sleeve;
  std::string source;  ///< who drafted it, for the header of what is made from it
  std::string licence;
};

/// Throws std::runtime_error naming the file and the field on anything missing or malformed, on segments that
/// do not join and on seams whose two sides differ by more than 1 mm.
Pattern read_pattern(const std::filesystem::path& file);

}  // namespace taut::tailor
