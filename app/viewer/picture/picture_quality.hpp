#pragma once

#include "prelude.hpp"

namespace taut::app {

/// How well the scene is drawn. The resolution is always that of the window: with software rendering,
/// enlarging a picture of half the size costs as much as drawing the whole one.
struct PictureQuality {
  int samples = 4;           ///< per pixel
  int shadow_map_px = 2048;  ///< width and height of the shadow map
  int shadow_taps = 16;      ///< samples of the shadow map per pixel
  int sky_directions = 24;   ///< directions in which shadow from the sky is computed; 0: none
  int shading_px = 1;        ///< shading is computed once per square of this side
  /// As of GarmentPainter::look_from: the simulated edges of a T-shirt are 7 in a small window.
  float shortest_edge_px = 8.0F;
  double cost = 1.0;  ///< of a whole frame, relative to the cheapest quality

  bool operator==(const PictureQuality&) const = default;
};

/// From best to cheapest. First the sky's shadow and the size of the shadow map are reduced, then samples,
/// then the resolution of shading.
inline constexpr std::array<PictureQuality, 6> picture_qualities = {{{4, 2048, 16, 24, 1, 8, 2.9},
                                                                     {4, 1024, 16, 12, 1, 8, 2.6},
                                                                     {1, 1024, 8, 6, 1, 12, 1.5},
                                                                     {1, 512, 6, 6, 2, 24, 1.2},
                                                                     {1, 256, 6, 4, 2, 24, 1.1},
                                                                     {1, 256, 4, 0, 2, 24, 1.0}}};

/// Chooses the best quality that still allows 30 frames per second. If drawing takes processors away from the
/// simulation, quality is reduced further, and at last the frame rate.
class QualityControl {
 public:
  /// Index into picture_qualities, for frames in which something moves.
  std::size_t level() const { return level_; }

  /// How long the window has to pause after a frame, so that the simulation gets processors.
  double rest_ms() const { return rest_ms_; }

  /// Takes the duration of a frame in which the scene was drawn. Also takes the simulated time that was given
  /// up meanwhile because no processor was free.
  void note(double frame_ms, double given_up_ms);

  static constexpr double longest_ms = 32.0;  ///< longer frames reduce the quality; a little less than 1/30 s
  /// Longest pause after a frame; more would make the window slower.
  static constexpr double most_rest_ms = 40.0;

 private:
  void go_to(std::size_t level);
  void note_simulation(double share_given_up);
  bool is_too_slow();
  bool has_time_for_better() const;

  std::size_t level_ = 2;
  double mean_ms_ = 0.0;
  double given_up_ = 0.0;  ///< mean fraction of simulated time that was given up
  double rest_ms_ = 0.0;
  int frames_ = 0;                 ///< since the level changed
  int slow_frames_ = 0;            ///< in a row
  int patience_ = least_patience;  ///< frames that must be fast enough before a better level is tried
  bool is_trial_ = false;          ///< the level is better than the one before and not yet proven

  static constexpr int least_patience = 90;
};

}  // namespace taut::app
