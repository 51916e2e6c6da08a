// Fabrics by name: the keys they set, and the precedence of keys beside them.

#include <gtest/gtest.h>

#include "app/base/errors.hpp"
#include "app/drawing/drawn_scene.hpp"
#include "app/scene/scene_file.hpp"
#include "app/scene/scene_format.hpp"
#include "temporary_folder.hpp"

namespace taut::app {
namespace {

using test::error_message;
using test::TemporaryFolder;

constexpr const char* grid = "[garment.grid]\nrows = 5\n";

std::vector<Override> overrides(std::initializer_list<std::pair<const char*, std::string>> keys) {
  std::vector<Override> all;
  for (const auto& [key, value] : keys) {
    all.push_back({key, value, "--set " + std::string(key) + '=' + value});
  }
  return all;
}

TEST(Fabric, ThoseOfTheProgramSayAllThatAFabricIs) {
  const std::vector<std::string> names = built_in_fabrics();
  for (const char* name : {"canvas", "cotton", "denim", "jersey", "linen", "silk", "wool"}) {
    EXPECT_TRUE(std::find(names.begin(), names.end(), name) != names.end()) << name;
  }
  for (const std::string& name : names) {
    const Fabric fabric = find_fabric(name);
    EXPECT_FALSE(fabric.title.empty()) << name;
    for (const Key<DrawnScene>& key : drawn_scene_format().keys) {
      // The inside of a plain fabric is a shade of its outside, and so are its stitches.
      if (is_fabric_key(key.name) && key.name != "picture.inside_colour" && key.name != "picture.stitch_colour") {
        EXPECT_TRUE(fabric.keys.at_path(key.name)) << name << ' ' << key.name;
      }
    }
  }
}

// Jersey has the values of cloth without a fabric, and a force law in addition. Cloth without a law costs less and
// moves as in the paper.
TEST(Fabric, JerseyIsWhatClothIsWhereNothingIsSaid) {
  DrawnScene scene;
  const nlohmann::ordered_json before = scene_settings(scene);
  apply_overrides(overrides({{"cloth.fabric", "jersey"}}), scene);
  nlohmann::ordered_json after = scene_settings(scene);
  EXPECT_EQ(after["cloth"]["fabric"], "jersey");
  after["cloth"]["fabric"] = "";
  for (const char* of_law : {"shear", "tensile_warp", "tensile_weft", "warp_limit", "weft_limit"}) {
    EXPECT_NE(after["cloth"][of_law], before["cloth"][of_law]);
    after["cloth"][of_law] = before["cloth"][of_law];
  }
  EXPECT_EQ(after, before);
}

TEST(Fabric, KeysBesideItAreStrongerWhereverTheyStand) {
  const std::string denim = std::string(grid) + "[cloth]\nthickness = 0.002\nfabric = \"denim\"\n";
  const DrawnScene scene = read_scene_text(denim, "scene.toml");
  EXPECT_EQ(scene.material.thickness_m, 0.002);
  EXPECT_EQ(scene.material.bending_rigidity_n_m, 98e-6);
  EXPECT_EQ(scene.picture.cloth.weave_kind, renderer::WeaveKind::twill);
  const DrawnScene changed =
      read_scene_text(denim, "scene.toml", overrides({{"cloth.friction", "0.9"}, {"cloth.fabric", "silk"}}));
  EXPECT_EQ(changed.material.friction, 0.9);
  EXPECT_EQ(changed.material.areal_density_kg_per_m2, 0.083);
  EXPECT_EQ(changed.picture.cloth.weave_kind, renderer::WeaveKind::satin);
}

TEST(Fabric, ASavedSceneKeepsItAndWhatWasChangedSince) {
  const TemporaryFolder folder;
  folder.write("my.toml", "title = \"mine\"\n[cloth]\nbending_rigidity = 3e-5\n");
  folder.write("scene.toml", std::string(grid) + "[cloth]\nfabric = \"my.toml\"\n");
  DrawnScene scene = read_scene_file(folder / "scene.toml");
  EXPECT_EQ(scene.material.bending_rigidity_n_m, 3e-5);
  scene.material.bending_rigidity_n_m = 4e-5;
  const DrawnScene saved = read_scene_text(scene_text(scene), "elsewhere/saved.toml");
  EXPECT_EQ(saved.fabric, folder / "my.toml");
  EXPECT_EQ(saved.material.bending_rigidity_n_m, 4e-5);
}

TEST(Fabric, SaysWhatThereIsAndWhatIsWrong) {
  DrawnScene scene;
  EXPECT_EQ(error_message<UsageError>([&] {
              apply_overrides(overrides({{"cloth.fabric", "denin"}}), scene);
            }),
            "--set cloth.fabric=denin: cloth.fabric: there is no fabric 'denin'; did you mean 'denim'? (fabrics: "
            "canvas, cotton, denim, jersey, linen, silk, wool; a file that ends in .toml does as well)");
  const TemporaryFolder folder;
  folder.write("my.toml", "title = \"mine\"\n[wind]\nspeed = 3\n");
  EXPECT_EQ(error_message<InputError>([&] {
              apply_overrides(overrides({{"cloth.fabric", (folder / "my.toml").string()}}), scene);
            }).find((folder / "my.toml").string() + ":2: unknown key 'wind'"),
            0U);
  folder.write("my.toml", "drape = [60, 40]\n");
  EXPECT_EQ(error_message<InputError>([&] {
              find_fabric(folder / "my.toml");
            }).find((folder / "my.toml").string() + ":1: drape: found [60, 40], expected a list of two"),
            0U);
}

}  // namespace
}  // namespace taut::app
