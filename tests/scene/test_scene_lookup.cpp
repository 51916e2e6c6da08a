#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>

#include "app/base/errors.hpp"
#include "app/drawing/drawn_scene.hpp"
#include "temporary_folder.hpp"

namespace taut::app {
namespace {

using test::error_message;
using test::TemporaryFolder;

constexpr const char* triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

TEST(SceneLookup, FindsBuiltInScenes) {
  const auto scenes = built_in_scenes();
  for (const char* name : {"cloth-fall", "pinned-9x9-5", "pinned-9x9-20", "tshirt", "tshirt-gravity",
                           "tshirt-wind-1", "tshirt-wind-10", "rotating-sphere", "reef-knot"}) {
    EXPECT_TRUE(std::any_of(scenes.begin(), scenes.end(), [&](const auto& scene) {
      return scene.name == name;
    })) << name;
  }
}

// Bash completion and scripts read the list line by line.
TEST(SceneLookup, ListsScenesAboutContactLast) {
  const auto scenes = built_in_scenes();
  const auto of_contact =
      std::find_if(scenes.begin(), scenes.end(), [](const auto& s) { return s.is_of_contact; });
  EXPECT_GE(of_contact - scenes.begin(), 7);
  EXPECT_GE(scenes.end() - of_contact, 13);
  EXPECT_TRUE(std::all_of(of_contact, scenes.end(), [](const auto& s) {
    return s.is_of_contact && s.file.parent_path().filename() == "contact";
  }));
}

TEST(SceneLookup, ReadsEveryBuiltInScene) {
  ASSERT_FALSE(built_in_scenes().empty());
  for (const BuiltInScene& scene : built_in_scenes()) {
    EXPECT_NO_THROW({
      const DrawnScene found = find_scene(scene.name, {});
      EXPECT_EQ(found.name, scene.name);
      EXPECT_FALSE(found.title.empty());
    }) << scene.name;
  }
}

TEST(SceneLookup, PrefersTheFolderInTheEnvironment) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "scenes");
  folder.write("scenes/mine.toml", "[garment.grid]\nrows = 5\n");
  ::setenv("TAUT_ASSETS", (folder / "").c_str(), 1);
  const auto scenes = built_in_scenes();
  const DrawnScene scene = find_scene("mine", {});
  ::unsetenv("TAUT_ASSETS");
  ASSERT_EQ(scenes.size(), 1U);
  EXPECT_EQ(scene.garment.grid.rows, 5U);
}

TEST(SceneLookup, MakesASceneOfAGarment) {
  const TemporaryFolder folder;
  const auto path = folder.write("shirt.obj", triangle);
  const DrawnScene scene = find_scene(path.string(), std::vector{parse_override("wind.speed=3")});
  EXPECT_EQ(scene.name, "shirt");
  EXPECT_EQ(scene.garment.file, path);
  EXPECT_FALSE(scene.pins.has_value());
  EXPECT_EQ(scene.surroundings.forces.wind.speed_m_per_s, 3.0);
}

TEST(SceneLookup, FindsWhatComesAlongByNameUnlessAFileIsNearer) {
  const TemporaryFolder folder;
  const auto scene = folder.write("mine.toml", "[garment]\nfile = \"tshirt_1028\"\n");
  EXPECT_EQ(find_scene(scene.string(), {}).garment.file, assets_folder() / "garments/tshirt_1028.obj");
  const auto own = folder.write("tshirt_1028", triangle);
  EXPECT_EQ(find_scene(scene.string(), {}).garment.file, own);
  EXPECT_EQ(find_asset("motions/walk.bvh"), assets_folder() / "motions/walk.bvh");
  EXPECT_EQ(find_asset("mannequin_female_34"), assets_folder() / "bodies/mannequin_female_34.glb");
  EXPECT_FALSE(find_asset("no_such_shirt").has_value());
  EXPECT_TRUE(locate_scene("tshirt_5280").is_garment);
}

TEST(SceneLookup, ListsTheScenesForAnUnknownName) {
  const std::string error = error_message<InputError>([] { find_scene("cloth-fal", {}); });
  EXPECT_CONTAINS(error, "did you mean 'cloth-fall'?");
  EXPECT_CONTAINS(error, "pinned-9x9-20");
  EXPECT_CONTAINS(error_message<InputError>([] { find_scene("no/such.toml", {}); }), "there is no file 'no/such.toml'");
}

}  // namespace
}  // namespace taut::app
