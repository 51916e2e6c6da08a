// Every committed motion on every committed mannequin: checks the moving surface that cloth would meet.

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <tuple>

#include "app/verify/crossing_pairs.hpp"
#include "mannequin/motion_file.hpp"

namespace taut::test {
namespace {

using sim::Vec3;

const std::filesystem::path assets = TAUT_ASSETS_DIR;
constexpr std::size_t blend_frames = 15;

struct Crossings {
  std::size_t worst = 0;  ///< crossing pairs in the worst frame
  std::size_t worst_frame = 0;
  std::map<std::string, int> places;  ///< crossing pairs in the worst frame, by the joints of both triangles
};

class Moving : public testing::TestWithParam<std::tuple<const char*, const char*>> {
 protected:
  Moving()
      : motion(read_motion(assets / "motions" / (std::string(std::get<0>(GetParam())) + ".bvh"))),
        body(read_body(assets / "bodies" / (std::string("mannequin_") + std::get<1>(GetParam()) + ".glb"))) {}

  /// The joint that the triangle's first corner follows most.
  std::string joint_of(sim::Index triangle) const {
    const sim::Index v = body.mesh.triangles[triangle][0];
    const auto& weights = body.weights[v];
    return body.names[body.joints[v][static_cast<std::size_t>(std::max_element(weights.begin(), weights.end()) -
                                                              weights.begin())]];
  }

  Crossings count_crossings() const {
    Crossings result;
    for (std::size_t frame = 0; frame < motion.frames.size(); ++frame) {
      const auto positions = pose_body(body, motion, frame);
      const auto pairs = app::crossing_pairs({positions, body.mesh.triangles});
      if (pairs.size() > result.worst) {
        result.worst = pairs.size();
        result.worst_frame = frame;
        result.places.clear();
        for (const sim::CrossingPair& pair : pairs) {
          ++result.places[joint_of(pair.first) + " with " + joint_of(pair.second)];
        }
      }
    }
    return result;
  }

  MotionFile motion;
  BodyFile body;
};

TEST_P(Moving, BeginsInThePoseAsStored) {
  const auto first = pose_body(body, motion, 0);
  for (std::size_t v = 0; v < first.size(); ++v) {
    ASSERT_LT(glm::length(first[v] - body.mesh.positions[v]), 1e-6) << "vertex " << v;
  }
}

TEST_P(Moving, EndsWhereItsRepetitionBegan) {
  const auto begin = pose_body(body, motion, blend_frames);
  const auto end = pose_body(body, motion, motion.frames.size() - 1);
  for (std::size_t v = 0; v < begin.size(); ++v) {
    ASSERT_LT(glm::length(begin[v] - end[v]), 1e-4) << "vertex " << v;
  }
}

TEST_P(Moving, TakesTwoToSixSecondsAtThirtyFramesASecond) {
  EXPECT_NEAR(motion.frame_time_s, 1.0 / 30.0, 1e-6);
  const double seconds = motion.frame_time_s * static_cast<double>(motion.frames.size() - 1);
  EXPECT_GE(seconds, 2.0);
  EXPECT_LE(seconds, 6.0);
}

/// Limits for body parts under a shirt. People move these at 1.4 m/s at most, while they raise their arms.
TEST_P(Moving, MovesWhatIsUnderAShirtAtHumanSpeed) {
  const std::string name = std::get<0>(GetParam());
  const double most_m_per_s = name == "walk" || name == "stand" ? 1.0 : 1.4;
  double fastest = 0.0;
  auto before = pose_body(body, motion, 0);
  for (std::size_t frame = 1; frame < motion.frames.size(); ++frame) {
    const auto now = pose_body(body, motion, frame);
    for (std::size_t v = 0; v < now.size(); ++v) {
      const std::string& joint = body.names[body.joints[v][0]];
      const bool covered = joint.starts_with("Spine") || joint == "Hips" || joint.ends_with("Shoulder") ||
                           joint == "LeftArm" || joint == "RightArm";
      fastest = covered ? std::max(fastest, glm::length(now[v] - before[v]) / motion.frame_time_s) : fastest;
    }
    before = now;
  }
  RecordProperty("fastest_mm_per_s", static_cast<int>(1e3 * fastest));
  EXPECT_LT(fastest, most_m_per_s);
  EXPECT_GT(fastest, 0.005) << "nothing moves";
}

TEST_P(Moving, CrossesItselfNowhere) {
  const Crossings crossings = count_crossings();
  std::string where;
  for (const auto& [joints, count] : crossings.places) {
    where += "\n  " + std::to_string(count) + " of " + joints;
  }
  EXPECT_EQ(crossings.worst, 0U) << "in frame " << crossings.worst_frame << where;
}

INSTANTIATE_TEST_SUITE_P(Motions, Moving,
                         testing::Combine(testing::Values("stand", "walk", "raise_arms", "reach", "twist", "sit"),
                                          testing::Values("male_40", "female_34", "female_42")),
                         [](const auto& both) {
                           return std::string(std::get<0>(both.param)) + "_" + std::get<1>(both.param);
                         });

TEST(Motions, HaveTheSkeletonOfTheMan) {
  const BodyFile body = read_body(assets / "bodies/mannequin_male_40.glb");
  const MotionFile motion = read_motion(assets / "motions/walk.bvh");
  ASSERT_EQ(motion.offsets_m.size(), body.names.size());
  EXPECT_LT(glm::length(motion.frames.front().root_m - body.places[0]), 1e-5);
  for (std::size_t j = 1; j < body.names.size(); ++j) {
    const Vec3 from_parent = body.places[j] - body.places[static_cast<std::size_t>(body.parents[j])];
    EXPECT_LT(glm::length(motion.offsets_m.at(body.names[j]) - from_parent), 2e-6) << body.names[j];
  }
}

}  // namespace
}  // namespace taut::test
