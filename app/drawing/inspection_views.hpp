#pragma once

#include <array>

#include "app/drawing/drawn_scene.hpp"
#include "app/models/garment_loading.hpp"

namespace taut::app {

constexpr int inspection_panel_px = 1000;  ///< width of one view

/// Two views of the garment as it was modelled, of one size and one scale.
struct InspectionViews {
  struct Side {
    const char* name;
    DrawnScene scene;
  };
  std::array<Side, 2> sides;
  float px_per_m = 0.0F;  ///< at the distance of the garment's middle
  int height_px = 0;      ///< of each view; as small as the garment allows
};

/// Makes the views from the scene that was asked for.
InspectionViews inspection_views(const DrawnScene& asked, const sim::Garment& garment,
                                 std::span<const sim::Index> pins);

}  // namespace taut::app
