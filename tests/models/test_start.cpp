// Cloth that begins in another shape than its model's.

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "app/base/errors.hpp"
#include "app/models/garment_loading.hpp"
#include "app/models/inspecting/remarks.hpp"
#include "app/models/reading/file_mesh.hpp"
#include "app/scene/scene_file.hpp"
#include "temporary_folder.hpp"

namespace taut::app {
namespace {

struct Start : testing::Test {
  void export_after(const Scene& scene, int frames) {
    sim::Simulation simulation = make_simulation(scene, load_garment(scene));
    for (int frame = 0; frame < frames; ++frame) {
      simulation.advance_frame();
    }
    exported_m = simulation.state().current;
    was_asleep = simulation.state().asleep;
    file = folder.write("end.obj", obj_text(simulation.garment().mesh, exported_m));
  }

  test::TemporaryFolder folder;
  std::filesystem::path file;
  std::vector<sim::Vec3> exported_m;
  bool was_asleep = false;
};

TEST_F(Start, IsTheShapeThatTheSameSceneExported) {
  Scene model;
  // A model with vertices to be welded, a unit to be guessed, another axis upwards, and subdivision.
  model.garment.file = folder.write("strip.obj",
                                    "v 0 0 0\nv 40 0 0\nv 0 0 50\nv 40 0 50\nv 40 0 50\nv 0 0 90\n"
                                    "f 1 2 3\nf 2 4 3\nf 3 5 6\n");
  model.garment.up = ModelAxis::z;
  model.garment.subdivisions = 2;
  for (Scene scene : {Scene{}, model}) {
    export_after(scene, 60);
    const std::vector<sim::Vec3> rest_m = load_garment(scene).garment->mesh.positions;
    scene.garment.start = file;
    const LoadedGarment loaded = load_garment(scene);
    const sim::Simulation simulation = make_simulation(scene, loaded);
    EXPECT_EQ(simulation.state().current, exported_m);
    EXPECT_NE(simulation.state().current, rest_m);
    EXPECT_EQ(loaded.garment->mesh.positions, rest_m) << "of which springs have their lengths";
  }
}

TEST_F(Start, StaysAtRestWhereTheClothWasAtRest) {
  Scene scene;
  scene.garment.grid.plane = sim::GridPlane::horizontal;
  scene.pins = std::vector<PinSelector>{"top-left", "top-right"};
  export_after(scene, 1500);
  ASSERT_TRUE(was_asleep);
  scene.garment.start = file;
  sim::Simulation simulation = make_simulation(scene, load_garment(scene));
  for (int frame = 0; frame < 60; ++frame) {
    simulation.advance_frame();
  }
  EXPECT_TRUE(simulation.state().asleep);
  for (std::size_t v = 0; v < exported_m.size(); ++v) {
    EXPECT_LT(glm::distance(simulation.state().current[v], exported_m[v]), 1e-3) << v;
  }
}

TEST_F(Start, OfAnotherGarmentIsRefusedWithBothCounts) {
  Scene scene;
  export_after(scene, 0);
  scene.garment.start = file;
  scene.garment.grid.rows = 5;
  EXPECT_CONTAINS(test::error_message<InputError>([&] { load_garment(scene); }),
                  "garment.start: found 81 vertices in '" + file.string() + "', expected the garment's 45");
}

TEST_F(Start, TellsOfClothAndPinsInBodiesAndOfBodiesThatCrossThemselves) {
  Scene scene;
  scene.garment.grid = {.columns = 5, .rows = 5, .width_m = 1.0, .height_m = 1.0};
  scene.pins = std::vector<PinSelector>{"top-left", "top-right"};
  const auto remarks = [&] { return remarks_on_start(scene, load_garment(scene), named_bodies(scene)).lines; };
  EXPECT_EQ(remarks(), std::vector<std::string>());
  const sim::Vec3 corner = load_garment(scene).garment->mesh.positions[0];
  scene.bodies.push_back({.body = {.name = "ball", .shape = sim::Sphere{corner - sim::Vec3(0.0, 0.0, 0.04), 0.05}}});
  std::vector<std::string> said = remarks();
  ASSERT_EQ(said.size(), 2U);
  EXPECT_CONTAINS(said[0], "at the start ");
  EXPECT_CONTAINS(said[0], " the body 'ball', the first: triangle ");
  EXPECT_CONTAINS(said[1], "1 pinned vertex begins within the body 'ball', the first: vertex 0, 10 mm deep at [");
  // A tetrahedron around the whole cloth.
  const double far_m = 10.0;
  sim::BodyMeshData around;
  around.positions_m = {
      {far_m, far_m, far_m}, {far_m, -far_m, -far_m}, {-far_m, far_m, -far_m}, {-far_m, -far_m, far_m}};
  around.triangles = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
  scene.bodies[0].body = {.shape = sim::BodyMesh{std::make_shared<sim::BodyMeshData>(around)}};
  said = remarks();
  ASSERT_EQ(said.size(), 2U);
  EXPECT_CONTAINS(said[0],
                  "at the start 1 part of the cloth is wholly within body 0, the first: that of vertex 0 at [");
  EXPECT_CONTAINS(said[1], "2 pinned vertices begin within body 0, the first: vertex 0, in it at [");
  // Two spikes that go through each other, beside the cloth.
  const auto spike = [](std::vector<sim::Vec3>& positions_m, const sim::Vec3& base, const sim::Vec3& tip) {
    for (const sim::Vec3& p : {base, base + sim::Vec3(0.1, 0.0, 0.0), base + sim::Vec3(0.0, 0.1, 0.1), tip}) {
      positions_m.push_back(p);
    }
  };
  sim::BodyMeshData data;
  spike(data.positions_m, {5.0, 0.0, 0.0}, {5.0, 1.0, 0.02});
  spike(data.positions_m, {5.0, 0.5, -0.5}, {5.03, 0.5, 0.5});
  data.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {4, 6, 5}, {4, 5, 7}, {5, 6, 7}, {6, 4, 7}};
  scene.bodies[0].body = {.shape = sim::BodyMesh{std::make_shared<sim::BodyMeshData>(data)}};
  said = remarks();
  ASSERT_EQ(said.size(), 1U);
  EXPECT_CONTAINS(said[0], "body 0 crosses itself: ");
  EXPECT_CONTAINS(said[0], ", the first: triangle ");
  EXPECT_CONTAINS(said[0], "] m");
}

}  // namespace
}  // namespace taut::app
