#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "app/drawing/garment_surface.hpp"
#include "models/garment_shapes.hpp"
#include "sim/mesh/grid.hpp"

namespace taut::app {
namespace {

// Widths of all bands that are ribbed, or of all that are not, in mm.
std::set<int> widths_mm(const GarmentSewing& sewing, bool ribbed) {
  std::set<int> widths;
  for (const renderer::BorderBand& band : sewing.bands) {
    if (band.width_m > 0.0F && band.ribbed == ribbed) {
      widths.insert(static_cast<int>(std::lround(1000.0F * band.width_m)));
    }
  }
  return widths;
}

sim::Garment scale_mesh(sim::Mesh mesh, double factor) {
  for (sim::Vec3& position : mesh.positions) {
    position *= factor;
  }
  return sim::make_garment(std::move(mesh));
}

TEST(GarmentSewing, AShirtHasHemsAndARibbedNeckband) {
  const GarmentSewing sewing = make_garment_sewing(sim::make_garment(test::shirt()));
  EXPECT_EQ(widths_mm(sewing, true), std::set<int>{18});
  EXPECT_EQ(widths_mm(sewing, false), std::set<int>{20});
  EXPECT_EQ(sewing.stitch_m, 0.004F);
}

TEST(GarmentSewing, TrousersHaveHemsAlone) {
  const GarmentSewing sewing = make_garment_sewing(sim::make_garment(test::trousers()));
  EXPECT_TRUE(widths_mm(sewing, true).empty());
  EXPECT_FALSE(widths_mm(sewing, false).empty());
}

TEST(GarmentSewing, ATinyGarmentHasAQuarterOfIt) {
  const GarmentSewing sewing = make_garment_sewing(scale_mesh(test::shirt(), 0.1));
  EXPECT_EQ(*widths_mm(sewing, false).rbegin(), 5) << "those of its sleeves are narrower still";
  EXPECT_EQ(sewing.stitch_m, 0.001F);
}

TEST(GarmentSewing, AGridIsPlainCloth) {
  const sim::Garment garment = sim::make_garment(sim::make_grid({}));
  const GarmentSewing sewing = make_garment_sewing(garment);
  EXPECT_TRUE(sewing.bands.empty());
  EXPECT_TRUE(sewing.seams.empty());
  EXPECT_EQ(sewing.rim_radius_m, 0.5F * static_cast<float>(garment.material.thickness_m));
}

TEST(GarmentSurface, IsAsFineAsItShows) {
  const sim::Garment garment = sim::make_garment(test::shirt());
  GarmentSurface surface(garment);
  surface.set_freedom({0.0004F});
  surface.set_detail(10.0F, 5.0F);
  EXPECT_EQ(surface.view().triangles.size(), 3 * garment.mesh.triangles.size())
      << "an edge is less than a pixel";
  EXPECT_TRUE(surface.view().trims.empty());
  surface.set_detail(1000.0F, 5.0F);
  EXPECT_GT(surface.view().triangles.size(), 48 * garment.mesh.triangles.size());
  EXPECT_FALSE(surface.view().trims.empty());
  surface.set_detail(1000.0F, 1000.0F);
  EXPECT_FALSE(surface.view().trims.empty()) << "hems need no finer triangles";
  EXPECT_LT(surface.view().triangles.size(), 6 * garment.mesh.triangles.size());
  std::vector<float> values(garment.mesh.positions.size(), 0.25F);
  surface.interpolate(values);
  EXPECT_EQ(values, std::vector<float>(surface.view().positions.size(), 0.25F));
  surface.set_detail(1000.0F, std::nullopt);
  EXPECT_EQ(surface.view().triangles.size(), 3 * garment.mesh.triangles.size());
  EXPECT_TRUE(surface.view().trims.empty());
}

}  // namespace
}  // namespace taut::app
