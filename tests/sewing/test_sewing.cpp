// Patterns sewn on a mannequin, and what is said of those that cannot be.

#include <gtest/gtest.h>

#include <fmt/core.h>

#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>

#include "app/bodies/body_loading.hpp"
#include "app/models/garment_loading.hpp"
#include "app/models/landmarks.hpp"
#include "app/models/scene_crossings.hpp"
#include "app/sewing/sewing.hpp"
#include "app/verify/stretch.hpp"
#include "sim/mesh/topology.hpp"
#include "temporary_folder.hpp"

namespace taut::app {
namespace {

const std::filesystem::path assets = TAUT_ASSETS_FOLDER;

/// A skirt of two panels, so many cm wide above and below, as high as a waist of 1.05 m.
std::string skirt(double waist_cm, double hem_cm) {
  const auto panel = [&](const char* name, double depth_cm) {
    return fmt::format(R"("{}": {{"vertices": [[{}, 0], [{}, -40], [{}, -40], [{}, 0]], "edges": [{{"endpoints": [0, 1]}},
      {{"endpoints": [1, 2], "curvature": [0.5, -0.1]}}, {{"endpoints": [2, 3]}}, {{"endpoints": [3, 0]}}], "translation": [0, 105, {}]}})",
                       name, -0.5 * waist_cm, -0.5 * hem_cm, 0.5 * hem_cm, 0.5 * waist_cm, depth_cm);
  };
  return R"({"pattern": {"panels": {)" + panel("front", 20.0) + ", " + panel("back", -20.0) +
         R"(}, "stitches": [[{"panel": "front", "edge": 0}, {"panel": "back", "edge": 0}],
            [{"panel": "front", "edge": 2}, {"panel": "back", "edge": 2}]]}})";
}

struct Sewing : testing::Test {
  Scene scene_with(const std::filesystem::path& pattern) const {
    Scene scene;
    scene.garment.file = pattern;
    scene.simulation.solver.bounded.max_stretch = 0.01;
    scene.surroundings.bodies = {{.name = "mannequin", .shape = sim::BodyMesh{}}};
    BodySource source;
    source.file = assets / "bodies/mannequin_female_34.glb";
    source.dress = 90;
    scene.body_sources = {source};
    load_bodies(scene);
    return scene;
  }
  SewnGarment sewn(Scene& scene, int triangles, int frames = 60) const { return sew(scene, {triangles, frames}, [](const std::string&) {}); }

  test::TemporaryFolder folder;
};

TEST_F(Sewing, ASkirtIsClosedWornAndAtRestAsItWasCut) {
  Scene scene = scene_with(folder.write("skirt.json", skirt(40.0, 60.0)));
  const SewnGarment garment = sewn(scene, 800);
  EXPECT_LE(garment.max_stretch, 0.01 + 1e-6);
  const sim::Mesh& mesh = garment.sewn.garment.mesh;
  const sim::Topology topology = sim::measure_topology(mesh, sim::make_adjacency(mesh));
  EXPECT_EQ(topology.components, 1u);
  EXPECT_EQ(topology.boundary_loops, 2u);
  EXPECT_EQ(topology.non_manifold_edges, 0u);
  EXPECT_EQ(topology.misoriented_edges, 0u);
  for (const SceneCrossings& crossings : scene_crossings({mesh.positions, mesh.triangles}, scene.surroundings.bodies, garment.time_s)) {
    EXPECT_TRUE(crossings.pairs.empty());
  }
  EXPECT_EQ(mesh.positions.size(), garment.pieces.flat_m.size() - garment.pieces.seams[0].size() - garment.pieces.seams[1].size());
}

