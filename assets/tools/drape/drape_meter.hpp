#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "app/base/job_runner.hpp"
#include "app/figures/pictures.hpp"
#include "sim/garment.hpp"
#include "sim/mesh/mesh.hpp"

namespace taut::app {

/// How a disc of cloth is divided into triangles: irregularly, and otherwise with another seed.
struct DiscMesh {
  double edge_m = 0.0;  ///< about; above 0
  std::uint64_t seed = 0;
};

/// A level disc around the origin, its outside up. Vertices lie at `edge_m` around two circles: that of
/// `inner_radius_m`, along which it is clamped, and its border. Between them they are scattered, and joined
/// as Delaunay has it (Bowyer 1981; Watson 1981).
sim::Mesh make_disc(double inner_radius_m, double radius_m, const DiscMesh& mesh);

// Cusick's drape meter (Cusick 1968): a disc of fabric is clamped between two smaller ones, and light from
// above throws the shadow of what hangs around them.

inline constexpr double draped_radius_m = 0.15;
inline constexpr double clamped_radius_m = 0.09;

/// The shadow of a draped disc.
struct DrapeShadow {
  /// The fraction of the hanging ring that is in the shadow: 0 where it hangs straight down, 1 where it
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

}  // namespace taut::app
