#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/frame_loop.hpp"
#include "app/garment/garment_loading.hpp"
#include "app/garment/inspection.hpp"
#include "app/output/run_report.hpp"

namespace taut::app {
namespace {

using nlohmann::json;

TEST(RunReport, HoldsWhatTheDesignPromises) {
  Scene scene;
  scene.name = "test";
  scene.garment.grid = {.columns = 3, .rows = 3};
  scene.simulation.solver.substeps = 7;
  sim::Simulation simulation(load_garment(scene).garment, scene.simulation, scene.surroundings);
  const auto records = run_frames(simulation, 2, {});
  const json report = json::parse(statistics_json(scene, simulation.garment(), "llvmpipe", records));
  EXPECT_EQ(report["scene"], "test");
  EXPECT_EQ(report["garment"]["vertices"], 9);
  EXPECT_EQ(report["garment"]["triangles"], 8);
  EXPECT_EQ(report["garment"]["pins"], 3);
  EXPECT_EQ(report["garment"]["springs"], (json{{"structural", 12}, {"shear", 8}, {"flexural", 6}}));
  EXPECT_EQ(report["settings"]["solver"]["substeps"], 7);
  EXPECT_EQ(report["settings"]["garment"]["grid"]["columns"], 3);
  EXPECT_EQ(report["versions"]["gl_renderer"], "llvmpipe");
  EXPECT_TRUE(report["versions"].contains("program"));
  EXPECT_TRUE(report["versions"].contains("compiler"));
  ASSERT_EQ(report["frames"].size(), 2U);
  for (const char* key :
       {"frame", "time_s", "max_stretch", "p99_stretch", "mean_stretch", "max_compression", "rms_speed",
        "kinetic_energy", "potential_energy", "convergence", "sim_ms", "draw_ms", "encode_ms"}) {
    EXPECT_TRUE(report["frames"][1][key].is_number()) << key;
  }
  EXPECT_EQ(report["frames"][1]["state_hash"].get<std::string>().size(), 16U);
  EXPECT_EQ(report["frames"][1]["asleep"], false);
  EXPECT_EQ(report["summary"]["frames"], 2);
}

TEST(RunReport, NamesNoRendererWhereNothingWasDrawn) {
  Scene scene;
  const LoadedGarment loaded = load_garment(scene);
  EXPECT_FALSE(
      json::parse(statistics_json(scene, loaded.garment, "", {}))["versions"].contains("gl_renderer"));
}

TEST(Inspection, MeasuresTheTShirt) {
  Scene scene;
  scene.garment.file = TAUT_ASSETS_FOLDER "/garments/tshirt_1028.obj";
  const Inspection inspection = inspect_garment(scene, load_garment(scene));
  EXPECT_EQ(inspection.triangles, 1028U);
  EXPECT_EQ(inspection.topology.components, 1U);
  EXPECT_EQ(inspection.topology.boundary_loops, 4U);
  EXPECT_LT(inspection.shortest_edge_m, inspection.mean_edge_m);
  EXPECT_LT(inspection.mean_edge_m, inspection.longest_edge_m);
  const json report = json::parse(inspection_json(inspection));
  EXPECT_EQ(report["triangles"], 1028);
  EXPECT_EQ(report["bounding_box_m"].size(), 2U);
  EXPECT_EQ(report["springs"]["structural"], inspection.structural_springs);
  EXPECT_GT(report["landmarks"]["hem"].get<int>(), 4);
}

}  // namespace
}  // namespace taut::app
