#include <gtest/gtest.h>

#include "app/drawing/drawn_scene_file.hpp"
#include "app/models/garment_loading.hpp"
#include "app/models/layers.hpp"
#include "temporary_folder.hpp"

namespace taut::app {
namespace {

constexpr double edge_m = 0.02;

/// Sheets of 21 x 21 vertices, one in front of the other.
sim::Garment sheets(std::vector<double> depths_m, double edge = edge_m) {
  constexpr sim::Index side = 21;
  sim::Mesh mesh;
  for (const double z : depths_m) {
    const auto first = static_cast<sim::Index>(mesh.positions.size());
    for (sim::Index v = 0; v < side * side; ++v) {
      mesh.positions.emplace_back(edge * (v % side), edge * (v / side), z);
      if (v % side > 0 && v >= side) {
        const sim::Index here = first + v;
        mesh.triangles.push_back({here, here - 1, here - side});
        mesh.triangles.push_back({here - 1, here - side - 1, here - side});
      }
    }
  }
  return sim::make_garment(std::move(mesh));
}

TEST(Layers, OneSheetIsKeptFromItselfByItsEdgesOrAFractionOfItsSize) {
  EXPECT_NEAR(suitable_layer_distance(sheets({0.0})), 0.02 * std::sqrt(2.0) * 20 * edge_m, 1e-12);
  // Edges of very different length: the fine ones count.
  sim::Garment fine = sheets({0.0});
  fine.mesh.positions.back() += sim::Vec3(10.0, 0.0, 0.0);
  EXPECT_NEAR(suitable_layer_distance(fine), edge_m, 1e-12);
}

TEST(Layers, SheetsNearEachOtherAreKeptApartByLessThanHalfTheGap) {
  EXPECT_NEAR(suitable_layer_distance(sheets({0.0, 0.015})), 0.45 * 0.015, 1e-12);
  EXPECT_NEAR(suitable_layer_distance(sheets({0.0, 0.015, 0.025})), 0.45 * 0.01, 1e-12);
}

TEST(Layers, EdgesNextToNothingBesideTheSizeAreNoLayers) {
  sim::Garment damaged = sheets({0.0}, 1e-9);
  damaged.mesh.positions.back() = sim::Vec3(1.0, 0.0, 0.0);
  EXPECT_EQ(suitable_layer_distance(damaged), 0.0);
}

TEST(Layers, SheetsThatTouchOrAreFarAwayDoNotCount) {
  const double alone_m = suitable_layer_distance(sheets({0.0}));
  EXPECT_NEAR(suitable_layer_distance(sheets({0.0, 0.001})), alone_m, 1e-4);
  EXPECT_NEAR(suitable_layer_distance(sheets({0.0, 0.1})), alone_m, 1e-3);
}

// Most edges long, most vertices in one place: what is far closer together than the edges are long.
TEST(Layers, WhereVerticesCrowdTheDistanceIsSmaller) {
  sim::Garment garment = sheets({0.0});
  const double even_m = suitable_layer_distance(garment);
  for (std::size_t v = 0; v < garment.mesh.positions.size() / 2; ++v) {
    garment.mesh.positions[v] *= 0.02;
  }
  const double crowded_m = suitable_layer_distance(garment);
  EXPECT_LT(crowded_m, 0.5 * even_m);
  EXPECT_GT(crowded_m, 0.0);
}

TEST(Layers, AModelWithoutASceneIsLeftToItsMesh) {
  const test::TemporaryFolder folder;
  const auto path = folder.write("shirt.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const sim::Garment garment = sheets({0.0, 0.015});
  GarmentInScene cloth;
  cloth.garment = sim::share(garment);
  const Scene scene = find_scene(path.string(), {});
  EXPECT_EQ(settled(scene.surroundings, scene.layer_distance_m, cloth).layer_distance_m,
            suitable_layer_distance(garment));
  const Scene asked = find_scene(path.string(), std::vector{parse_override("cloth.layer_distance=0")});
  EXPECT_EQ(settled(asked.surroundings, asked.layer_distance_m, cloth).layer_distance_m, 0.0);
  const Scene automatic = find_scene("cloth-fall", std::vector{parse_override("cloth.layer_distance=auto")});
  EXPECT_FALSE(automatic.layer_distance_m.has_value());
}

}  // namespace
}  // namespace taut::app
