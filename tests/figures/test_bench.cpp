#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "app/bench/bench_output.hpp"
#include "app/figures/experiments/power_law.hpp"
#include "app/models/garment_loading.hpp"
#include "sim/mesh/grid.hpp"
#include "sim/simulation.hpp"

namespace taut::app {
namespace {

using Log = std::vector<std::string>;
using Positions = std::vector<sim::Vec3>;
using EngineRun = Run;  // a fixture has a Run of its own

// Stretches the whole cloth by what it is told and costs what it is told.
class ScriptedEngine : public Engine {
 public:
  ScriptedEngine(const GarmentInScene& cloth, std::string name, double cpu_ms, double growth, Log* log)
      : name_(std::move(name)),
        cpu_ms_(cpu_ms),
        growth_(growth),
        log_(log),
        rest_(cloth.garment->mesh.positions) {
    now_ = rest_;
  }

  FrameCost advance_frame() override {
    log_->push_back(name_);
    ++frame_;
    for (std::size_t v = 0; v < rest_.size(); ++v) {
      now_[v] = rest_[v] * (1.0 + growth_ * frame_);
    }
    return {cpu_ms_, 3, 1000.0, true, 2.0 * growth_ * frame_};
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
    return {name, "", {}, {}, [=, this](const GarmentInScene& cloth, const Scene&) {
              return std::make_unique<ScriptedEngine>(cloth, name, cpu_ms, growth, &log);
            }};
  }
  std::vector<EngineRun> run(const std::vector<Entrant>& entrants, int frames) {
    return race(entrants, square, {}, {.frames = frames, .slowest_frame_ms = 100.0}, [](int) {});
  }

