#include <gtest/gtest.h>

#include "app/bodies/rig_pose.hpp"

namespace taut::app {
namespace {

using Names = std::vector<std::string>;

TEST(JointNames, OfOtherProgramsMeanTheSameParts) {
  EXPECT_EQ(parts_of_joints(Names{"Hips", "Spine", "Spine1", "LeftUpLeg", "RightForeArm", "LeftToeBase", "Head"}),
            (Names{"hips", "spine", "spine1", "left upleg", "right forearm", "left toebase", "head"}));
  EXPECT_EQ(parts_of_joints(Names{"mixamorig:Hips", "mixamorig1:LeftLeg", "mixamorigRightArm"}),
            (Names{"hips", "left leg", "right arm"}));
  EXPECT_EQ(parts_of_joints(Names{"hip", "abdomen", "lThigh", "RShin", "lShldr", "lCollar", "rForeArm"}),
            (Names{"hips", "spine", "left upleg", "right leg", "left arm", "left shoulder", "right forearm"}));
  EXPECT_EQ(parts_of_joints(Names{"pelvis", "thigh_l", "calf.R", "upperarm_l", "Bip01 L UpperArm", "spine_02"}),
            (Names{"hips", "left upleg", "right leg", "left arm", "left arm", "spine1"}));
  EXPECT_EQ(parts_of_joints(Names{"Armature_mixamorig_Hips", "Armature_mixamorig_LeftForeArm", "Armature_spine"}),
            (Names{"hips", "left forearm", "spine"}))
      << "as Blender writes them to Collada";
  EXPECT_EQ(parts_of_joints(Names{"HIPS", "leftupleg", "LEFT_FOOT"}), (Names{"hips", "left upleg", "left foot"}));
}

TEST(JointNames, AShoulderIsTheArmOfASkeletonWithElbows) {
  EXPECT_EQ(parts_of_joints(Names{"LeftCollar", "LeftShoulder", "LeftElbow", "LeftHip", "LeftKnee"}),
            (Names{"left shoulder", "left arm", "left forearm", "left upleg", "left leg"}));
  EXPECT_EQ(parts_of_joints(Names{"LeftShoulder", "LeftArm"}), (Names{"left shoulder", "left arm"}));
}

TEST(JointNames, OthersAreComparedWithoutCaseAndSeparators) {
  EXPECT_EQ(parts_of_joints(Names{"LeftHandIndex1", "left_hand_index1", "Tail", ""}),
            (Names{"left handindex1", "left handindex1", "tail", ""}));
}

TEST(JointNames, TrunkArmsAndLegsShow) {
  EXPECT_TRUE(is_main_part("hips"));
  EXPECT_TRUE(is_main_part("left forearm"));
  EXPECT_FALSE(is_main_part("left handindex1"));
  EXPECT_FALSE(is_main_part("tail"));
}

}  // namespace
}  // namespace taut::app
