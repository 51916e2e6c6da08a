// Cusick's drape meter, and how fabrics drape in it.

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "drape_meter.hpp"
#include "sim/mesh/adjacency.hpp"

namespace taut::app {
namespace {

constexpr double flat_m2 = std::numbers::pi * draped_radius_m * draped_radius_m;

TEST(Disc, IsCoveredOnceByEvenTriangles) {
  for (const DiscMesh& size : drape_meshes) {
    const sim::Mesh disc = make_disc(clamped_radius_m, draped_radius_m, size);
    double area_m2 = 0.0;
    for (const sim::Triangle& t : disc.triangles) {
      const sim::Vec3 doubled = sim::doubled_area_vector(disc.positions, t);
      EXPECT_GT(doubled.y, 0.1 * size.edge_m * size.edge_m);
      area_m2 += 0.5 * doubled.y;
    }
    EXPECT_NEAR(area_m2, flat_m2, 0.002 * flat_m2);
    const double border = std::round(2.0 * std::numbers::pi * draped_radius_m / size.edge_m);
    EXPECT_EQ(static_cast<double>(disc.triangles.size()),
              2.0 * static_cast<double>(disc.positions.size()) - 2.0 - border);
  }
  const auto other = make_disc(clamped_radius_m, draped_radius_m, {drape_meshes[0].edge_m, 9});
  EXPECT_NE(other.positions, make_disc(clamped_radius_m, draped_radius_m, drape_meshes[0]).positions);
}

/// The disc with its border moved inwards by `depth_m` at the dents of `folds` folds.
DrapeShadow shadow_of_waves(int folds, double depth_m) {
  const sim::Mesh disc = make_disc(clamped_radius_m, draped_radius_m, {0.005, 1});
  std::vector<sim::Vec3> positions_m = disc.positions;
  for (sim::Vec3& p : positions_m) {
    const double radius_m = std::hypot(p.x, p.z);
    const double outside = std::max(0.0, radius_m - clamped_radius_m) / (draped_radius_m - clamped_radius_m);
    const double wave = 0.5 - 0.5 * std::cos(folds * std::atan2(p.z, p.x));
    p *= radius_m > 0.0 ? (radius_m - depth_m * outside * wave) / radius_m : 1.0;
  }
  return drape_shadow(disc.triangles, positions_m);
}

TEST(DrapeShadow, CountsFoldsAndWhatOfTheRingIsShaded) {
  EXPECT_NEAR(shadow_of_waves(5, 0.0).coefficient, 1.0, 0.005);
  EXPECT_EQ(shadow_of_waves(5, 0.0).folds, 0);
  for (const int folds : {3, 6, 8}) {
    EXPECT_EQ(shadow_of_waves(folds, 0.03).folds, folds);
  }
  // The curve r - d/2 + d/2 cos encloses pi (mean radius^2 + amplitude^2 / 2).
  const double mean_m = draped_radius_m - 0.015;
  const double shaded_m2 = std::numbers::pi * (mean_m * mean_m + 0.5 * 0.015 * 0.015);
  const double clamped_m2 = std::numbers::pi * clamped_radius_m * clamped_radius_m;
  EXPECT_NEAR(shadow_of_waves(6, 0.03).coefficient, (shaded_m2 - clamped_m2) / (flat_m2 - clamped_m2), 0.01);
}

double drape_percent(const std::string& fabric, const DiscMesh& mesh) {
  return 100.0 * run_drape(set_fabric({}, fabric).material, mesh).shadow.coefficient;
}

void expect_as_published(const DiscMesh& mesh) {
  std::map<std::string, double> percent;
  for (const char* name : {"silk", "wool", "cotton", "denim"}) {
    percent[name] = drape_percent(name, mesh);
    const auto [lowest, highest] = *find_fabric(name).published_drape_percent;
    EXPECT_GE(percent[name], lowest) << name << ' ' << mesh.edge_m;
    EXPECT_LE(percent[name], highest) << name << ' ' << mesh.edge_m;
  }
  EXPECT_LT(percent["silk"], percent["wool"]);
  EXPECT_LT(percent["wool"], percent["cotton"]);
  EXPECT_LT(percent["cotton"], percent["denim"]);
}

// The experiments of the figure "truth" use coarser meshes.
TEST(Drape, FabricsHangAsPublishedOnAFineMesh) { expect_as_published(drape_meshes[2]); }

}  // namespace
}  // namespace taut::app
