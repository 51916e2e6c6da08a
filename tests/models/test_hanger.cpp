// The hanger on which a garment is put, and its fit.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "app/base/errors.hpp"
#include "app/models/hanging/hanger.hpp"
#include "garment_shapes.hpp"
#include "loading_shapes.hpp"
#include "sim/mesh/extent.hpp"

namespace taut::app {
namespace {

/// The ends of the hanger that is chosen for the garment.
std::pair<sim::Vec3, sim::Vec3> bar_ends(const std::vector<sim::Body>& hanger) {
  return {std::get<sim::Capsule>(hanger.at(0).shape).end_m, std::get<sim::Capsule>(hanger.at(1).shape).end_m};
}

TEST(Hanger, IsChosenForShouldersWithoutNeckline) {
  const test::TemporaryFolder folder;
  for (const sim::Mesh& mesh : {test::jacket(), test::raised_sleeve(), test::hoodie()}) {
    const LoadedGarment loaded = test::load(folder, mesh);
    EXPECT_TRUE(loaded.pins.empty());
    EXPECT_EQ(loaded.hanging->parts.at(0).by, HungBy::hanger);
    const auto [left, right] = bar_ends(loaded.hanger);
    EXPECT_NEAR(left.x, -0.2, 0.06);
    EXPECT_NEAR(right.x, 0.2, 0.06);
    EXPECT_GT(left.y, 0.6) << "close below the shoulders, which are at 0.72 m";
    EXPECT_LT(left.y, 0.72);
    EXPECT_CONTAINS(test::remarks(loaded), "it hangs on a hanger that is ");
  }
  EXPECT_TRUE(test::load(folder, test::shirt()).hanger.empty());
}

TEST(Hanger, AWideNecklineWouldSlideOverItsEnds) {
  sim::Mesh mesh = test::jacket();
  std::erase_if(mesh.triangles, [&](const sim::Triangle& t) {
    const sim::Vec3 middle = (mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) / 3.0;
    return std::abs(middle.x) < 0.14 && middle.y > 0.6;
  });
  const std::vector<GarmentPart> parts = find_garment_parts(mesh, sim::make_adjacency(mesh));
  const GarmentPart& part = *std::ranges::max_element(parts, {}, &GarmentPart::area_m2);
  EXPECT_FALSE(hanger_for(mesh, part, 0.65, 1.0).empty());
  EXPECT_TRUE(hanger_for(mesh, part, 0.65, 0.6).empty());
  EXPECT_TRUE(hang_as_in_a_shop(mesh, sim::make_adjacency(mesh)).hanger.empty());
}

TEST(Hanger, HoldsTheLargestPartAndPinsTheOthers) {
  const test::TemporaryFolder folder;
  const LoadedGarment loaded =
      test::load(folder, test::both(test::jacket(), test::translate(test::skirt(), {0, -0.8, 0})));
  EXPECT_EQ(loaded.hanger.size(), 2U);
  EXPECT_EQ(loaded.pins.size(), 24U);
  Scene scene;
  std::vector<sim::Body> bodies;
  put_on_hanger(loaded, scene, bodies);
  ASSERT_EQ(scene.pins->size(), 24U);
  EXPECT_EQ(std::get<sim::Index>(scene.pins->front()), *loaded.file_vertices.number_of(loaded.pins.front()));
  EXPECT_EQ(named_bodies(scene), loaded.hanger);
  EXPECT_EQ(bodies, loaded.hanger);
  const sim::Body ball = {.name = "ball", .shape = sim::Sphere{}};
  scene.bodies.insert(scene.bodies.begin(), BodyInScene{ball});
  bodies.insert(bodies.begin(), ball);
  take_off_hanger(scene, bodies);
  EXPECT_EQ(named_bodies(scene), std::vector{ball});
  EXPECT_EQ(bodies, std::vector{ball});
  EXPECT_FALSE(scene.pins);
}

struct OnHanger : testing::Test {
  LoadedGarment load_on_hanger(const sim::Mesh& mesh) {
    scene.garment.file = folder.write("garment.obj", obj_text(mesh, mesh.positions));
    scene.garment.mesh = MeshChoice::model;
    scene.garment.up = ModelAxis::y;
    scene.garment.scale = 1.0;
    scene.pins = std::vector<PinSelector>{std::string("hanger")};
    return load_garment(scene);
  }

