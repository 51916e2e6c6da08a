#include <gtest/gtest.h>

#include <stdexcept>

#include "app/models/reading/model_arrays.hpp"

namespace taut::app {
namespace {

/// A model with one element of every kind.
ModelArrays small_model() {
  ModelArrays model;
  model.positions = {{1, 2, 3}, {4, 5, 6}};
  model.format = "test";
  Rig& rig = model.rig;
  rig.nodes = {{"root", no_node, glm::dmat4(1.0)}, {"joint", 0, glm::dmat4(2.0)}};
  rig.parts = {{1, "skin", 0, 2, true}};
  rig.in_part = model.positions;
  rig.bones = {{1, glm::dmat4(3.0)}};
  rig.influences = {{0, 0, 1.0}, {1, 0, 0.5}};
  rig.targets = {{0, 0.25, {{0, 0, 1}, {0, 1, 0}}}};
  const RigKeys keys = {{0.0, 1.0}, {{1, 0, 0, 0}, {0, 1, 0, 0}}};
  rig.clips = {{"Walk", 1.5, {{1, keys, {}, keys}}, {{0, keys}}, {"tail"}}};
  return model;
}

TEST(RigCoding, ComesBackAsItWas) {
  const ModelArrays model = small_model();
  const std::string bytes = encode(model);
  const ModelArrays again = decode(bytes);
  EXPECT_EQ(encode(again), bytes);
  EXPECT_EQ(again.rig.nodes[1].name, "joint");
  EXPECT_EQ(again.rig.nodes[1].to_parent, glm::dmat4(2.0));
  EXPECT_EQ(again.rig.clips[0].channels[0].scales.values[1], glm::dvec4(0, 1, 0, 0));
  EXPECT_EQ(again.rig.clips[0].unknown, std::vector<std::string>{"tail"});
}

TEST(RigCoding, BytesThatAreCutOffAreRefused) {
  const std::string bytes = encode(small_model());
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    EXPECT_THROW(decode(bytes.substr(0, length)), std::runtime_error) << length;
  }
}

TEST(RigCoding, IndicesThatMeanNothingAreRefused) {
  const auto is_refused = [](const auto& damage) {
    ModelArrays model = small_model();
    damage(model.rig);
    EXPECT_THROW(decode(encode(model)), std::runtime_error);
  };
  is_refused([](Rig& rig) { rig.nodes[1].parent = 1; });
  is_refused([](Rig& rig) { rig.parts[0].node = 2; });
  is_refused([](Rig& rig) { rig.parts[0].vertices = 3; });
  is_refused([](Rig& rig) { rig.in_part.pop_back(); });
  is_refused([](Rig& rig) { rig.bones[0].node = 2; });
  is_refused([](Rig& rig) { rig.influences[0].bone = 1; });
  is_refused([](Rig& rig) { rig.influences[1].vertex = 2; });
  is_refused([](Rig& rig) { rig.targets[0].part = 1; });
  is_refused([](Rig& rig) { rig.targets[0].offsets.pop_back(); });
  is_refused([](Rig& rig) { rig.clips[0].channels[0].node = 2; });
  is_refused([](Rig& rig) { rig.clips[0].targets[0].target = 1; });
  is_refused([](Rig& rig) { rig.clips[0].channels[0].positions.times_s.pop_back(); });
}

}  // namespace
}  // namespace taut::app
