#include <gtest/gtest.h>

#include "app/base/errors.hpp"
#include "app/models/garment_loading.hpp"
#include "app/models/hanging/landmarks.hpp"
#include "temporary_folder.hpp"

namespace taut::app {
namespace {

using test::error_message;
using test::TemporaryFolder;

// Faces name the vertices in another order than the file lists them, no face uses vertex 0, and the file has texture
// seams. The imported order therefore differs from the file's.
constexpr const char* cloth =
    "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
    "vt 0 0\nvt 1 0\nvt 0 1\n"
    "f 4/1 5/2 3/3\nf 5/3 2/1 3/2\n";

Scene scene_with(const TemporaryFolder& folder, const std::string& landmarks) {
  folder.write("cloth.landmarks.toml", landmarks);
  Scene scene;
  scene.garment.file = folder.write("cloth.obj", cloth);
  return scene;
}

sim::Vec3 first_position(const LoadedGarment& loaded, std::size_t landmark, std::size_t i = 0) {
  return loaded.garment->mesh.positions[loaded.landmarks[landmark].second[i]];
}

TEST(Landmarks, FindVerticesOfTheFileByTheirPlace) {
  const TemporaryFolder folder;
  const LoadedGarment loaded =
      load_garment(scene_with(folder, "corner = [1, 3]\n[more]\npoints = [[0, 1, 0]]\n"));
  ASSERT_EQ(loaded.landmarks.size(), 2U);
  EXPECT_EQ(loaded.landmarks[0].first, "corner");
  EXPECT_EQ(first_position(loaded, 0), sim::Vec3(0, 0, 0));
  EXPECT_EQ(first_position(loaded, 0, 1), sim::Vec3(1, 1, 0));
  EXPECT_EQ(first_position(loaded, 1), sim::Vec3(0, 1, 0));
}

TEST(Landmarks, ScaleWithTheGarment) {
  const TemporaryFolder folder;
  Scene scene = scene_with(folder, "corner = [3]\nsame = [[1, 1, 0]]\n");
  scene.garment.scale = 0.01;
  const LoadedGarment loaded = load_garment(scene);
  EXPECT_EQ(loaded.landmarks[0].second, loaded.landmarks[1].second);
}

TEST(Landmarks, AreWithinTheLastDigitsOfTheirPoints) {
  const TemporaryFolder folder;
  EXPECT_EQ(load_garment(scene_with(folder, "a = [[0.000007, 0, 0]]\n")).landmarks.size(), 1U);
  EXPECT_THROW(load_garment(scene_with(folder, "a = [[0.000015, 0, 0]]\n")), InputError);
}

TEST(Landmarks, SayWhichPointIsNoVertex) {
  const TemporaryFolder folder;
  const auto error = [&](const std::string& text) {
    return error_message<InputError>([&] { load_garment(scene_with(folder, text)); });
  };
  EXPECT_CONTAINS(error("a = [1]\nb = [[0.5, 0, 0]]\n"),
                  "cloth.landmarks.toml:2: landmark b: the garment has no vertex at [0.5, 0, 0]");
  EXPECT_CONTAINS(
      error("a = [7]\n"),
      "cloth.landmarks.toml:1: landmark a: found vertex 7, expected one of the vertices of the file, 0 to 4");
  EXPECT_CONTAINS(error("a = [0]\n"), "vertex 0 of the file belongs to no face");
}

TEST(Landmarks, CanBePinned) {
  const TemporaryFolder folder;
  Scene scene = scene_with(folder, "top = [3, 4]\n");
  scene.pins = {{"top"}};
  EXPECT_EQ(load_garment(scene).pins.size(), 2U);
  scene.pins = {{"topp"}};
  const std::string error = error_message<InputError>([&] { load_garment(scene); });
  EXPECT_CONTAINS(error, "no part named 'topp'; did you mean 'top'? (it has: top, top-band, hanger)");
}

TEST(Landmarks, OfTheTShirtLieOnIt) {
  Scene scene;
  for (const char* name : {"tshirt_10600", "tshirt_5280", "tshirt_2640", "tshirt_1028"}) {
    scene.garment.file = std::string(TAUT_ASSETS_FOLDER "/garments/") + name + ".obj";
    scene.pins = {{"left_shoulder_seam", "right_shoulder_seam", "back_neckline"}};
    const LoadedGarment loaded = load_garment(scene);
    for (const sim::Index pin : loaded.pins) {
      EXPECT_GT(loaded.garment->mesh.positions[pin].y, 1.5) << name;
    }
    EXPECT_GT(loaded.pins.size(), 8U) << name;
  }
}

}  // namespace
}  // namespace taut::app
