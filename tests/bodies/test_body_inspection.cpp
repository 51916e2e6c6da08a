#include <cmath>

#include "app/bodies/body_loading.hpp"
#include "app/models/inspecting/inspection.hpp"
#include "gltf_text.hpp"
#include "loading.hpp"

namespace taut::app {
namespace {

TEST(BodyInspection, SaysWhatIsInABodyAndHowItMoves) {
  const test::TemporaryFolder folder;
  test::GltfModel model = test::tube();
  // The tube rises by 1.5 m in a second, then sinks at half that speed.
  model.clips = {{"Rise", {{0, "translation", {0.0F, 1.0F, 3.0F}, {0, 1, 0, 0, 2.5F, 0, 0, 1, 0}}}}};
  BodySource source;
  source.file = folder.write("body.gltf", gltf_text(model));
  const Json body = inspect_body(source);
  EXPECT_EQ(body["vertices"], model.positions.size());
  EXPECT_EQ(body["triangles"], model.triangles.size());
  EXPECT_EQ(body["closed_surfaces"], 1U);
  EXPECT_NEAR(body["size_m"][1].get<double>(), 2.0, 1e-6);
  EXPECT_NEAR(body["volume_m3"].get<double>(), 2.0 * 2.0 * std::sqrt(2.0) * 0.04, 1e-6) << "an octagon, 2 m high";
  EXPECT_EQ(body["joints"], (Json{"Hips", "Spine", "LeftFoot"}));
  ASSERT_TRUE(body.contains("motion"));
  const Json& motion = body["motion"];
  EXPECT_EQ(motion["frames"], 181U);
  EXPECT_TRUE(body["crossings"]["frames"].empty());
  const std::string text = describe(body);
  EXPECT_CONTAINS(text, "\njoints                    [Hips, Spine, LeftFoot]\n");
  EXPECT_CONTAINS(text, "\nanimations                'Rise' (3 s)\n");
  EXPECT_CONTAINS(text, "repeated, its motion goes on from frame 0, which its last is again\n");
  EXPECT_EQ(motion["repeats_from_frame"], 0);
}

TEST(BodyInspection, SaysInWhichFrameABodyCrossesItself) {
  const test::TemporaryFolder folder;
  test::GltfModel model = test::tube();
  const auto half = static_cast<float>(std::sqrt(0.5));
  // The upper end is folded by more than half a turn, through the tube.
  const float c = std::cos(1.5F);
  const float s = std::sin(1.5F);
  model.clips = {
      {"Fold", {{1, "rotation", {0.0F, 4.0F}, {0, half, 0, half, half * -s, half * c, half * s, half * c}}}}};
  BodySource source;
  source.file = folder.write("body.gltf", gltf_text(model));
  const Json body = inspect_body(source);
  const Json& crossings = body["crossings"];
  EXPECT_EQ(crossings["frames_looked_at"], 20U);
  ASSERT_FALSE(crossings["frames"].empty());
  EXPECT_GT(crossings["frames"][0]["frame"], 0U) << "it begins straight";
  EXPECT_CONTAINS(describe(body), "crossings                 frames_looked_at 20, frames [frame ");
}

}  // namespace
}  // namespace taut::app
