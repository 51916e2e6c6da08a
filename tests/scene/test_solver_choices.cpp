#include <gtest/gtest.h>

#include <algorithm>

#include "app/drawing/drawn_scene.hpp"
#include "app/viewer/simulation/live_simulation.hpp"
#include "app/viewer/state/viewer_state.hpp"

// Choices of a person in the window's lists, made by the same calls as in the window.

namespace taut::app {
namespace {

const std::string first_scene = "tshirt";

DrawnScene scene_with(const std::string& garment) {
  DrawnScene scene = find_scene(first_scene, {});
  for (const Choice& choice : garment_choices()) {
    if (choice.name == garment) {
      scene.garment.file = choice.file;
      if (garment.find("tshirt") != 0) {
        scene.pins.reset();
      }
    }
  }
  return garment == "grid" ? find_scene("cloth-fall", {}) : scene;
}

ChangeSettings with_solver(DrawnScene& scene, sim::SolverKind kind) {
  scene.simulation.solver.kind = kind;
  scene.simulation.solver.substeps.reset();
  return ChangeSettings(scene);
}

void expect_frames(LiveSimulation& live, int frames, const std::string& what) {
  for (int i = 0; i < frames; ++i) {
    live.advance();
  }
  const SnapshotPtr after = live.take_snapshot();
  EXPECT_FALSE(after->stopped) << what << ": " << (after->notices->empty() ? "" : after->notices->back().text);
  EXPECT_EQ(after->record.frame, frames) << what;
  // Springs that diverge reach any length. Springs that only give stay below this stretch.
  EXPECT_LT(after->record.stretch.max, 2.0) << what;
}

struct Chosen {
  std::string garment;
  sim::SolverKind solver;
};

void PrintTo(const Chosen& chosen, std::ostream* out) { *out << chosen.garment << ", " << sim::to_name(chosen.solver); }

std::vector<Chosen> all_choices() {
  std::vector<Chosen> all;
  for (const char* garment :
       {"grid", "tshirt_1028", "tshirt_5280", "tshirt_10600", "tshirt_female_34", "tshirt_female_42"}) {
    for (const sim::SolverKind solver : sim::all_solver_kinds) {
      all.push_back({garment, solver});
    }
  }
  for (const char* garment :
       {"dress", "hooded_top", "long_shirt", "long_sleeves", "skirt", "trousers", "tshirt_2640"}) {
    all.push_back({garment, sim::SolverKind::bounded});
  }
  return all;
}

class SolverChoices : public testing::TestWithParam<Chosen> {};

// Explicit solvers without a bound take a hundred times as long on fine meshes, so they run for a quarter of a
// second. Solvers of large linear systems run for a few frames only.
TEST_P(SolverChoices, RunsForASecondOrAQuarter) {
  DrawnScene scene = scene_with(GetParam().garment);
  const bool is_coarse = GetParam().garment == "grid" || GetParam().garment == "tshirt_1028";
  const bool has_bound = GetParam().solver == sim::SolverKind::bounded || GetParam().solver == sim::SolverKind::strong;
  LiveSimulation live(scene);
  live.apply(with_solver(scene, GetParam().solver));
  const bool solves_systems =
      GetParam().solver == sim::SolverKind::fast_projection || GetParam().solver == sim::SolverKind::implicit;
  const int frames_of_fine = has_bound ? 60 : solves_systems ? 4 : 15;
  expect_frames(live, is_coarse ? 60 : frames_of_fine, GetParam().garment);
}

INSTANTIATE_TEST_SUITE_P(All, SolverChoices, testing::ValuesIn(all_choices()), [](const auto& test) {
  std::string name = test.param.garment + "_" + sim::to_name(test.param.solver);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST(SolverChoices, HoldsEveryGarmentOfTheList) {
  for (const Choice& garment : garment_choices()) {
    const auto all = all_choices();
    EXPECT_TRUE(std::any_of(all.begin(), all.end(), [&](const Chosen& c) { return c.garment == garment.name; }))
        << garment.name;
  }
}

// Solvers one after the other on the same garment. Each begins with the shape that the one before has left.
TEST(SolverChoices, FollowOneAnother) {
  DrawnScene scene = scene_with("tshirt_1028");
  LiveSimulation live(scene);
  int frames = 0;
  for (const sim::SolverKind to :
       {sim::SolverKind::ideal, sim::SolverKind::strong, sim::SolverKind::provot, sim::SolverKind::bounded,
        sim::SolverKind::fast_projection, sim::SolverKind::implicit, sim::SolverKind::ideal, sim::SolverKind::vassilev,
        sim::SolverKind::bounded}) {
    live.apply(with_solver(scene, to));
    for (int i = 0; i < 20; ++i) {
      live.advance();
    }
    frames += 20;
    EXPECT_FALSE(live.take_snapshot()->stopped) << sim::to_name(to);
    EXPECT_EQ(live.take_snapshot()->record.frame, frames) << sim::to_name(to);
  }
}

struct AfterDivergence : testing::Test {
  DrawnScene scene = find_scene("pinned-9x9-5", {});
  LiveSimulation live{scene};

  AfterDivergence() {
    DrawnScene wild = scene;
    wild.simulation.solver.kind = sim::SolverKind::ideal;
    wild.simulation.solver.ideal.stiffness.structural_n_per_m = 1e9;
    live.apply(ChangeSettings(wild));
    for (int i = 0; i < 100; ++i) {
      live.advance();
    }
  }
  void expect_anew() {
    const SnapshotPtr shown = live.take_snapshot();
    for (const sim::Vec3& position : shown->positions()) {
      EXPECT_LT(std::abs(position.x) + std::abs(position.y) + std::abs(position.z), 10.0);
    }
    EXPECT_TRUE(live.wants_to_advance());
    expect_frames(live, 30, "anew");
  }
};

TEST_F(AfterDivergence, NothingThatIsLostIsShown) {
  ASSERT_TRUE(live.take_snapshot()->stopped);
  const SnapshotPtr shown = live.take_snapshot();
  for (const sim::Vec3& position : shown->positions()) {
    EXPECT_LT(std::abs(position.x) + std::abs(position.y) + std::abs(position.z), 1e10);
  }
}

TEST_F(AfterDivergence, AnotherSolverStartsAnew) {
  ASSERT_TRUE(live.take_snapshot()->stopped);
  for (const sim::SolverKind solver : sim::all_solver_kinds) {
    DrawnScene chosen = scene;
    live.apply(with_solver(chosen, solver));
    expect_anew();
    live.apply(Reset{});
  }
}

TEST_F(AfterDivergence, AnotherSettingStartsAnew) {
  DrawnScene breezy = scene;
  breezy.surroundings.forces.wind.speed_m_per_s = 1.0;
  live.apply(ChangeSettings(breezy));
  expect_anew();
}

TEST_F(AfterDivergence, AnotherSceneStartsAnew) {
  live.apply(LoadScene{std::make_shared<const SceneWithBodies>(find_scene("pinned-9x9-20", {}))});
  expect_anew();
}

}  // namespace
}  // namespace taut::app
