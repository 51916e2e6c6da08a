#include <gtest/gtest.h>

#include <cmath>

#include "race.hpp"
#include "sim/mesh/grid.hpp"
#include "sim/simulation.hpp"

namespace taut::app {
namespace {

using EngineRun = Run;  // a fixture has a Run of its own

GarmentInScene make_cloth(sim::Index side, std::vector<sim::Index> pins = {}) {
  return {sim::share(sim::make_garment(sim::make_grid({.columns = side, .rows = side}))), std::move(pins), {}, {}};
}

// Returns the stretch of the worst edge, from triangles and positions alone.
double worst_edge(const sim::Mesh& mesh, std::span<const sim::Vec3> positions) {
  double worst = -1.0;
  for (const sim::Triangle& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      const sim::Vec3 now = positions[t[k]] - positions[t[(k + 1) % 3]];
      const sim::Vec3 then = mesh.positions[t[k]] - mesh.positions[t[(k + 1) % 3]];
      worst = std::max(worst, std::hypot(now.x, now.y, now.z) / std::hypot(then.x, then.y, then.z) - 1.0);
    }
  }
  return worst;
}

class BenchEngines : public testing::TestWithParam<std::string> {};

TEST_P(BenchEngines, HaveTheStretchThatTheirPositionsShow) {
  const Scene scene = make_race_scene(race_scenes()[0], race_sizes()[0]);
  const LoadedGarment loaded = load_garment(scene);
  for (const Entrant& entrant : list_entrants(GetParam(), {0.05, 0.01}, false)) {
    const EngineRun run = race({entrant}, loaded, scene, {.frames = 12, .slowest_frame_ms = 1e9}).front();
    const std::unique_ptr<Engine> engine = entrant.make(loaded, scene);
    ASSERT_EQ(run.frames.size(), 12U) << entrant.settings;
    for (const FrameSample& frame : run.frames) {
      engine->advance_frame();
      const double worst = worst_edge(loaded.garment->mesh, engine->positions());
      EXPECT_NEAR(frame.springs.max, worst, 1e-12);
      EXPECT_LE(frame.surface.p99, frame.surface.max);
      EXPECT_GT(frame.cost.cpu_ms, 0.0);
      EXPECT_TRUE(!entrant.bound || worst <= *entrant.bound) << entrant.settings;
    }
    EXPECT_GT(summarise_run(run).stretch, 1e-5) << "nothing hangs on anything";
  }
}

INSTANTIATE_TEST_SUITE_P(All, BenchEngines, testing::ValuesIn(engine_names()),
                         [](const auto& engine) { return engine.param; });

std::vector<sim::Vec3> shape_after(const Entrant& entrant, const GarmentInScene& cloth, const Scene& scene) {
  const std::unique_ptr<Engine> engine = entrant.make(cloth, scene);
  for (int frame = 0; frame < 40; ++frame) {
    engine->advance_frame();
  }
  return {engine->positions().begin(), engine->positions().end()};
}

TEST(Ablation, EveryPartThatIsTakenAwayIsMissed) {
  const Scene scene = make_race_scene(race_scenes()[0], race_sizes()[0]);
  const LoadedGarment loaded = load_garment(scene);
  const std::vector<Entrant> entrants = ablation_entrants({0.01});
  const std::vector<sim::Vec3> whole = shape_after(entrants.front(), loaded, scene);
  for (std::size_t k = 1; k < entrants.size(); ++k) {
    const bool is_alike = shape_after(entrants[k], loaded, scene) == whole;
    EXPECT_EQ(is_alike, entrants[k].engine == "no vectors") << entrants[k].engine;
  }
}

// Free fall without wind: every engine must be where gravity moves it, otherwise times compare different tasks.
TEST(BulletPeer, FallsAndSwingsAsTheSceneSays) {
  const GarmentInScene cloth = make_cloth(5);
  sim::Surroundings air;
  air.forces.air_drag_per_s = 2.0;
  air.forces.wind.pressure_coefficient = air.forces.wind.friction_coefficient = 0.0;
  const auto engine = make_bullet_engine(*cloth.garment, cloth.pins, air, 1.0 / 60.0, {10, 2});
  for (int frame = 0; frame < 60; ++frame) {
    engine->advance_frame();
  }
  // Fall with the drag d: y = -g / d (t - (1 - e^(-d t)) / d).
  const double expected_m = -9.81 / 2.0 * (1.0 - (1.0 - std::exp(-2.0)) / 2.0);
  EXPECT_NEAR(engine->positions()[12].y - cloth.garment->mesh.positions[12].y, expected_m, 0.02);

  const GarmentInScene pinned = make_cloth(5, {0, 4});
  air.pin_motion = {{0.1, 0.0, 0.0}, 1.0};
  const auto shaken = make_bullet_engine(*pinned.garment, pinned.pins, air, 1.0 / 60.0, {10, 2});
  for (int frame = 0; frame < 15; ++frame) {
    shaken->advance_frame();
  }
  EXPECT_NEAR(shaken->positions()[4].x - pinned.garment->mesh.positions[4].x, 0.1, 1e-5);
}

TEST(BulletPeer, IsBlownByTheSameWind) {
  const GarmentInScene cloth = make_cloth(5);
  Scene scene;
  scene.surroundings.forces.wind = {.speed_m_per_s = 3.0};
  scene.simulation.solver.kind = sim::SolverKind::strong;
  scene.simulation.solver.substeps = 20;
  scene.simulation.solver.strong.iterations = 1;
  const auto bullet = make_bullet_engine(*cloth.garment, cloth.pins, scene.surroundings, 1.0 / 60.0, {20, 1});
  sim::Simulation taut = make_simulation(scene, cloth);
  for (int frame = 0; frame < 30; ++frame) {
    bullet->advance_frame();
    taut.advance_frame();
  }
  const double drift_m = taut.state().current[12].z;
  EXPECT_LT(drift_m, -0.3);
  EXPECT_NEAR(bullet->positions()[12].z, drift_m, 0.02 * std::abs(drift_m));
}

using Log = std::vector<std::string>;
using Positions = std::vector<sim::Vec3>;

// Stretches the whole cloth by a given factor, at a given cost.
class ScriptedEngine : public Engine {
 public:
  ScriptedEngine(const GarmentInScene& cloth, std::string name, double cpu_ms, double growth, Log* log)
      : name_(std::move(name)), cpu_ms_(cpu_ms), growth_(growth), log_(log), rest_(cloth.garment->mesh.positions) {
    now_ = rest_;
  }

