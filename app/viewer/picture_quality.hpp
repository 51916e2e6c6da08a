#pragma once

#include <array>

#include "renderer/frame_view.hpp"

namespace taut::app {

/// How well the scene is drawn, as far as the machine allows.
struct PictureQuality {
  int samples = 4;
  int shadow_map_px = 2048;
  int sky_directions = 24;
  float scale = 1.0F;  ///< of the drawing's width and height to the window's

  bool operator==(const PictureQuality&) const = default;
};

/// From best to cheapest: first samples give way, then the sky's shade and the size of shadows, and only then
/// the resolution.
inline constexpr std::array<PictureQuality, 6> picture_qualities = {{{4, 2048, 24, 1.0F},
                                                                     {1, 2048, 24, 1.0F},
                                                                     {1, 1024, 12, 1.0F},
                                                                     {1, 1024, 6, 1.0F},
                                                                     {1, 1024, 6, 0.75F},
                                                                     {1, 512, 0, 0.5F}}};

/// Chooses the quality by how long frames took.
class QualityControl {
 public:
  /// What a frame that moves is to be drawn with.
  const PictureQuality& moving() const { return picture_qualities[level_]; }
  std::size_t level() const { return level_; }

  /// A frame of the moving picture took so long to draw.
  void note(double measured_ms);

  static constexpr double longest_ms = 26.0;  ///< above: cheaper; leaves room for the rest of 1/30 s
  static constexpr double enough_ms = 11.0;   ///< below: dearer, which at most about doubles the time

 private:
  std::size_t level_ = 1;
  double mean_ms_ = 0.0;
  int frames_ = 0;  ///< since the level changed
};

}  // namespace taut::app