TEST_F(Sewing, ItsFileIsAGarmentThatIsAtRestAsItWasCut) {
  Scene scene = scene_with(folder.write("skirt.json", skirt(40.0, 60.0)));
  const SewnGarment garment = sewn(scene, 800, 1);
  const std::filesystem::path file = folder.write("sewn.obj", obj_of(garment));
  folder.write("sewn.landmarks.toml", landmarks_of(garment));
  Scene again;
  again.garment.file = file;
  const LoadedGarment loaded = load_garment(again);
  ASSERT_EQ(loaded.garment->mesh.triangles.size(), garment.pieces.triangles.size());
  EXPECT_EQ(loaded.landmarks.size(), 2u);
  EXPECT_DOUBLE_EQ(loaded.metres_per_uv, 0.01);
  ASSERT_EQ(loaded.file_faces.sections.size(), 2u);
  EXPECT_EQ(loaded.file_faces.sections[0].line, "g back");
  // The border above is as long as it was drafted, whatever it measures where it is worn.
  double flat_m = 0.0, all_m = 0.0;
  for (std::size_t s = 0; s < loaded.garment->springs.structural_count; ++s) {
    all_m += loaded.garment->springs.rest_lengths_m[s];
  }
  for (std::size_t s = 0; s < garment.sewn.garment.springs.structural_count; ++s) {
    flat_m += garment.sewn.garment.springs.rest_lengths_m[s];
  }
  EXPECT_NEAR(all_m, flat_m, 1e-7 * flat_m);
  EXPECT_LE(largest_stretch(loaded.garment->mesh, loaded.garment->mesh.positions).surface, 0.01 + 1e-6);
  double side_m = 0.0;
  const auto& seam = garment.pieces.seams[0];
  for (std::size_t k = 1; k < seam.size(); ++k) {
    side_m += glm::distance(garment.pieces.flat_m[seam[k - 1].first], garment.pieces.flat_m[seam[k].first]);
  }
  EXPECT_NEAR(side_m, std::hypot(0.4, 0.1), 5e-4);
}

TEST_F(Sewing, SaysThatWhatWasSewnIsTooSmall) {
  Scene scene = scene_with(folder.write("skirt.json", skirt(30.0, 35.0)));
  scene.simulation.solver.max_substeps = 30;  // more would try harder, and longer
  const std::string message = test::message_of<SewingFailed>([&] { sewn(scene, 200); });
  EXPECT_NE(message.find("its seams are closed, but it cannot be worn: while it is dressed"), std::string::npos) << message;
  EXPECT_NE(message.find("in a garment of 6"), std::string::npos) << message;
}

TEST_F(Sewing, SaysWhichSeamStaysOpenAndByHowMuch) {
  // The waist is sewn together as well, and the body is in between.
  std::string text = skirt(40.0, 60.0);
  text.replace(text.rfind("]}}"), 3, R"(, [{"panel": "front", "edge": 3}, {"panel": "back", "edge": 3}]]}})");
  Scene scene = scene_with(folder.write("skirt.json", text));
  try {
    sewn(scene, 400);
    FAIL() << "it was sewn";
  } catch (const SewingFailed& error) {
    EXPECT_NE(std::string(error.what()).find("a seam stays open: front, edge 3 with back, edge 3, by "), std::string::npos) << error.what();
    EXPECT_GT(error.garment.sewn.gap_m, 0.005);
    EXPECT_FALSE(error.garment.sewn.garment.mesh.triangles.empty()) << "there is nothing to draw";
  }
}

TEST_F(Sewing, SewsAShirtThatNobodyHereMade) {
  const char* const folder_of_patterns = std::getenv("TAUT_PATTERNS");
  const std::filesystem::path pattern = std::filesystem::path(folder_of_patterns != nullptr ? folder_of_patterns : "") / "shirt_mean.json";
  if (!std::filesystem::exists(pattern)) {
    GTEST_SKIP() << "TAUT_PATTERNS names no folder with shirt_mean.json of GarmentCode";
  }
  Scene scene = scene_with(pattern);
  const SewnGarment garment = sewn(scene, 2000);
  EXPECT_LE(garment.max_stretch, 0.01 + 1e-6);
  EXPECT_EQ(garment.sewn.gap_m, 0.0);
}

}  // namespace
}  // namespace taut::app
