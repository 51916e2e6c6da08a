// Keys of bodies and pins that move.

#include <gtest/gtest.h>

#include "app/base/errors.hpp"
#include "app/drawing/drawn_scene.hpp"
#include "temporary_folder.hpp"

namespace taut::app {
namespace {

using test::error_message;

const std::string grid = "[garment.grid]\ncolumns = 5\nrows = 5\n";

DrawnScene read(const std::string& rest) { return read_scene_text(grid + rest, "scene.toml"); }

std::string error_text(const std::string& rest) {
  return error_message<InputError>([&] { read(rest); });
}

const std::string moving = R"(
[pins]
at = "none"
[[pins.moving]]
at = ["top-left", 7]
shift = { velocity = [1, 0, 0.5], from = 0.25 }
[[pins.moving]]
at = "bottom-edge"
spin = { turns_per_second = -0.5, axis = [0, 0, 3], about = [0, 0.1, 0], until = 2 }
[[bodies]]
shape = "sphere"
name = "ball"
path = [[0, 0, 0, 0], [1.5, 0.1, 0.2, 0.3]]
[[bodies]]
shape = "mesh"
file = "avatar.obj"
scale = 0.01
up = "z"
motion = "walk.pc2"
frame_rate = 25
friction = 0
shift = { velocity = [0, 1, 0], until = 3 }
)";

TEST(MovingKeys, AreReadForBodiesAndPinsAlike) {
  const DrawnScene scene = read(moving);
  ASSERT_EQ(scene.moving_pins.size(), 2U);
  EXPECT_EQ(std::get<sim::Index>(scene.moving_pins[0].at.at(1)), 7U);
  EXPECT_EQ(scene.moving_pins[0].motion, (sim::RigidMotion{.shift = {{1, 0, 0.5}, 0.25}}));
  EXPECT_EQ(std::get<std::string>(scene.moving_pins[1].at.at(0)), "bottom-edge");
  EXPECT_EQ(scene.moving_pins[1].motion, (sim::RigidMotion{.spin = {{0, 0.1, 0}, {0, 0, 1}, -0.5, 0.0, 2.0}}));
  const std::vector<sim::Body> bodies = named_bodies(scene);
  ASSERT_EQ(bodies.size(), 2U);
  EXPECT_EQ(bodies[0].name, "ball");
  EXPECT_EQ(bodies[0].motion, (sim::RigidMotion{.path = {{0, {0, 0, 0}}, {1.5, {0.1, 0.2, 0.3}}}}));
  EXPECT_EQ(bodies[1].motion, (sim::RigidMotion{.shift = {{0, 1, 0}, 0, 3}}));
  EXPECT_EQ(bodies[1].friction, 0.0);
  const BodySource& source = scene.bodies.at(1).source;
  EXPECT_EQ(source.file, "avatar.obj");
  EXPECT_EQ(source.scale, 0.01);
  EXPECT_EQ(source.up, ModelAxis::z);
  EXPECT_EQ(source.motion, "walk.pc2");
  EXPECT_EQ(source.frame_rate_hz, 25.0);
}

TEST(MovingKeys, AreWrittenAsTheyWereRead) {
  const std::string text =
      scene_text(read(moving + "[[pins.moving]]\nat = [3]\nspin = { turns_per_second = 1, axis = [1, 2, 3] }\n"));
  const DrawnScene again = read_scene_text(text, "again.toml");
  EXPECT_EQ(scene_text(again), text);
  const DrawnScene first = read(moving);
  EXPECT_EQ(again.bodies[0].body.motion, first.bodies[0].body.motion);
  EXPECT_EQ(again.bodies[1].body.motion, first.bodies[1].body.motion);
  EXPECT_EQ(again.moving_pins[1].motion, first.moving_pins[1].motion);
  EXPECT_EQ(again.bodies[1].source.file, std::filesystem::absolute("avatar.obj"));
  EXPECT_EQ(again.bodies[1].source.frame_rate_hz, 25.0);
}

TEST(MovingKeys, OfOneBodyAreSetOnTheCommandLine) {
  const std::vector<Override> options = {
      {"body.file", "doll.glb", "--body doll.glb"}, {"body.motion", "run.bvh", "--body-motion run.bvh"},
      {"body.clip", "Run", "--body-clip Run"},      {"body.scale", "0.01", "--body-units cm"},
      {"body.dress", "90", "--dress 90"},           {"body.loop", "true", "--body-loop"}};
  const DrawnScene scene = read_scene_text(grid + moving, "scene.toml", options);
  ASSERT_EQ(scene.bodies.size(), 3U);
  EXPECT_TRUE(std::holds_alternative<sim::BodyMesh>(scene.bodies[2].body.shape));
  EXPECT_EQ(scene.bodies.at(1).source.motion, "walk.pc2") << "as it was";
  const BodySource& source = scene.bodies.at(2).source;
  EXPECT_EQ(scene.bodies[2].body.name, "doll");
  EXPECT_EQ(source.file, "doll.glb");
  EXPECT_EQ(source.motion, "run.bvh");
  EXPECT_EQ(source.clip, "Run");
  EXPECT_EQ(source.scale, 0.01);
  EXPECT_EQ(source.dress, 90);
  EXPECT_EQ(scene.dressing_frames(), 90);
  const DrawnScene again = read_scene_text(scene_text(scene), "again.toml");
  EXPECT_EQ(again.bodies.at(2).source.clip, "Run");
  EXPECT_EQ(again.bodies.at(2).source.dress, 90);
  EXPECT_TRUE(again.bodies.at(2).source.loop);
  EXPECT_FALSE(again.bodies.at(1).source.loop) << "unless it is asked for";
}

TEST(MovingKeys, OfOneBodyNeedABody) {
  const auto error_with = [](const std::string& text, const Override& option) {
    return error_message<UsageError>([&] { read_scene_text(grid + text, "scene.toml", std::vector{option}); });
  };
  EXPECT_CONTAINS(error_with("", {"body.motion", "run.bvh", "--body-motion run.bvh"}),
                  "--body-motion run.bvh: body.motion: the scene has no body that is a model");
  EXPECT_CONTAINS(error_with(moving, {"body.frame_rate", "-1", "--body-fps -1"}), "found -1, expected a number from 0");
  EXPECT_CONTAINS(error_with(moving, {"body.clips", "Run", "--set body.clips=Run"}),
                  "unknown key 'clips'; did you mean 'clip'");
}

TEST(MovingKeys, TakeDirectionsOfAnyLength) {
  for (const char* axis : {"[0, 1e-150, 0]", "[0, 5e-324, 0]", "[0, 1e6, 0]"}) {
    const DrawnScene scene = read(std::string("[[bodies]]\nshape = \"plane\"\nnormal = ") + axis +
                                  "\nspin = { turns_per_second = 1, axis = " + axis + " }\n");
    EXPECT_EQ(scene.bodies[0].body.motion.spin.axis, sim::Vec3(0, 1, 0)) << axis;
    EXPECT_EQ(std::get<sim::Plane>(scene.bodies[0].body.shape).normal, sim::Vec3(0, 1, 0)) << axis;
  }
}

TEST(MovingKeys, AreExplained) {
  const std::string help = scene_help();
  EXPECT_CONTAINS(help, "Each [[pins.moving]]:\n  at = not set");
  EXPECT_CONTAINS(help, "spin.turns_per_second = not set");
  EXPECT_CONTAINS(help, "Each [[bodies]] with shape = \"mesh\" also:\n  file = not set");
}

TEST(MovingKeys, SayWhatIsWrong) {
  const std::string ball = "[[bodies]]\nshape = \"sphere\"\n";
  EXPECT_CONTAINS(error_text("[[colliders]]\nshape = \"plane\"\n"), "scene.toml:4: unknown key 'colliders'");
  EXPECT_CONTAINS(error_text("[[colliders]]\nshape = \"plane\"\n"), "bodies");
  EXPECT_CONTAINS(error_text(ball + "shift = { speed = 3 }\n"), ":6: unknown key 'shift.speed'");
  EXPECT_CONTAINS(error_text(ball + "shift = { velocity = 3 }\n"), ":6: shift.velocity: found 3, expected three");
  EXPECT_CONTAINS(error_text(ball + "shift = { velocity = [1, 0, 0], from = 2, until = 1 }\n"),
                  "shift.until: found 1 s, expected a time after shift.from, 2 s");
  EXPECT_CONTAINS(error_text(ball + "spin = { from = 2, until = 2 }\n"), "a time after spin.from, 2 s");
  EXPECT_CONTAINS(error_text(ball + "spin = { axis = [0, 0, 0] }\n"), "spin.axis: found [0, 0, 0]");
  for (const char* path : {"3", "[]", "[[0, 1, 2]]", "[[1, 0, 0, 0], [1, 0, 0, 0]]", "[[0, 0, 0, nan]]"}) {
    EXPECT_CONTAINS(error_text(ball + "path = " + path + '\n'), "expected a list of [time, x, y, z], the times rising")
        << path;
  }
  EXPECT_CONTAINS(error_text("[[bodies]]\nshape = \"mesh\"\n"), ":4: a body of shape \"mesh\" has no file");
  EXPECT_CONTAINS(error_text(ball + "file = \"a.obj\"\n"), ":6: unknown key 'file'");
  EXPECT_CONTAINS(error_text("[[pins.moving]]\nspin = { turns_per_second = 1 }\n"),
                  ":4: an entry of pins.moving has no");
  EXPECT_CONTAINS(error_text("[pins]\nmoving = 3\n"), "pins.moving: found 3, expected a list of tables");
}

TEST(AllowExceeding, SaysForWhichPromise) {
  const auto allowed = [](const std::string& value) {
    const DrawnScene scene = read("[solver]\nallow_exceeding = " + value + '\n');
    const sim::BoundedSettings& bounded = scene.simulation.solver.bounded;
    const DrawnScene again = read_scene_text(scene_text(scene), "again.toml");
    EXPECT_EQ(again.simulation.solver, scene.simulation.solver) << value;
    EXPECT_CONTAINS(scene_text(scene), "allow_exceeding = " + value + '\n');
    return std::pair(bounded.allow_exceeding, bounded.allow_crossing);
  };
  EXPECT_EQ(allowed("false"), std::pair(false, false));
  EXPECT_EQ(allowed("true"), std::pair(true, true));
  EXPECT_EQ(allowed("\"bound\""), std::pair(true, false));
  EXPECT_EQ(allowed("\"contact\""), std::pair(false, true));
  for (const std::string wrong : {"\"both\"", "1", "[\"bound\"]", "\"true\""}) {
    const std::string text = error_text("[solver]\nallow_exceeding = " + wrong + '\n');
    EXPECT_CONTAINS(text, "solver.allow_exceeding: found ");
    EXPECT_CONTAINS(text, "expected true or false or \"bound\" or \"contact\"");
  }
}

}  // namespace
}  // namespace taut::app
