#include <gtest/gtest.h>

#include "app/base/errors.hpp"
#include "app/models/garment_loading.hpp"
#include "app/models/reading/garment_import.hpp"
#include "temporary_folder.hpp"

namespace taut::app {
namespace {

using test::error_message;
using test::TemporaryFolder;

std::string import_error(const std::filesystem::path& path) {
  return error_message<InputError>([&] { import_garment(path); });
}

sim::Vec3 first_normal(const ImportedModel& model) {
  return sim::doubled_area_vector(model.positions, model.triangles.front());
}

//  3---2---5
//  | q | t |     and a pentagon, a line and a point
//  0---1---+
TEST(GarmentImport, CutsPolygonsAndCountsWhatItIgnores) {
  const TemporaryFolder folder;
  const auto path = folder.write("cloth.obj",
                                 "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nv 3 0.5 0\n"
                                 "f 1 2 3 4\nf 2 5 3\nf 2 5 7 6 3\nl 1 2\np 1\n");
  const ImportedModel model = import_garment(path);
  EXPECT_EQ(model.file_quads, 1U);
  EXPECT_EQ(model.file_triangles, 1U);
  EXPECT_EQ(model.file_polygons, 1U);
  EXPECT_EQ(model.ignored_lines, 1U);
  EXPECT_EQ(model.ignored_points, 1U);
  EXPECT_EQ(model.triangles.size(), 6U);
  EXPECT_GT(first_normal(model).z, 0.0);
}

// A glTF triangle in the xy plane whose node mirrors x, moves by (10, 0, 0) and doubles.
TEST(GarmentImport, PlacesMeshesAndKeepsTheOutsideOutside) {
  const TemporaryFolder folder;
  const auto path =
      folder.write("mirror.gltf", R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
"nodes":[{"mesh":0,"scale":[-2,2,2],"translation":[10,0,0]}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],
"bufferViews":[{"buffer":0,"byteLength":36}],
"buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})");
  const ImportedModel model = import_garment(path);
  ASSERT_EQ(model.positions.size(), 3U);
  EXPECT_EQ(model.positions[1], sim::Vec3(8, 0, 0));
  EXPECT_EQ(model.positions[2], sim::Vec3(10, 2, 0));
  EXPECT_GT(first_normal(model).z, 0.0);
}

TEST(GarmentImport, RefusesWhatIsNoModel) {
  const TemporaryFolder folder;
  EXPECT_CONTAINS(import_error(folder / "none.obj"), "there is no file");
  EXPECT_CONTAINS(import_error(folder / ""), "is a folder");
  EXPECT_CONTAINS(import_error(folder.write("empty.obj", "")), "empty.obj' is empty");
  const std::string text = import_error(folder.write("notes.txt", "Buy milk.\n"));
  EXPECT_CONTAINS(text, "notes.txt': ");
  EXPECT_CONTAINS(text, "expected a 3D model");
  EXPECT_CONTAINS(import_error(folder.write("text.obj", "Buy milk.\n")), "text.obj': ");
  EXPECT_CONTAINS(import_error(folder.write("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n")), "points.obj': ");
  EXPECT_CONTAINS(import_error(folder.write("line.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n")), "it has no faces");
}

TEST(GarmentLoading, NamesTheFileOfAMeshWithoutArea) {
  const TemporaryFolder folder;
  Scene scene;
  scene.garment.file = folder.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
  const std::string error = error_message<InputError>([&] { load_garment(scene); });
  EXPECT_CONTAINS(error, "flat.obj");
}

TEST(GarmentLoading, ScalesAndPinsAModelByItsTop) {
  const TemporaryFolder folder;
  Scene scene;
  scene.garment.file = folder.write("mm.obj", "v 0 1000 0\nv 0 0 0\nv 1000 0 0\nv 1000 980 0\nf 1 2 3 4\n");
  scene.garment.scale = 0.001;
  const LoadedGarment loaded = load_garment(scene);
  EXPECT_EQ(loaded.garment->mesh.positions.size(), 4U);
  EXPECT_EQ(loaded.repairs->welded_vertices + loaded.garment->mesh.positions.size(),
            loaded.repairs->input_vertices);
  EXPECT_NEAR(loaded.garment->mesh.positions[0].y, 1.0, 1e-9);
  EXPECT_EQ(loaded.pins.size(), 2U);
}

TEST(GarmentLoading, PinsHoldClothOverTheWidthThatIsAsked) {
  Scene scene;
  scene.garment.grid.columns = scene.garment.grid.rows = 11;
  scene.garment.grid.width_m = scene.garment.grid.height_m = 1.0;
  scene.pins = std::vector<PinSelector>{sim::Index{60}};  // the middle vertex
  EXPECT_EQ(load_garment(scene).pins, std::vector<sim::Index>{60});
  scene.pin_width_m = 0.21;
  EXPECT_EQ(load_garment(scene).pins, (std::vector<sim::Index>{49, 59, 60, 61, 71}));
  scene.pin_width_m = 0.29;
  EXPECT_EQ(load_garment(scene).pins.size(), 9U);
}

}  // namespace
}  // namespace taut::app
