#pragma once

#include <array>
#include <cstddef>

namespace taut::app {

/// How well the scene is drawn, as far as the machine allows.
struct PictureQuality {
  int samples = 4;
  int shadow_map_px = 2048;
  int shadow_taps = 16;
  int sky_directions = 24;
  int shading_px = 1;  ///< side of the square of pixels that are shaded as one
  float scale = 1.0F;  ///< of the drawing's width and height to the window's

  bool operator==(const PictureQuality&) const = default;
};

/// From best to cheapest: first the sky's shade and the size of shadows give way, then samples, then the
/// resolution of the surfaces' shading, and only then that of the picture.
inline constexpr std::array<PictureQuality, 7> picture_qualities = {{{4, 2048, 16, 24, 1, 1.0F},
                                                                     {4, 1024, 16, 12, 1, 1.0F},
                                                                     {1, 1024, 8, 6, 1, 1.0F},
                                                                     {1, 512, 6, 6, 2, 1.0F},
                                                                     {1, 256, 6, 4, 2, 1.0F},
                                                                     {1, 256, 6, 4, 2, 0.65F},
                                                                     {1, 256, 6, 0, 2, 0.5F}}};

/// Chooses the quality by how long frames took: 30 of them a second, as well as that allows.
class QualityControl {
 public:
  /// What a frame that moves is to be drawn with.
  const PictureQuality& moving() const { return picture_qualities[level_]; }
  std::size_t level() const { return level_; }

  /// All the work for a frame in which the scene was drawn took so long.
  void note(double frame_ms);

  static constexpr double longest_ms = 30.0;  ///< above: cheaper; leaves a little of 1/30 s
  static constexpr double enough_ms = 18.0;   ///< below: dearer, which takes about half as long again

 private:
  void go_to(std::size_t level);

  std::size_t level_ = 2;
  double mean_ms_ = 0.0;
  int frames_ = 0;                 ///< since the level changed
  int patience_ = least_patience;  ///< frames that have to be fast enough before a dearer level is tried
  bool is_trial_ = false;          ///< the level is dearer than the one before, and new

  static constexpr int least_patience = 90;
};

}  // namespace taut::app
