// Pins and bodies that close in on cloth until no frame without a crossing exists.

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "app/verify/crossing_pairs.hpp"
#include "scenes.hpp"

namespace taut::sim {
namespace {

constexpr double speed_m_per_s = 0.2;

Body ball_at(const char* name, double z_m) {
  const double towards = z_m > 0.0 ? -speed_m_per_s : speed_m_per_s;
  return {
      .name = name, .shape = Sphere{{0.002, 0.003, z_m}, 0.08}, .motion = {.shift = {{0.0, 0.0, towards}, 0.05, 1.0}}};
}

/// A sheet that hangs by its upper edge between two balls that close in on it.
ContactScene sheet_between_balls() {
  ContactScene scene = {.mesh = make_mesh({13, 13, 0.3, 0.3, GridPlane::vertical, {0.0, 0.15, 0.0}})};
  scene.bounded.max_stretch = 0.05;
  for (Index v = 0; v < 13; ++v) {
    scene.pins.push_back(v);
  }
  scene.surroundings.bodies = {ball_at("left", -0.12), ball_at("right", 0.12)};
  return scene;
}

/// A level sheet whose corner is pulled down through the body below it.
ContactScene sheet_led_into(const Shape& shape) {
  ContactScene scene = {.mesh = make_mesh({.at_m = {0.0, 0.12, 0.0}}), .pins = {0, 40, 80}};
  scene.surroundings.bodies = {{.name = "below", .shape = shape}};
  scene.surroundings.moving_pins = {{{40}, {.shift = {{0.0, -speed_m_per_s, 0.0}, 0.0, 1.0}}}};
  scene.bounded.max_stretch = 0.05;
  scene.bounded.allow_exceeding = true;
  return scene;
}

/// Returns the error that ends the run within a second; `before` is the state of its last frame.
std::optional<ContactBlocked> blocked_in(Simulation& simulation, State& before) {
  for (int frame = 0; frame < 60; ++frame) {
    before = simulation.state();
    try {
      simulation.advance_frame();
    } catch (const ContactBlocked& error) {
      return error;
    }
  }
  return std::nullopt;
}

TEST(Blocked, BallsThatCloseInOnASheetStopItAsItWas) {
  for (const bool within_cloth : {false, true}) {
    ContactScene scene = sheet_between_balls();
    scene.bounded.contact = within_cloth;
    Simulation simulation = begin(std::move(scene));
    State before;
    const std::optional<ContactBlocked> error = blocked_in(simulation, before);
    ASSERT_TRUE(error);
    EXPECT_EQ(hash(simulation.state()), hash(before));
    EXPECT_EQ(simulation.state().time_s, before.time_s);
    // The balls leave no room for the cloth's thickness 0.2 s after they began to move.
    EXPECT_NEAR(error->time_s(), 0.25, 1.5 / 60.0);
    EXPECT_NEAR(error->time_s() - before.time_s, 1.0 / 60.0, 1e-12);
    const BlockedContact& blocked = error->blocked();
    EXPECT_EQ(blocked.sides[0].vertices.size(), 3U);
    EXPECT_FALSE(blocked.sides[0].body);
    ASSERT_TRUE(blocked.sides[1].body && blocked.behind && blocked.behind->body);
    EXPECT_EQ(*blocked.sides[1].body + *blocked.behind->body, 1U) << "one and the other";
    EXPECT_GT(blocked.distance_m, 0.0);
    EXPECT_LT(blocked.distance_m, speed_m_per_s / 60.0 + 1e-3);
    EXPECT_LT(glm::distance(blocked.place_m, {0.002, 0.003, 0.0}), 0.03);
    for (const Index v : blocked.sides[0].vertices) {
      EXPECT_LT(glm::distance(before.current[v], blocked.place_m), 0.04) << "of the triangle that is there";
    }
    const std::string closing = *blocked.sides[1].body == 0 ? "left" : "right";
    EXPECT_EQ(closing, blocked.place_m.z < 0.0 ? "left" : "right") << "which is on that side";
    const std::string behind = *blocked.sides[1].body == 0 ? "right" : "left";
    EXPECT_NE(std::string(error->what()).find("the body '" + closing + "' closes in on the triangle of the vertices "),
              std::string::npos)
        << error->what();
    EXPECT_NE(std::string(error->what()).find("which the body '" + behind + "' keeps from giving way; they are "),
              std::string::npos)
        << error->what();
  }
}

TEST(Blocked, TheSceneMayAcceptIt) {
  ContactScene scene = sheet_between_balls();
  scene.bounded.allow_crossing = true;
  Simulation simulation = begin(std::move(scene));
  int blocked = 0;
  for (int frame = 0; frame < 30; ++frame) {
    simulation.advance_frame();
    blocked += simulation.frame_report().blocked ? 1 : 0;
  }
  EXPECT_GT(blocked, 0);
  EXPECT_NEAR(simulation.state().time_s, 0.5, 1e-12);
}

TEST(Blocked, NamesThePinThatIsLedIntoABody) {
  for (const Shape& shape : {Shape(Sphere{{0.0, 0.0, 0.0}, 0.1}), Shape(Plane{{0.0, 0.1, 0.0}, {0.0, 1.0, 0.0}}),
                             Shape(Capsule{{-0.1, 0.0, 0.0}, {0.1, 0.0, 0.0}, 0.1, 0.1}), Shape(box())}) {
    Simulation simulation = begin(sheet_led_into(shape));
    State before;
    const std::optional<ContactBlocked> error = blocked_in(simulation, before);
    ASSERT_TRUE(error) << shape.index();
    const std::string text = error->what();
    EXPECT_NE(text.find("'below'"), std::string::npos) << text;
    EXPECT_NE(text.find("pinned"), std::string::npos) << text;
    EXPECT_NE(text.find("40"), std::string::npos) << text;
    EXPECT_NEAR(error->blocked().place_m.y, 0.1, 0.005) << text;
    EXPECT_EQ(hash(simulation.state()), hash(before));
  }
}

TEST(Blocked, AHandThatPullsIntoABodyOnlyPullsHarder) {
  ContactScene scene = {.mesh = make_mesh({13, 13, 0.4, 0.4, GridPlane::horizontal, {0.003, 0.11, 0.002}})};
  scene.surroundings.bodies = {{.name = "ball", .shape = Sphere{{0.0, 0.0, 0.0}, 0.1}},
                               {.name = "wall", .shape = box(), .motion = {.path = {{0.0, {0.0, 0.4, 0.0}}}}}};
  // The hand is in the middle of the ball and then in the middle of the box above.
  Simulation simulation = begin(scene);
  for (int frame = 1; frame <= 40; ++frame) {
    Surroundings pulled = scene.surroundings;
    const Vec3 hand_m = frame <= 20 ? Vec3(0.0) : Vec3(0.0, 0.4, 0.0);
    pulled.forces.grabbed_vertices = {{84, hand_m, 500.0, 5.0}, {85, hand_m, 500.0, 5.0}};
    simulation.set_surroundings(pulled);
    ASSERT_NO_THROW(simulation.advance_frame()) << "frame " << frame;
    ASSERT_FALSE(simulation.frame_report().blocked) << "frame " << frame;
    const Surface cloth = {simulation.state().current, simulation.garment().mesh.triangles};
    ASSERT_TRUE(app::crossing_pairs(cloth).empty()) << "frame " << frame;
    for (const Vec3& p : cloth.positions_m) {
      ASSERT_GT(glm::length(p), 0.1) << "frame " << frame;
    }
  }
  EXPECT_GT(simulation.state().current[84].y, 0.15) << "it was not pulled at all";
}

}  // namespace
}  // namespace taut::sim
