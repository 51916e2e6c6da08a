#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/drawing/drawn_scene.hpp"
#include "app/figures/experiments/drape_test.hpp"
#include "app/figures/experiments/recording.hpp"
#include "app/figures/print.hpp"
#include "app/scene/fabric.hpp"

namespace taut::app {

/// A fabric and how it draped on each of several meshes, in the order of the meshes.
struct DrapedFabric {
  Fabric fabric;
  DrawnScene scene;  ///< made of it; without a garment
  std::vector<DrapeRun> runs;

  double mean_percent() const;
  /// Half of the way from the smallest to the largest coefficient.
  double spread_percent() const;
  /// "7" or "6-8".
  std::string folds() const;
};

/// The last disc of each fabric, seen from above, with what was measured of all.
Drawing draw_drapes(std::span<const DrapedFabric> fabrics, LazyOffscreenRenderer& offscreen);

/// Returns `scene`, named in its title, made of a fabric of this name or file. Throws UsageError if there is
/// none.
DrawnScene made_of(DrawnScene scene, const std::string& fabric);

/// One scene made of several fabrics, at the end of each recording. The scenes' titles stand below.
Drawing draw_fabrics(std::span<const Recording> recordings, LazyOffscreenRenderer& offscreen);

}  // namespace taut::app
