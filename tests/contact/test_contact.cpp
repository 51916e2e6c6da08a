#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "app/verify/crossing_pairs.hpp"
#include "app/verify/stretch.hpp"
#include "scenes.hpp"
#include "sim/bytes.hpp"

namespace taut::sim {
namespace {

std::size_t crossings(const Simulation& simulation) {
  return app::crossing_pairs({simulation.state().current, simulation.garment().mesh.triangles}).size();
}

/// A band that stands on the ground and folds over itself many times as it falls.
ContactScene falling_band() {
  ContactScene scene = {.mesh = make_mesh({5, 61, 0.08, 1.2, GridPlane::vertical, {0.003, 1.203, 0.001}})};
  for (std::size_t v = 0; v < scene.mesh.positions.size(); ++v) {
    Vec3& p = scene.mesh.positions[v];
    p.z += 0.004 * std::sin(37.0 * p.y + 3.0 * p.x);
  }
  scene.surroundings.bodies = {{.name = "ground", .shape = Plane{}}};
  return scene;
}

TEST(Contact, ABandThatFallsOnItselfCrossesNothing) {
  Simulation simulation = begin(falling_band());
  for (int frame = 1; frame <= 90; ++frame) {
    simulation.advance_frame();
    ASSERT_EQ(crossings(simulation), 0U) << "frame " << frame;
    ASSERT_TRUE(simulation.frame_report().bound_kept) << "frame " << frame;
    for (const Vec3& p : simulation.state().current) {
      ASSERT_GT(p.y, 0.0) << "frame " << frame;
    }
  }
}

// Pins are not projected into regions; instead, regions end before pins have left a straight path.
TEST(Contact, SheetsOnPinsThatSwingFastCrossNothing) {
  ContactScene scene = {
      .mesh =
          both(make_mesh({.columns = 13, .rows = 13, .plane = GridPlane::vertical}),
               make_mesh({.columns = 13, .rows = 13, .plane = GridPlane::vertical, .at_m = {0.011, 0.007, 0.004}}))};
  scene.pins = {0, 12, 169, 181};
  scene.surroundings.pin_motion = {.amplitude_m = {0.1, 0.1, 0.2}, .frequency_hz = 3.0};
  scene.bounded.max_stretch = 0.05;
  Simulation simulation = begin(std::move(scene));
  for (int frame = 1; frame <= 90; ++frame) {
    simulation.advance_frame();
    ASSERT_EQ(crossings(simulation), 0U) << "frame " << frame;
  }
}

TEST(Contact, AFrameReportsItsSearchesAndTheDistanceThatItBeganWith) {
  ContactScene scene = {.mesh = make_mesh({.at_m = {0.0, 7e-4, 0.0}})};
  for (Index v = 0; v < scene.mesh.positions.size(); ++v) {
    scene.pins.push_back(v);
  }
  scene.surroundings.bodies = {{.name = "ground", .shape = Plane{}}};
  Simulation simulation = begin(scene);
  EXPECT_EQ(simulation.frame_report().contact, ContactReport{});
  simulation.advance_frame();
  const ContactReport report = simulation.frame_report().contact;
  EXPECT_GE(report.detections, 1);
  EXPECT_EQ(report.max_pairs, 81) << "every vertex";
  EXPECT_NEAR(report.min_distance_m, 7e-4, 1e-8);

  scene.surroundings.bodies.clear();
  Simulation apart = begin(scene);
  apart.advance_frame();
  EXPECT_GE(apart.frame_report().contact.detections, 1) << "for what is near within the cloth";
  EXPECT_GT(apart.frame_report().contact.min_distance_m, 7e-4);
  scene.bounded.contact = false;
  Simulation off = begin(scene);
  off.advance_frame();
  EXPECT_EQ(off.frame_report().contact, ContactReport{});
}

TEST(Contact, WithoutItTheSameBandCrossesItself) {
  ContactScene scene = falling_band();
  scene.bounded.contact = false;
  scene.pins = {2};
  scene.surroundings.forces.wind = {.speed_m_per_s = 8.0, .direction = {0.0, 0.0, 1.0}};
  Simulation simulation = begin(std::move(scene));
  std::size_t most = 0;
  for (int frame = 1; frame <= 60; ++frame) {
    simulation.advance_frame();
    most = std::max(most, crossings(simulation));
  }
  EXPECT_GT(most, 0U);
}

TEST(Contact, VectorUnitsAndThreadsChangeNothing) {
  std::optional<std::uint64_t> expected;
  for (const VectorUnit unit : available_vector_units()) {
    for (const int threads : {1, 3}) {
      ContactScene scene = falling_band();
      scene.bounded.vector_unit = unit;
      scene.bounded.threads = threads;
      Simulation simulation = begin(std::move(scene));
      for (int frame = 0; frame < 25; ++frame) {
        simulation.advance_frame();
      }
      expected = expected.value_or(hash(simulation.state()));
      EXPECT_EQ(hash(simulation.state()), *expected) << to_name(unit) << ", threads: " << threads;
    }
  }
}

TEST(Contact, GoesOnFromACheckpointWithTheSameBits) {
  Simulation simulation = begin(falling_band());
  for (int frame = 0; frame < 20; ++frame) {
    simulation.advance_frame();
  }
  Simulation restored = begin(falling_band());
  restored.restore(simulation.save());
  for (int frame = 0; frame < 10; ++frame) {
    simulation.advance_frame();
    restored.advance_frame();
  }
  EXPECT_EQ(hash(simulation.state()), hash(restored.state()));
}

TEST(Contact, LayersComeToRestAThicknessApart) {
  ContactScene scene = {
      .mesh =
          both(make_mesh({.at_m = {0.0, 0.003, 0.0}}),
               make_mesh({.columns = 8, .rows = 8, .width_m = 0.3, .length_m = 0.3, .at_m = {0.01, 0.006, 0.003}}))};
  scene.surroundings.bodies = {{.name = "ground", .shape = Plane{}}};
  const double thickness_m = scene.material.thickness_m;
  Simulation simulation = begin(std::move(scene));
  for (int frame = 0; frame < 90; ++frame) {
    simulation.advance_frame();
  }
  double lower_m = 0.0;
  double upper_m = 0.0;
  for (std::size_t v = 0; v < simulation.state().current.size(); ++v) {
    const double expected_m = v < 81 ? thickness_m : 2.0 * thickness_m;
    EXPECT_NEAR(simulation.state().current[v].y, expected_m, 0.6 * thickness_m) << v;
    (v < 81 ? lower_m : upper_m) += simulation.state().current[v].y / (v < 81 ? 81 : 64);
  }
  EXPECT_NEAR(lower_m, thickness_m, 0.1 * thickness_m);
  EXPECT_NEAR(upper_m, 2.0 * thickness_m, 0.1 * thickness_m);
}

/// Returns the mean speed upwards, in m/s, of `count` vertices from `first` on.
double mean_speed_upwards(const Simulation& simulation, Index first, Index count) {
  double sum = 0.0;
  for (Index v = first; v < first + count; ++v) {
    sum += velocity(simulation.state(), v).y;
  }
  return sum / count;
}

TEST(Contact, ACollisionKeepsMomentumAndDoesNotRebound) {
  ContactScene scene = {.mesh =
                            both(make_mesh({.at_m = {0.0, 0.0, 0.0}}), make_mesh({.at_m = {0.011, 0.0044, 0.007}}))};
  scene.surroundings.forces.gravity_m_per_s2 = Vec3(0.0);
  scene.surroundings.forces.air_drag_per_s = 0.0;
  Simulation simulation = begin(std::move(scene));
  simulation.advance_frame();
  Checkpoint moving = simulation.save();
  for (std::size_t v = 81; v < 162; ++v) {
    moving.state.previous[v].y += moving.state.time_step_s * 0.15;
  }
  simulation.restore(moving);
  simulation.advance_frame();
  const double before = mean_speed_upwards(simulation, 81, 81);
  ASSERT_LT(before, -0.1);
  ASSERT_EQ(mean_speed_upwards(simulation, 0, 81), 0.0) << "they have met already";
  while (mean_speed_upwards(simulation, 0, 81) == 0.0 && simulation.state().time_s < 0.2) {
    simulation.advance_frame();
  }
  EXPECT_NEAR(mean_speed_upwards(simulation, 0, 81), 0.5 * before, 0.1 * -before);
  EXPECT_NEAR(mean_speed_upwards(simulation, 81, 81), 0.5 * before, 0.1 * -before);
}

TEST(Contact, ClothHangsOverABoxThatRisesAndTurns) {
  ContactScene scene = {.mesh = make_mesh({.columns = 17, .rows = 17, .at_m = {0.006, 0.11, 0.004}})};
  scene.surroundings.bodies = {
      {.name = "box",
       .shape = box(),
       .motion = {.shift = {{0.0, 0.4, 0.0}, 0.3, 0.8}, .spin = {{}, {0.0, 1.0, 0.0}, 0.2, 0.3, 0.8}}}};
  const Body body = scene.surroundings.bodies[0];
  const auto& triangles = std::get<BodyMesh>(body.shape).data->triangles;
  Simulation simulation = begin(std::move(scene));
  for (int frame = 1; frame <= 60; ++frame) {
    simulation.advance_frame();
    std::vector<Vec3> body_m(8);
    positions_at(body, simulation.state().time_s, body_m);
    const Surface cloth = {simulation.state().current, simulation.garment().mesh.triangles};
    ASSERT_TRUE(app::crossing_pairs(cloth, {body_m, triangles}).empty()) << "frame " << frame;
    ASSERT_EQ(crossings(simulation), 0U) << "frame " << frame;
    ASSERT_TRUE(simulation.frame_report().bound_kept) << "frame " << frame;
  }
  // The box lifts the sheet by 0.2 m, and the sheet does not slide off.
  EXPECT_GT(simulation.state().current[8 * 17 + 8].y, 0.29);
}

TEST(Contact, WhatCrossesAtTheStartIsLeftOutUntilItIsApart) {
  // A standing sheet goes through a level one, and gravity pulls it out.
  ContactScene scene = {.mesh = both(make_mesh({.columns = 9, .rows = 9, .at_m = {0.0, 0.0, 0.0}}),
                                     make_mesh({5, 5, 0.1, 0.1, GridPlane::vertical, {0.013, 0.04, 0.007}}))};
  for (Index v = 0; v < 81; ++v) {
    scene.pins.push_back(v);
  }
  Simulation simulation = begin(std::move(scene));
  std::size_t before = crossings(simulation);
  ASSERT_GT(before, 0U);
  for (int frame = 1; frame <= 60; ++frame) {
    simulation.advance_frame();
    const std::size_t now = crossings(simulation);
    ASSERT_LE(now, before) << "frame " << frame;
    before = now;
    ASSERT_TRUE(simulation.frame_report().bound_kept) << "frame " << frame;
  }
}

TEST(Contact, ClothThatBeginsWithinABallComesOut) {
  ContactScene scene = {
      .mesh = make_mesh({.columns = 9, .rows = 9, .width_m = 0.2, .length_m = 0.2, .at_m = {0.003, 0.14, 0.004}})};
  scene.surroundings.bodies = {{.name = "ball", .shape = Sphere{{}, 0.15}}};
  Simulation simulation = begin(std::move(scene));
  for (int frame = 1; frame <= 60; ++frame) {
    simulation.advance_frame();
  }
  for (const Vec3& p : simulation.state().current) {
    EXPECT_GT(glm::length(p), 0.15);
  }
}

}  // namespace
}  // namespace taut::sim
