#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "app/bench/engines/bullet_engine.hpp"
#include "app/bench/findings.hpp"
#include "app/models/garment_loading.hpp"
#include "sim/mesh/grid.hpp"
#include "sim/simulation.hpp"

namespace taut::app {
namespace {

GarmentInScene cloth_of(sim::Index side, std::vector<sim::Index> pins = {}) {
  return {sim::share(sim::make_garment(sim::make_grid({.columns = side, .rows = side}))),
          std::move(pins),
          {},
          {}};
}

// Edges found and measured anew, from triangles and positions alone.
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

// The stretch of the most stretched triangle along any direction in it. Its square is the larger eigenvalue
// of the metric now against the metric at rest, both from the edges alone.
double worst_triangle(const sim::Mesh& mesh, std::span<const sim::Vec3> positions) {
  using Metric = std::array<double, 3>;
  const auto metric_of = [](const sim::Triangle& t, std::span<const sim::Vec3> corners) -> Metric {
    const sim::Vec3 e = corners[t[1]] - corners[t[0]], f = corners[t[2]] - corners[t[0]];
    return {glm::dot(e, e), glm::dot(e, f), glm::dot(f, f)};
  };
  double worst = -1.0;
  for (const sim::Triangle& t : mesh.triangles) {
    const auto [now_ee, now_ef, now_ff] = metric_of(t, positions);
    const auto [ee, ef, ff] = metric_of(t, mesh.positions);
    const double determinant = ee * ff - ef * ef;
    const double half_trace = 0.5 * (ff * now_ee - 2.0 * ef * now_ef + ee * now_ff) / determinant;
    const double product = (now_ee * now_ff - now_ef * now_ef) / determinant;
    const double larger = half_trace + std::sqrt(std::max(half_trace * half_trace - product, 0.0));
    worst = std::max(worst, std::sqrt(larger) - 1.0);
  }
  return worst;
}

struct Seen {
  double worst_edge = 0.0;
  double worst_triangle = 0.0;
};

// Notes where an engine has its cloth, frame by frame, outside of the benchmark's own measuring.
class Witness : public Engine {
 public:
  Witness(std::unique_ptr<Engine> engine, const sim::Mesh& mesh, std::vector<Seen>* seen)
      : engine_(std::move(engine)), mesh_(mesh), seen_(seen) {}
  FrameCost advance_frame() override {
    const FrameCost cost = engine_->advance_frame();
    seen_->push_back({worst_edge(mesh_, engine_->positions()), worst_triangle(mesh_, engine_->positions())});
    return cost;
  }
  std::span<const sim::Vec3> positions() const override { return engine_->positions(); }