  test::TemporaryFolder folder;
  Scene scene;
};

TEST_F(OnHanger, AGarmentStaysInTheRunAndCrossesNothing) {
  const LoadedGarment loaded = load_on_hanger(test::shirt());
  std::vector<sim::Body> bodies;
  put_on_hanger(loaded, scene, bodies);
  ASSERT_EQ(scene.pins->size(), 0U);
  sim::Simulation simulation = make_simulation(scene, loaded, bodies);
  for (int frame = 0; frame < 90; ++frame) {
    simulation.advance_frame();
  }
  const sim::Extent range = sim::compute_extent(simulation.state().current);
  EXPECT_NEAR(range.upper.y, 0.7, 0.05);
  EXPECT_NEAR(range.lower.y, 0.0, 0.1);
}

TEST_F(OnHanger, StrapsHaveAShorterOne) {
  const auto [left, right] = bar_ends(load_on_hanger(test::strap_dress()).hanger);
  EXPECT_GT(right.x, 0.09);
  EXPECT_LT(right.x, 0.15);
  EXPECT_GT(right.y, 0.8);
}

TEST_F(OnHanger, SlopesAsItsShouldersDo) {
  const auto sloping = [](double slope) {
    sim::Mesh mesh = test::shirt();
    for (sim::Vec3& p : mesh.positions) {
      p.y -= slope * std::abs(p.x);
    }
    return mesh;
  };
  const std::vector<sim::Body> hanger = load_on_hanger(sloping(0.3)).hanger;
  const sim::Vec3 middle = std::get<sim::Capsule>(hanger.at(0).shape).start_m;
  EXPECT_NEAR((middle.y - bar_ends(hanger).first.y) / (middle.x - bar_ends(hanger).first.x), 0.3, 0.05);
  EXPECT_FALSE(load_on_hanger(sloping(0.45)).hanger.empty());
  EXPECT_CONTAINS(test::error_message<InputError>([&] { load_on_hanger(sloping(0.55)); }),
                  "found no room for a hanger");
}

TEST_F(OnHanger, NeedsRoom) {
  sim::Mesh flat = test::shirt();
  for (sim::Vec3& p : flat.positions) {
    p.z *= 0.05;
  }
  EXPECT_CONTAINS(test::error_message<InputError>([&] { load_on_hanger(flat); }),
                  "pins.at: found no room for a hanger below the garment's shoulders");
}

/// Front and back of half a tube with clearance for any hanger. Its shoulders are at 0.69 m and reach `half_width_m`
/// to each side.
sim::Mesh yoke(double half_width_m) {
  const auto body = [=](double x, double y) { return std::abs(x) < half_width_m && y > 0.0 && y < 0.7; };
  return test::sewn({.front = body, .back = body, .open = [](double, double y) { return y < 0.01; }, .depth_m = 0.3});
}

/// Raises the top of the mesh by `height_m` within `half_width_m` of the middle.
sim::Mesh with_collar(sim::Mesh mesh, double half_width_m, double height_m) {
  for (sim::Vec3& p : mesh.positions) {
    p.y += p.y > 0.68 && std::abs(p.x) < half_width_m ? height_m : 0.0;
  }
  return mesh;
}

double half_length_m(const std::vector<sim::Body>& hanger) {
  return 0.5 * (bar_ends(hanger).second.x - bar_ends(hanger).first.x);
}

/// Slope of the left bar: the height by which it falls over the distance by which it reaches out.
double fall_distance(const std::vector<sim::Body>& hanger) {
  const auto& bar = std::get<sim::Capsule>(hanger.at(0).shape);
  return (bar.start_m.y - bar.end_m.y) / (bar.start_m.x - bar.end_m.x);
}

TEST_F(OnHanger, WideGarmentsHaveOneForGrownUps) {
  const std::vector<sim::Body> hanger = load_on_hanger(yoke(0.6)).hanger;
  EXPECT_NEAR(half_length_m(hanger), 0.2, 1e-9);
  const auto& bar = std::get<sim::Capsule>(hanger.at(0).shape);
  EXPECT_DOUBLE_EQ(bar.start_radius_m, 0.008);
  EXPECT_DOUBLE_EQ(bar.end_radius_m, 0.008);
  EXPECT_EQ(hanger.at(0).friction, 0.5);
  EXPECT_NEAR(fall_distance(hanger), 0.0, 1e-9);
  EXPECT_NEAR(bar.end_m.y, 0.69 - 0.016, 1e-9) << "in steps of 4 mm, until it is 4 mm from the cloth";
}

TEST_F(OnHanger, NarrowGarmentsHaveASmallerOne) {
  EXPECT_NEAR(half_length_m(load_on_hanger(yoke(0.21)).hanger), 0.45 * 0.42, 1e-9);
}

TEST_F(OnHanger, ACollarIsNoShoulder) {
  EXPECT_NEAR(fall_distance(load_on_hanger(with_collar(yoke(0.6), 0.05, 0.06)).hanger), 0.0, 1e-9);
  EXPECT_NEAR(fall_distance(load_on_hanger(with_collar(yoke(0.6), 0.11, 0.03)).hanger), 0.25, 1e-9)
      << "what reaches to 0.4 of its half length is one: it rises by 3 of the 12 cm that are left";
}

// The wide garment is narrow above its shoulders.
TEST_F(OnHanger, IsAtLeastHalfAsLongAsTheLongest) {
  const auto mesh = [](double half_width_m) {
    const auto body = [=](double x, double y) {
      return std::abs(x) < (y < 0.5 ? 0.3 : half_width_m) && y > 0.0 && y < 0.7;
    };
    return test::sewn({.front = body, .back = body, .open = [](double, double y) { return y < 0.01; }, .depth_m = 0.3});
  };
  EXPECT_NEAR(half_length_m(load_on_hanger(mesh(0.15)).hanger), 0.2 * std::pow(0.93, 5), 1e-9);
  EXPECT_LT(half_length_m(load_on_hanger(mesh(0.12)).hanger), 0.12);
  EXPECT_THROW(load_on_hanger(mesh(0.09)), InputError);
}

TEST_F(OnHanger, IsNotFarBelowTheShoulders) {
  const auto thin_above = [](double height_m) {
    sim::Mesh mesh = yoke(0.6);
    for (sim::Vec3& p : mesh.positions) {
      p.z *= p.y > height_m ? 0.05 : 1.0;
    }
    return mesh;
  };
  EXPECT_NEAR(half_length_m(load_on_hanger(thin_above(0.61)).hanger), 0.2, 1e-9);
  EXPECT_THROW(load_on_hanger(thin_above(0.56)), InputError) << "13 cm and more";
}

}  // namespace
}  // namespace taut::app
