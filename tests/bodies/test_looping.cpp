// Motions that repeat.

#include <glm/geometric.hpp>

#include "app/bodies/frame_source.hpp"
#include "app/drawing/drawn_scene.hpp"
#include "gltf_text.hpp"
#include "loading.hpp"

namespace taut::app {
namespace {

struct Looping : testing::Test {
  /// A tube that moves up and down to these heights, half a second for each, at two frames a second.
  BodySource source_of(const std::vector<float>& heights_m) const {
    test::GltfModel model = test::tube();
    std::vector<float> times_s;
    std::vector<float> places;
    for (const float height_m : heights_m) {
      times_s.push_back(0.5F * static_cast<float>(times_s.size()));
      places.insert(places.end(), {0.0F, height_m, 0.0F});
    }
    model.clips = {{"Rise", {{0, "translation", times_s, places}}}};
    BodySource source;
    source.file = folder.write("body.gltf", gltf_text(model));
    source.frame_rate_hz = 2.0;
    source.loop = true;
    return source;
  }
  /// Height of a vertex in each frame above its height at 0 s, in mm.
  static std::vector<int> millimetres(const LoadedBody& body, int frames) {
    std::vector<int> heights;
    for (int frame = 0; frame < frames; ++frame) {
      const double up_m = body.positions_m(0.5 * frame)[0].y - body.positions_m(0.0)[0].y;
      heights.push_back(static_cast<int>(std::lround(1e3 * up_m)));
    }
    return heights;
  }
  test::TemporaryFolder folder;
};

TEST_F(Looping, AMotionThatDoesNotRepeatStaysInItsLastFrame) {
  BodySource source = source_of({1.0F, 1.2F, 1.5F});
  source.loop = false;
  const LoadedBody body = load(source);
  EXPECT_EQ(millimetres(body, 6), (std::vector<int>{0, 200, 500, 500, 500, 500}));
  EXPECT_FALSE(sim::is_moving_after(body.body, 1.0));
}

TEST_F(Looping, RepeatsFromTheFrameThatItsLastIsAgain) {
  const LoadedBody body = load(source_of({1.0F, 1.4F, 1.6F, 1.8F, 1.7F, 1.4F}));
  EXPECT_EQ(millimetres(body, 12), (std::vector<int>{0, 400, 600, 800, 700, 400, 600, 800, 700, 400, 600, 800}))
      << "frame 0 leads into it";
  EXPECT_EQ(body.said().find("repeated"), std::string::npos);
  EXPECT_TRUE(sim::is_moving_after(body.body, 1e6));
  EXPECT_EQ(body.positions_m(2.5 + 4e6), body.positions_m(2.5)) << "a long time after";
}

TEST_F(Looping, RepeatsFromItsFirstFrameAndSaysHowFarThatIs) {
  const LoadedBody body = load(source_of({1.0F, 1.4F, 1.2F}));
  EXPECT_EQ(millimetres(body, 7), (std::vector<int>{0, 400, 200, 0, 400, 200, 0}));
  EXPECT_CONTAINS(body.said(),
                  "repeated, its motion goes on from its first frame, from which its last is up to 0.2 m away");
}

TEST_F(Looping, RefusesAJumpThatIsTooFarForAFrame) {
  const BodySource far = source_of({1.0F, 1.6F, 2.2F});
  EXPECT_CONTAINS(error_text(far),
                  "body.gltf': found a motion to be repeated (loop, --body-loop) whose last frame is up to 1.2 m "
                  "from its first, expected at most 1 m");
}

TEST_F(Looping, BeginsAtItsStartAndRepeatsAllOfIt) {
  BodySource source = source_of({1.0F, 1.4F, 1.6F, 1.8F, 1.7F, 1.4F});
  source.start_s = 1.0;
  EXPECT_EQ(millimetres(load(source), 6), (std::vector<int>{0, 200, 100, -200, 0, 200}));
}

TEST_F(Looping, WhatRepeatsIsDressedAsEver) {
  BodySource source = source_of({1.0F, 1.4F, 1.0F});
  source.dress = 30;
  const LoadedBody body = load(source);
  EXPECT_EQ(millimetres(body, 6), (std::vector<int>{0, 400, 0, 400, 0, 400}));
  EXPECT_LT(glm::distance(body.positions_m(-0.5)[0], body.positions_m(-9.0)[0]), 1e-12);
}

struct MotionsOfMannequins : testing::TestWithParam<const char*> {};

TEST_P(MotionsOfMannequins, RepeatWithoutAJump) {
  BodySource source;
  source.file = assets_folder() / "bodies/mannequin_male_40.glb";
  source.motion = assets_folder() / "motions" / (std::string(GetParam()) + ".bvh");
  const LoadedBody body = load(source);
  const LoopBegin begin = find_loop_begin(*body.mesh().frames, body.mesh().data->positions_m.size());
  EXPECT_TRUE(begin.meets);
  EXPECT_EQ(begin.frame, 15U) << "what is before leads into it";
  EXPECT_LT(begin.max_distance_m, 1e-5);
}

INSTANTIATE_TEST_SUITE_P(Motions, MotionsOfMannequins,
                         testing::Values("stand", "walk", "raise_arms", "reach", "twist", "sit"),
                         [](const auto& motion) { return std::string(motion.param); });

}  // namespace
}  // namespace taut::app
