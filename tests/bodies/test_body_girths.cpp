// Girths of bodies, as a tape measures them.

#include <fmt/core.h>

#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <map>

#include "app/bodies/body_loading.hpp"
#include "app/garments/dressing/body_girths.hpp"
#include "app/garments/dressing/dressing.hpp"
#include "app/models/hanging/garment_measures.hpp"
#include "app/scene/scene_key.hpp"
#include "loading.hpp"

namespace taut::app {
namespace {

constexpr double pi = 3.14159265358979;

/// Ellipse of a body at a height: its half axes, and the displacement of its middle forwards.
struct Ring {
  double height_m, half_width_m, half_depth_m, forward_m;
};

/// A closed surface through ellipses, one above the other.
sim::Mesh stack_rings(const std::vector<Ring>& rings) {
  constexpr sim::Index around = 48;
  sim::Mesh mesh;
  for (const Ring& ring : rings) {
    for (sim::Index k = 0; k < around; ++k) {
      const double angle = 2.0 * pi * k / around;
      mesh.positions.emplace_back(ring.half_width_m * std::cos(angle), ring.height_m,
                                  ring.forward_m + ring.half_depth_m * std::sin(angle));
    }
  }
  const auto top = static_cast<sim::Index>(rings.size() - 1);
  const auto last = static_cast<sim::Index>(mesh.positions.size());
  mesh.positions.emplace_back(0.0, rings.front().height_m, rings.front().forward_m);
  mesh.positions.emplace_back(0.0, rings.back().height_m, rings.back().forward_m);
  for (sim::Index k = 0; k < around; ++k) {
    const sim::Index next = (k + 1) % around;
    for (sim::Index r = 0; r < top; ++r) {
      mesh.triangles.push_back({r * around + k, (r + 1) * around + k, (r + 1) * around + next});
      mesh.triangles.push_back({r * around + k, (r + 1) * around + next, r * around + next});
    }
    mesh.triangles.push_back({last, k, next});
    mesh.triangles.push_back({last + 1, top * around + next, top * around + k});
  }
  return mesh;
}

/// Perimeter of an ellipse (Ramanujan 1914).
double around_ellipse(double a, double b) { return pi * (3.0 * (a + b) - std::sqrt((3.0 * a + b) * (a + 3.0 * b))); }

/// A person in a long robe, without arms.
const std::vector<Ring> robe = {{0.0, 0.20, 0.13, 0},    {0.9, 0.20, 0.13, 0},    {1.1, 0.15, 0.10, 0},
                                {1.3, 0.17, 0.13, 0.01}, {1.4, 0.15, 0.12, 0},    {1.5, 0.06, 0.06, 0},
                                {1.6, 0.06, 0.06, 0},    {1.65, 0.09, 0.11, 0.0}, {1.75, 0.08, 0.09, 0}};

TEST(BodyGirths, OfABodyOfEllipsesAreThoseOfTheEllipses) {
  const sim::Mesh mesh = stack_rings(robe);
  const BodyMeasures measures = measure_body({mesh.positions, mesh.triangles}, {});
  const auto expect = [&](const char* name, double girth_m, double height_m) {
    const Girth* girth = find_girth(measures, name);
    ASSERT_NE(girth, nullptr) << name;
    EXPECT_NEAR(girth->girth_m, girth_m, 0.01 * girth_m) << name;
    EXPECT_NEAR(girth->height_m, height_m, 0.01) << name;
  };
  expect("chest", around_ellipse(0.17, 0.13), 1.3);
  expect("waist", around_ellipse(0.15, 0.10), 1.1);
  EXPECT_NEAR(find_girth(measures, "seat")->girth_m, around_ellipse(0.20, 0.13), 0.01);
  EXPECT_NEAR(find_girth(measures, "neck")->girth_m, around_ellipse(0.06, 0.06), 0.01);
  EXPECT_EQ(find_girth(measures, "thigh"), nullptr) << "it has no legs";
  EXPECT_EQ(find_girth(measures, "upper arm"), nullptr);
  ASSERT_TRUE(measures.neck_m);
  EXPECT_NEAR(measures.neck_m->y, 1.47, 0.01) << "where the shoulders begin";
}

void add(const sim::Mesh& part, const sim::Vec3& at_m, sim::Mesh& mesh) {
  const auto first = static_cast<sim::Index>(mesh.positions.size());
  for (const sim::Vec3& p : part.positions) {
    mesh.positions.push_back(p + at_m);
  }
  for (const auto& [a, b, c] : part.triangles) {
    mesh.triangles.push_back({a + first, b + first, c + first});
  }
}

// Arms that hang beside a trunk are nearer to its sides than the middle of the trunk is.
TEST(ShapeRig, TheTrunkFollowsNoArm) {
  sim::Mesh mesh = stack_rings({robe.begin() + 1, robe.end()});
  add(stack_rings({robe.begin(), robe.begin() + 2}), sim::Vec3(0.0), mesh);
  const std::size_t of_trunk = mesh.positions.size();
  for (const double side : {-1.0, 1.0}) {
    add(stack_rings({{0.9, 0.04, 0.04, 0}, {1.35, 0.05, 0.05, 0}}), {0.26 * side, 0.0, 0.0}, mesh);
  }
  add(stack_rings({{1.34, 0.36, 0.06, 0}, {1.44, 0.36, 0.06, 0}}), sim::Vec3(0.0), mesh);
  const sim::Surface body = {mesh.positions, mesh.triangles};
  const std::optional<Rig> rig = guess_rig(body, measure_body(body, {}));
  ASSERT_TRUE(rig);
  for (const RigInfluence& influence : rig->influences) {
    const sim::Vec3& p = mesh.positions[influence.vertex];
    const std::string& joint = rig->nodes[rig->bones[influence.bone].node].name;
    const bool is_arm = joint.ends_with("Arm") || joint.ends_with("Hand");
    if (p.y < 1.32) {
      EXPECT_EQ(is_arm, influence.vertex >= of_trunk) << joint << ' ' << p.x << ' ' << p.y;
    }
  }
  EXPECT_FALSE(guess_rig(body, {})) << "nothing was measured";
}

// The trunk has hips at 0.37 of its height, a belly at 0.54 and a chest at 0.7. The belly is neither seat nor chest.
TEST(BodyGirths, SeatAndChestAreLookedForWhereTheyAre) {
  const sim::Mesh mesh = stack_rings({{0.0, 0.15, 0.10, 0},
                                      {0.55, 0.20, 0.13, 0},
                                      {0.65, 0.15, 0.10, 0},
                                      {0.8, 0.22, 0.14, 0},
                                      {0.9, 0.15, 0.10, 0},
                                      {1.03, 0.17, 0.12, 0.01},
                                      {1.15, 0.15, 0.10, 0},
                                      {1.4, 0.15, 0.11, 0},
                                      {1.5, 0.06, 0.06, 0},
                                      {1.6, 0.06, 0.06, 0},
                                      {1.65, 0.09, 0.11, 0.0},
                                      {1.75, 0.08, 0.09, 0}});
  const BodyMeasures measures = measure_body({mesh.positions, mesh.triangles}, {});
  ASSERT_NE(find_girth(measures, "chest"), nullptr);
  EXPECT_NEAR(find_girth(measures, "seat")->height_m, 0.55, 0.005);
  EXPECT_NEAR(find_girth(measures, "chest")->height_m, 1.03, 0.005);
}

TEST(BodyGirths, ABellyIsNoChest) {
  std::vector<Ring> rings = robe;
  rings[2] = {1.1, 0.15, 0.13, 0.03};
  rings[4] = {1.4, 0.17, 0.12, -0.01};
  rings.insert(rings.begin() + 3, {1.2, 0.16, 0.12, 0.0});
  const sim::Mesh mesh = stack_rings(rings);
  const BodyMeasures measures = measure_body({mesh.positions, mesh.triangles}, {});
  EXPECT_NEAR(find_girth(measures, "chest")->height_m, 1.3, 0.01);
  EXPECT_NEAR(find_girth(measures, "waist")->height_m, 1.1, 0.01);
}

TEST(BodyGirths, ANeckIsNarrowerThanAHead) {
  const auto has_neck = [](double half_width_m) {
    std::vector<Ring> rings = robe;
    rings[5].half_width_m = rings[5].half_depth_m = half_width_m;
    rings[6] = {1.6, half_width_m, half_width_m, 0};
    const sim::Mesh mesh = stack_rings(rings);
    return find_girth(measure_body({mesh.positions, mesh.triangles}, {}), "neck") != nullptr;
  };
  EXPECT_TRUE(has_neck(0.08)) << "0.8 of its girth";
  EXPECT_FALSE(has_neck(0.09)) << "0.9";
}

/// A person with legs up to 0.8 m, arms that hang beside the trunk down to 0.7 m, and a slab across the arms from
/// 1.34 m up.
sim::Mesh person(double arms_m) {
  sim::Mesh mesh = stack_rings({robe.begin() + 1, robe.end()});
  add(stack_rings({{0.8, 0.20, 0.13, 0}, {0.9, 0.20, 0.13, 0}}), sim::Vec3(0.0), mesh);
  for (const double side : {-1.0, 1.0}) {
    add(stack_rings({{0.3, 0.08, 0.08, 0}, {0.82, 0.08, 0.08, 0}}), {0.1 * side, 0.0, 0.0}, mesh);
    // A boot: its shaft goes around the leg, and its toes point forwards.
    add(stack_rings({{0.0, 0.09, 0.09, 0}, {0.05, 0.09, 0.09, 0.1}, {0.12, 0.09, 0.09, -0.3}, {0.55, 0.09, 0.09, 0}}),
        {0.2 * side, 0.0, 0.0}, mesh);
    add(stack_rings({{0.70, 0.04, 0.04, 0}, {0.82, 0.04, 0.04, 0}, {0.9, 0.04, 0.04, 0}, {1.35, 0.05, 0.05, 0}}),
        {0.26 * side, 0.0, 0.0}, mesh);
  }
  add(stack_rings({{1.34, arms_m, 0.06, 0}, {1.44, arms_m, 0.06, 0}}), sim::Vec3(0.0), mesh);
  return mesh;
}

TEST(BodyGirths, ATapeIsTightGoesAroundBothLegsAndLeavesArmsOut) {
  const sim::Mesh mesh = person(0.36);
  const BodyMeasures measures = measure_body({mesh.positions, mesh.triangles}, {});
  ASSERT_FALSE(measures.levels.empty());
  const LevelTape& chest = measures.level_at(1.3);
  EXPECT_NEAR(chest.girth_m, around_ellipse(0.17, 0.13), 0.01);
  EXPECT_EQ(chest.arm_count, 2U);
  EXPECT_FALSE(chest.has_legs_apart);
  EXPECT_NEAR(chest.front_m, 0.14, 0.002);
  EXPECT_TRUE(measures.level_at(0.7).has_legs_apart);
  EXPECT_NEAR(measures.levels[measures.fork].height_m, 0.81, 0.012);
  EXPECT_NEAR(tight_tape_m({{0, 0}, {1, 0}, {0.5, 0.1}, {1, 1}, {0, 1}}), 4.0, 1e-12) << "over a dent";
  EXPECT_TRUE(is_in_hull(convex_hull({{0, 0}, {1, 0}, {1, 1}, {0, 1}}), {0.5, 0.9}));
  EXPECT_FALSE(is_in_hull(convex_hull({{0, 0}, {1, 0}, {1, 1}, {0, 1}}), {0.5, 1.1}));
}

TEST(BodyGirths, ArmsBeginWhereTheGirthJumps) {
  const auto upper_chest_m = [](double arms_m) {
    const sim::Mesh mesh = person(arms_m);
    const BodyMeasures measures = measure_body({mesh.positions, mesh.triangles}, {});
    const Girth* const girth = find_girth(measures, "upper chest");
    return girth == nullptr ? 0.0 : girth->height_m;
  };
  EXPECT_EQ(upper_chest_m(0.17), 0.0) << "by less than 1.08";
  EXPECT_NEAR(upper_chest_m(0.27), 1.34 - 0.011, 0.0045) << "between the second and the third level below";
}

TEST(ShapeRig, PutsJointsWhereTheyAreInPeople) {
  const sim::Mesh mesh = person(0.36);
  const sim::Surface body = {mesh.positions, mesh.triangles};
  const BodyMeasures measures = measure_body(body, {});
  ASSERT_NE(find_girth(measures, "thigh"), nullptr);
  EXPECT_NEAR(find_girth(measures, "thigh")->height_m, 0.8, 0.02);
  const std::optional<Rig> rig = guess_rig(body, measures);
  ASSERT_TRUE(rig);
  const JointPlaces places = compute_joint_positions(*rig, stored_pose(*rig), {});
  EXPECT_LT(glm::distance(places.at("left arm"), sim::Vec3(0.138, 1.409, 0.003)), 0.002);
  EXPECT_LT(glm::distance(places.at("left upleg"), sim::Vec3(0.081, 0.867, 0.0)), 0.002);
  EXPECT_LT(glm::distance(places.at("left hand"), sim::Vec3(0.3, 0.7, 0.0)), 0.002) << "the farthest";
  EXPECT_LT(glm::distance(places.at("left foot"), sim::Vec3(0.2, 0.025, 0.05)), 0.002) << "with its toes";
  const std::map<double, std::string> joint_at = {
      {0.55, "LeftUpLeg"}, {0.7, "LeftHand"}, {0.82, "LeftForeArm"}, {0.9, "LeftForeArm"}};
  for (const RigInfluence& influence : rig->influences) {
    const sim::Vec3& p = mesh.positions[influence.vertex];
    if (p.x > 0.25 && joint_at.contains(p.y)) {
      EXPECT_EQ(rig->nodes[rig->bones[influence.bone].node].name, joint_at.at(p.y)) << p.x << ' ' << p.y;
    }
  }
}

TEST(BodyGirths, ATableHasNone) {
  const sim::Mesh mesh =
      stack_rings({{0.0, 0.1, 0.1, 0}, {0.7, 0.1, 0.1, 0}, {0.71, 0.6, 0.6, 0}, {0.75, 0.6, 0.6, 0}});
  EXPECT_TRUE(measure_body({mesh.positions, mesh.triangles}, {}).girths.empty());
}

// One curve ends where the surface ends, the other goes around the point.
TEST(Section, TellsCurvesThatEndFromThoseThatGoAround) {
  sim::Mesh tube = stack_rings({{0.0, 0.2, 0.1, 0}, {1.0, 0.2, 0.1, 0}});
  auto curves = cut_section({tube.positions, tube.triangles}, {{0.0, 0.5, 0.0}});
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_TRUE(curves[0].is_closed);
  EXPECT_TRUE(is_around_point(curves[0]));
  EXPECT_NEAR(length_m(curves[0]), around_ellipse(0.2, 0.1), 0.002);
  EXPECT_FALSE(is_around_point(cut_section({tube.positions, tube.triangles}, {{0.5, 0.5, 0.0}})[0]));
  tube.triangles.erase(tube.triangles.begin());  // a triangle of the side
  curves = cut_section({tube.positions, tube.triangles}, {{0.0, 0.5, 0.0}});
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_FALSE(curves[0].is_closed);
  EXPECT_LT(length_m(curves[0]), around_ellipse(0.2, 0.1));
}

/// A mannequin whose arms point `degrees` below the horizontal and are scaled by `scale`.
sim::Mesh with_arms(const char* mannequin, double degrees, double scale) {
  BodySource source;
  source.file = std::string(TAUT_ASSETS_FOLDER) + "/bodies/mannequin_" + mannequin + ".glb";
  const ReadBody body = read_body(source, {});
  const std::map<std::string, sim::Index> nodes = joint_nodes(*body.rig);
  RigPose pose = stored_pose(*body.rig);
  std::vector<TurnedBone> bones;
  for (const std::string side : {"left ", "right "}) {
    const sim::Index arm = nodes.at(side + "arm");
    const sim::Index forearm = nodes.at(side + "forearm");
    const sim::Index hand = nodes.at(side + "hand");
    const double angle = degrees * pi / 180.0;
    const sim::Vec3 direction = {(side == "left " ? 1.0 : -1.0) * std::cos(angle), -std::sin(angle), 0.0};
    bones.push_back({arm, forearm, direction});
    bones.push_back({forearm, hand, direction});
    const sim::Vec3 shoulder(pose.to_model[arm][3]);
    for (const sim::Index node : {arm, forearm, hand}) {
      pose.to_model[node] = glm::translate(glm::dmat4(1.0), shoulder) * glm::scale(glm::dmat4(1.0), sim::Vec3(scale)) *
                            glm::translate(glm::dmat4(1.0), -shoulder) * pose.to_model[node];
    }
  }
  sim::Mesh mesh{std::vector<sim::Vec3>(body.mesh.data->positions_m.size()), body.mesh.data->triangles, {}};
  std::vector<sim::Vec3> in_file(body.rig->in_part.size());
  pose_vertices(*body.rig, make_turning_poses(*body.rig, pose, bones).front(), in_file);
  mesh.positions = placed_m(body.places, in_file);
  return mesh;
}

void expect_girths(const sim::Mesh& mesh, const BodyMeasures& truth, const std::string& which) {
  const BodyMeasures measures = measure_body_and_arms({mesh.positions, mesh.triangles}, {});
  for (const char* name : {"chest", "waist", "seat", "thigh"}) {
    const Girth* const girth = find_girth(measures, name);
    ASSERT_NE(girth, nullptr) << name << ' ' << which;
    EXPECT_NEAR(girth->girth_m / find_girth(truth, name)->girth_m, 1.0, 0.01) << name << ' ' << which;
  }
}

// Oblique sections of forearms are longer than sections of legs. Sections of arms that are stretched out merge with
// the trunk.
TEST(BodyGirths, AreTheSameWhereverArmsHang) {
  for (const char* mannequin : {"female_34", "male_40"}) {
    const sim::Mesh stored = with_arms(mannequin, 43.0, 1.0);
    const BodyMeasures truth = measure_body_and_arms({stored.positions, stored.triangles}, {});
    for (const double degrees : {0.0, 10.0, 25.0, 30.0, 60.0, 80.0}) {
      for (const double scale : {1.0, 1.22}) {
        const sim::Mesh mesh = with_arms(mannequin, degrees, scale);
        expect_girths(mesh, truth, fmt::format("{} {} {}", mannequin, degrees, scale));
        const BodyMeasures measures = measure_body_and_arms({mesh.positions, mesh.triangles}, {});
        for (const char* name : {"upper arm", "armhole"}) {
          ASSERT_NE(find_girth(measures, name), nullptr) << name << degrees;
          const double times = find_girth(measures, name)->girth_m / find_girth(truth, name)->girth_m;
          EXPECT_NEAR(times, 0.5 * (1.0 + scale), 0.5 * scale - 0.42) << name << ' ' << mannequin << ' ' << degrees;
        }
      }
    }
  }
}

// Rolls like this arise where the hem of a shoulder is rolled in.
TEST(BodyGirths, ARollOfClothIsNoArmhole) {
  const ArmJoints arm = {{0.2, 1.4, 0.0}, {0.2, 1.1, 0.0}, {1.0, 0.0, 0.0}};
  sim::Mesh sleeve = stack_rings({{1.0, 0.09, 0.09, 0}, {1.6, 0.09, 0.09, 0}});
  for (sim::Vec3& p : sleeve.positions) p.x += 0.2;
  const auto hole = find_armhole({sleeve.positions, sleeve.triangles}, arm, 0.56);
  ASSERT_TRUE(hole.has_value());
  EXPECT_GT(hole->tape_m, 0.5);
  add(stack_rings({{1.0, 0.003, 0.003, 0}, {1.6, 0.003, 0.003, 0}}), {0.2, 0.0, 0.0}, sleeve);
  const auto beside_roll = find_armhole({sleeve.positions, sleeve.triangles}, arm, 0.56);
  ASSERT_TRUE(beside_roll.has_value());
  EXPECT_DOUBLE_EQ(beside_roll->tape_m, hole->tape_m);
}

// Hair down to the hips, and shoes.
TEST(BodyGirths, WhatIsNoSkinIsLeftOut) {
  sim::Mesh mesh = with_arms("female_34", 43.0, 1.0);
  const BodyMeasures truth = measure_body_and_arms({mesh.positions, mesh.triangles}, {});
  add(stack_rings({{0.9, 0.2, 0.15, 0}, {1.72, 0.12, 0.14, 0}}), sim::Vec3(0.0), mesh);
  for (const double side : {-1.0, 1.0}) {
    add(stack_rings({{-0.02, 0.08, 0.15, 0.04}, {0.12, 0.07, 0.1, 0}}), {0.13 * side, 0.0, 0.0}, mesh);
  }
  expect_girths(mesh, truth, "with hair");
}

struct Published {
  const char* name;
  double neck, chest, waist, seat, biceps;
};

// The published girths of the mannequins are at published heights. A tape that searches for the fullest and the
// narrowest level finds levels near those.
TEST(BodyGirths, OfTheMannequinsAreNearThePublishedOnes) {
  for (const Published& p : {Published{"male_40", 0.400, 1.053, 0.846, 1.052, 0.368},
                             Published{"female_34", 0.340, 0.925, 0.750, 1.010, 0.270},
                             Published{"female_42", 0.420, 1.143, 0.900, 1.153, 0.334}}) {
    BodySource source;
    source.file = std::string(TAUT_ASSETS_FOLDER) + "/bodies/mannequin_" + p.name + ".glb";
    const Json body = inspect_body(source);
    ASSERT_EQ(body["girths"].size(), 9U) << p.name;
    const auto share = [&](std::size_t k, double published) {
      return body["girths"][k]["girth_m"].get<double>() / published - 1.0;
    };
    EXPECT_NEAR(share(0, p.neck), 0.0, 0.013) << p.name;
    EXPECT_NEAR(share(2, p.chest), 0.0, 0.026) << p.name << ", at the fullest level towards the front";
    EXPECT_NEAR(share(3, p.waist), -0.01, 0.012) << p.name << ", the narrowest level is above the published one";
    EXPECT_NEAR(share(4, p.seat), 0.03, 0.03) << p.name << ", the fullest level is above the published one";
    EXPECT_NEAR(share(8, p.biceps), 0.0, 0.001) << p.name;
    EXPECT_EQ(body["girths"][2]["name"], "chest");
  }
}

}  // namespace
}  // namespace taut::app
