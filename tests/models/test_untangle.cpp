// Starts that cross, and their shapes after untangling, judged by the exact test for crossings of app/verify.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "app/models/garment_loading.hpp"
#include "app/models/inspecting/remarks.hpp"
#include "app/models/reading/file_mesh.hpp"
#include "app/runs/frame_verifier.hpp"
#include "app/verify/crossing_pairs.hpp"
#include "sim/untangle/untangle.hpp"
#include "temporary_folder.hpp"

namespace taut::app {
namespace {

/// Adds a grid of vertices. `place` maps columns and rows, both from 0 to 1, to positions; `closed` joins the columns
/// to a tube.
template <class Place>
void add_grid(sim::Mesh& mesh, sim::Index columns, sim::Index rows, bool closed, const Place& place) {
  const auto first = static_cast<sim::Index>(mesh.positions.size());
  for (sim::Index j = 0; j < rows; ++j) {
    for (sim::Index i = 0; i < columns; ++i) {
      mesh.positions.push_back(place(double(i) / (closed ? columns : columns - 1), double(j) / (rows - 1)));
    }
  }
  for (sim::Index j = 0; j + 1 < rows; ++j) {
    for (sim::Index i = 0; i < (closed ? columns : columns - 1); ++i) {
      const sim::Index a = first + j * columns + i, b = first + j * columns + (i + 1) % columns;
      mesh.triangles.push_back({a, b, b + columns});
      mesh.triangles.push_back({a, b + columns, a + columns});
    }
  }
}

sim::Vec3 on_circle(double u, double radius, double height) {
  const double angle = 2.0 * std::numbers::pi * u;
  return {radius * std::cos(angle), height, -radius * std::sin(angle)};
}

/// A tube of two walls 3 mm apart, joined at its hems, whose waves go through each other.
sim::Mesh tube_of_two_walls(double waves_m) {
  sim::Mesh tube;
  add_grid(tube, 40, 39, true, [&](double u, double t) {
    const double height = t < 0.5 ? 2.0 * t : 2.0 - 2.0 * t;
    const double side = t < 0.5 ? 1.0 : -1.0;
    const double wave = std::sin(6.0 * std::numbers::pi * u) * std::sin(3.0 * std::numbers::pi * height);
    return on_circle(u, 0.15 + (t == 0.5 ? 0.0 : side * (0.0015 + waves_m * wave)), 0.4 * height);
  });
  return tube;
}

sim::Mesh sheet() {
  sim::Mesh mesh;
  add_grid(mesh, 21, 21, false, [](double u, double v) { return sim::Vec3(0.4 * u - 0.2, 0.0, 0.4 * v - 0.2); });
  return mesh;
}

/// A tongue of 20 cm that hangs through the sheet by 3 cm.
sim::Mesh sheet_and_tongue() {
  sim::Mesh mesh = sheet();
  add_grid(mesh, 5, 11, false, [](double u, double v) { return sim::Vec3(0.013 + 0.08 * u, 0.2 * v - 0.031, 0.007); });
  return mesh;
}

/// A ring that goes once through the middle of the sheet. Only a cut could separate them.
sim::Mesh sheet_and_ring() {
  sim::Mesh mesh = sheet();
  add_grid(mesh, 60, 3, true, [](double u, double v) {
    const sim::Vec3 p = on_circle(u, 0.25, 0.02 * v - 0.007);
    return sim::Vec3(p.x + 0.253, p.z, p.y);
  });
  return mesh;
}

struct Untangle : testing::Test {
  Scene make_scene(const sim::Mesh& mesh, bool untangle) {
    Scene scene;
    scene.garment.file = folder.write("model.obj", obj_text(mesh, mesh.positions));
    scene.garment.scale = 1.0;
    scene.garment.up = ModelAxis::y;
    scene.garment.untangle = untangle;
    scene.garment.mesh = MeshChoice::model;
    scene.garment.weld_m = 1e-6;
    scene.simulation.solver.bounded.max_stretch = 0.01;
    return scene;
  }

  /// Requires that the start was moved and that nothing crosses in it.
  static void expect_apart(const LoadedGarment& loaded) {
    EXPECT_GT(loaded.untangling.value().pairs_before, 0U);
    EXPECT_EQ(loaded.untangling->pairs_left, 0U);
    EXPECT_EQ(count_crossings(loaded), 0U);
    const double narrow_m = 0.49 * loaded.garment->material.thickness_m;
    EXPECT_TRUE(sim::find_gaps(*loaded.garment, narrow_m, 0.0, *loaded.start_m).empty());
  }

