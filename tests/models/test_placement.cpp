#include <gtest/gtest.h>

#include "app/models/hanging/hanging.hpp"
#include "app/models/hanging/placement.hpp"
#include "garment_shapes.hpp"
#include "temporary_folder.hpp"

namespace taut::app {
namespace {

sim::Mesh bounding_box(double x, double y, double z, const sim::Vec3& at = {0, 0, 0}) {
  return {{at, at + sim::Vec3(x, y, 0), at + sim::Vec3(0, y, z)}, {{0, 1, 2}}, {}};
}

TEST(Placement, GuessesTheUnitOfAGarment) {
  EXPECT_EQ(place_model(bounding_box(0.5, 0.7, 0.3), {}).scale, 1.0);
  EXPECT_FALSE(place_model(bounding_box(0.5, 0.7, 0.3), {}).guessed);
  EXPECT_EQ(place_model(bounding_box(50, 70, 30), {}).scale, 0.01);
  EXPECT_EQ(place_model(bounding_box(500, 700, 300), {}).scale, 0.001);
  EXPECT_EQ(place_model(bounding_box(5, 7, 3), {}).scale, 0.1);
  EXPECT_DOUBLE_EQ(place_model(bounding_box(1e9, 2e9, 0), {}).scale, 0.5e-9);
  EXPECT_DOUBLE_EQ(place_model(bounding_box(1e-9, 2e-9, 0), {}).scale, 0.5e9);
}

TEST(Placement, LooksAtOneOfSeveralGarmentsSideBySide) {
  const auto row_of = [](double unit) {
    sim::Mesh row;
    for (sim::Index k = 0; k < 5; ++k) {
      const sim::Mesh one = bounding_box(0.5 * unit, 0.7 * unit, 0.3 * unit, {1.1 * k * unit, 0.0, 0.0});
      row.positions.insert(row.positions.end(), one.positions.begin(), one.positions.end());
      row.triangles.push_back({3 * k, 3 * k + 1, 3 * k + 2});
    }
    return row;
  };
  EXPECT_EQ(place_model(row_of(1.0), {}).scale, 1.0);
  EXPECT_FALSE(place_model(row_of(1.0), {}).is_vast);
  EXPECT_EQ(place_model(row_of(100.0), {}).scale, 0.01);
  EXPECT_EQ(place_model(row_of(1000.0), {}).scale, 0.001);
}

TEST(Placement, BelievesTheFileWithinReason) {
  const Placement inches = place_model(bounding_box(10, 30, 5), {{}, {}, 0.0254, {}});
  EXPECT_EQ(inches.scale, 0.0254);
  EXPECT_EQ(inches.unit_text, "inch, as the file says");
  const Placement centimetres = place_model(bounding_box(50, 70, 30), {{}, {}, 1.0, {}});
  EXPECT_EQ(centimetres.scale, 0.01);
  EXPECT_EQ(centimetres.unit_text, "centimetre, guessed, since the file's own, metre, would make it 70 m large");
  EXPECT_EQ(place_model(bounding_box(50, 70, 30), {1.0, {}, 0.01, {}}).scale, 1.0);
}

// Sizes on both sides of each limit.
TEST(Placement, KnowsTheSizesOfGarments) {
  const auto guessed = [](double size) { return place_model(bounding_box(size, size, 0), {}).scale; };
  EXPECT_EQ(guessed(0.25), 1.0);
  EXPECT_EQ(guessed(0.15), 1.0) << "a glove";
  EXPECT_DOUBLE_EQ(guessed(0.08), 1.0 / 0.08);
  EXPECT_EQ(guessed(1.9), 1.0);
  EXPECT_EQ(guessed(2.4), 0.3048) << "0.73 m in feet";
  EXPECT_EQ(guessed(3.0), 0.3048) << "0.91 m in feet, 0.3 m in decimetres";
  EXPECT_EQ(guessed(6.0), 0.1);
  EXPECT_EQ(guessed(28.0), 0.0254) << "0.71 m in inches, 0.28 m in centimetres";
  EXPECT_EQ(guessed(60.0), 0.01);
  EXPECT_EQ(guessed(80.0), 0.01);
  EXPECT_EQ(place_model(bounding_box(50, 50, 0), {}).unit_text,
            "centimetre, guessed from its size of 0.5 m; the inch would make it 1.3 m");
  const auto believed = [](double size) {
    return place_model(bounding_box(size, size, 0), {{}, {}, 1.0, {}}).unit_text == "metre, as the file says";
  };
  EXPECT_TRUE(believed(0.03));
  EXPECT_FALSE(believed(0.015));
  EXPECT_TRUE(believed(15.0));
  EXPECT_FALSE(believed(25.0));
}

sim::Mesh scaled(sim::Mesh mesh, double factor) {
  for (sim::Vec3& position : mesh.positions) position *= factor;
  return mesh;
}

TEST(Placement, ReadsAPersonsGarmentInEveryUnit) {
  const sim::Mesh hat = scaled(test::bottle(0.45, {0.0, 0.0}), 0.45);
  const sim::Mesh glove = scaled(test::bottle(1.2, {0.0, 0.0}), 0.2);
  for (const sim::Mesh& garment :
       {test::shirt(), test::skirt(), test::trousers(), test::strap_dress(), test::jacket(), test::hoodie(), hat, glove,
        test::thick(scaled(test::skirt(), 0.85)), test::thick(scaled(test::trousers(), 1.3))}) {
    for (const Unit& unit : units) {
      EXPECT_EQ(place_model(scaled(garment, 1.0 / unit.metres), {}).scale, unit.metres)
          << unit.name << ", " << garment.triangles.size() << " triangles";
    }
  }
}

TEST(Placement, ASlitIsNoCuff) {
  sim::Mesh shirt = test::shirt();
  const sim::Vec3 slit = {0.1, 0.3, sim::compute_extent(shirt.positions).upper.z};
  const auto is_in_slit = [&](const sim::Triangle& t) {
    return glm::distance(triangle_middle(shirt.positions, t), slit) < 0.03;
  };
  EXPECT_GT(std::erase_if(shirt.triangles, is_in_slit), 0u);
  EXPECT_EQ(place_model(scaled(shirt, 70.0), {}).scale, 0.01) << "in inches it would be 1.6 m large";
}

TEST(Placement, TurnsTheModelUpright) {
  const sim::Vec3 p(1, 2, 3);
  const auto turned = [&](ModelAxis up) { return place_model(bounding_box(1, 1, 1), {1.0, up, {}, {}})(p); };
  EXPECT_EQ(turned(ModelAxis::y), sim::Vec3(1, 2, 3));
  EXPECT_EQ(turned(ModelAxis::z), sim::Vec3(1, 3, -2));
  EXPECT_EQ(turned(ModelAxis::x), sim::Vec3(-2, 1, 3));
  EXPECT_EQ(turned(ModelAxis::minus_y), sim::Vec3(1, -2, -3));
  EXPECT_EQ(turned(ModelAxis::minus_z), sim::Vec3(1, -3, 2));
  EXPECT_EQ(turned(ModelAxis::minus_x), sim::Vec3(2, -1, 3));
  EXPECT_EQ(place_model(bounding_box(1, 0.3, 1), {}).up, ModelAxis::z);
  EXPECT_EQ(place_model(bounding_box(1, 0.6, 1), {}).up, ModelAxis::y);
  EXPECT_EQ(place_model(bounding_box(1, 0.3, 1), {{}, {}, {}, ModelAxis::y}).up, ModelAxis::y);
}

TEST(Placement, BringsBackWhatIsVeryFarAway) {
  const sim::Mesh far = bounding_box(1, 1, 0, {1e6, 0, 0});
  EXPECT_NEAR(place_model(far, {})(far.positions[0]).x, -0.5, 1e-9);
  EXPECT_EQ(place_model(bounding_box(1, 1, 0, {700, 0, 0}), {}).moved_m, sim::Vec3(0.0));
  EXPECT_NE(place_model(bounding_box(1, 1, 0, {1500, 0, 0}), {}).moved_m, sim::Vec3(0.0));
}

/// A tube of four sides, like a sleeve, a skirt or a shirt without a neck.
sim::Mesh tube(double top, double bottom, double x = 0.0) {
  sim::Mesh mesh;
  for (const double y : {bottom, 0.5 * (top + bottom), top}) {
    for (const sim::Vec3& p : {sim::Vec3(0.2, y, 0.2), {-0.2, y, 0.2}, {-0.2, y, -0.2}, {0.2, y, -0.2}}) {
      mesh.positions.push_back(p + sim::Vec3(x, 0, 0));
    }
  }
  for (sim::Index ring = 0; ring < 8; ring += 4) {
    for (sim::Index k = 0; k < 4; ++k) {
      const sim::Index a = ring + k, b = ring + (k + 1) % 4;
      mesh.triangles.push_back({a, b, a + 4});
      mesh.triangles.push_back({b, b + 4, a + 4});
    }
  }
  return mesh;
}

Hanging hung(const sim::Mesh& mesh) { return hang(mesh, sim::make_adjacency(mesh)); }

TEST(Hanging, HoldsATubeByItsTopOpening) {
  const Hanging hanging = hung(tube(1.0, 0.0));
  ASSERT_EQ(hanging.parts.size(), 1U);
  EXPECT_EQ(hanging.parts[0].by, HungBy::top_opening);
  EXPECT_EQ(hanging.pins, (std::vector<sim::Index>{8, 9, 10, 11}));
}

TEST(Hanging, HoldsEveryPartByItself) {
  sim::Mesh mesh = tube(1.0, 0.0);
  // A triangle that stands on its tip far below, and one that lies flat.
  for (const sim::Vec3& p : {sim::Vec3(3, -1, 0), {4, 0, 0}, {2, 0, 0}, {6, 0, -1}, {7, 0, 0}, {5, 0, 0}}) {
    mesh.positions.push_back(p);
  }
  mesh.triangles.push_back({12, 13, 14});
  mesh.triangles.push_back({15, 16, 17});
  const Hanging hanging = hung(mesh);
  ASSERT_EQ(hanging.parts.size(), 3U);
  EXPECT_EQ(hanging.parts[1].by, HungBy::highest_band);
  EXPECT_EQ(hanging.parts[2].by, HungBy::back_edge);
  EXPECT_EQ(hanging.pins, (std::vector<sim::Index>{8, 9, 10, 11, 13, 14, 15}));
  const std::vector<std::string> lines = describe(hanging);
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(lines[2], "part 3 of 3: 3 vertices, lies flat, held by its back edge, 1 pin");
  EXPECT_CONTAINS(lines[3], "2 parts are flat, like pattern pieces");
}

TEST(Hanging, SaysWhatIsClosed) {
  const sim::Mesh tetrahedron = {
      {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, 1, 0}}, {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}, {}};
  const Hanging hanging = hung(tetrahedron);
  EXPECT_TRUE(hanging.parts[0].closed);
  EXPECT_EQ(hanging.pins, (std::vector<sim::Index>{3}));
  EXPECT_CONTAINS(describe(hanging).back(), "1 part is closed all around");
}

}  // namespace
}  // namespace taut::app
