#pragma once

#include <array>
#include <cstddef>

namespace taut::app {

/// How well the scene is drawn, as far as the machine allows. Always at the window's resolution: a software
/// rasteriser takes as long to stretch a picture of half the size as to draw the whole one.
struct PictureQuality {
  int samples = 4;
  int shadow_map_px = 2048;
  int shadow_taps = 16;
  int sky_directions = 24;
  int shading_px = 1;  ///< side of the square of pixels that are shaded as one
  double cost = 1.0;   ///< of a frame with all that belongs to it, relative to the cheapest

  bool operator==(const PictureQuality&) const = default;
};

/// From best to cheapest: first the sky's shade and the size of shadows give way, then samples, then the
/// resolution of the surfaces' shading.
inline constexpr std::array<PictureQuality, 6> picture_qualities = {{{4, 2048, 16, 24, 1, 2.6},
                                                                     {4, 1024, 16, 12, 1, 2.3},
                                                                     {1, 1024, 8, 6, 1, 1.5},
                                                                     {1, 512, 6, 6, 2, 1.2},
                                                                     {1, 256, 6, 4, 2, 1.1},
                                                                     {1, 256, 4, 0, 2, 1.0}}};

/// Chooses the quality by how long frames took: 30 of them a second, as well as that allows. Where drawing
/// takes processors from the simulation, the picture gives way as well, and in the end its rate.
class QualityControl {
 public:
  /// One of picture_qualities, for what a frame that moves is to be drawn with.
  std::size_t level() const { return level_; }

  /// How long the window is to rest after a frame, so that the simulation gets on.
  double rest_ms() const { return rest_ms_; }

  /// All the work for a frame in which the scene was drawn took so long; meanwhile the simulation waited for
  /// a processor so long that it gave time up.
  void note(double frame_ms, double given_up_ms);

  static constexpr double longest_ms = 32.0;  ///< above: cheaper; leaves a little of 1/30 s
  static constexpr double most_rest_ms = 40.0;

 private:
  void go_to(std::size_t level);
  void note_simulation(double share_given_up);
  bool is_too_slow();
  bool has_time_for_better() const;

  std::size_t level_ = 2;
  double mean_ms_ = 0.0;
  double given_up_ = 0.0;  ///< mean share of the time
  double rest_ms_ = 0.0;
  int frames_ = 0;                 ///< since the level changed
  int slow_frames_ = 0;            ///< in a row
  int patience_ = least_patience;  ///< frames that have to be fast enough before a dearer level is tried
  bool is_trial_ = false;          ///< the level is dearer than the one before, and new

  static constexpr int least_patience = 90;
};

}  // namespace taut::app