 private:
  std::unique_ptr<Engine> engine_;
  sim::Mesh mesh_;
  std::vector<Seen>* seen_;
};

class BenchEngines : public testing::TestWithParam<std::string> {};

TEST_P(BenchEngines, HaveTheStretchThatTheirPositionsShow) {
  const Scene scene = make_bench_scene(bench_scenes()[0], bench_sizes()[0]);
  const LoadedGarment loaded = load_garment(scene);
  std::vector<Entrant> entrants = entrants_of(GetParam(), {0.05, 0.01}, false);
  if (entrants.empty()) {
    GTEST_SKIP() << "this engine is not there";
  }
  std::map<std::string, std::vector<Seen>> seen;
  for (Entrant& entrant : entrants) {
    std::vector<Seen>& here = seen[entrant.settings];
    entrant.make = [make = entrant.make, &here](const GarmentInScene& cloth, const Scene& s) {
      return std::make_unique<Witness>(make(cloth, s), cloth.garment->mesh, &here);
    };
  }
  for (const auto& run : race(entrants, loaded, scene, {.frames = 30, .slowest_frame_ms = 1e9}, [](int) {})) {
    const std::vector<Seen>& here = seen[run.entrant.settings];
    ASSERT_EQ(run.frames.size(), here.size()) << run.entrant.settings;
    for (std::size_t f = 0; f < here.size(); ++f) {
      EXPECT_NEAR(run.frames[f].stretch, here[f].worst_edge, 1e-12);
      EXPECT_NEAR(run.frames[f].surface.max, here[f].worst_triangle, 1e-9);
      EXPECT_LE(run.frames[f].surface.p99, run.frames[f].surface.max);
      EXPECT_GT(run.frames[f].cost.cpu_ms, 0.0);
      EXPECT_GT(run.frames[f].cost.projections, 0.0);
      if (run.entrant.bound && run.frames[f].cost.is_certified) {
        EXPECT_LE(here[f].worst_edge, *run.entrant.bound) << run.entrant.settings << ", frame " << f + 1;
      }
    }
    EXPECT_GT(facts_of(run).stretch, 1e-4) << "nothing hangs on anything";
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
  const Scene scene = make_bench_scene(bench_scenes()[0], bench_sizes()[0]);
  const LoadedGarment loaded = load_garment(scene);
  const std::vector<Entrant> entrants = ablation_entrants({0.01});
  const std::vector<sim::Vec3> whole = shape_after(entrants.front(), loaded, scene);
  for (std::size_t k = 1; k < entrants.size(); ++k) {
    const bool is_alike = shape_after(entrants[k], loaded, scene) == whole;
    EXPECT_EQ(is_alike, entrants[k].engine == "no vectors") << entrants[k].engine;
  }
}

TEST(Ablation, HasSpringsAndSurfaceOfEveryBoundBesideEachOther) {
  const std::vector<Entrant> entrants = ablation_entrants({0.05, 0.01});
  for (const double bound : {0.05, 0.01}) {
    for (const sim::BoundKind kind : sim::all_bound_kinds) {
      const bool is_default = kind == sim::BoundedSettings{}.bound;
      const std::string engine = is_default ? "bounded" : sim::name_of(kind);
      EXPECT_EQ(std::count_if(entrants.begin(), entrants.end(),
                              [&](const Entrant& entrant) {
                                return entrant.engine == engine && entrant.bound == bound &&
                                       entrant.held == kind;
                              }),
                1)
          << engine;
    }
  }
  EXPECT_EQ(entrants.front().engine, "bounded");
  EXPECT_EQ(entrants.back().held, sim::BoundedSettings{}.bound) << "a part is taken from the default";
}

TEST(Ablation, AsksTheSolverForWhatItSays) {
  Scene scene;
  scene.simulation.solver.kind = sim::SolverKind::strong;
  scene.simulation.solver.substeps = 7;
  scene.simulation.solver.bounded.tethers = false;
  for (const sim::BoundKind kind : sim::all_bound_kinds) {
    const SolverChoice solver = asked_for(scene, 0.03, kind).simulation.solver;
    EXPECT_EQ(solver.kind, sim::SolverKind::bounded);
    EXPECT_FALSE(solver.substeps);
    EXPECT_EQ(solver.bounded, (sim::BoundedSettings{.bound = kind, .max_stretch = 0.03, .tethers = false}));
  }
}

// Free fall without wind: every engine has to be where gravity puts it, or else times compare different
// tasks.
TEST(BulletPeer, FallsAndSwingsAsTheSceneSays) {
  if (bullet_version().empty()) {
    GTEST_SKIP() << "built without Bullet";
  }
  const GarmentInScene cloth = cloth_of(5);
  sim::Surroundings air;
  air.forces.air_drag_per_s = 2.0;
  air.forces.wind.pressure_coefficient = air.forces.wind.friction_coefficient = 0.0;
  const auto engine = make_bullet_engine(*cloth.garment, cloth.pins, air, 1.0 / 60.0, {10, 2});
  for (int frame = 0; frame < 60; ++frame) {
    engine->advance_frame();
  }
  // y = -g / d (t - (1 - e^(-d t)) / d) for a fall with the drag d.
  const double expected_m = -9.81 / 2.0 * (1.0 - (1.0 - std::exp(-2.0)) / 2.0);
  EXPECT_NEAR(engine->positions()[12].y - cloth.garment->mesh.positions[12].y, expected_m, 0.02);

  const GarmentInScene pinned = cloth_of(5, {0, 4});
  air.pin_motion = {{0.1, 0.0, 0.0}, 1.0};
  const auto shaken = make_bullet_engine(*pinned.garment, pinned.pins, air, 1.0 / 60.0, {10, 2});
  for (int frame = 0; frame < 15; ++frame) {
    shaken->advance_frame();
  }
  EXPECT_NEAR(shaken->positions()[4].x - pinned.garment->mesh.positions[4].x, 0.1, 1e-5);
}

TEST(BulletPeer, IsBlownByTheSameWind) {
  if (bullet_version().empty()) {
    GTEST_SKIP() << "built without Bullet";
  }
  const GarmentInScene cloth = cloth_of(5);
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

TEST(SweepSpeed, OfTheWidestUnitIsTheOneThatFramesAreMeasuredBy) {
  sim::GridSettings grid;
  grid.columns = grid.rows = 33;
  const std::vector<SweepSpeed> speeds = measure_sweep_speeds(sim::make_garment(sim::make_grid(grid)));
  const std::vector<sim::VectorUnit> units = sim::available_vector_units();
  ASSERT_EQ(speeds.size() + 1, units.size()) << "all but the best, which is one of them";
  EXPECT_EQ(speeds.back().unit, sim::name_of(units.back()));
  EXPECT_GT(speeds.front().springs_per_s, 1e6);
  EXPECT_LT(speeds.back().springs_per_s, 1e10);
  EXPECT_EQ(units.size() > 2, speeds.back().springs_per_s > 1.5 * speeds.front().springs_per_s);
}

}  // namespace
}  // namespace taut::app
