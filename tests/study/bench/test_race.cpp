#include <gtest/gtest.h>

#include "race.hpp"
#include "sim/mesh/grid.hpp"
#include "sim/simulation.hpp"

namespace taut::app {
namespace {

using EngineRun = Run;  // a fixture has a Run of its own

GarmentInScene make_cloth(sim::Index side, std::vector<sim::Index> pins = {}) {
  return {sim::share(sim::make_garment(sim::make_grid({.columns = side, .rows = side}))), std::move(pins), {}, {}};
}

void advance(Engine& engine, int frames) {
  for (int frame = 0; frame < frames; ++frame) engine.advance_frame();
}

// Free fall without wind: every engine must be where gravity moves it, otherwise times compare different tasks.
TEST(BulletPeer, FallsAndSwingsAsTheSceneSays) {
  Scene scene;
  sim::Surroundings& air = scene.surroundings;
  air.forces.air_drag_per_s = 2.0;
  air.forces.wind.pressure_coefficient = air.forces.wind.friction_coefficient = 0.0;
  const GarmentInScene cloth = make_cloth(5);
  const auto engine = make_bullet_engine(cloth, scene, {10, 2});
  advance(*engine, 60);
  // Fall with the drag d: y = -g / d (t - (1 - e^(-d t)) / d).
  const double expected_m = -9.81 / 2.0 * (1.0 - (1.0 - std::exp(-2.0)) / 2.0);
  EXPECT_NEAR(engine->positions()[12].y - cloth.garment->mesh.positions[12].y, expected_m, 0.02);

  const GarmentInScene pinned = make_cloth(5, {0, 4});
  air.pin_motion = {{0.1, 0.0, 0.0}, 1.0};
  const auto shaken = make_bullet_engine(pinned, scene, {10, 2});
  advance(*shaken, 15);
  EXPECT_NEAR(shaken->positions()[4].x - pinned.garment->mesh.positions[4].x, 0.1, 1e-5);
}

TEST(BulletPeer, IsBlownByTheSameWind) {
  const GarmentInScene cloth = make_cloth(5);
  Scene scene;
  scene.surroundings.forces.wind = {.speed_m_per_s = 3.0};
  scene.simulation.solver.kind = sim::SolverKind::strong;
  scene.simulation.solver.substeps = 20;
  scene.simulation.solver.strong.iterations = 1;
  const auto bullet = make_bullet_engine(cloth, scene, {20, 1});
  sim::Simulation taut = make_simulation(scene, cloth);
  for (int frame = 0; frame < 30; ++frame) {
    bullet->advance_frame();
    taut.advance_frame();
  }
  const double drift_m = taut.state().current[12].z;
  EXPECT_LT(drift_m, -0.3);
  EXPECT_NEAR(bullet->positions()[12].z, drift_m, 0.02 * std::abs(drift_m));
}

TEST(TautEntrant, KeepsItsBound) {
  Scene scene;
  scene.simulation.solver.bounded.contact = false;
  const GarmentInScene cloth = make_cloth(9, {0, 8});
  const std::vector<Entrant> entrants = taut_entrants({0.01});
  const std::vector<EngineRun> runs = race(entrants, cloth, scene, 40, 1e9);
  for (const EngineRun& run : runs) {
    EXPECT_LE(run.max_stretch(), 0.01);
    EXPECT_GT(run.max_stretch(), 1e-5) << "nothing hangs on anything";
  }
}

/// Cloth that grows by a fraction of its size in every frame, and notes its name for each.
class ScriptedEngine : public Engine {
 public:
  ScriptedEngine(const GarmentInScene& cloth, std::string name, double cpu_ms, double growth,
                 std::vector<std::string>& log)
      : name_(std::move(name)), cpu_ms_(cpu_ms), growth_(growth), log_(log), now_(cloth.garment->mesh.positions) {}

  double advance_frame() override {
    log_.push_back(name_);
    for (sim::Vec3& p : now_) p *= 1.0 + growth_;
    return cpu_ms_;
  }
  std::span<const sim::Vec3> positions() const override { return now_; }

 private:
  std::string name_;
  double cpu_ms_, growth_;
  std::vector<std::string>& log_;
  std::vector<sim::Vec3> now_;
};

TEST(Race, TakesTenFramesInTurnsAndGivesUpWhatIsTooSlowOrHopeless) {
  std::vector<std::string> log;
  const auto scripted = [&log](const std::string& name, double cpu_ms, double growth) -> Entrant {
    return {name, "", {}, [=, &log](const GarmentInScene& cloth, const Scene&) {
              return std::make_unique<ScriptedEngine>(cloth, name, cpu_ms, growth, log);
            }};
  };
  const std::vector<EngineRun> runs =
      race({scripted("slow", 101.0, 0.0), scripted("torn", 1.0, 0.2), scripted("good", 99.0, 0.0)}, make_cloth(3), {},
           15, 100.0);
  EXPECT_EQ(runs[0].given_up, "too slow");
  EXPECT_EQ(runs[1].given_up, "hopeless");
  EXPECT_EQ(runs[2].given_up, "");
  std::vector<std::string> expected(6, "slow");
  expected.insert(expected.end(), 6, "torn");
  expected.insert(expected.end(), 15, "good");
  EXPECT_EQ(log, expected);
}

TEST(Race, ChoosesTheFastestThatKeepsTheBoundInEveryFrame) {
  const auto made_run = [](const std::string& engine, std::optional<double> bound, double cpu_ms, double stretch) {
    return EngineRun{{engine, "", bound, {}}, {{cpu_ms, 0.0, 0.0}, {cpu_ms, stretch, 0.0}}, ""};
  };
  std::vector<EngineRun> runs = {made_run("bullet", {}, 9.0, 0.01),    made_run("bullet", {}, 5.0, 0.04),
                                 made_run("bullet", {}, 4.0, 0.06),    made_run("bounded", 0.01, 1.0, 0.01),
                                 made_run("bounded", 0.05, 2.0, 0.05), made_run("bullet", {}, 1.0, NAN)};
  EXPECT_EQ(best_run(runs, "bullet", 0.05), &runs[1]);
  EXPECT_EQ(best_run(runs, "bullet", 0.01), &runs[0]);
  EXPECT_EQ(best_run(runs, "bullet", 0.001), &runs[0]) << "the closest";
  EXPECT_EQ(best_run(runs, "bounded", 0.05), &runs[4]) << "the other was asked for something else";
  EXPECT_EQ(best_run(runs, "bounded", 0.02), nullptr);
  runs[0].given_up = runs[1].given_up = "too slow";
  EXPECT_EQ(best_run(runs, "bullet", 0.05), &runs[2]);
}

}  // namespace
}  // namespace taut::app
