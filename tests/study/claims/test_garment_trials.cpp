#include <gtest/gtest.h>

#include "app/base/errors.hpp"
#include "app/drawing/drawn_scene.hpp"
#include "app/models/garment_loading.hpp"
#include "sim/mesh/groups.hpp"
#include "temporary_folder.hpp"
#include "tests/study/claims/trials.hpp"

namespace taut::app {
namespace {

using test::TemporaryFolder;

// Measures of the triangles, computed without the program's own topology.
struct Shape {
  std::size_t border_edges = 0;
  std::size_t borders = 0;        ///< closed lines of border edges
  std::size_t crowded_edges = 0;  ///< edges with more than two triangles
  std::size_t edges = 0;
  int euler_characteristic = 0;
};

Shape make_shape(const sim::Mesh& mesh) {
  std::map<std::array<sim::Index, 2>, int> uses;
  for (const sim::Triangle& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) ++uses[{std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3])}];
  }
  Shape shape;
  shape.edges = uses.size();
  std::vector<std::array<sim::Index, 2>> border;
  for (const auto& [edge, count] : uses) {
    if (count == 1) border.push_back(edge);
    shape.crowded_edges += count > 2 ? 1 : 0;
  }
  shape.border_edges = border.size();
  sim::Groups lines = sim::connect_vertices(mesh.positions.size(), border);
  std::set<sim::Index> names;
  for (const auto& edge : border) names.insert(lines.find(edge[0]));
  shape.borders = names.size();
  shape.euler_characteristic =
      static_cast<int>(mesh.positions.size()) - static_cast<int>(shape.edges) + static_cast<int>(mesh.triangles.size());
  return shape;
}

TEST(SampleGarments, AreWhatTheySayOnceTheyAreReadBack) {
  std::map<std::string, Shape> shapes;
  std::set<std::string> formats;
  for (const auto& entry : std::filesystem::directory_iterator(TAUT_ASSETS_FOLDER "/garments/samples")) {
    const std::string name = entry.path().stem().string(), format = entry.path().extension().string();
    DrawnScene scene = find_scene(entry.path().string(), {});
    scene.garment.mesh = MeshChoice::model;
    const LoadedGarment loaded = load_garment(scene);
    shapes[name] = make_shape(loaded.garment->mesh);
    formats.insert(format);
    EXPECT_EQ(loaded.placement->scale, format == ".fbx" ? 0.01 : 1.0) << name;
    EXPECT_EQ(loaded.garment->springs.count(sim::SpringKind::structural), shapes[name].edges) << name;
    if (name == "turned") {
      EXPECT_GT(loaded.repairs->turned_triangles, 50U);
    } else if (name == "honeycomb") {
      EXPECT_EQ(loaded.model->file_polygons, 100U);
    } else if (name == "sheet") {
      EXPECT_EQ(loaded.model->file_quads, 13U * 17U);
    }
  }
  EXPECT_EQ(shapes.size(), 11U);
  EXPECT_EQ(formats.size(), 6U);
  EXPECT_EQ(shapes["skirt"].borders, 2U);
  EXPECT_EQ(shapes["cushion"].border_edges, 0U);
  EXPECT_EQ(shapes["cushion"].euler_characteristic, 2) << "a closed ball";
  EXPECT_EQ(shapes["band"].borders, 1U);
  EXPECT_EQ(shapes["band"].euler_characteristic, 0);
  EXPECT_EQ(shapes["wings"].crowded_edges, 13U);
  EXPECT_EQ(shapes["sleeves"].borders, 6U) << "three tubes";
  EXPECT_EQ(shapes["lining"].borders, 4U) << "two tubes";
}

TEST(GarmentTrials, CountWhatASolverReached) {
  const std::string file = TAUT_ASSETS_FOLDER "/garments/samples/sheet.obj";
  double done = 0.0;
  const GarmentTrial trial = try_garment(file, "a sheet", [&](double fraction) { done = fraction; });
  EXPECT_EQ(trial.refusal, "");
  EXPECT_EQ(trial.file, "sheet.obj");
  EXPECT_EQ(trial.mapping.vertices, 14U * 18U);
  EXPECT_EQ(trial.mapping.structural, trial.mapping.edges);
  EXPECT_GT(trial.mapping.flexural, 100U);
  EXPECT_EQ(trial.mapping.loose_vertices, 0U);
  EXPECT_GT(trial.strong.max_stretch_seen, 0.0);
  EXPECT_GT(trial.bounded.max_stretch_seen, 0.0);
  EXPECT_LE(trial.bounded.max_stretch_seen, trial_bound);
  EXPECT_GT(trial.bounded.median_ms, 0.0);
  EXPECT_EQ(done, 1.0);
}

TEST(GarmentTrials, SayWhyAModelIsRefused) {
  const TemporaryFolder folder;
  const auto file = folder.write("line.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n");
  const GarmentTrial trial = try_garment(file.string(), "a line", [](double) {});
  EXPECT_NE(trial.refusal.find("it has no faces"), std::string::npos) << trial.refusal;
  EXPECT_EQ(trial.mapping.edges, 0U);
}

}  // namespace
}  // namespace taut::app
