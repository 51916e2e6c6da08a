// Pins and hangers of a garment without a body, on models of each kind that people have.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/models/hanging/hanging.hpp"
#include "garment_shapes.hpp"
#include "loading_shapes.hpp"
#include "sim/mesh/extent.hpp"

namespace taut::app {
namespace {

/// Support of the first component, and the number and extent of the pins.
struct Held {
  HungBy by;
  std::size_t count;
  sim::Extent range;
};

Held hang_mesh(const sim::Mesh& mesh) {
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

TEST(Hanging, HoldsShirtsByTheNeckline) {
  for (const sim::Mesh& mesh : {test::shirt(), test::shirt_with_gap()}) {
    const Held neck = hang_mesh(mesh);
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
    EXPECT_EQ(hang_mesh(mesh).by, HungBy::top_opening);
    EXPECT_NEAR(hang_mesh(mesh).range.upper.z, 0.09, 1e-9);
  }
}

TEST(Hanging, HoldsADressWithStrapsOnBothSides) {
  const Held straps = hang_mesh(test::strap_dress());
  EXPECT_EQ(straps.by, HungBy::straps);
  expect_across(straps, -0.15, 0.15);
  EXPECT_NEAR(straps.range.upper.y, 0.9, 1e-9);
  EXPECT_NEAR(straps.range.lower.y, 0.9, 1e-9) << "not by its neckline";
  EXPECT_EQ(hang_mesh(test::strap_dress(0.84)).by, HungBy::top_opening) << "a neckline of 0.07 of the height";
}

TEST(Hanging, HoldsAnApronByItsStrapsAndNoTiltedWaist) {
  const auto apron = [](double bib_m) {
    const auto body = [bib_m](double x, double y) {
      return std::abs(x) < 0.2 && y > 0.0 && (y < 0.9 - bib_m || (std::abs(x) > 0.05 && std::abs(x) < 0.11 && y < 0.9));
    };
    const auto open = [bib_m](double, double y) { return y < 0.01 || (y < 0.89 && y > 0.89 - bib_m); };
    return hang_mesh(test::sewn({.front = body, .back = body, .open = open}));
  };
  EXPECT_EQ(apron(0.3).by, HungBy::straps);
  EXPECT_GT(apron(0.3).range.lower.y, 0.85);
  sim::Mesh waist = test::skirt();
  for (sim::Vec3& p : waist.positions) {
    p.y *= 1.0 + 0.5 * p.x;
  }
  EXPECT_EQ(hang_mesh(waist).by, HungBy::top_opening);
}

// One strap is higher than the other by more than the pinned band, and the neckline is too steep.
TEST(Hanging, HoldsUnevenStrapsByBothArmholes) {
  sim::Mesh mesh = test::strap_dress(0.15);
  for (sim::Vec3& p : mesh.positions) {
    p.y += p.y > 0.6 && p.x > 0.0 ? 0.6 * (p.y - 0.6) : 0.0;
  }
  const Held armholes = hang_mesh(mesh);
  EXPECT_EQ(armholes.by, HungBy::straps);
  expect_across(armholes, -0.15, 0.15);
  for (sim::Vec3& p : mesh.positions) {
    p.y += p.y > 0.6 && p.x > 0.0 ? 0.15 * (p.y - 0.6) : 0.0;
  }
  EXPECT_NE(hang_mesh(mesh).by, HungBy::straps) << "they are no pair";
}

TEST(Hanging, HoldsAHoodByTheNeck) {
  const Held neck = hang_mesh(test::hoodie());
  EXPECT_EQ(neck.by, HungBy::neck);
  expect_across(neck, -0.15, 0.15);
  EXPECT_NEAR(neck.range.lower.y, 0.75, 1e-9);
  EXPECT_NEAR(neck.range.upper.y, 0.75, 1e-9);
}

TEST(Hanging, TakesNoCollarOrTopForAHood) {
  EXPECT_EQ(hang_mesh(test::hoodie(0.86)).by, HungBy::top_opening) << "a stand-up collar, too low for a hood";
  EXPECT_EQ(hang_mesh(test::hoodie(1.08, 0.84)).by, HungBy::neck) << "the face is open over half of the hood";
  EXPECT_NE(hang_mesh(test::hoodie(1.08, 0.87)).by, HungBy::neck) << "over 0.43 of it";
  EXPECT_EQ(hang_mesh(test::hoodie(1.08, 0.66, 0.24)).by, HungBy::neck) << "it is 1.6 times wider below";
  EXPECT_NE(hang_mesh(test::hoodie(1.08, 0.66, 0.2)).by, HungBy::neck) << "1.4 times";
}

TEST(Hanging, TakesNoBodiceAboveAWideSkirtForAHood) {
  for (const double hem_m : {0.4, 0.6, 0.9}) {
    const Held straps = hang_mesh(test::dress_with_wide_skirt(hem_m));
    EXPECT_EQ(straps.by, HungBy::straps) << hem_m;
    EXPECT_GE(straps.count, 8U);
    EXPECT_GT(straps.range.lower.y, 1.1);
  }
}

// A seam that was left open joins the neckline and the hem to one border.
TEST(Hanging, TakesNoOpenSeamForAnOpening) {
  const Held top = hang_mesh(test::split_tube(0.01));
  EXPECT_EQ(top.by, HungBy::top_opening);
  EXPECT_EQ(top.count, 25U);
  EXPECT_NEAR(top.range.lower.y, 0.75, 1e-9);
  EXPECT_EQ(hang_mesh(test::split_tube(0.03)).by, HungBy::highest_band) << "0.6 of an edge is no seam";
}

TEST(Hanging, TakesForAHoodWhatHasItsHeight) {
  const auto by = [](double share) {
    sim::Mesh mesh = test::hoodie();
    for (sim::Vec3& p : mesh.positions) {
      // The first 9 cm above the shoulders, at 0.72 m, are not stretched: the pins are there.
      p.y += std::max(0.0, p.y - 0.81) * ((0.72 * share / (1.0 - share) - 0.09) / 0.27 - 1.0);
    }
    return hang_mesh(mesh).by;
  };
  EXPECT_NE(by(0.16), HungBy::neck) << "a collar";
  EXPECT_EQ(by(0.18), HungBy::neck);
  EXPECT_EQ(by(0.47), HungBy::neck);
  EXPECT_NE(by(0.54), HungBy::neck) << "a bodice above a skirt";
}

TEST(Hanging, FindsTheNeckAboveShouldersThatSlope) {
  const auto by = [](double slope) {
    sim::Mesh mesh = test::hoodie();
    for (sim::Vec3& p : mesh.positions) {
      p.y -= slope * std::max(0.0, std::abs(p.x) - 0.15);
    }
    return hang_mesh(mesh).by;
  };
  EXPECT_EQ(by(0.9), HungBy::neck);
  EXPECT_NE(by(1.4), HungBy::neck) << "it widens too slowly";
}

TEST(Hanging, HoldsTrousersAndSkirtsByTheWaist) {
  const Held waist = hang_mesh(test::trousers());
  EXPECT_EQ(waist.by, HungBy::top_opening);
  EXPECT_EQ(waist.count, 32U);
  EXPECT_EQ(hang_mesh(test::skirt()).count, 24U);
  EXPECT_NEAR(hang_mesh(test::skirt()).range.lower.y, 0.55, 1e-9);
}

TEST(Hanging, HoldsAJacketByItsShouldersNotByItsSleeves) {
  const Held shoulders = hang_mesh(test::jacket());
  EXPECT_EQ(shoulders.by, HungBy::shoulders);
  expect_across(shoulders, -0.21, 0.21);
  EXPECT_EQ(hang_mesh(test::raised_sleeve()).by, HungBy::shoulders);
  EXPECT_LT(hang_mesh(test::raised_sleeve()).range.upper.y, 0.73);
}

// Short sleeves above a wide hem. They end at 0.41 and 0.39 of its width from the middle.
TEST(Hanging, TellsSleevesFromArmholesByHowFarOutTheyEnd) {
  EXPECT_EQ(hang_mesh(test::jacket(0.51)).by, HungBy::shoulders);
  EXPECT_EQ(hang_mesh(test::jacket(0.54)).by, HungBy::highest_band);
}

TEST(Hanging, HoldsACapeAtItsTop) {
  EXPECT_EQ(hang_mesh(test::cape()).by, HungBy::highest_band);
  EXPECT_NEAR(hang_mesh(test::cape()).range.lower.y, 0.84, 1e-9);
}

TEST(Hanging, HoldsACircleSkirtThatLiesFlatByItsWaist) {
  const Held waist = hang_mesh(test::circle_skirt());
  EXPECT_EQ(waist.by, HungBy::top_opening);
  EXPECT_EQ(waist.count, 32U);
  EXPECT_NEAR(waist.range.upper.x, 0.15, 1e-9);
}

// Openings count as top openings from 0.6 of the height up.
TEST(Hanging, TakesTheEndOfALiningForATopOpeningOnlyIfItIsHigh) {
  EXPECT_EQ(hang_mesh(test::lined_bell(0.58)).by, HungBy::highest_band);
  EXPECT_EQ(hang_mesh(test::lined_bell(0.63)).by, HungBy::top_opening);
}

TEST(Hanging, TakesALongAndWideOpeningThatCarries) {
  const auto by = [](double height_m, const test::Neck& neck) { return hang_mesh(test::bottle(height_m, neck)).by; };
  EXPECT_EQ(by(1.6, {0.054, 0.054}), HungBy::top_opening);
  EXPECT_EQ(by(1.6, {0.048, 0.048}), HungBy::highest_band) << "0.19 of the size around";
  EXPECT_EQ(by(0.8, {0.022, 0.1}), HungBy::top_opening);
  EXPECT_EQ(by(0.8, {0.018, 0.1}), HungBy::highest_band) << "0.09 of the width";
  EXPECT_EQ(by(0.8, {0.06, 0.06, 0.075}), HungBy::top_opening);
  EXPECT_EQ(by(0.8, {0.06, 0.06, 0.083}), HungBy::highest_band) << "0.06 of the width off balance";
  EXPECT_EQ(by(0.8, {0.09, 0.03, 0.0, 0.12}), HungBy::top_opening) << "it leans";
  EXPECT_EQ(by(0.8, {0.09, 0.03, 0.0, 0.14}), HungBy::highest_band) << "0.28 of the width off balance";
}

TEST(Hanging, TakesNoSteepOpeningForOneAtTheTop) {
  const auto by = [](double steepness) {  // the opening rises by 0.27 k; the height is 1 + 0.135 k
    sim::Mesh mesh = test::skirt();
    const double k = steepness / (0.27 - 0.135 * steepness);
    for (sim::Vec3& p : mesh.positions) {
      p.y *= 1.0 + k * p.x;
    }
    return hang_mesh(mesh).by;
  };
  EXPECT_EQ(by(0.38), HungBy::top_opening);
  EXPECT_NE(by(0.42), HungBy::top_opening);
}

TEST(Hanging, FindsWhatLiesFlat) {
  EXPECT_EQ(hang_mesh(test::circle_skirt(0.026)).by, HungBy::top_opening);
  EXPECT_EQ(hang_mesh(test::circle_skirt(0.031)).by, HungBy::highest_band);
}

TEST(Hanging, NamesTwelvePartsAndCountsTheOthers) {
  const sim::Mesh mesh = test::panels(13, 0.01);
  const std::vector<std::string> lines = describe(hang(mesh, sim::make_adjacency(mesh)));
  ASSERT_EQ(lines.size(), 13U);
  EXPECT_CONTAINS(lines[11], "part 12 of 13: ");
  EXPECT_EQ(lines[12], "and 1 part more, held likewise");
}

TEST(Upright, IsWhereAnOpeningCanHoldTheGarment) {
  const test::TemporaryFolder folder;
  const auto up = [&](const sim::Mesh& mesh) { return test::load(folder, mesh).placement->up; };
  EXPECT_EQ(up(test::circle_skirt()), ModelAxis::y) << "though it is far longer along z";
  for (const sim::Mesh& mesh : {test::skirt(), test::shirt(), test::strap_dress(), test::trousers(), test::hoodie(),
                                test::cape(), test::jacket()}) {
    EXPECT_EQ(up(mesh), ModelAxis::y);
  }
  for (const sim::Mesh& mesh :
       {test::skirt(), test::shirt(), test::strap_dress(), test::trousers(), test::hoodie(), test::circle_skirt()}) {
    EXPECT_EQ(up(test::with_z_up(mesh)), ModelAxis::z);
  }
  for (const sim::Mesh& mesh : {test::cape(), test::jacket()}) {
    EXPECT_EQ(up(test::with_z_up(mesh)), ModelAxis::z) << "though no opening carries it";
  }
  EXPECT_EQ(up(test::laid_flat(test::shirt())), ModelAxis::minus_z);
  EXPECT_EQ(up(test::laid_flat(test::trousers())), ModelAxis::minus_z);
  EXPECT_EQ(test::load(folder, test::laid_flat(test::shirt())).pins.size(), 18U);
}

TEST(Upright, TurnsWhatLiesOnItsBackToItsNarrowerEnd) {
  const test::TemporaryFolder folder;
  const auto up = [&](double height) {
    sim::Mesh mesh = test::skirt();
    for (sim::Vec3& p : mesh.positions) {
      p = {p.x, height * p.z, -p.y};
    }
    return test::load(folder, mesh).placement->up;
  };
  EXPECT_EQ(up(0.08), ModelAxis::minus_z);
  EXPECT_EQ(up(0.15), ModelAxis::minus_z) << "upside down: nobody wears it so";
}

TEST(Upright, IsFoundWithoutOpenings) {
  const test::TemporaryFolder folder;
  const auto up = [&](const sim::Mesh& mesh) { return test::load(folder, mesh).placement->up; };
  for (const sim::Mesh& mesh : {test::thick(test::shirt()), test::thick(test::skirt()), test::thick(test::trousers()),
                                test::thick(test::strap_dress()), test::thick(test::jacket())}) {
    EXPECT_EQ(up(mesh), ModelAxis::y);
  }
  for (const sim::Mesh& mesh :
       {test::thick(test::shirt()), test::thick(test::skirt()), test::thick(test::strap_dress())}) {
    EXPECT_EQ(up(test::with_z_up(mesh)), ModelAxis::z);
  }
  for (const sim::Mesh& mesh : {test::shirt(), test::skirt(), test::strap_dress()}) {
    EXPECT_EQ(up(test::laid_flat(test::thick(mesh, 0.001))), ModelAxis::minus_z);
  }
}

/// A sheet of this width and height on a grid; `place` maps both to positions.
sim::Mesh cloth(double width_m, double height_m, const std::function<sim::Vec3(double, double)>& place) {
  constexpr sim::Index columns = 40, rows = 40;
  sim::Mesh mesh;
  for (sim::Index k = 0; k < (columns + 1) * (rows + 1); ++k) {
    mesh.positions.push_back(
        place(width_m * (k % (columns + 1)) / columns, height_m * static_cast<double>(k / (columns + 1)) / rows));
  }
  for (sim::Index k = 0; k < (columns + 1) * rows; ++k) {
    if (k % (columns + 1) < columns) {
      mesh.triangles.push_back({k, k + 1, k + columns + 2});
      mesh.triangles.push_back({k, k + columns + 2, k + columns + 1});
    }
  }
  return mesh;
}

TEST(Upright, IsWhereAClothWithoutOpeningsIsHighAndHardlyMoves) {
  const test::TemporaryFolder folder;
  const auto up = [&](const sim::Mesh& mesh) { return test::load(folder, mesh).placement->up; };
  const sim::Mesh curtain =
      cloth(1.5, 2.0, [](double x, double y) { return sim::Vec3(x, y, 0.06 * std::sin(25.0 * x)); });
  const sim::Mesh scarf =
      cloth(0.3, 1.8, [](double x, double y) { return sim::Vec3(x, y, 0.002 * std::sin(17.0 * y)); });
  const sim::Mesh blanket =
      cloth(1.5, 2.0, [](double x, double y) { return sim::Vec3(x, 0.02 * std::sin(5.0 * x) * std::sin(5.0 * y), y); });
  EXPECT_EQ(up(curtain), ModelAxis::y) << "lying, its folds hold it";
  EXPECT_EQ(up(test::with_z_up(curtain)), ModelAxis::z);
  EXPECT_EQ(up(scarf), ModelAxis::y) << "across its waves it goes around nothing";
  EXPECT_EQ(up(blanket), ModelAxis::z);
  // A panel cut from cloth on a table, with its narrow end away from the person who cuts.
  const auto piece = [](double away) {
    return cloth(1.0, 1.0,
                 [away](double x, double y) { return sim::Vec3((x - 0.5) * (1.0 - 0.5 * y), 0.0, away * y); });
  };
  EXPECT_EQ(up(piece(-1.0)), ModelAxis::minus_z);
  EXPECT_EQ(up(piece(1.0)), ModelAxis::z);
}

sim::Mesh turned_over(sim::Mesh mesh) {
  for (sim::Vec3& p : mesh.positions) p = {p.x, -p.y, -p.z};
  return mesh;
}

TEST(Upright, IsFoundUpsideDown) {
  const test::TemporaryFolder folder;
  const auto up = [&](const sim::Mesh& mesh) { return test::load(folder, mesh).placement->up; };
  sim::Mesh sock = test::bottle(1.2, {0.0, 0.0});
  for (sim::Vec3& p : sock.positions) p = {p.x, -p.y, p.z + std::max(p.y - 0.6, 0.0)};
  const std::vector<std::pair<std::string, sim::Mesh>> garments = {{"skirt", test::skirt()},
                                                                   {"shirt", test::shirt()},
                                                                   {"dress", test::strap_dress()},
                                                                   {"trousers", test::trousers()},
                                                                   {"hoodie", test::hoodie()},
                                                                   {"cape", test::cape()},
                                                                   {"jacket", test::jacket()},
                                                                   {"thick skirt", test::thick(test::skirt())},
                                                                   {"thick shirt", test::thick(test::shirt())},
                                                                   {"thick trousers", test::thick(test::trousers())},
                                                                   {"hat", test::bottle(0.5, {0.0, 0.0})},
                                                                   {"sock", sock},
                                                                   {"thick sock", test::thick(sock)}};
  for (const auto& [name, mesh] : garments) {
    EXPECT_EQ(up(mesh), ModelAxis::y) << name;
    EXPECT_EQ(up(turned_over(mesh)), ModelAxis::minus_y) << name;
    EXPECT_EQ(up(turned_over(test::with_z_up(mesh))), ModelAxis::minus_z) << name;
  }
}

TEST(Upright, HasTheNarrowerEndOfACapeAtTheTop) {
  const test::TemporaryFolder folder;
  const auto cape = [](double upwards) {
    return cloth(1.0, 1.0, [upwards](double around, double down) {
      const double angle = 4.5 * (around - 0.5), radius_m = 0.08 + 0.35 * std::sqrt(down);
      return sim::Vec3(radius_m * std::sin(angle), -0.8 * upwards * down, -0.8 * radius_m * std::cos(angle));
    });
  };
  EXPECT_EQ(test::load(folder, cape(1.0)).placement->up, ModelAxis::y);
  EXPECT_EQ(test::load(folder, cape(-1.0)).placement->up, ModelAxis::minus_y);
}

TEST(Upright, IsThatOfTheClothAndNotOfItsStand) {
  const test::TemporaryFolder folder;
  const auto on_stand = [](const sim::Mesh& garment) {
    sim::Mesh base = cloth(0.4, 0.4, [](double x, double z) { return sim::Vec3(x - 0.2, -0.4, z - 0.2); });
    return test::both(garment, test::thick(base, 0.03));
  };
  EXPECT_EQ(test::load(folder, on_stand(test::strap_dress())).placement->up, ModelAxis::y);
  EXPECT_EQ(test::load(folder, on_stand(test::shirt())).placement->up, ModelAxis::y);
}

TEST(Upright, HasLegsBelowAndLeavesABagAsItStands) {
  const test::TemporaryFolder folder;
  const auto up = [&](const sim::Mesh& mesh) { return test::load(folder, mesh).placement->up; };
  // The legs have no taper, so taper does not show which end is up.
  EXPECT_EQ(up(turned_over(test::with_z_up(test::trousers()))), ModelAxis::minus_z);
  // Bent legs let the view from above reach deeper. They hang so close that one reaches over the middle.
  sim::Mesh close = test::trousers();
  for (sim::Vec3& p : close.positions) {
    p.x += p.y < 0.6 && p.x > -0.12 && p.x < 0.0 ? 0.05 : 0.0;
    p.z += 0.3 * std::max(0.6 - p.y, 0.0);
  }
  EXPECT_EQ(up(test::with_z_up(close)), ModelAxis::z);
  EXPECT_EQ(up(turned_over(test::bottle(1.0, {0.0, 0.0}))), ModelAxis::y) << "a glove, open at its top";
  EXPECT_EQ(up(test::bottle(1.0, {0.0, 0.0})), ModelAxis::y);
  sim::Mesh tote = turned_over(test::bottle(0.5, {0.0, 0.0}));
  for (sim::Vec3& p : tote.positions) p.z *= 0.3;
  EXPECT_EQ(up(tote), ModelAxis::y) << "a tote bag";
}

TEST(Upright, IsWhereMostOfTheAreaIsCarried) {
  const test::TemporaryFolder folder;
  const auto up = [&](double size) {
    sim::Mesh mesh = test::with_z_up(test::skirt());
    for (sim::Vec3& p : mesh.positions) {
      p *= size;
    }
    return test::load(folder, test::both(mesh, test::cape())).placement->up;
  };
  EXPECT_EQ(up(1.0), ModelAxis::y) << "a third";
  EXPECT_NE(up(1.8), ModelAxis::y) << "two thirds";
}

TEST(Upright, IsNotTurnedByAFewOpeningsThatCarryLittle) {
  const test::TemporaryFolder folder;
  // A doll's skirt with z up, beside a cloth without openings.
  sim::Mesh doll = test::with_z_up(test::skirt());
  for (sim::Vec3& p : doll.positions) {
    p *= 0.5;
  }
  EXPECT_EQ(test::load(folder, test::both(doll, test::cape())).placement->up, ModelAxis::y);
}

TEST(Strays, AreLeftOutAndSaid) {
  const test::TemporaryFolder folder;
  const LoadedGarment alone = test::load(folder, test::shirt());
  const LoadedGarment loaded = test::load(folder, test::both(test::shirt(), test::button({107.0, 0.4, 0.1}, 0.01)));
  EXPECT_EQ(loaded.placement->scale, 1.0);
  EXPECT_EQ(loaded.garment->mesh.positions, alone.garment->mesh.positions);
  EXPECT_CONTAINS(test::remarks(loaded), "8 triangles with 0.031 % of its area lie 107 m away and are left out");
  EXPECT_EQ(test::remarks(alone).find("left out"), std::string::npos);
}

TEST(Strays, AreWholePieces) {
  const test::TemporaryFolder folder;
  // A ribbon with 0.6 % of the area. Most of it lies farther from the shirt than the shirt's size.
  sim::Mesh ribbon;
  for (sim::Index k = 0; k < 40; ++k) {
    ribbon.positions.insert(ribbon.positions.end(), {{0.3 + 0.05 * k, 0.4, 0.0}, {0.3 + 0.05 * k, 0.402, 0.0}});
    if (k > 0) {
      ribbon.triangles.insert(ribbon.triangles.end(),
                              {{2 * k - 2, 2 * k, 2 * k + 1}, {2 * k - 2, 2 * k + 1, 2 * k - 1}});
    }
  }
  EXPECT_EQ(test::load(folder, test::both(test::shirt(), ribbon)).strays.triangles, 0U);
  EXPECT_EQ(test::load(folder, test::both(test::shirt(), test::translate(ribbon, {2, 0, 0}))).strays.triangles, 78U);
}

TEST(Strays, AreNeitherNearNorLarge) {
  const test::TemporaryFolder folder;
  const auto left_out = [&](const sim::Mesh& more) {
    return test::load(folder, test::both(test::shirt(), more)).strays.triangles;
  };
  EXPECT_EQ(left_out(test::button({0.6, 0.4, 0.0}, 0.01)), 0U) << "0.17 of the shirt's size beside it";
  EXPECT_EQ(left_out(test::button({0.75, 0.4, 0.0}, 0.01)), 8U) << "0.33";
  EXPECT_EQ(left_out(test::button({1.6, 0.4, 0.0}, 0.044)), 0U) << "0.6 % of the area";
  EXPECT_EQ(left_out(test::button({1.6, 0.4, 0.0}, 0.035)), 8U) << "0.3 % of the area";
}

TEST(Seams, JoinPanelsWhoseBordersLieTogether) {
  const test::TemporaryFolder folder;
  const LoadedGarment loaded = test::load(folder, test::panels(20, 0.0009));
  ASSERT_EQ(loaded.hanging->parts.size(), 1U);
  EXPECT_EQ(loaded.hanging->parts[0].by, HungBy::top_opening);
  EXPECT_EQ(loaded.repairs->sewn_vertices, 140U);
  EXPECT_EQ(loaded.pins.size(), 60U);
  EXPECT_CONTAINS(test::remarks(loaded),
                  "parts sewn together at 140 vertices where their borders lie within 1 mm (garment.weld)");
  EXPECT_EQ(test::load(folder, test::panels(20, 0.0011)).hanging->parts.size(), 20U);
}

TEST(Trims, GoWithTheClothThatTheyLieOn) {
  const test::TemporaryFolder folder;
  const double front_m = 0.06;
  const auto sewn_on = [&](const sim::Mesh& trim) {
    return test::load(folder, test::both(test::shirt(), trim)).trims_sewn_on;
  };
  const LoadedGarment loaded =
      test::load(folder, test::both(test::shirt(), test::button({0.01, 0.4, front_m + 0.003}, 0.02)));
  ASSERT_EQ(loaded.hanging->parts.size(), 1U);
  EXPECT_EQ(loaded.garment->mesh.triangles.size(), test::shirt().triangles.size() + 8 + 3);
  EXPECT_EQ(loaded.pins.size(), 18U);
  EXPECT_CONTAINS(test::remarks(loaded), "1 small part sewn to the cloth below (garment.weld)");
  EXPECT_EQ(sewn_on(test::button({0.01, 0.4, front_m + 0.018}, 0.02)), 1U);
  EXPECT_EQ(sewn_on(test::button({0.01, 0.4, front_m + 0.022}, 0.02)), 0U) << "it does not lie near the cloth";
  EXPECT_EQ(sewn_on(test::button({0.4, 0.2, front_m}, 0.02)), 0U) << "beside the cloth";
  EXPECT_EQ(sewn_on(test::button({0.01, -0.03, 0.012}, 0.02)), 1U) << "a label that hangs from the hem";
  EXPECT_EQ(sewn_on(test::button({0.01, 0.4, front_m + 0.003}, 0.18)), 1U) << "8 % of the area";
  EXPECT_EQ(sewn_on(test::button({0.01, 0.4, front_m + 0.003}, 0.23)), 0U) << "13 % of the area";
}

// Stitches beside each other would let a button turn.
TEST(Trims, AreStitchedAtPlacesFarFromEachOther) {
  const test::TemporaryFolder folder;
  constexpr double radius_m = 0.02;
  const LoadedGarment loaded =
      test::load(folder, test::both(test::shirt(), test::button({0.01, 0.4, 0.063}, radius_m)));
  const sim::Mesh& mesh = loaded.garment->mesh;
  std::vector<sim::Vec3> stitches_m;
  for (auto t = mesh.triangles.end() - 3; t != mesh.triangles.end(); ++t) stitches_m.push_back(mesh.positions[(*t)[0]]);
  EXPECT_GE(glm::distance(stitches_m[0], stitches_m[1]), radius_m);
  EXPECT_GE(glm::distance(stitches_m[1], stitches_m[2]), radius_m);
  EXPECT_GE(glm::distance(stitches_m[2], stitches_m[0]), radius_m);
}

TEST(Trims, AreLeftAloneWhereTheSceneSaysWhatIsSewn) {
  const test::TemporaryFolder folder;
  const sim::Mesh mesh = test::both(test::shirt(), test::button({0.01, 0.4, 0.063}, 0.02));
  Scene scene;
  scene.garment.file = folder.write("garment.obj", obj_text(mesh, mesh.positions));
  scene.garment.mesh = MeshChoice::model;
  scene.garment.weld_m = 0.0;
  EXPECT_EQ(load_garment(scene).hanging->parts.size(), 2U);
}

sim::Vec3 first_normal(const LoadedGarment& loaded) {
  const sim::Mesh& mesh = loaded.garment->mesh;
  return sim::doubled_area_vector(mesh.positions, mesh.triangles.front());
}

TEST(Outside, IsWhereAGarmentFacesAway) {
  const test::TemporaryFolder folder;
  const auto turned = [&](const sim::Mesh& mesh) { return test::load(folder, mesh).turned_outside_out; };
  const sim::Mesh tetrahedron = {
      {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, 1, 0}}, {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}, {}};
  for (const sim::Mesh& mesh : {test::shirt(), test::hoodie(), test::skirt(), test::trousers(), tetrahedron}) {
    EXPECT_EQ(turned(mesh), 0U);
    EXPECT_GE(turned(test::inside_out(mesh)) + 1, mesh.triangles.size());
    EXPECT_GT(
        glm::dot(first_normal(test::load(folder, test::inside_out(mesh))), first_normal(test::load(folder, mesh))),
        0.0);
  }
  EXPECT_CONTAINS(test::remarks(test::load(folder, test::inside_out(tetrahedron))),
                  "4 triangles of surfaces that faced inwards turned");
  EXPECT_EQ(turned(test::inside_out(test::cape())), 0U) << "a piece with one border has no inside";
}

// A tube whose upper end is turned down over its outside faces inwards there. In the last three cases the turned part
// exceeds the rest by 0.39, 0.47 and 0.58 of the whole.
TEST(Outside, IsLeftAloneWherePartOfAGarmentIsTurnedDown) {
  const test::TemporaryFolder folder;
  const auto turned = [&](double until_m) { return test::load(folder, test::turned_down(until_m)).turned_outside_out; };
  EXPECT_EQ(turned(0.4), 0U);
  EXPECT_EQ(turned(-0.4), 0U);
  EXPECT_EQ(turned(-0.6), 0U);
  EXPECT_GT(turned(-1.0), 0U);
}

TEST(Remarks, SayThatNoGarmentIsSoLarge) {
  const test::TemporaryFolder folder;
  Scene scene;
  const sim::Mesh mesh = test::shirt();
  scene.garment.file = folder.write("garment.obj", obj_text(mesh, mesh.positions));
  scene.garment.scale = 8.0;
  EXPECT_CONTAINS(test::remarks(load_garment(scene)),
                  "it is 7.2 m large, which no garment is, with the unit 8 m, as asked for");
  scene.garment.scale = 2.0;
  EXPECT_EQ(test::remarks(load_garment(scene)).find("no garment is"), std::string::npos);
}

}  // namespace
}  // namespace taut::app
