#pragma once

#include <array>

#include "app/drawing/drawn_scene.hpp"
#include "app/models/garment_loading.hpp"

namespace taut::app {

constexpr int inspection_panel_px = 1000;  ///< the width of one side's picture

/// The garment as it was modelled from two sides, on pictures of one size and at one scale.
struct InspectionViews {
  struct Side {
    const char* name;
    DrawnScene scene;
  };
  std::array<Side, 2> sides;
  float px_per_m = 0.0F;  ///< at the middle of the garment
  int height_px = 0;      ///< of each picture: as low as the garment allows
};

InspectionViews inspection_views(const DrawnScene& asked, const sim::Garment& garment,
                                 std::span<const sim::Index> pins);

}  // namespace taut::app
