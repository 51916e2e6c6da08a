// Bodies that grow into their clothes before the run.

#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <numeric>

#include "app/drawing/drawn_scene.hpp"
#include "app/garments/dressing/dressing.hpp"
#include "app/models/garment_loading.hpp"
#include "app/models/inspecting/remarks.hpp"
#include "app/models/inspecting/scene_crossings.hpp"
#include "app/runs/run_checkpoint.hpp"
#include "gltf_text.hpp"
#include "loading.hpp"

namespace taut::app {
namespace {

using test::GltfModel;

/// Distance of a point from the axis of the tube.
double from_axis(const sim::Vec3& p) { return glm::length(sim::Vec3(p.x, 0.0, p.z)); }

struct Dressing : testing::Test {
  BodySource source_of(const GltfModel& model) const {
    BodySource source;
    source.file = folder.write("body.gltf", gltf_text(model));
    source.dress = 30;
    return source;
  }
  /// An octagon of cloth around a vertical axis at this x. It is wide enough for the tube, which grows in 60 frames.
  DrawnScene ring_at(double x_m) const {
    folder.write("body.gltf", gltf_text(test::tube()));
    std::string ring;
    for (int k = 0; k < 16; ++k) {
      const double angle = 0.25 * 3.14159265358979 * (k / 2);
      ring += "v " + std::to_string(x_m + 0.26 * std::cos(angle)) + ' ' + std::to_string(0.6 + 0.2 * (k % 2)) + ' ' +
              std::to_string(0.26 * std::sin(angle)) + '\n';
    }
    for (int k = 0; k < 16; k += 2) {
      const auto at = [&](int step) { return ' ' + std::to_string(1 + (k + step) % 16); };
      ring += 'f' + at(0) + at(1) + at(3) + at(2) + '\n';
    }
    folder.write("ring.obj", ring);
    DrawnScene scene =
        read_scene_file(folder.write("scene.toml",
                                     "[garment]\nfile = \"ring.obj\"\nscale = 1\nup = \"y\"\n[pins]\nat = \"none\"\n"
                                     "[[bodies]]\nshape = \"mesh\"\nfile = \"body.gltf\"\ndress = 60\n"));
    return scene;
  }
  test::TemporaryFolder folder;
};

TEST_F(Dressing, AStillBodyGrowsFromItsBones) {
  const GltfModel model = test::tube();
  const LoadedBody body = load(source_of(model));
  const auto thin_m = body.positions_m(-0.5);
  const auto half_m = body.positions_m(-0.3);  // the body has full size from -0.1 s on
  const auto full_m = body.positions_m(0.0);
  for (std::size_t v = 0; v < model.positions.size(); ++v) {
    const sim::Vec3& p = model.positions[v];
    EXPECT_LT(glm::distance(full_m[v], p), 1e-6) << v;
    EXPECT_NEAR(from_axis(thin_m[v]), 0.1 * from_axis(p), 1e-6) << "the bones are on the axis, vertex " << v;
    EXPECT_LT(glm::distance(half_m[v], 0.5 * (thin_m[v] + full_m[v])), 1e-6) << v;
  }
  EXPECT_NEAR(thin_m[0].y, 0.0, 1e-6);
  EXPECT_NEAR(thin_m[16].y, 0.275, 1e-6) << "half of it follows the foot, which is a joint at the ground";
  EXPECT_NEAR(thin_m.back().y, 1.55, 1e-6) << "most of the way from 2 m to the spine at 1.5 m";
  EXPECT_EQ(body.positions_m(-9.0), thin_m);
  EXPECT_EQ(body.positions_m(9.0), full_m);
  EXPECT_TRUE(sim::is_moving_after(body.body, -0.1));
  EXPECT_FALSE(sim::is_moving_after(body.body, 0.0));
}

TEST_F(Dressing, AMotionBeginsWhenTheBodyHasGrown) {
  GltfModel model = test::tube();
  model.clips = {{"Rise", {{0, "translation", {0.0F, 1.0F}, {0, 1.5F, 0, 0, 2, 0}}}}};
  BodySource source = source_of(model);
  const LoadedBody dressed = load(source);
  source.dress = 0;
  const LoadedBody undressed = load(source);
  for (const double time_s : {0.0, 0.3, 1.0, 2.0}) {
    const auto expected_m = undressed.positions_m(time_s);
    const auto found_m = dressed.positions_m(time_s);
    for (std::size_t v = 0; v < found_m.size(); ++v) {
      EXPECT_LT(glm::distance(found_m[v], expected_m[v]), 1e-12) << v;
    }
  }
  EXPECT_NEAR(dressed.positions_m(-0.5)[0].y, 0.5, 1e-6) << "it grows in the pose that the motion begins with";
}

// Half a turn. Vertices move straight from pose to pose and come nearer to the joint by at most 2 %.
TEST(TurningBack, GoesThroughPosesThatAreNear) {
  Rig rig;
  rig.nodes = {{"Arm", no_node, glm::dmat4(1.0)}, {"Hand", 0, glm::dmat4(1.0)}};
  RigPose pose = stored_pose(rig);
  pose.to_model[1][3] = glm::dvec4(1.0, 0.0, 0.0, 1.0);
  const std::vector<TurnedBone> bones = {{0, 1, {-1.0, 0.01, 0.0}}};
  std::vector<RigPose> poses = make_turning_poses(rig, pose, bones);
  ASSERT_EQ(poses.size(), 8U);
  EXPECT_NEAR(poses[0].to_model[1][3].x, -1.0, 1e-3) << "it begins where it shall point";
  poses.push_back(pose);
  for (std::size_t k = 0; k + 1 < poses.size(); ++k) {
    EXPECT_GT(glm::length(sim::Vec3(0.5 * (poses[k].to_model[1][3] + poses[k + 1].to_model[1][3]))), 0.98);
  }
}

TEST_F(Dressing, NeedsJoints) {
  GltfModel model = test::tube();
  model.weights.clear();
  EXPECT_CONTAINS(error_text(source_of(model)), "found a body to be dressed (dress, --dress) without joints; expected");
  BodySource source = source_of(test::tube());
  source.file = folder.write("body.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  EXPECT_CONTAINS(error_text(source), "without joints");
}

TEST_F(Dressing, ClothThatBeganInTheBodyIsAroundItAtFrame0) {
  const DrawnScene scene = ring_at(0.1);
  const LoadedBodies bodies = load_bodies(scene);
  const LoadedGarment loaded = load_garment(scene);
  sim::Simulation simulation = make_simulation(scene, loaded, bodies.all);
  const auto crossings = [&] {
    return scene_crossings({simulation.state().current, simulation.garment().mesh.triangles}, bodies.all, 0.0)
        .back()
        .pairs.size();
  };
  EXPECT_GT(crossings(), 0U) << "as it was modelled";
  EXPECT_EQ(remarks_on_start(scene, loaded, bodies.all).lines, std::vector<std::string>{})
      << "the run begins with a thin body";
  const sim::Surroundings surroundings = simulation.surroundings();
  EXPECT_EQ(go_to_start(scene, bodies, simulation), 0);
  EXPECT_EQ(simulation.surroundings(), surroundings) << "with gravity again";
  EXPECT_EQ(simulation.state().time_s, 0.0);
  EXPECT_EQ(crossings(), 0U);
  for (const sim::Vec3& place_m : simulation.state().current) {
    EXPECT_GT(place_m.y, 0.5) << "it did not fall off the thin body";
  }
}

TEST_F(Dressing, ClothThatCrossesTheBodyWhenItHasGrownEndsTheRun) {
  DrawnScene scene = ring_at(0.25);
  const LoadedBodies bodies = load_bodies(scene);
  const LoadedGarment loaded = load_garment(scene);
  sim::Simulation simulation = make_simulation(scene, loaded, bodies.all);
  EXPECT_CONTAINS(test::error_message<PromiseBroken>([&] { go_to_start(scene, bodies, simulation); }),
                  "when it is dressed, ");
  scene.simulation.solver.bounded.allow_crossing = true;
  sim::Simulation allowed = make_simulation(scene, loaded, bodies.all);
  EXPECT_EQ(go_to_start(scene, bodies, allowed), 0);
}

/// Clearance for two upright square tubes whose walls are `gap_m` apart. Each has a joint in its middle: a leg, or a
/// finger of one hand.
std::optional<ClearanceResult> room_between(double gap_m, bool are_fingers = false, int garments = 1) {
  Rig rig;
  if (are_fingers) {
    rig.nodes.push_back({"LeftHand", no_node, glm::dmat4(1.0)});
  }
  std::vector<sim::Triangle> triangles;
  for (const double side : {0.0, 1.0}) {
    const auto node = static_cast<sim::Index>(rig.nodes.size());
    const sim::Vec3 middle(side * (0.2 + gap_m), 0.5, 0.0);
    const char* leg = side > 0.0 ? "LeftLeg" : "RightLeg";
    const char* finger = side > 0.0 ? "LeftHandIndex1" : "LeftHandMiddle1";
    rig.nodes.push_back(
        {are_fingers ? finger : leg, are_fingers ? 0 : no_node, glm::translate(glm::dmat4(1.0), middle)});
    rig.bones.push_back({node, glm::translate(glm::dmat4(1.0), -middle)});
    const auto bone = static_cast<sim::Index>(rig.bones.size() - 1);
    const auto first = static_cast<sim::Index>(rig.in_part.size());
    for (sim::Index k = 0; k < 44; ++k) {
      const sim::Index corner = k % 4;
      rig.influences.push_back({rig.in_part.size(), bone, 1.0});
      rig.in_part.push_back(
          middle + sim::Vec3(corner == 0 || corner == 3 ? 0.1 : -0.1, 0.1 * (k / 4) - 0.5, corner < 2 ? 0.1 : -0.1));
    }
    for (sim::Index k = 0; k < 40; ++k) {
      const sim::Index next = k % 4 == 3 ? k - 3 : k + 1;
      triangles.push_back({first + k, first + k + 4, first + next});
      triangles.push_back({first + next, first + k + 4, first + next + 4});
    }
  }
  rig.parts = {{0, "", 0, rig.in_part.size(), true}};
  FileVertexPlaces places;
  places.file_vertex.resize(rig.in_part.size());
  std::iota(places.file_vertex.begin(), places.file_vertex.end(), 0U);
  const std::vector<RigPose> poses = {stored_pose(rig)};
  return leave_clearance(rig, poses, places, triangles, garments);
}

TEST(ClearanceResult, IsLeftBetweenLimbsThatTouch) {
  EXPECT_FALSE(room_between(0.05));
  const auto room = room_between(0.001);
  ASSERT_TRUE(room);
  EXPECT_GT(room->vertices, 10U);
  EXPECT_GT(room->max_distance_m, 0.002);
  EXPECT_LT(room->max_distance_m, 0.03);
  EXPECT_FALSE(room_between(0.001, true)) << "no cloth goes there";
  EXPECT_FALSE(room_between(0.012));
  EXPECT_TRUE(room_between(0.012, false, 2)) << "another garment is worn over it";
}

}  // namespace
}  // namespace taut::app
