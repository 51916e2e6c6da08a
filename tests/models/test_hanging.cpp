// What holds a garment without a body, on models of each kind that people have.

#include <gtest/gtest.h>

#include "app/models/garment_loading.hpp"
#include "app/models/garment_remarks.hpp"
#include "app/models/hanging.hpp"
#include "app/models/obj_writing.hpp"
#include "garment_shapes.hpp"
#include "sim/mesh/extent.hpp"
#include "temporary_folder.hpp"

namespace taut::app {
namespace {

/// How the first part hangs, and what its pins extend over.
struct Held {
  HungBy by;
  std::size_t count;
  sim::Extent range;
};

Held held(const sim::Mesh& mesh) {
  const Hanging hanging = hang(mesh, sim::make_adjacency(mesh));
  Held held{hanging.parts.at(0).by, hanging.pins.size(), {}};
  for (const sim::Index pin : hanging.pins) {
    held.range.add(mesh.positions[pin]);
  }
  return held;
}

void expect_across(const Held& held, double lower_m, double upper_m) {
  EXPECT_NEAR(held.range.lower.x, lower_m, 1e-9);
  EXPECT_NEAR(held.range.upper.x, upper_m, 1e-9);
}

/// Loaded as a file without units and axes.
LoadedGarment load(const test::TemporaryFolder& folder, const sim::Mesh& mesh) {
  Scene scene;
  scene.garment.file = folder.write("garment.obj", obj_text(mesh, mesh.positions));
  return load_garment(scene);
}

std::string remarks(const LoadedGarment& loaded) {
  std::string text;
  for (const std::string& line : remarks_of(loaded)) {
    text += line + '\n';
  }
  return text;
}

TEST(Hanging, HoldsShirtsByTheNeckline) {
  for (const sim::Mesh& mesh : {test::shirt(), test::shirt_with_gap()}) {
    const Held neck = held(mesh);
    EXPECT_EQ(neck.by, HungBy::top_opening);
    EXPECT_EQ(neck.count, 18U);
    expect_across(neck, -0.09, 0.09);
  }
}

TEST(Hanging, LooksAcrossAGarmentThatFacesAside) {
  for (sim::Mesh mesh : {test::shirt(), test::shirt_with_gap()}) {
    for (sim::Vec3& p : mesh.positions) {
      p = {p.z, p.y, -p.x};
    }
    EXPECT_EQ(held(mesh).by, HungBy::top_opening);
    EXPECT_NEAR(held(mesh).range.upper.z, 0.09, 1e-9);
  }
}

TEST(Hanging, HoldsADressWithStrapsOnBothSides) {
  const Held straps = held(test::strap_dress());
  EXPECT_EQ(straps.by, HungBy::top_opening);
  expect_across(straps, -0.09, 0.09);
  EXPECT_NEAR(straps.range.upper.y, 0.9, 1e-9);
}

// One strap is higher by more than the band that is held, and the neckline is too steep.
TEST(Hanging, HoldsUnevenStrapsByBothArmholes) {
  sim::Mesh mesh = test::strap_dress(0.15);
  for (sim::Vec3& p : mesh.positions) {
    p.y += p.y > 0.6 && p.x > 0.0 ? 0.1 * (p.y - 0.6) : 0.0;
  }
  const Held armholes = held(mesh);
  EXPECT_EQ(armholes.by, HungBy::two_openings);
  expect_across(armholes, -0.21, 0.21);
  for (sim::Vec3& p : mesh.positions) {
    p.y += p.y > 0.6 && p.x > 0.0 ? 0.8 * (p.y - 0.6) : 0.0;
  }
  EXPECT_NE(held(mesh).by, HungBy::two_openings) << "they are no pair";
}

TEST(Hanging, HoldsAHoodByTheNeck) {
  const Held neck = held(test::hoodie());
  EXPECT_EQ(neck.by, HungBy::neck);
  expect_across(neck, -0.15, 0.15);
  EXPECT_NEAR(neck.range.lower.y, 0.75, 1e-9);
  EXPECT_NEAR(neck.range.upper.y, 0.75, 1e-9);
}

TEST(Hanging, TakesNoCollarOrTopForAHood) {
  EXPECT_EQ(held(test::hoodie(0.86)).by, HungBy::top_opening) << "a stand-up collar, too low for a hood";
  EXPECT_NE(held(test::hoodie(1.08, 0.9)).by, HungBy::neck) << "it has no opening for a face";
  EXPECT_NE(held(test::hoodie(1.9)).by, HungBy::neck) << "half of it is above its shoulders";
  EXPECT_NE(held(test::hoodie(1.08, 0.66, 0.2)).by, HungBy::neck) << "it hardly widens below";
}

TEST(Hanging, HoldsTrousersAndSkirtsByTheWaist) {
  const Held waist = held(test::trousers());
  EXPECT_EQ(waist.by, HungBy::top_opening);
  EXPECT_EQ(waist.count, 32U);
  EXPECT_EQ(held(test::skirt()).count, 24U);
  EXPECT_NEAR(held(test::skirt()).range.lower.y, 0.55, 1e-9);
}

TEST(Hanging, HoldsAJacketByItsShouldersNotByItsSleeves) {
  const Held shoulders = held(test::jacket());
  EXPECT_EQ(shoulders.by, HungBy::shoulders);
  expect_across(shoulders, -0.21, 0.21);
  EXPECT_EQ(held(test::raised_sleeve()).by, HungBy::shoulders);
  EXPECT_LT(held(test::raised_sleeve()).range.upper.y, 0.73);
}

TEST(Hanging, HoldsACapeAtItsTop) {
  EXPECT_EQ(held(test::cape()).by, HungBy::highest_band);
  EXPECT_NEAR(held(test::cape()).range.lower.y, 0.84, 1e-9);
}

TEST(Hanging, HoldsACircleSkirtThatLiesFlatByItsWaist) {
  const Held waist = held(test::circle_skirt());
  EXPECT_EQ(waist.by, HungBy::top_opening);
  EXPECT_EQ(waist.count, 32U);
  EXPECT_NEAR(waist.range.upper.x, 0.15, 1e-9);
}

// Where an opening begins to be one at the top: 0.6 of the height.
TEST(Hanging, TakesTheEndOfALiningForATopOpeningOnlyIfItIsHigh) {
  EXPECT_EQ(held(test::lined_bell(0.5)).by, HungBy::highest_band);
  EXPECT_EQ(held(test::lined_bell(0.7)).by, HungBy::top_opening);
}

TEST(Upright, IsWhereAnOpeningCanHoldTheGarment) {
  const test::TemporaryFolder folder;
  const auto up = [&](const sim::Mesh& mesh) { return load(folder, mesh).placement->up; };
  EXPECT_EQ(up(test::circle_skirt()), ModelAxis::y) << "though it is far longer along z";
  for (const sim::Mesh& mesh : {test::skirt(), test::shirt(), test::strap_dress(), test::trousers(),
                                test::hoodie(), test::cape(), test::jacket()}) {
    EXPECT_EQ(up(mesh), ModelAxis::y);
  }
  for (const sim::Mesh& mesh : {test::skirt(), test::shirt(), test::strap_dress(), test::trousers(),
                                test::hoodie(), test::circle_skirt()}) {
    EXPECT_EQ(up(test::with_z_up(mesh)), ModelAxis::z);
  }
  EXPECT_EQ(up(test::laid_flat(test::shirt())), ModelAxis::minus_z);
  EXPECT_EQ(up(test::laid_flat(test::trousers())), ModelAxis::minus_z);
  EXPECT_EQ(load(folder, test::laid_flat(test::shirt())).pins.size(), 18U);
}

TEST(Upright, IsNotTurnedByAFewOpeningsThatCarryLittle) {
  const test::TemporaryFolder folder;
  // A skirt for a doll with z up beside a cloth that has no openings.
  sim::Mesh doll = test::with_z_up(test::skirt());
  for (sim::Vec3& p : doll.positions) {
    p *= 0.5;
  }
  EXPECT_EQ(load(folder, test::both(doll, test::cape())).placement->up, ModelAxis::y);
}

TEST(Strays, AreLeftOutAndSaid) {
  const test::TemporaryFolder folder;
  const LoadedGarment alone = load(folder, test::shirt());
  const LoadedGarment loaded = load(folder, test::both(test::shirt(), test::button({107.0, 0.4, 0.1}, 0.01)));
  EXPECT_EQ(loaded.placement->scale, 1.0);
  EXPECT_EQ(loaded.garment->mesh.positions, alone.garment->mesh.positions);
  EXPECT_CONTAINS(remarks(loaded), "8 triangles with 0.031 % of its area lie 107 m away and are left out");
  EXPECT_EQ(remarks(alone).find("left out"), std::string::npos);
}

TEST(Strays, AreNeitherNearNorLarge) {
  const test::TemporaryFolder folder;
  const auto left_out = [&](const sim::Mesh& more) {
    return load(folder, test::both(test::shirt(), more)).strays.triangles;
  };
  EXPECT_EQ(left_out(test::button({1.2, 0.4, 0.0}, 0.01)), 0U) << "less than the shirt's size beside it";
  EXPECT_EQ(left_out(test::button({1.6, 0.4, 0.0}, 0.01)), 8U);
  EXPECT_EQ(left_out(test::button({1.6, 0.4, 0.0}, 0.055)), 0U) << "0.8 % of the area";
  EXPECT_EQ(left_out(test::button({1.6, 0.4, 0.0}, 0.035)), 8U) << "0.3 % of the area";
}

TEST(Remarks, SayThatNoGarmentIsSoLarge) {
  const test::TemporaryFolder folder;
  Scene scene;
  const sim::Mesh mesh = test::shirt();
  scene.garment.file = folder.write("garment.obj", obj_text(mesh, mesh.positions));
  scene.garment.scale = 8.0;
  EXPECT_CONTAINS(remarks(load_garment(scene)),
                  "it is 7.2 m large, which no garment is, with the unit 8 m, as asked for");
  scene.garment.scale = 2.0;
  EXPECT_EQ(remarks(load_garment(scene)).find("no garment is"), std::string::npos);
}

}  // namespace
}  // namespace taut::app
