// BVH motions on a body with joints of its own, against positions computed here.

#include <cmath>
#include <glm/geometric.hpp>

#include "app/bodies/frame_source.hpp"
#include "gltf_text.hpp"
#include "loading.hpp"

namespace taut::app {
namespace {

using test::GltfModel;

constexpr double tolerance_m = 1e-6;

/// A skeleton in centimetres, half as large as the tube: the hips are 50 above the floor, and the foot hangs 50 below
/// them.
std::string bvh(const std::string& names_and_root, const std::string& frames) {
  return "HIERARCHY\nROOT " + names_and_root + "MOTION\n" + frames;
}
const std::string skeleton =
    "mixamorig:Hips\n{\n  OFFSET 0 50 0\n"
    "  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n"
    "  JOINT spine\n  {\n    OFFSET 0 25 0\n    CHANNELS 3 Xrotation Yrotation Zrotation\n"
    "    End Site\n    {\n      OFFSET 0 25 0\n    }\n  }\n"
    "  JOINT left_foot\n  {\n    OFFSET 0 -50 0\n    CHANNELS 3 Zrotation Yrotation Xrotation\n"
    "    End Site\n    {\n      OFFSET 0 0 10\n    }\n  }\n}\n";
const std::string frames =
    "Frames: 4\nFrame Time: 0.5\n"
    "0 50 0 0 0 0  0 0 0  0 0 0\n"
    "5 60 0 0 0 0  0 0 90  0 0 0\n"
    "0 50 0 0 0 0  0 0 0  0 0 0\n"
    "0 50 10 0 0 90  90 0 0  0 0 0\n";

sim::Vec3 about_z(const sim::Vec3& d) { return {-d.y, d.x, d.z}; }
sim::Vec3 about_y(const sim::Vec3& d) { return {d.z, d.y, -d.x}; }
sim::Vec3 about_x(const sim::Vec3& d) { return {d.x, -d.z, d.y}; }

struct Bvh : testing::Test {
  BodySource source_of(const GltfModel& model, const std::string& motion) const {
    BodySource source;
    source.file = folder.write("body.gltf", gltf_text(model));
    source.motion = folder.write("walk.bvh", motion);
    return source;
  }
  std::string error_of_motion(const std::string& motion) const { return error_text(source_of(test::tube(), motion)); }
  test::TemporaryFolder folder;
};

double upper_share(const sim::Vec3& p) { return std::clamp(2.0 * (p.y - 1.0), 0.0, 1.0); }

TEST_F(Bvh, TurnsJointsFromTheStoredPoseInTheAxesOfTheScene) {
  const GltfModel model = test::tube();
  const LoadedBody body = load(source_of(model, bvh(skeleton, frames)));
  EXPECT_EQ(body.mesh().frames->rate_hz(), 2.0);
  EXPECT_EQ(body.said(), "");
  const std::vector<sim::Vec3> zero_m = body.positions_m(0.0);
  const std::vector<sim::Vec3> second_m = body.positions_m(0.5);
  const std::vector<sim::Vec3> third_m = body.positions_m(1.5);
  const sim::Vec3 hips(0, 1, 0);
  const sim::Vec3 spine(0, 0.5, 0);  // offset from the hips
  for (std::size_t v = 0; v < model.positions.size(); ++v) {
    const sim::Vec3& p = model.positions[v];
    const double share = upper_share(p);
    EXPECT_LT(glm::distance(zero_m[v], p), tolerance_m) << v;
    // The body is twice as large as the skeleton: 5 cm of the skeleton's hips move the body's by 10 cm.
    const sim::Vec3 bent = hips + spine + about_z(p - hips - spine);
    EXPECT_LT(glm::distance(second_m[v], sim::Vec3(0.1, 0.2, 0) + (1.0 - share) * p + share * bent), tolerance_m) << v;
    const sim::Vec3 with_hips = hips + about_y(p - hips);
    const sim::Vec3 nodding = hips + about_y(spine + about_x(p - hips - spine));
    EXPECT_LT(glm::distance(third_m[v], sim::Vec3(0, 0, 0.2) + (1.0 - share) * with_hips + share * nodding),
              tolerance_m)
        << v;
  }
}

TEST_F(Bvh, OrderOfChannelsIsTheOrderOfRotations) {
  const GltfModel model = test::tube();
  const auto max_distance_m = [&](const std::string& channels, const std::string& numbers, const auto& turned) {
    const std::vector<sim::Vec3> shown_m =
        load(source_of(model, bvh("Hips\n{\nOFFSET 0 0 0\nCHANNELS 3 " + channels + "\n}\n",
                                  "Frames: 1\nFrame Time: 1\n" + numbers + "\n")))
            .positions_m(0.0);
    double max_distance_m = 0.0;
    for (std::size_t v = 0; v < shown_m.size(); ++v) {
      const sim::Vec3 expected_m = turned(model.positions[v] - model.positions[0]);
      max_distance_m = std::max(max_distance_m, glm::distance(shown_m[v] - shown_m[0], expected_m));
    }
    return max_distance_m;
  };
  EXPECT_LT(max_distance_m("Zrotation Xrotation Yrotation", "90 90 0",
                           [](const sim::Vec3& d) { return about_z(about_x(d)); }),
            tolerance_m);
  EXPECT_LT(max_distance_m("Xrotation Yrotation Zrotation", "90 0 90",
                           [](const sim::Vec3& d) { return about_x(about_z(d)); }),
            tolerance_m);
  EXPECT_LT(max_distance_m("Yrotation Zrotation Xrotation", "90 0 0", about_y), tolerance_m);
}

// The same body moves in the same way if its file has z up.
TEST_F(Bvh, KnowsWhichWayIsUpInTheBody) {
  const GltfModel model = test::tube();
  GltfModel lying = model;
  const auto laid = [](const sim::Vec3& p) { return sim::Vec3(p.x, -p.z, p.y); };
  for (sim::Vec3& p : lying.positions) {
    p = laid(p);
  }
  for (GltfModel::Joint& joint : lying.joints) {
    joint.translation = laid(joint.translation);
  }
  const LoadedBody upright = load(source_of(model, bvh(skeleton, frames)));
  BodySource source = source_of(lying, bvh(skeleton, frames));
  source.up = ModelAxis::z;
  const LoadedBody turned = load(source);
  for (const double time_s : {0.0, 0.5, 1.5}) {
    const auto expected_m = upright.positions_m(time_s);
    const auto found_m = turned.positions_m(time_s);
    for (std::size_t v = 0; v < found_m.size(); ++v) {
      EXPECT_LT(glm::distance(found_m[v], expected_m[v]), tolerance_m) << v;
    }
  }
}

TEST_F(Bvh, KnowsWhichWayIsUpInTheMotion) {
  const std::string lying =
      "Hips\n{\n OFFSET 0 0 50\n CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n"
      " JOINT Spine\n {\n OFFSET 0 0 25\n CHANNELS 3 Xrotation Yrotation Zrotation\n"
      " JOINT Head\n {\n OFFSET 0 0 25\n }\n }\n"
      " JOINT LeftFoot\n {\n OFFSET 0 0 -50\n }\n}\n";
  const LoadedBody upright = load(source_of(test::tube(), bvh(skeleton, frames)));
  const LoadedBody turned = load(
      source_of(test::tube(), bvh(lying, "Frames: 2\nFrame Time: 0.5\n0 0 50 0 0 0 0 0 0\n5 0 60 0 0 0 0 -90 0\n")));
  EXPECT_CONTAINS(turned.said(), "up in its motion is z");
  const auto expected_m = upright.positions_m(0.5);
  const auto found_m = turned.positions_m(0.5);
  for (std::size_t v = 0; v < found_m.size(); ++v) {
    EXPECT_LT(glm::distance(found_m[v], expected_m[v]), tolerance_m) << v;
  }
}

// Recorded motions have the root's zero pose at the origin and may begin anywhere.
TEST_F(Bvh, HipsBeginWhereTheBodyIs) {
  std::string recorded = skeleton;
  recorded.replace(recorded.find("0 50 0"), 6, "0 0 0");
  // The joint of the foot is above the ground in the motion and in the model.
  recorded.replace(recorded.find("0 -50 0"), 7, "0 -40 0");
  GltfModel model = test::tube();
  model.joints[2].translation.y = -0.8;
  const LoadedBody body = load(source_of(
      model, bvh(recorded, "Frames: 2\nFrame Time: 0.5\n200 55 30 0 0 0 0 0 0 0 0 0\n210 50 30 0 0 0 0 0 0 0 0 0\n")));
  const auto first_m = body.positions_m(0.0);
  const auto second_m = body.positions_m(0.5);
  EXPECT_LT(glm::distance(first_m[0], model.positions[0] + sim::Vec3(0, 0.1, 0)), tolerance_m);
  EXPECT_LT(glm::distance(second_m[0], model.positions[0] + sim::Vec3(0.2, 0, 0)), tolerance_m);
}

TEST_F(Bvh, SaysWhichJointsAreNotThere) {
  std::string other = skeleton;
  other.replace(other.find("spine"), 5, "LeftArm");
  const std::string said = load(source_of(test::tube(), bvh(other, frames))).said();
  EXPECT_CONTAINS(said, "joints that its motion does not turn: Spine");
  EXPECT_CONTAINS(said, "joints of its motion that it does not have: LeftArm");
}

TEST_F(Bvh, RefusesAMotionOfAnotherSkeleton) {
  std::string other = skeleton;
  for (const auto& [from, to] :
       {std::pair<std::string, std::string>{"mixamorig:Hips", "Trunk"}, {"spine", "Rotor"}, {"left_foot", "Tail"}}) {
    other.replace(other.find(from), from.size(), to);
  }
  EXPECT_CONTAINS(error_of_motion(bvh(other, frames)),
                  "walk.bvh': found the joints Trunk, Rotor, Tail, none of which is one of the body's; expected "
                  "Hips, Spine, LeftFoot");
  GltfModel still = test::tube();
  still.weights.clear();
  EXPECT_CONTAINS(error_text(source_of(still, bvh(skeleton, frames))), "a body whose vertices follow no joints");
}

TEST_F(Bvh, NamesTheLineOfWhatIsWrong) {
  const std::string good = bvh(skeleton, frames);
  EXPECT_EQ(error_of_motion(good), "");
  EXPECT_CONTAINS(error_of_motion("HIERARCH\n"), "walk.bvh': line 1: found 'HIERARCH', expected HIERARCHY");
  EXPECT_CONTAINS(error_of_motion(bvh("Hips\n{\n OFFSET 0 x 0\n", "")),
                  "line 4: found 'x', expected three coordinates");
  EXPECT_CONTAINS(error_of_motion(bvh("Hips\n{\n CHANNELS 1 Wrotation\n", "")),
                  "line 4: found 'Wrotation', expected a channel");
  EXPECT_CONTAINS(error_of_motion(good.substr(0, good.size() - 3)),
                  "found the end of the file, expected 4 frames of 12 numbers");
  EXPECT_CONTAINS(error_of_motion(good + "7\n"), "found '7', expected the end of the file after 4 frames");
  EXPECT_CONTAINS(error_of_motion(bvh(skeleton, "Frames: 0\n")), "expected the number of frames, 1 to");
  EXPECT_CONTAINS(error_of_motion(bvh(skeleton, "Frames: 1\nFrame Time: 0\n")), "a time of a frame from 1e-05 to 10000 s");
}

TEST_F(Bvh, RefusesChannelsTwiceAndNumbersThatNobodyMovesBy) {
  const std::string twice =
      "Hips\n{\n OFFSET 0 50 0\n CHANNELS 3 Xposition Yposition Zposition\n"
      " CHANNELS 3 Zrotation Xrotation Yrotation\n}\n";
  EXPECT_CONTAINS(error_of_motion(bvh(twice, "Frames: 1\nFrame Time: 0.5\n0 0 0 0 0 0\n")), "channels of a joint once");
  for (const std::string time : {"1e-300", "1e8", "0"}) {
    EXPECT_CONTAINS(error_of_motion(bvh(skeleton, "Frames: 4\nFrame Time: " + time + "\n")), "from 1e-05 to 10000 s");
  }
  EXPECT_CONTAINS(error_of_motion(bvh(skeleton, "Frames: 4\nFrame Time: 0.5\n1e300 50 0 0 0 0 0 0 0 0 0 0\n")),
                  "found '1e300'");
}

TEST_F(Bvh, AJumpIsNamedBeforeTheRun) {
  EXPECT_CONTAINS(error_of_motion(bvh(skeleton,
                                      "Frames: 2\nFrame Time: 1\n0 50 0 0 0 0 0 0 0 0 0 0\n"
                                      "0 150 0 0 0 0 0 0 0 0 0 0\n")),
                  "walk.bvh': frame 1, vertex 0: found at [0.2, 2, 0] m, 2 m from where it is in the frame before");
}

}  // namespace
}  // namespace taut::app
