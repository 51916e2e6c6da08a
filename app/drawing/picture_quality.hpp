#pragma once

#include "renderer/frame_view.hpp"

namespace taut::app {

/// Drawing quality of a scene in the window or the page. The resolution is always theirs: with software rendering,
/// enlarging a picture of half the size costs as much as drawing the whole one.
struct PictureQuality {
  int samples = 4;           ///< per pixel
  int shadow_map_px = 2048;  ///< width and height of the shadow map
  int shadow_taps = 16;      ///< samples of the shadow map per pixel
  int sky_directions = 12;   ///< directions in which the sky's shadow is computed; 0: none
  int shading_px = 1;        ///< side of the squares that share one shading computation
  /// Edge length for GarmentPainter::look_from. The simulated edges of a T-shirt have 7 px in a small window.
  float min_edge_px = 12.0F;
  double cost = 1.0;  ///< cost of a whole frame, relative to the cheapest quality

  bool operator==(const PictureQuality&) const = default;
  /// Sets everything but the edge length.
  void apply(renderer::PictureSettings& settings) const;
};

/// Qualities from best to cheapest, all with smooth outlines. The sky's shadow and the shadow map are reduced first,
/// then samples and the resolution of shading.
inline constexpr std::array<PictureQuality, 6> picture_qualities = {{{4, 2048, 16, 12, 1, 12, 2.9},
                                                                     {4, 1024, 16, 8, 1, 12, 2.7},
                                                                     {1, 1024, 8, 4, 2, 12, 1.7},
                                                                     {1, 512, 6, 4, 2, 24, 1.3},
                                                                     {1, 256, 6, 2, 2, 24, 1.1},
                                                                     {1, 256, 4, 0, 2, 24, 1.0}}};

/// Chooses the best quality that still allows 30 frames per second. If drawing takes processors away from the
/// simulation, it reduces the quality further, and finally the frame rate.
class QualityControl {
 public:
  /// `level`: of the first frames.
  explicit QualityControl(std::size_t level = 2) : level_(level) {}

  /// Returns the index into picture_qualities for frames in which something moves.
  std::size_t level() const { return level_; }

  /// Returns how long the window must pause after a frame to leave processors to the simulation.
  double rest_ms() const { return rest_ms_; }

  /// Updates the quality after a frame that drew the scene. `given_up_ms`: simulated time that was given up meanwhile
  /// because no processor was free.
  void note(double frame_ms, double given_up_ms);

  static constexpr double max_ms = 32.0;  ///< duration above which the quality is reduced; slightly less than 1/30 s
  /// Longest pause after a frame. A longer one would make the window slower.
  static constexpr double max_rest_ms = 40.0;

 private:
  void go_to(std::size_t level);
  void note_simulation(double share_given_up);
  bool is_too_slow();
  bool can_afford_next_level() const;

  std::size_t level_;
  double mean_ms_ = 0.0;
  double given_up_ = 0.0;  ///< mean fraction of simulated time that was given up
  double rest_ms_ = 0.0;
  int frames_ = 0;                        ///< frames since the level changed
  int slow_frames_ = 0;                   ///< consecutive slow frames
  int trial_wait_frames_ = min_patience;  ///< frames that must be fast enough before a better level is tried
  bool is_trial_ = false;                 ///< the level is better than the one before and not yet proven

  static constexpr int min_patience = 90;
};

}  // namespace taut::app
