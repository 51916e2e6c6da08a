#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "app/base/job_runner.hpp"
#include "app/figures/experiments/fabric_disc.hpp"
#include "sim/garment.hpp"

namespace taut::app {

// Cusick's drape meter (Cusick 1968): a disc of fabric is clamped between two smaller ones, and light from
// above throws the shadow of what hangs around them.

inline constexpr double draped_radius_m = 0.15;
inline constexpr double clamped_radius_m = 0.09;

/// The shadow of a draped disc.
struct DrapeShadow {
  /// Of the ring that hangs, the fraction that is in the shadow: 0 where it hangs straight down, 1 where it
  /// stands off like a board.
  double coefficient = 0.0;
  int folds = 0;
};

/// The shadow that the triangles throw on the ground, seen along y, of a disc around the origin.
DrapeShadow drape_shadow(std::span<const sim::Triangle> triangles, std::span<const sim::Vec3> positions_m);

/// One disc after it came to rest.
struct DrapeRun {
  std::shared_ptr<const sim::Garment> garment;
  std::vector<sim::Index> pins;
  std::vector<sim::Vec3> positions_m;
  DrapeShadow shadow;
  int frames = 0;  ///< until it was at rest, or the most
  bool at_rest = false;
  double max_stretch = 0.0;
};

/// Meshes of three sizes of triangles and three seeds.
inline constexpr std::array drape_meshes = {DiscMesh{0.012, 1}, DiscMesh{0.010, 2}, DiscMesh{0.008, 3}};

/// Lets a disc hang until it is at rest, from level, or for 10 s. Throws what sim::Simulation throws.
DrapeRun run_drape(
    const sim::Material& fabric, const DiscMesh& mesh,
    const ProgressCallback& report_progress = [](double) {});

}  // namespace taut::app