  static std::size_t count_crossings(const LoadedGarment& loaded) {
    return crossing_pairs(surface_at_start(loaded)).size();
  }

  /// Returns the first broken promise at the start or in 30 frames; empty if none is broken. Requires that nothing
  /// was left out.
  static std::string broken_in_a_run(const Scene& scene, const LoadedGarment& loaded) {
    sim::Simulation simulation = make_simulation(scene, loaded);
    EXPECT_EQ(simulation.state().current, *loaded.start_m) << "was moved once more";
    FrameVerifier verifier;
    std::string broken = verifier.begin(simulation);
    for (int frame = 0; frame <= 30 && broken.empty(); ++frame) {
      if (frame > 0) {
        simulation.advance_frame();
      }
      FrameRecord record = measure_frame(simulation, frame);
      broken = verifier.check(simulation, record);
    }
    return broken;
  }

  test::TemporaryFolder folder;
};

// Five of the file's nine quads lie on each other. The model becomes a fitted mesh that crosses itself.
TEST_F(Untangle, KeepsEveryCoordinateANumber) {
  Scene scene;
  scene.garment.file = TAUT_TESTS_FOLDER "/models/shapes/nine_quads_that_cross.obj";
  const LoadedGarment loaded = load_garment(scene);
  for (const sim::Vec3& p : surface_at_start(loaded).positions_m) EXPECT_TRUE(is_exactly_comparable(p));
}

TEST_F(Untangle, PartsTheWallsOfAThickTube) {
  const Scene scene = make_scene(tube_of_two_walls(0.003), true);
  const LoadedGarment loaded = load_garment(scene);
  EXPECT_GT(loaded.untangling.value().pairs_before, 100U);
  expect_apart(loaded);
  EXPECT_LT(loaded.untangling->max_move_m, 0.005);
  EXPECT_LE(sim::measure_surface_stretch(*loaded.garment, *loaded.start_m).max,
            scene.simulation.solver.bounded.max_stretch);
  EXPECT_EQ(broken_in_a_run(scene, loaded), "");
}

// Waves of the walls are many times as high as the walls are apart. No contour shows the inside.
TEST_F(Untangle, TurnsWallsToTheSideTheyFace) {
  const Scene scene = make_scene(tube_of_two_walls(0.006), true);
  const LoadedGarment loaded = load_garment(scene);
  expect_apart(loaded);
  for (std::size_t v = 0; v < loaded.start_m->size(); ++v) {
    const sim::Vec3& from = loaded.garment->mesh.positions[v];
    ASSERT_LT(glm::distance((*loaded.start_m)[v], from), 0.015) << v;
  }
}

TEST_F(Untangle, PullsATongueOutOnTheNearerSide) {
  const Scene scene = make_scene(sheet_and_tongue(), true);
  const LoadedGarment loaded = load_garment(scene);
  expect_apart(loaded);
  EXPECT_LT(loaded.untangling.value().max_move_m, 0.04);
  double sheet_m = 0.0, tip_m = 0.0;
  for (std::size_t v = 0; v < loaded.start_m->size(); ++v) {
    const sim::Vec3& rest_m = loaded.garment->mesh.positions[v];
    const double height_m = (*loaded.start_m)[v].y;
    tip_m += rest_m.y < -0.03 ? height_m / 5.0 : 0.0;
    sheet_m +=
        rest_m.y == 0.0 && std::abs(rest_m.z) < 1e-9 && rest_m.x > 0.01 && rest_m.x < 0.11 ? height_m / 5.0 : 0.0;
  }
  EXPECT_GT(tip_m, sheet_m) << "the tip is above the sheet";
  EXPECT_EQ(broken_in_a_run(scene, loaded), "");
}

// The contour begins at the border of one sheet and ends at the border of the other, so it encloses no part of
// either.
TEST_F(Untangle, PullsOutASheetThatIsSlidIntoAnother) {
  sim::Mesh mesh = sheet();
  add_grid(mesh, 11, 11, false,
           [](double u, double v) { return sim::Vec3(0.003, 0.2 * u - 0.101, 0.2 * v - 0.2 - 0.167); });
  const Scene scene = make_scene(mesh, true);
  const LoadedGarment loaded = load_garment(scene);
  expect_apart(loaded);
  EXPECT_EQ(broken_in_a_run(scene, loaded), "");
}

// The layers have no distance at rest. They must nevertheless be kept apart by the cloth's thickness.
TEST_F(Untangle, LayersThatAreOneAtRestCarryEachOther) {
  sim::Mesh layers;
  add_grid(layers, 17, 17, false, [](double u, double v) { return sim::Vec3(0.2 * u, 0.0, 0.2 * v); });
  add_grid(layers, 17, 17, false, [](double u, double v) {
    return sim::Vec3(0.2 * u + 0.003, 2e-7 * std::sin(20.0 * u) * std::cos(20.0 * v), 0.2 * v + 0.002);
  });
  Scene scene = make_scene(layers, true);
  scene.pins.emplace();
  for (const auto& corner : {sim::Vec3(0, 0, 0), sim::Vec3(0.2, 0, 0), sim::Vec3(0, 0, 0.2), sim::Vec3(0.2, 0, 0.2)}) {
    scene.pins->push_back(NearestTo{corner});
  }
  const LoadedGarment loaded = load_garment(scene);
  expect_apart(loaded);
  EXPECT_EQ(broken_in_a_run(scene, loaded), "");
}

TEST_F(Untangle, SaysWhatCannotBeParted) {
  const Scene scene = make_scene(sheet_and_ring(), true);
  const LoadedGarment loaded = load_garment(scene);
  ASSERT_TRUE(loaded.untangling);
  const std::size_t left = count_crossings(loaded);
  EXPECT_GT(left, 0U);
  EXPECT_EQ(loaded.untangling->pairs_left, left);
  EXPECT_LE(left, loaded.untangling->pairs_before);
  EXPECT_LT(loaded.untangling->max_move_m, 0.15) << "about five edges";
  const std::vector<std::string> remarks = remarks_on_start(scene, loaded, {}).lines;
  ASSERT_EQ(remarks.size(), 2U);
  EXPECT_CONTAINS(remarks[0], "that crossed at the start " + std::to_string(left));
  EXPECT_CONTAINS(remarks[1], "at the start " + std::to_string(left));
  EXPECT_CONTAINS(remarks[1], "the first: triangle ");
}

TEST_F(Untangle, LeavesWhatDoesNotCrossAsItIs) {
  const sim::Mesh tube = tube_of_two_walls(0.0);
  const LoadedGarment plain = load_garment(make_scene(tube, false));
  const LoadedGarment asked = load_garment(make_scene(tube, true));
  EXPECT_FALSE(asked.untangling);
  EXPECT_FALSE(asked.start_m);
  EXPECT_TRUE(asked.garment->untangled_m.empty());
  EXPECT_EQ(surface_at_start(asked).positions_m.size(), plain.garment->mesh.positions.size());
  EXPECT_TRUE(remarks_on_start(make_scene(tube, true), asked, {}).lines.empty());
}

TEST(UntangleBudget, EndsWithTheBestShapeSoFar) {
  const sim::Mesh mesh = sheet_and_tongue();
  const sim::Garment garment = sim::make_garment(mesh, {}, sim::Material{});
  int rounds = 0;
  const auto find = [&](std::span<const sim::Vec3> positions_m) {
    ++rounds;
    std::vector<sim::TrianglePair> pairs;
    for (const sim::CrossingPair& pair : crossing_pairs({positions_m, mesh.triangles}))
      pairs.push_back({pair.first, pair.second});
    return pairs;
  };
  sim::UntangleSettings settings;
  const sim::UntangleResult whole = sim::untangle(garment, mesh.positions, settings, find);
  EXPECT_FALSE(whole.is_given_up);
  const int all_rounds = std::exchange(rounds, 0);
  settings.max_pairs = 3 * whole.pairs_before;
  const sim::UntangleResult part = sim::untangle(garment, mesh.positions, settings, find);
  EXPECT_TRUE(part.is_given_up);
  EXPECT_LT(rounds, all_rounds);
  EXPECT_LE(part.pairs_left, part.pairs_before);
  EXPECT_NE(describe(part).find("untangling was given up"), std::string::npos);
  settings.max_pairs = whole.pairs_before - 1;
  EXPECT_EQ(sim::untangle(garment, mesh.positions, settings, find).positions_m, mesh.positions);
}

// Two sheets 10 micrometres apart. In one of them a vertex was moved until its triangles are almost flat.
TEST(UntangleAnew, PartsWhatIsAsOneAndEvensOutWhatIsFlat) {
  sim::Mesh mesh;
  for (const double height_m : {0.0, 1e-5}) {
    add_grid(mesh, 21, 21, false, [&](double u, double v) { return sim::Vec3(0.4 * u, height_m, 0.4 * v); });
  }
  const std::size_t moved = 10 * 21 + 10;
  mesh.positions[moved].x += 0.0195;
  const sim::Garment garment = sim::make_garment(mesh, {}, sim::Material{});
  const auto none = [](std::span<const sim::Vec3>) { return std::vector<sim::TrianglePair>{}; };
  sim::UntangleSettings settings;
  EXPECT_EQ(sim::untangle(garment, mesh.positions, settings, none).max_move_m, 0.0);
  settings.is_cut_anew = true;
  const sim::UntangleResult parted = sim::untangle(garment, mesh.positions, settings, none);
  EXPECT_TRUE(sim::find_gaps(garment, 0.5 * settings.distance_m, 0.0, parted.positions_m).empty());
  EXPECT_GT(glm::distance(parted.positions_m[moved], parted.positions_m[moved + 1]), 0.005);
  EXPECT_TRUE(crossing_pairs({parted.positions_m, mesh.triangles}).empty());
}

TEST_F(Untangle, IsOfferedWhereSomethingCrosses) {
  const Scene scene = make_scene(sheet_and_tongue(), false);
  const LoadedGarment loaded = load_garment(scene);
  EXPECT_FALSE(loaded.untangling);
  const std::vector<std::string> remarks = remarks_on_start(scene, loaded, {}).lines;
  ASSERT_EQ(remarks.size(), 1U);
  EXPECT_CONTAINS(remarks[0], "--untangle");
}

// A start that was draped without contact, of a model that does not cross itself.
TEST_F(Untangle, PartsAStartThatWasDraped) {
  sim::Mesh flat;
  add_grid(flat, 21, 31, false, [](double u, double v) { return sim::Vec3(0.4 * u, 0.0, 0.6 * v); });
  Scene scene = make_scene(flat, false);
  const sim::Mesh rest = load_garment(scene).garment->mesh;
  std::vector<sim::Vec3> folded_m = rest.positions;
  for (sim::Vec3& p : folded_m) {
    // The back third lies over the middle and dips through it.
    const double beyond_m = p.z - 0.4;
    if (beyond_m > 0.0) {
      p.z = 0.4 - 0.99 * beyond_m;
      p.y = 0.004 * std::cos(30.0 * p.x + 40.0 * beyond_m) + 0.002;
    }
  }
  scene.garment.start = folder.write("start.obj", obj_text(rest, folded_m));
  scene.garment.untangle = true;
  const LoadedGarment loaded = load_garment(scene);
  EXPECT_GT(loaded.untangling.value().pairs_before, 20U);
  expect_apart(loaded);
  EXPECT_EQ(broken_in_a_run(scene, loaded), "");
  EXPECT_TRUE(loaded.garment->untangled_m.empty()) << "of what does not cross at rest";
  EXPECT_EQ(loaded.garment->mesh.positions, rest.positions);
}

TEST(StartCrossings, AreDescribedByTheFirst) {
  const std::vector<sim::Vec3> positions = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, -1}, {1, 1, 1}};
  const std::vector<sim::Triangle> triangles = {{0, 1, 2}, {3, 4, 4}};
  const std::vector<sim::CrossingPair> pairs(3, {0, 1, {1.0, 1.0, 0.0}});
  EXPECT_EQ(describe({positions, triangles}, pairs),
            "3 pairs of triangles cross, the first: triangle 0 (vertices 0, 1, 2) and triangle 1 (vertices 3, 4, 4) at "
            "[1.00000, 1.00000, 0.00000] m");
  EXPECT_TRUE(describe({positions, triangles}, std::span(pairs).first(1)).starts_with("1 pair of triangles crosses"));
}

// Contact keeps neighbours apart by half of their distance at rest, and not at all if that distance is zero.
TEST(Gaps, AreFoundBetweenNeighboursThatAlmostTouch) {
  const double near_m = 5e-6;
  const sim::Mesh mesh = {{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.5, -1.0, 1.0}, {0.5, near_m, -0.3}, {0.5, near_m, 0.3}},
                          {{0, 1, 2}, {0, 3, 4}},
                          {}};
  const sim::Garment garment = sim::make_garment(mesh);
  EXPECT_TRUE(sim::find_gaps(garment, 1e-3, 1e-6, mesh.positions).empty());
  const std::vector<sim::Gap> gaps = sim::find_gaps(garment, 1e-3, 1e-5, mesh.positions);
  ASSERT_FALSE(gaps.empty());
  EXPECT_NEAR(gaps.front().width_m, near_m, 1e-9);
}

}  // namespace
}  // namespace taut::app
