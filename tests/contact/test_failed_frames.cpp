// A failed frame leaves no trace: the bytes of a checkpoint and the bits and steps of later frames stay the same.

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "scenes.hpp"
#include "sim/simulation.hpp"

namespace taut::sim {
namespace {

struct Interrupted {};

std::string to_bytes(const Simulation& simulation) { return encode(simulation.save(), simulation.garment()); }

Body closing_ball(const char* name, double z_m, double speed_m_per_s) {
  return {.name = name,
          .shape = Sphere{{0.0, 0.0, z_m}, 0.1},
          .motion = {.shift = {{0.0, 0.0, speed_m_per_s}, 0.05, 1.0}}};
}

/// A sheet that hangs by its upper edge between two balls.
ContactScene sheet_between_balls(double speed_m_per_s) {
  ContactScene scene = {.mesh = make_mesh({13, 13, 0.3, 0.3, GridPlane::vertical, {0.0, 0.15, 0.0}})};
  scene.bounded.max_stretch = 0.05;
  for (Index v = 0; v < 13; ++v) {
    scene.pins.push_back(v);
  }
  scene.surroundings.bodies = {closing_ball("left", -0.12, speed_m_per_s),
                               closing_ball("right", 0.12, -speed_m_per_s)};
  return scene;
}

/// Counts the calls of a frame's poll and throws in call number `throws_in`; 0 throws in none.
struct Poll {
  std::shared_ptr<int> calls = std::make_shared<int>(0);
  int throws_in = 0;

  void operator()() const {
    if (++*calls == throws_in) {
      throw Interrupted{};
    }
  }
};

TEST(FailedFrames, ABlockedFrameLeavesEveryByteAndTheCountOfSteps) {
  Simulation simulation = begin(sheet_between_balls(0.5));
  std::string before;
  int steps = 0;
  bool is_blocked = false;
  for (int frame = 0; frame < 60 && !is_blocked; ++frame) {
    before = to_bytes(simulation);
    steps = simulation.frame_report().substeps;
    try {
      simulation.advance_frame();
    } catch (const ContactBlocked&) {
      is_blocked = true;
    }
  }
  ASSERT_TRUE(is_blocked);
  EXPECT_TRUE(to_bytes(simulation) == before);

  Surroundings still = simulation.surroundings();
  still.bodies.clear();
  simulation.set_surroundings(still);
  simulation.advance_frame();
  EXPECT_LE(simulation.frame_report().substeps, 2 * steps);
}

/// Six sheets between balls that close in on them fast.
ContactScene pressed_sheets() {
  ContactScene scene = sheet_between_balls(8.0);
  for (int layer = 1; layer < 6; ++layer) {
    const auto count = static_cast<Index>(scene.mesh.positions.size());
    scene.mesh = both(scene.mesh, make_mesh({13, 13, 0.3, 0.3, GridPlane::vertical, {0.0, 0.15, 0.004 * layer}}));
    for (Index v = 0; v < 13; ++v) {
      scene.pins.push_back(count + v);
    }
  }
  return scene;
}

// An attempt that goes on to the frame's end at any cost makes 36 calls; a usual frame makes 12.
TEST(FailedFrames, TheLastAttemptEndsInsideItsStepsWhenItsWorkIsSpent) {
  Simulation simulation = begin(pressed_sheets());
  std::vector<int> calls;
  bool is_blocked = false;
  while (calls.size() < 60 && !is_blocked) {
    const Poll count;
    try {
      simulation.advance_frame(count);
      calls.push_back(*count.calls);
    } catch (const ContactBlocked&) {
      is_blocked = true;
      EXPECT_LT(*count.calls, 2 * calls.front());
    }
  }
  ASSERT_TRUE(is_blocked);
}

// All attempts together have a budget of work. Once it is spent, nothing is kept apart, but the bound still holds. A
// frame without a budget makes 1029 calls, a usual one 12. Only the first blocked frame is checked, as cloth flies
// apart after it.
TEST(FailedFrames, WhereCrossingsAreAcceptedASpentAttemptGoesOn) {
  ContactScene scene = pressed_sheets();
  scene.bounded.allow_crossing = true;
  Simulation simulation = begin(std::move(scene));
  bool is_blocked = false;
  for (int frame = 0; frame < 8; ++frame) {
    const Poll count;
    simulation.advance_frame(count);
    EXPECT_TRUE(simulation.frame_report().bound_kept) << frame;
    if (!is_blocked && simulation.frame_report().blocked) {
      is_blocked = true;
      EXPECT_LT(*count.calls, 60 * 12) << frame;
    }
  }
  EXPECT_TRUE(is_blocked);
}

TEST(FailedFrames, AnInterruptedFrameGoesOnWithTheSameBits) {
  Simulation straight = begin(sheet_between_balls(0.2));
  Simulation interrupted = begin(sheet_between_balls(0.2));
  for (int frame = 0; frame < 8; ++frame) {
    const Poll count;
    straight.advance_frame(count);
    ASSERT_GT(*count.calls, straight.frame_report().substeps);
    const std::string before = to_bytes(interrupted);
    for (const int call : {1, *count.calls / 2, *count.calls}) {
      EXPECT_THROW(interrupted.advance_frame(Poll{.throws_in = call}), Interrupted);
      ASSERT_TRUE(to_bytes(interrupted) == before) << "frame " << frame << ", call " << call;
    }
    interrupted.advance_frame();
    ASSERT_TRUE(to_bytes(interrupted) == to_bytes(straight)) << "frame " << frame;
  }
}

TEST(FailedFrames, ADivergedFrameLeavesEveryByte) {
  ContactScene scene = sheet_between_balls(0.0);
  SimulationSettings settings;
  settings.solver = {.substeps = 1, .method = IdealSettings{{.structural_n_per_m = 1e9}}};
  Simulation simulation(share(make_garment(scene.mesh)), scene.pins, settings, {});
  std::string before;
  const auto run = [&] {
    for (int frame = 0; frame < 60; ++frame) {
      before = to_bytes(simulation);
      simulation.advance_frame();
    }
  };
  EXPECT_THROW(run(), Diverged);
  EXPECT_TRUE(to_bytes(simulation) == before);
}

}  // namespace
}  // namespace taut::sim
