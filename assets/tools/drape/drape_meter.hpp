#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "app/base/job_runner.hpp"
#include "app/figures/pictures.hpp"
#include "app/scene/fabric.hpp"
#include "sim/garment.hpp"
#include "sim/mesh/mesh.hpp"

namespace taut::app {

/// Triangles of a disc of cloth. They are irregular, and differ with the seed.
struct DiscMesh {
  double edge_m = 0.0;  ///< approximate edge length, above 0
  std::uint64_t seed = 0;
};

/// Returns a level disc around the origin, with its outside up. Vertices lie at distances of `edge_m` on two circles:
/// the circle of `inner_radius_m`, along which the disc is clamped, and the border. Scattered vertices lie between, and
/// all are joined to Delaunay triangles (Bowyer 1981; Watson 1981).
sim::Mesh make_disc(double inner_radius_m, double radius_m, const DiscMesh& mesh);

// Cusick's drape meter (Cusick 1968): a disc of fabric is clamped between two smaller discs, and light from above
// throws the shadow of the hanging ring around them.

inline constexpr double draped_radius_m = 0.15;
inline constexpr double clamped_radius_m = 0.09;

/// Shadow of a draped disc.
struct DrapeShadow {
  /// Fraction of the hanging ring that is in the shadow: 0 if it hangs straight down, 1 if it stands off like a board.
  double coefficient = 0.0;
  int folds = 0;
};

/// Returns the shadow of triangles on the ground in the view along y, for a disc around the origin.
DrapeShadow drape_shadow(std::span<const sim::Triangle> triangles, std::span<const sim::Vec3> positions_m);

/// A disc after it came to rest.
struct DrapeRun {
  std::shared_ptr<const sim::Garment> garment;
  std::vector<sim::Index> pins;
  std::vector<sim::Vec3> positions_m;
  DrapeShadow shadow;
  int frames = 0;  ///< frames until rest, or the maximum
  bool at_rest = false;
  double max_stretch = 0.0;
};

/// Meshes of three triangle sizes with three seeds.
inline constexpr std::array drape_meshes = {DiscMesh{0.012, 1}, DiscMesh{0.010, 2}, DiscMesh{0.008, 3}};

/// Lets a level disc hang until it is at rest, or for 10 s. Throws as sim::Simulation does.
DrapeRun run_drape(
    const sim::Material& fabric, const DiscMesh& mesh,
    const ProgressCallback& report_progress = [](double) {});

/// A fabric with its drape on several meshes, in the order of the meshes.
struct DrapedFabric {
  Fabric fabric;
  DrawnScene scene;  ///< a scene with this fabric, without a garment
  std::vector<DrapeRun> runs;

  double mean_percent() const;
  /// Returns half the difference between the largest and the smallest coefficient.
  double spread_percent() const;
  /// Returns "7" or "6-8".
  std::string folds() const;
};

/// Draws the last disc of each fabric from above, with the measurements of all discs.
Drawing draw_drapes(std::span<const DrapedFabric> fabrics, LazyOffscreenRenderer& offscreen);

}  // namespace taut::app