  Log log;
  GarmentInScene square = {
      sim::share(sim::make_garment(sim::make_grid({.columns = 3, .rows = 3}))), {}, {}, {}};
};

TEST_F(Race, TakesTenFramesInTurns) {
  run({scripted("a", 1.0, 0.0), scripted("b", 1.0, 0.0)}, 15);
  Log expected;
  for (const auto& [name, frames] : {std::pair("a", 10), {"b", 10}, {"a", 5}, {"b", 5}}) {
    expected.insert(expected.end(), static_cast<std::size_t>(frames), name);
  }
  EXPECT_EQ(log, expected);
}

TEST_F(Race, MeasuresWhatIsShownApartFromWhatGoesOn) {
  const EngineRun run_a = run({scripted("a", 2.0, 0.001)}, 5).front();
  ASSERT_EQ(run_a.frames.size(), 5U);
  EXPECT_NEAR(run_a.frames[4].stretch, 0.005, 1e-12);
  EXPECT_NEAR(run_a.frames[4].p99_stretch, 0.005, 1e-12);
  EXPECT_NEAR(run_a.frames[4].raw_stretch, 0.010, 1e-12);
}

TEST_F(Race, GivesUpWhatIsTooSlowOrHopelessAndGoesOnWithTheRest) {
  const std::vector<EngineRun> runs =
      run({scripted("slow", 101.0, 0.0), scripted("torn", 1.0, 0.2), scripted("good", 99.0, 0.0)}, 20);
  EXPECT_EQ(runs[0].end, RunEnd::too_slow);
  EXPECT_EQ(runs[1].end, RunEnd::hopeless);
  EXPECT_EQ(runs[2].end, RunEnd::finished);
  EXPECT_LT(runs[0].frames.size(), 20U);
  EXPECT_EQ(runs[2].frames.size(), 20U);
  EXPECT_FALSE(keeps(runs[0], 1.0));
}

TEST_F(Race, NotesThatAnEngineDiverged) {
  Entrant lost = scripted("lost", 1.0, 0.0);
  lost.make = [](const GarmentInScene&, const Scene&) -> std::unique_ptr<Engine> {
    struct Lost : Engine {
      FrameCost advance_frame() override { throw sim::Diverged(0, 0.0); }
      std::span<const sim::Vec3> positions() const override { return none; }
      Positions none;
    };
    return std::make_unique<Lost>();
  };
  EXPECT_EQ(run({lost}, 3).front().end, RunEnd::diverged);
}

Run made_run(const std::string& engine, std::optional<double> bound, std::vector<double> times_ms,
             double stretch) {
  Run made{
      {engine, engine + " as set", bound, bound ? std::optional(sim::BoundKind::springs) : std::nullopt, {}},
      {},
      RunEnd::finished,
      {}};
  for (const double ms : times_ms) {
    made.frames.push_back(
        {{ms, 2, 1e6, true, {}}, 3.0 * stretch, stretch, 0.5 * stretch, {5.0 * stretch, 2.0 * stretch}});
  }
  return made;
}

TEST(BenchFindings, SumARunUp) {
  EngineRun made = made_run("strong", {}, {1.0, 9.0, 2.0, 4.0, 4.0}, 0.02);
  made.frames[1].stretch = 0.05;
  made.frames[1].cost.is_certified = false;
  made.frames[2].surface = {0.3, 0.2};
  const RunFacts facts = facts_of(made);
  EXPECT_EQ(facts.median_ms, 4.0);
  EXPECT_EQ(facts.mean_ms, 4.0);
  EXPECT_EQ(facts.stretch, 0.05);
  EXPECT_EQ(facts.raw_stretch, 0.06);
  EXPECT_EQ(facts.p99_stretch, 0.01);
  EXPECT_EQ(facts.surface_stretch, 0.3);
  EXPECT_EQ(facts.p99_surface_stretch, 0.2);
  EXPECT_EQ(facts.not_certified, 1);
  EXPECT_NEAR(facts.projections_per_s, 5e6 / 20e-3, 1e-3);
  EXPECT_EQ(frames_over(made, 0.02), 1);
  EXPECT_EQ(frames_over(made, std::nextafter(0.02, 0.0)), 5);
}

TEST(BenchFindings, CountANumberThatIsNoneAsOver) {
  EXPECT_EQ(frames_over(made_run("strong", {}, {1.0}, std::nan("")), 1.0), 1);
}

TEST(BenchFindings, ChooseTheFastestThatKeepsTheBoundInEveryFrame) {
  Heat heat;
  heat.runs = {made_run("bullet", {}, {9.0, 9.0}, 0.01), made_run("bullet", {}, {5.0, 5.0}, 0.04),
               made_run("bullet", {}, {4.0, 4.0}, 0.04), made_run("bounded", 0.01, {1.0, 1.0}, 0.01),
               made_run("bounded", 0.05, {2.0, 2.0}, 0.05)};
  heat.runs[2].frames[1].stretch = 0.06;
  EXPECT_EQ(best_run(heat, "bullet", 0.05), &heat.runs[1]);
  EXPECT_EQ(best_run(heat, "bullet", 0.01), &heat.runs[0]);
  EXPECT_EQ(best_run(heat, "bullet", 0.001), nullptr);
  EXPECT_EQ(closest_run(heat, "bullet", 0.001), &heat.runs[0]);
  // Faster, but asked for something else.
  EXPECT_EQ(best_run(heat, "bounded", 0.05), &heat.runs[4]);
  const auto ratio = speed_ratio(heat, 0.01, "bullet", 0.05);
  ASSERT_TRUE(ratio);
  EXPECT_EQ(ratio->ratio(), 5.0);
  heat.runs[0].end = heat.runs[1].end = RunEnd::too_slow;
  EXPECT_FALSE(speed_ratio(heat, 0.01, "bullet", 0.05));
}

TEST(BenchFindings, CompareByWorstEdgeAndByThe99thPercentile) {
  Heat heat;
  // Half of their worst edge is the 99th percentile of made-up runs.
  heat.runs = {made_run("bullet", {}, {9.0, 9.0}, 0.05), made_run("bullet", {}, {5.0, 5.0}, 0.1),
               made_run("bounded", 0.01, {1.0, 1.0}, 0.01)};
  EXPECT_EQ(best_run(heat, "bullet", 0.05), &heat.runs[0]);
  EXPECT_EQ(best_run(heat, "bullet", 0.05, StretchMeasure::p99), &heat.runs[1]);
  EXPECT_EQ(frames_over(heat.runs[1], 0.05), 2);
  EXPECT_EQ(frames_over(heat.runs[1], 0.05, StretchMeasure::p99), 0);
  EXPECT_EQ(speed_ratio(heat, 0.01, "bullet", 0.05)->ratio(), 9.0);
  EXPECT_EQ(speed_ratio(heat, 0.01, "bullet", 0.05, StretchMeasure::p99)->ratio(), 5.0);
}

TEST(BenchFindings, AParetoFrontHoldsWhatNothingBeatsInBoth) {
  const std::vector<DataPoint> points = {{3, 1}, {1, 5}, {2, 5}, {2, 3}, {4, 1}, {5, 0.5}};
  EXPECT_EQ(pareto_front(points), (std::vector<std::size_t>{1, 3, 0, 5}));
  EXPECT_TRUE(pareto_front({}).empty());
}

TEST(BenchFindings, FitTheExponentOfGrowth) {
  const std::vector<DataPoint> exact = {
      {1e3, 2e-6 * std::pow(1e3, 1.2)}, {1e4, 2e-6 * std::pow(1e4, 1.2)}, {8e4, 2e-6 * std::pow(8e4, 1.2)}};
  EXPECT_NEAR(fit_power_law(exact).exponent, 1.2, 1e-12);
  EXPECT_NEAR(fit_power_law(exact).factor, 2e-6, 1e-15);
  BenchResults results;
  for (const int triangles : {1000, 8000, 64000}) {
    results.heats.push_back({{"hanging", "", {}}, {triangles, triangles, 0}, 0, 0, {}, {}});
    results.heats.back().runs = {made_run("strong", {}, {1e-3 * triangles}, triangles > 9000 ? 0.5 : 0.01)};
  }
  const auto growth = growth_of(results, "hanging", "strong", 0.05);
  ASSERT_TRUE(growth);
  EXPECT_NEAR(growth->exponent, 1.0, 1e-12);
  EXPECT_EQ(growth->sizes, 2);
  EXPECT_FALSE(growth_of(results, "wind", "strong", 0.05));
}

BenchResults made_results() {
  BenchResults results;
  results.bounds = {0.05, 0.01};
  results.frames = 2;
  results.heats.push_back({bench_scenes()[0], bench_sizes()[0], 10, 0, {}, {{"sse", 1e9}, {"avx2", 2e9}}});
  results.heats[0].runs = {
      made_run("bounded", 0.01, {1.0, 1.0}, 0.0094), made_run("bounded", 0.05, {0.5, 0.5}, 0.0484),
      made_run("bullet", {}, {9.0, 9.0}, 0.0364), made_run("bullet", {}, {4.0, 4.0}, 0.0822),
      made_run("strong", {}, {2.0, 2.0}, 0.3126)};
  return results;
}

TEST(BenchTable, HasWorstEdgeAnd99thPercentileOfEveryEngine) {
  const std::string table = bench_table(made_results());
  const auto expect_in = [&](const std::string& text) {
    EXPECT_NE(table.find(text), std::string::npos) << "'" << text << "' is not in\n" << table;
  };
  expect_in("the fastest setting whose worst edge keeps it in every frame");
  expect_in("4.840     2.420    24.200     9.680");
  expect_in("3.640     1.820    18.200     7.280");
  expect_in("closest: worst edge 31.3 %, p99 15.6 %, surface 156 %, its p99 62.5 % at 2 ms");
  expect_in("by worst edge: bounded at 1 % (1.00 ms) is 9.0 times faster than Bullet at 5 %");
  expect_in("by 99th percentile: bounded at 1 % (1.00 ms) is 4.0 times faster than Bullet at 5 %");
}

TEST(BenchPlot, HasWorstEdgeAnd99thPercentileOfEveryEngine) {
  const std::vector<Plot> plots = bench_plots(made_results());
  ASSERT_EQ(plots.size(), 1U);
  std::map<std::string, std::vector<DataPoint>> curves;
  for (const Curve& curve : plots[0].curves) {
    curves[curve.name] = curve.points;
  }
  ASSERT_EQ(curves.size(), 6U);
  const std::vector<DataPoint> worst = {{4.0, 8.22}, {9.0, 3.64}}, p99 = {{4.0, 4.11}, {9.0, 1.82}};
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(curves.at("Bullet, worst edge").at(i)[1], worst[i][1], 1e-9);
    EXPECT_NEAR(curves.at("Bullet, 99th percentile").at(i)[1], p99[i][1], 1e-9);
  }
  for (const char* engine : {"bounded", "strong"}) {
    EXPECT_EQ(curves.count(std::string(engine) + ", worst edge"), 1U);
    EXPECT_EQ(curves.count(std::string(engine) + ", 99th percentile"), 1U);
  }
}

TEST(BenchJson, HasWorstEdgeAnd99thPercentileOfEveryEngine) {
  const auto heat = nlohmann::json::parse(bench_json(made_results(), {}))["heats"][0];
  for (const auto& cell : heat["cells"]) {
    EXPECT_EQ(cell["max_p99_stretch"].get<double>(), 0.5 * cell["max_stretch"].get<double>());
    const auto& run = heat["runs"][cell["run"].get<std::size_t>()];
    for (const auto& place : {cell, run}) {
      EXPECT_EQ(place["max_surface_stretch"].get<double>(), 5.0 * cell["max_stretch"].get<double>());
      EXPECT_EQ(place["max_p99_surface_stretch"].get<double>(), 2.0 * cell["max_stretch"].get<double>());
    }
    EXPECT_EQ(run["bound_holds"].is_null(), run["bound"].is_null());
  }
  EXPECT_EQ(heat["runs"][0]["bound_holds"], "springs");
  EXPECT_EQ(heat["ratios"][0]["by"], "worst edge");
  EXPECT_EQ(heat["ratios"][1]["by"], "99th percentile");
  EXPECT_EQ(heat["ratios"][1]["times_faster"], 4.0);
  for (const char* engine : {"bounded", "bullet", "strong"}) {
    EXPECT_TRUE(heat["pareto_fronts_p99"].contains(engine));
  }
}

TEST(BenchJson, SaysForEveryCellWhetherItsBoundWasKept) {
  BenchResults results;
  results.bounds = {0.05, 0.01};
  results.heats.push_back({bench_scenes()[0], bench_sizes()[0], 10, 0, {}, {{"sse", 1e9}, {"avx2", 2e9}}});
  results.heats[0].runs = {made_run("strong", {}, {4.0, 4.0}, 0.03),
                           made_run("strong", {}, {2.0, 2.0}, 0.07)};
  const auto json = nlohmann::json::parse(bench_json(results, {}));
  const auto& heat = json["heats"][0];
  ASSERT_EQ(heat["cells"].size(), 2U);
  EXPECT_EQ(heat["cells"][0]["kept"], true);
  EXPECT_EQ(heat["cells"][0]["run"], 0);
  EXPECT_EQ(heat["cells"][0]["median_ms"], 4.0);
  EXPECT_EQ(heat["cells"][1]["kept"], false);
  EXPECT_EQ(heat["pareto_fronts"]["strong"], (nlohmann::json{1, 0}));
  EXPECT_EQ(heat["runs"][1]["frames_over"][0]["frames"], 2);
  EXPECT_NEAR(heat["cells"][0]["of_sweep"].get<double>(), 1e6 / 4e-3 / 2e9, 1e-9);
  EXPECT_EQ(heat["sweeps"][1], (nlohmann::json{{"vector_unit", "avx2"}, {"springs_per_s", 2e9}}));
  EXPECT_EQ(heat["cells"][0]["times_strong_projections_per_s"], 0.5);
}

}  // namespace
}  // namespace taut::app
