#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tailor/flat/planar.hpp"

namespace taut::tailor {

/// Half of the front or the back. Every line runs counter-clockwise around the piece, seen from outside.
/// Metres, y up; the file has millimetres, y down, as patterns are drafted.
struct HalfBody {
  /// In order, from the fold at x = 0 around to the fold.
  std::vector<Vec2> hem, side_seam, armhole, shoulder_seam, neckline;
};

/// The right sleeve, its lines as in HalfBody.
struct RightSleeve {
  std::vector<Vec2> cuff, underarm_front, cap_front, cap_back, underarm_back;
};

/// The outlines of a pattern file.
struct Pattern {
  HalfBody front;
  HalfBody back;
  RightSleeve sleeve;
  std::string source;  ///< who drafted it; written into the header of the garments
  std::string licence;
  std::string wearer = {};           ///< the name of the size; empty: the first, a man's
  double neck_point_height_m = 0.0;  ///< where the wearer's neck and shoulder meet; without a name 0
};

/// Throws std::runtime_error that names the file and the field if something is missing or malformed. Also
/// throws if lines do not join, or if the two sides of a seam differ by more than 1 mm.
Pattern read_pattern(const std::filesystem::path& file);

}  // namespace taut::tailor
