// The list of motions in the window.

#include <gtest/gtest.h>

#include "app/viewer/panel/panel.hpp"
#include "app/viewer/state/viewer_state.hpp"
#include "app/viewer/viewer.hpp"
#include "bodies/gltf_text.hpp"
#include "person.hpp"
#include "temporary_folder.hpp"

namespace taut::app {
namespace {

struct MotionList : testing::Test {
  /// A cloth, and a body that grows for two frames.
  std::filesystem::path scene_with(const std::string& body) const {
    return folder.write("worn.toml",
                        "[garment.grid]\ncolumns = 5\nrows = 5\n[solver]\nkind = "
                        "\"strong\"\n[[bodies]]\nshape = \"mesh\"\ndress = 2\n" +
                            body);
  }
  std::filesystem::path tube(const test::GltfModel& model) const {
    folder.write("tube.gltf", gltf_text(model));
    return scene_with("file = \"tube.gltf\"\n");
  }
  static void load(test::Person& person, const std::filesystem::path& scene) {
    person.act(renderer::WindowEvent(renderer::FileDropped{scene.string()}));
    person.wait(4);
  }
  static std::vector<std::string> labels(const DrawnScene& scene) {
    std::vector<std::string> names;
    for (const Choice& motion : motion_choices(scene, {}).choices) {
      names.push_back(motion.label);
    }
    return names;
  }
  test::TemporaryFolder folder;
};

const std::vector<std::string> of_mannequins = {"raise arms", "reach", "sit", "stand", "twist", "walk"};

TEST_F(MotionList, StartsTheSceneAgainWithTheMotionThatIsChosen) {
  test::Person person("pinned-9x9-5");
  EXPECT_FALSE(person.shows("motion")) << "there is no body";
  load(person, scene_with("file = \"" TAUT_ASSETS_FOLDER "/bodies/mannequin_male_40.glb\"\n"
                          "motion = \"" TAUT_ASSETS_FOLDER "/motions/stand.bvh\"\nstart = 0.5\n"));
  const ViewerState& state = person.viewer.state();
  ASSERT_TRUE(person.shows("motion"));
  EXPECT_FALSE(hint_for("motion").empty());
  person.wait(20);
  const auto standing = state.newest->surroundings;
  ASSERT_GT(state.newest->record.frame, 10);
  person.click("motion");
  for (const std::string motion : {"motion.stand", "motion.raise_arms", "motion.sit"}) {
    EXPECT_TRUE(person.shows(motion)) << motion;
  }
  person.click("motion.walk");
  person.wait(3);
  EXPECT_LT(state.newest->record.frame, 10) << "it begins anew";
  const BodySource& source = state.scene.bodies.at(0).source;
  EXPECT_EQ(source.motion.filename(), "walk.bvh");
  EXPECT_TRUE(source.loop);
  EXPECT_EQ(source.start_s, 0.0);
  EXPECT_EQ(source.dress, 2);
  EXPECT_NE(state.newest->surroundings.bodies, standing.bodies);
  EXPECT_GT(std::get<sim::BodyMesh>(state.newest->surroundings.bodies.at(0).shape).frames->count(), 100000U);

  const DrawnScene kept = read_scene_text(
      scene_text(kept_scene(state, scene_area(person.viewer.layout())), GarmentNaming::full_path), "kept.toml");
  EXPECT_EQ(kept.bodies.at(0).source.motion, source.motion);
  EXPECT_TRUE(kept.bodies.at(0).source.loop);
}

TEST_F(MotionList, HasTheMotionsThatFitAndThoseOfTheBodyItself) {
  test::GltfModel model = test::tube();
  EXPECT_EQ(labels(find_scene(tube(model).string(), {})), of_mannequins);
  model.clips = {{"Rise", {{0, "translation", {0.0F, 1.0F}, {0, 1, 0, 0, 1.2F, 0}}}}};
  std::vector<std::string> and_its_own = of_mannequins;
  and_its_own.emplace_back("Rise (its own)");
  EXPECT_EQ(labels(find_scene(tube(model).string(), {})), and_its_own);
  for (auto& joint : model.joints) {
    joint.name = "Tail " + joint.name.substr(0, 1);
  }
  EXPECT_EQ(labels(find_scene(tube(model).string(), {})), std::vector<std::string>{"Rise (its own)"});
  model.weights.clear();
  EXPECT_TRUE(labels(find_scene(tube(model).string(), {})).empty()) << "no vertex follows a joint";
  EXPECT_TRUE(labels(find_scene("pinned-9x9-5", {})).empty());
}

TEST_F(MotionList, AnAnimationWhoseEndIsFarFromItsBeginIsPlayedOnce) {
  test::GltfModel model = test::tube();
  const auto loops_up_to = [&](float height_m) {
    model.clips = {{"Rise", {{0, "translation", {0.0F, 2.0F}, {0, 1, 0, 0, height_m, 0}}}}};
    SceneWithBodies moved = find_scene(tube(model).string(), {});
    set_motion(0, motion_choices(moved.scene, {}).choices.back(), moved);
    const BodySource& source = moved.scene.bodies.at(0).source;
    EXPECT_EQ(source.clip, "Rise");
    EXPECT_TRUE(is_chosen({"Rise", "", ""}, source));
    EXPECT_FALSE(is_chosen({"walk", "", "walk.bvh"}, source));
    return source.loop;
  };
  EXPECT_TRUE(loops_up_to(1.5F));
  EXPECT_FALSE(loops_up_to(2.5F));
}

}  // namespace
}  // namespace taut::app
