// Models that move by joints, shapes and nodes, against positions computed here.

#include <cmath>
#include <glm/geometric.hpp>

#include "app/bodies/rig_pose.hpp"
#include "gltf_text.hpp"
#include "loading.hpp"

namespace taut::app {
namespace {

using test::GltfModel;

const double half = std::sqrt(0.5);

/// Numbers in the file have single precision.
constexpr double tolerance_m = 1e-6;

sim::Vec3 turned_about_z(const sim::Vec3& p, const sim::Vec3& about, double angle) {
  const sim::Vec3 d = p - about;
  return about + sim::Vec3(std::cos(angle) * d.x - std::sin(angle) * d.y,
                           std::sin(angle) * d.x + std::cos(angle) * d.y, d.z);
}

/// Position of a vertex of the tube after the spine rotated about z and the hips moved. All vertices move with the
/// hips.
sim::Vec3 bent(const sim::Vec3& p, double angle, const sim::Vec3& hips_moved = sim::Vec3(0.0)) {
  const double upper = std::clamp(2.0 * (p.y - 1.0), 0.0, 1.0);
  return hips_moved + (1.0 - upper) * p + upper * turned_about_z(p, {0, 1.5, 0}, angle);
}

/// A clip in which the spine rotates by a quarter turn about the model's z axis in one second.
GltfModel::Clip bending(const std::string& name) {
  // A quarter turn about z after the quarter turn about y of the rest pose.
  return {name,
          {{1,
            "rotation",
            {0.0F, 1.0F},
            {0, static_cast<float>(half), 0, static_cast<float>(half), -0.5F, 0.5F, 0.5F, 0.5F}}}};
}

struct Rigs : testing::Test {
  BodySource source_of(const GltfModel& model) const {
    BodySource source;
    source.file = folder.write("body.gltf", gltf_text(model));
    return source;
  }
  test::TemporaryFolder folder;
};

TEST_F(Rigs, ATubeBendsAsItsJointsDo) {
  GltfModel model = test::tube();
  model.clips = {bending("Bend")};
  const LoadedBody body = load(source_of(model));
  ASSERT_EQ(body.mesh().data->positions_m.size(), model.positions.size());
  ASSERT_EQ(body.mesh().frames->count(), 61U);
  double worst_m = 0.0;
  for (const double time_s : {0.0, 0.25, 0.5, 1.0, 7.0}) {
    const std::vector<sim::Vec3> found_m = body.positions_m(time_s);
    for (std::size_t v = 0; v < model.positions.size(); ++v) {
      const double angle = 0.5 * 3.14159265358979 * std::min(time_s, 1.0);
      worst_m = std::max(worst_m, glm::distance(found_m[v], bent(model.positions[v], angle)));
    }
  }
  EXPECT_LT(worst_m, tolerance_m);
  EXPECT_CONTAINS(body.said(), "body 'avatar': it plays the first of its animations: 'Bend' (1 s)");
}

TEST_F(Rigs, AMovedRootTakesAllAlong) {
  GltfModel model = test::tube();
  model.clips = {{"Rise", {{0, "translation", {0.0F, 2.0F}, {0, 1, 0, 0.5F, 1.25F, 0}}}}};
  const LoadedBody body = load(source_of(model));
  const std::vector<sim::Vec3> found_m = body.positions_m(1.0);
  for (std::size_t v = 0; v < model.positions.size(); ++v) {
    EXPECT_LT(glm::distance(found_m[v], model.positions[v] + sim::Vec3(0.25, 0.125, 0)), tolerance_m) << v;
  }
}

TEST_F(Rigs, AClipIsChosenByItsName) {
  GltfModel model = test::tube();
  model.clips = {{"Rise", {{0, "translation", {0.0F, 2.0F}, {0, 1, 0, 0, 2, 0}}}}, bending("Bend")};
  BodySource source = source_of(model);
  source.clip = "Bend";
  source.frame_rate_hz = 10.0;
  const LoadedBody body = load(source);
  EXPECT_EQ(body.mesh().frames->count(), 11U);
  EXPECT_LT(glm::distance(body.positions_m(1.0).back(), bent({0, 2, 0}, 0.5 * 3.14159265358979)),
            tolerance_m);
  EXPECT_EQ(body.said(), "") << "it was asked for";
  source.clip = "none";
  EXPECT_EQ(load(source).mesh().frames, nullptr);
  source.clip = "Walk";
  EXPECT_CONTAINS(error_text(source),
                  "body.gltf': it has no animation 'Walk'; expected one of those it has: 'Rise' (2 s), 'Bend' (1 s)");
  model.clips.clear();
  source = source_of(model);
  EXPECT_EQ(load(source).mesh().frames, nullptr);
  source.clip = "Walk";
  EXPECT_CONTAINS(error_text(source), "expected one of those it has: none");
}

TEST_F(Rigs, AMotionBeginsLaterIfItIsAskedTo) {
  GltfModel model = test::tube();
  model.clips = {bending("Bend")};
  BodySource source = source_of(model);
  source.start_s = 0.5;
  const LoadedBody body = load(source);
  EXPECT_EQ(body.mesh().frames->count(), 31U);
  EXPECT_LT(glm::distance(body.positions_m(0.0).back(), bent({0, 2, 0}, 0.25 * 3.14159265358979)),
            tolerance_m);
  source.start_s = 1.1;
  EXPECT_CONTAINS(error_text(source), "found start = 1.1 s, expected a time of the motion, which ends at 1 s");
}

TEST_F(Rigs, ShapesAreMixedIn) {
  GltfModel model = test::tube();
  model.joints.clear();
  model.weights.clear();
  model.targets = {std::vector<sim::Vec3>(model.positions.size(), sim::Vec3(0.0))};
  model.targets[0].back() = {0.0, 0.5, 0.25};
  model.clips = {{"Swell", {{0, "weights", {0.0F, 1.0F, 2.0F}, {0.0F, 1.0F, 0.5F}}}}};
  const LoadedBody body = load(source_of(model));
  EXPECT_LT(glm::distance(body.positions_m(0.0).back(), {0, 2, 0}), tolerance_m);
  EXPECT_LT(glm::distance(body.positions_m(0.5).back(), {0, 2.25, 0.125}), tolerance_m);
  EXPECT_LT(glm::distance(body.positions_m(1.5).back(), {0, 2.375, 0.1875}), tolerance_m);
  EXPECT_LT(glm::distance(body.positions_m(1.0).front(), model.positions.front()), tolerance_m);
}

TEST_F(Rigs, WeightsThatDoNotSumToOneAreRefusedWithTheirVertex) {
  GltfModel model = test::tube();
  model.weights[5] = {{0, 0.5F}};
  EXPECT_CONTAINS(error_text(source_of(model)), "vertex 5 of its mesh 'tube");
  EXPECT_CONTAINS(error_text(source_of(model)), "sum to 0.5, expected 1");
  model.weights[5] = {};
  EXPECT_CONTAINS(error_text(source_of(model)), "sum to 0, expected 1");
  model.weights[5] = {{0, 0.25F}, {1, 0.746F}};
  EXPECT_EQ(error_text(source_of(model)), "") << "as 8 bits round it";
}

TEST_F(Rigs, JointsThatMoveNothingAreRefused) {
  GltfModel model = test::tube();
  model.weights.clear();
  model.clips = {bending("Bend")};
  EXPECT_CONTAINS(error_text(source_of(model)), "its animation 'Bend' moves 1 nodes, and no vertex follows any");
}

TEST_F(Rigs, TheHeightOfADollAndOfAHouseIsSaid) {
  GltfModel model = test::tube();
  BodySource source = source_of(model);
  EXPECT_EQ(load(source).said(), "");
  source.scale = 0.3;
  EXPECT_EQ(load(source).said(), "");
  source.scale = 0.2;
  EXPECT_CONTAINS(load(source).said(), "it is 0.4 m high (scale, --body-units)");
  source.scale = 1.2;
  EXPECT_EQ(load(source).said(), "");
  source.scale = 1.3;
  EXPECT_CONTAINS(load(source).said(), "it is 2.6 m high (scale, --body-units)");
}

TEST(Rotations, GoAlongTheShorterArcAtAConstantRate) {
  const glm::dvec4 from(0, 0, 0, 1);
  for (const double share : {0.0, 0.1, 0.5, 0.7, 1.0}) {
    const double angle = 0.9 * share;  // half of the angle between the rotations
    const glm::dvec4 expected(std::sin(angle), 0, 0, std::cos(angle));
    const glm::dvec4 to(std::sin(0.9), 0, 0, std::cos(0.9));
    EXPECT_LT(glm::length(rotation_between(from, to, share) - expected), 1e-14) << share;
    EXPECT_LT(glm::length(rotation_between(from, -to, share) - expected), 1e-14) << share;
  }
}

// Blender writes the joints and the shapes of one action as two glTF animations.
TEST(RigClips, AllAreLookedAtAtOnce) {
  const test::TemporaryFolder folder;
  GltfModel model = test::tube();
  model.targets = {std::vector<sim::Vec3>(model.positions.size(), sim::Vec3(0.0, 0.0, 0.25))};
  model.clips = {{"Joints", {{0, "translation", {0.0F, 1.0F}, {0, 1, 0, 0, 1.5F, 0}}}},
                 {"Shapes", {{0, "weights", {0.0F, 2.0F}, {0, 1}}}}};
  BodySource source;
  source.file = folder.write("body.gltf", gltf_text(model));
  const auto moved_m = [&](const char* clip, double time_s) {
    source.clip = clip;
    return load(source).positions_m(time_s)[0] - model.positions[0];
  };
  EXPECT_LT(glm::distance(moved_m("", 1.0), sim::Vec3(0.0, 0.5, 0.0)), tolerance_m);
  EXPECT_LT(glm::distance(moved_m("all", 1.0), sim::Vec3(0.0, 0.5, 0.125)), tolerance_m);
  EXPECT_LT(glm::distance(moved_m("all", 9.0), sim::Vec3(0.0, 0.5, 0.25)), tolerance_m) << "the longer";
}

// The height in the message reveals a file in another unit than its format prescribes.
TEST(RigClips, AJumpOfABodyThatIsNoPersonsSizeIsSaidWithItsHeight) {
  const test::TemporaryFolder folder;
  GltfModel model = test::tube();
  model.clips = {{"Rise", {{0, "translation", {0.0F, 0.1F}, {0, 1, 0, 0, 1.5F, 0}}}}};
  BodySource source;
  source.file = folder.write("body.gltf", gltf_text(model));
  source.scale = 100.0;
  EXPECT_CONTAINS(error_text(source), "expected at most 1 m; it is 200 m high (scale, --body-units)");
}

/// A tetrahedron as FBX. Its shape is mixed in by `percent` % and moves the first vertex up by 1.
std::string fbx_with_shape(int percent) {
  return R"(; FBX 7.4.0 project file
FBXHeaderExtension:  { FBXVersion: 7400 }
GlobalSettings:  { Properties70:  {
    P: "UpAxis", "int", "Integer", "",1
    P: "UnitScaleFactor", "double", "Number", "",100
} }
Objects:  {
  Geometry: 100, "Geometry::body", "Mesh" {
    Vertices: *12 { a: 0,0,0,1,0,0,0,1,0,0,0,1 }
    PolygonVertexIndex: *12 { a: 0,2,-2,0,1,-4,0,3,-3,1,2,-4 }
  }
  Geometry: 101, "Geometry::Belly", "Shape" {
    Indexes: *1 { a: 0 }
    Vertices: *3 { a: 0,-0.5,0 }
    Normals: *3 { a: 0,0,0 }
  }
  Model: 200, "Model::body", "Mesh" { Version: 232 }
  Deformer: 300, "Deformer::body", "BlendShape" { Version: 100 }
  Deformer: 301, "SubDeformer::Belly", "BlendShapeChannel" {
    Version: 100
    DeformPercent: )" +
         std::to_string(percent) + R"(
    FullWeights: *1 { a: 100 }
  }
}
Connections:  {
  C: "OO",200,0
  C: "OO",100,200
  C: "OO",300,100
  C: "OO",301,300
  C: "OO",101,301
}
)";
}

// The importer assimp reports each of these shapes as fully mixed in.
TEST(RigOfFbx, ShapesAreNotMixedInByThemselves) {
  const test::TemporaryFolder folder;
  for (const int percent : {0, 40}) {
    BodySource source;
    source.file = folder.write("body.fbx", fbx_with_shape(percent));
    const LoadedBody body = load(source);
    double min_height_m = 1.0;
    for (const sim::Vec3& place_m : body.positions_m(0.0)) {
      min_height_m = std::min(min_height_m, place_m.y);
    }
    EXPECT_EQ(min_height_m, 0.0) << percent;
    EXPECT_CONTAINS(body.said(), "none of its shapes is mixed in: how much of them is not read from FBX");
  }
}

}  // namespace
}  // namespace taut::app
