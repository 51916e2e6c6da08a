// Landmarks of a garment that are found by its shape: neck or waist, hem, cuffs, front, and the height up to which it
// surrounds a trunk.

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <glm/geometric.hpp>

#include "../models/garment_shapes.hpp"
#include "app/garments/dressing/fit.hpp"
#include "app/models/hanging/garment_measures.hpp"

namespace taut::app {
namespace {

TEST(GarmentMarks, TellShirtsFromTrousers) {
  const auto marks = [](const sim::Mesh& mesh) {
    return find_garment_marks(sim::make_garment(mesh), mesh.positions, {});
  };
  const GarmentMarks shirt = marks(test::shirt());
  EXPECT_FALSE(shirt.is_worn_at_waist);
  EXPECT_EQ(shirt.cuffs.size(), 2U);
  EXPECT_TRUE(shirt.is_front_known);
  EXPECT_EQ(shirt.front, sim::Vec3(0.0, 0.0, 1.0)) << "where its neckline is lower";
  const GarmentMarks trousers = marks(test::trousers());
  EXPECT_TRUE(trousers.is_worn_at_waist);
  EXPECT_TRUE(trousers.cuffs.empty());
  EXPECT_EQ(trousers.legs.size(), 2U);
  EXPECT_TRUE(shirt.legs.empty());
  EXPECT_FALSE(trousers.hem_height_m);
}

/// The skirt with rings of vertices, from the hem up, at this distance from the axis. It is a quarter wider than
/// deep.
sim::Mesh make_skirt(const std::function<double(double height_m)>& radius_m) {
  sim::Mesh mesh = test::skirt();
  for (sim::Vec3& p : mesh.positions) {
    const double wider = radius_m(p.y) / glm::length(sim::Vec3(p.x, 0.0, p.z));
    p = {1.25 * wider * p.x, p.y, wider * p.z};
  }
  return mesh;
}

TEST(GarmentMarks, KnowJacketsAndHoodsByTheirNecks) {
  const auto marks = [](const sim::Mesh& mesh) {
    return find_garment_marks(sim::make_garment(mesh), mesh.positions, {});
  };
  const sim::Mesh jacket = test::jacket();
  const GarmentMarks open = marks(jacket);
  EXPECT_TRUE(open.is_open_in_front);
  EXPECT_FALSE(open.is_worn_at_waist);
  EXPECT_EQ(open.cuffs.size(), 2U);
  EXPECT_TRUE(open.legs.empty()) << "its sleeves are none";
  EXPECT_FALSE(open.hem_height_m);
  ASSERT_TRUE(open.top);
  EXPECT_NEAR(open.neck_base_m, sim::compute_extent(jacket.positions).upper.y, 1e-9);
  EXPECT_FALSE(marks(test::shirt()).is_open_in_front);
  sim::Mesh hoodie = test::hoodie();
  EXPECT_NEAR(marks(hoodie).neck_base_m, 0.7, 0.051) << "its top is at 1.08";
  EXPECT_EQ(marks(hoodie).front, sim::Vec3(0.0, 0.0, 1.0));
  for (sim::Vec3& p : hoodie.positions) {
    p = {-p.x, p.y, -p.z};
  }
  EXPECT_EQ(marks(hoodie).front, sim::Vec3(0.0, 0.0, -1.0)) << "where its face is";
}

TEST(GarmentMarks, MeasureFromBelowAStandCollar) {
  const auto base_m = [](double collar_m) {
    const sim::Mesh mesh = make_skirt([=](double height_m) { return height_m > 0.56 - collar_m ? 0.1 : 0.2; });
    return find_garment_marks(sim::make_garment(mesh), mesh.positions, {}).neck_base_m;
  };
  EXPECT_NEAR(base_m(0.07), 0.49, 0.011);
  EXPECT_NEAR(base_m(0.0), 0.55, 1e-9);
  EXPECT_NEAR(base_m(0.3), 0.55, 1e-9) << "no collar is so high";
}

TEST(GarmentMarks, KnowTheFrontByHowFarTheNecklineDips) {
  const auto is_known = [](double slope) {
    sim::Mesh mesh = make_skirt([](double) { return 0.2; });
    for (sim::Vec3& p : mesh.positions) {
      p.y -= p.y > 0.54 ? slope * p.z : 0.0;
    }
    return find_garment_marks(sim::make_garment(mesh), mesh.positions, {}).is_front_known;
  };
  EXPECT_FALSE(is_known(0.045)) << "0.023 of its width";
  EXPECT_TRUE(is_known(0.08)) << "0.04";
}

TEST(GarmentMarks, TakeForAHemWhatIsInTheMiddle) {
  const auto has_hem = [](double off) {
    sim::Mesh mesh = make_skirt([](double height_m) { return 0.1 + 0.2 * height_m / 0.55; });
    for (sim::Vec3& p : mesh.positions) {
      p.x += off * 0.75 * (1.0 - p.y / 0.55);
    }
    return find_garment_marks(sim::make_garment(mesh), mesh.positions, {}).hem_height_m.has_value();
  };
  EXPECT_TRUE(has_hem(0.12));
  EXPECT_FALSE(has_hem(0.18));
}

TEST(GarmentTube, GoesOnBeyondACrackAndIsNoFold) {
  sim::Mesh mesh = make_skirt([](double) { return 0.2; });
  const auto cracked = std::find_if(mesh.triangles.begin(), mesh.triangles.end(), [&](const sim::Triangle& t) {
    return std::min({mesh.positions[t[0]].y, mesh.positions[t[1]].y, mesh.positions[t[2]].y}) > 0.2;
  });
  mesh.triangles.erase(cracked);
  EXPECT_NEAR(find_tube({mesh.positions, mesh.triangles})->max_height_m, 0.55, 0.01);
  sim::Mesh fold = make_skirt([](double) { return 0.01; });
  fold = test::translate(std::move(fold), {0.24, -0.1, 0.0});
  const sim::Mesh with_fold = test::both(mesh, fold);
  EXPECT_NEAR(find_tube({with_fold.positions, with_fold.triangles})->min_height_m, 0.0, 0.01);
}

TEST(GarmentTube, EndsWhereSleevesBegin) {
  const auto tube = [](double wider) {
    sim::Mesh mesh = make_skirt([=](double height_m) { return height_m < 0.28 ? 0.2 : 0.2 * wider; });
    for (sim::Vec3& p : mesh.positions) {
      p.y -= p.y > 0.28 ? 0.05 : 0.0;  // puts two rings at one height
    }
    return find_tube({mesh.positions, mesh.triangles});
  };
  EXPECT_NEAR(tube(1.15)->min_height_m, 0.5 * 0.5 / 200, 1e-6);
  EXPECT_NEAR(tube(1.15)->max_height_m, 0.25, 0.005);
  EXPECT_NEAR(tube(1.07)->max_height_m, 0.5, 0.005);
}

// A worn shirt is wide at levels where at the start it surrounded the trunk alone: its sleeves join there.
TEST(Worn, IsMeasuredBelowTheSleeves) {
  sim::Mesh mesh = make_skirt([](double) { return 0.2; });
  const sim::Garment garment = sim::make_garment(mesh);
  std::vector<FitRow> rows = {{"upper chest", 1.0, 1.4, 0.3}, {"waist", 1.0, 1.4, 0.2}, {"chest", 1.0, 1.4, 0.45}};
  for (sim::Vec3& p : mesh.positions) {
    p = p.y > 0.28 ? sim::Vec3(2.0 * p.x, p.y - 0.05, p.z) : p;
  }
  measure_worn(garment, mesh.positions, rows);
  EXPECT_NEAR(*rows[0].worn_m, *rows[1].worn_m, 0.1 * *rows[1].worn_m);
  EXPECT_FALSE(rows[2].worn_m) << "far above";
}

}  // namespace
}  // namespace taut::app