  FrameCost advance_frame() override {
    log_->push_back(name_);
    ++frame_;
    for (std::size_t v = 0; v < rest_.size(); ++v) {
      now_[v] = rest_[v] * (1.0 + growth_ * frame_);
    }
    return {cpu_ms_, 3, true};
  }
  std::span<const sim::Vec3> positions() const override { return now_; }

 private:
  std::string name_;
  double cpu_ms_, growth_;
  Log* log_;
  int frame_ = 0;
  Positions rest_, now_;
};

struct Race : testing::Test {
  Entrant scripted(const std::string& name, double cpu_ms, double growth) {
    return {name, "", {}, [=, this](const GarmentInScene& cloth, const Scene&) {
              return std::make_unique<ScriptedEngine>(cloth, name, cpu_ms, growth, &log);
            }};
  }
  std::vector<EngineRun> run(const std::vector<Entrant>& entrants, int frames) {
    return race(entrants, square, {}, {.frames = frames, .slowest_frame_ms = 100.0});
  }

  Log log;
  GarmentInScene square = {sim::share(sim::make_garment(sim::make_grid({.columns = 3, .rows = 3}))), {}, {}, {}};
};

TEST_F(Race, TakesTenFramesInTurns) {
  run({scripted("a", 1.0, 0.0), scripted("b", 1.0, 0.0)}, 15);
  Log expected;
  for (const auto& [name, frames] : {std::pair("a", 10), {"b", 10}, {"a", 5}, {"b", 5}}) {
    expected.insert(expected.end(), static_cast<std::size_t>(frames), name);
  }
  EXPECT_EQ(log, expected);
}

TEST_F(Race, GivesUpWhatIsTooSlowOrHopelessAndGoesOnWithTheRest) {
  const std::vector<EngineRun> runs =
      run({scripted("slow", 101.0, 0.0), scripted("torn", 1.0, 0.2), scripted("good", 99.0, 0.0)}, 20);
  EXPECT_EQ(runs[0].end, RunEnd::too_slow);
  EXPECT_EQ(runs[1].end, RunEnd::hopeless);
  EXPECT_EQ(runs[2].end, RunEnd::finished);
  EXPECT_LT(runs[0].frames.size(), 20U);
  EXPECT_EQ(runs[2].frames.size(), 20U);
}

EngineRun made_run(const std::string& engine, std::optional<double> bound, std::vector<double> times_ms,
                   double stretch) {
  EngineRun made{{engine, "", bound, {}}, {}, RunEnd::finished};
  for (const double ms : times_ms) {
    made.frames.push_back({{ms, 2, true}, {}, {}});
    made.frames.back().springs.max = stretch;
  }
  return made;
}

TEST(BenchFindings, SumARunUp) {
  EngineRun made = made_run("strong", {}, {1.0, 9.0, 2.0, 4.0, 4.0}, 0.02);
  made.frames[1].springs.max = 0.05;
  made.frames[2].surface.max = 0.3;
  made.frames[1].cost.is_certified = false;
  const RunFacts facts = summarise_run(made);
  EXPECT_EQ(facts.median_ms, 4.0);
  EXPECT_EQ(facts.mean_ms, 4.0);
  EXPECT_EQ(facts.stretch, 0.05);
  EXPECT_EQ(facts.surface_stretch, 0.3);
  EXPECT_EQ(facts.not_certified, 1);
  EXPECT_EQ(frames_over(made, 0.02), 1);
  EXPECT_EQ(frames_over(made, std::nextafter(0.02, 0.0)), 5);
  EXPECT_EQ(frames_over(made_run("strong", {}, {1.0}, std::nan("")), 1.0), 1);
}

TEST(BenchFindings, ChooseTheFastestThatKeepsTheBoundInEveryFrame) {
  std::vector<EngineRun> runs = {made_run("bullet", {}, {9.0, 9.0}, 0.01), made_run("bullet", {}, {5.0, 5.0}, 0.04),
                                 made_run("bullet", {}, {4.0, 4.0}, 0.04), made_run("bounded", 0.01, {1.0, 1.0}, 0.01),
                                 made_run("bounded", 0.05, {2.0, 2.0}, 0.05)};
  runs[2].frames[1].springs.max = 0.06;
  EXPECT_EQ(best_run(runs, "bullet", 0.05), &runs[1]);
  EXPECT_EQ(best_run(runs, "bullet", 0.01), &runs[0]);
  EXPECT_EQ(best_run(runs, "bullet", 0.001), &runs[0]) << "the closest";
  EXPECT_EQ(best_run(runs, "bounded", 0.05), &runs[4]) << "the other was asked for something else";
  EXPECT_EQ(best_run(runs, "bounded", 0.02), nullptr);
  runs[0].end = runs[1].end = RunEnd::too_slow;
  EXPECT_EQ(best_run(runs, "bullet", 0.05), &runs[2]);
}

}  // namespace
}  // namespace taut::app
