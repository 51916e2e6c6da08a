#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "app/bench/bench.hpp"
#include "app/bodies/body_loading.hpp"
#include "app/drawing/drawn_scene.hpp"
#include "sim/solvers/bounded/kernels/kernels.hpp"
#include "temporary_folder.hpp"

namespace taut::app {
namespace {

/// A sheet of 5 by 5 that falls on a ball, whose top begins `depth_m` above the sheet.
Scene falling_sheet(double depth_m, double max_stretch = 0.01) {
  Scene scene;
  scene.garment.grid = {.columns = 5, .rows = 5, .plane = sim::GridPlane::horizontal};
  scene.pins.emplace();
  scene.simulation.solver.kind = sim::SolverKind::bounded;
  scene.simulation.solver.bounded = {.max_stretch = max_stretch, .contact = true, .threads = 1};
  const sim::Vec3 middle_m = load_garment(scene).garment->mesh.positions[12];
  scene.bodies = {{.body = {.name = "ball", .shape = sim::Sphere{middle_m - sim::Vec3(0.0, 0.2 - depth_m, 0.0), 0.2}}}};
  return scene;
}

ContactRun make_run(const Scene& scene, int frames, std::uint64_t seed = 0) {
  return run_contact(scene, load_garment(scene), load_bodies(scene).all, frames, seed, [](int, sim::Simulation&) {});
}

TEST(ContactBench, StartsAreMovedAtRandomAndCanBeRepeated) {
  Scene scene = falling_sheet(-0.01);
  scene.pins = {{sim::Index{3}}};
  const LoadedGarment cloth = load_garment(scene);
  const std::vector<sim::Vec3>& rest_m = cloth.garment->mesh.positions;
  const auto start_m = jittered_start(cloth, 0.002, 7);
  EXPECT_EQ(start_m, jittered_start(cloth, 0.002, 7));
  EXPECT_NE(start_m, jittered_start(cloth, 0.002, 8));
  EXPECT_EQ(start_m[3], rest_m[3]) << "pinned";
  // The generator gives the same numbers on every machine.
  EXPECT_NEAR(start_m[0].x - rest_m[0].x, 5.0877061e-05, 1e-12);
  double max_distance_m = 0.0;
  for (std::size_t v = 0; v < rest_m.size(); ++v) {
    for (int axis = 0; axis < 3; ++axis) {
      max_distance_m = std::max(max_distance_m, std::abs(start_m[v][axis] - rest_m[v][axis]));
    }
  }
  EXPECT_LE(max_distance_m, jitter_fraction * 0.002);
  EXPECT_GT(max_distance_m, 0.8 * jitter_fraction * 0.002);
}

TEST(ContactBench, DragsTheWindUpAndBack) {
  const Scene scene = falling_sheet(-0.01);
  const LoadedGarment cloth = load_garment(scene);
  std::vector<double> speeds_m_per_s;
  run_contact(scene, cloth, named_bodies(scene), 4, 0, [&](int frame, sim::Simulation& simulation) {
    drag_wind(frame, 4, 20.0, simulation);
    speeds_m_per_s.push_back(simulation.surroundings().forces.wind.speed_m_per_s);
  });
  EXPECT_EQ(speeds_m_per_s, (std::vector<double>{10.0, 20.0, 10.0, 0.0}));
}

TEST(ContactBench, TellsTheSlowestSecond) {
  ContactRun run;
  run.frames.resize(100);
  for (std::size_t k = 0; k < 100; ++k) run.frames[k].took_ms = run.frames[k].cpu_ms = k < 20 || k >= 80 ? 1.0 : 3.0;
  EXPECT_DOUBLE_EQ(summarise_contact({&run, 1}).slowest_second_ms, 3.0);
  run.frames.resize(40);
  EXPECT_DOUBLE_EQ(summarise_contact({&run, 1}).slowest_second_ms, 2.0);
}

TEST(ContactBench, ARunThatKeepsBothPromisesPasses) {
  const Scene scene = falling_sheet(-0.001);
  const ContactRun run = make_run(scene, 8);
  EXPECT_EQ(run.first_broken, "");
  EXPECT_EQ(run.frames.size(), 8U);
  const ContactFacts facts = summarise_contact({&run, 1});
  EXPECT_EQ(facts.passed_runs, 1U);
  EXPECT_EQ(facts.crossing_pairs + facts.broken_frames, 0U);
  EXPECT_GE(facts.detections, 1.0);
  EXPECT_GT(facts.max_pairs, 0);
  EXPECT_GT(facts.min_distance_m, 0.0);
  EXPECT_LE(facts.min_distance_m, 0.001 + 1e-6);
  EXPECT_GT(facts.stretch, 0.0005);
  EXPECT_LE(facts.stretch, 0.01 + 1e-9);
  const ContactRun moved = make_run(scene, 8, 1), again = make_run(scene, 8, 1);
  EXPECT_NE(moved.stretch, run.stretch);
  EXPECT_EQ(moved.stretch, again.stretch);
}

TEST(ContactBench, ARunThatBreaksAPromiseIsNamedAndGoesOn) {
  const Scene scene = falling_sheet(0.05);
  ContactTrial trial = {"needles", 0.01, 32, {make_run(falling_sheet(-0.001), 3), make_run(scene, 3, 5)}};
  EXPECT_CONTAINS(trial.runs[1].first_broken, "frame 0, 0.0000 s: ");
  EXPECT_CONTAINS(trial.runs[1].first_broken, "the body 'ball', the first: triangle ");
  EXPECT_EQ(trial.runs[1].frames.size(), 3U);
  const ContactFacts facts = summarise_contact(trial.runs);
  EXPECT_EQ(facts.passed_runs, 1U);
  EXPECT_EQ(facts.frames, 6U);
  EXPECT_GE(facts.broken_frames, 1U);
  EXPECT_GE(facts.crossing_pairs, trial.runs[1].start.crossing_pairs);
  EXPECT_GT(trial.runs[1].start.crossing_pairs, 0U);
  const std::string table = contact_row(trial);
  EXPECT_CONTAINS(table, "  1 of 2\n");
  EXPECT_CONTAINS(table, "\n  needles, start 5: frame 0, 0.0000 s: ");
  const std::string csv = contact_csv({&trial, 1});
  EXPECT_CONTAINS(csv, "scene,seed,triangles,bound,frames,median_ms,");
  EXPECT_CONTAINS(csv, "\nneedles,0,32,0.01,3,");
  EXPECT_CONTAINS(csv, "\nneedles,5,32,0.01,3,");
  EXPECT_CONTAINS(csv, trial.runs[1].first_broken);
}

TEST(ContactBench, HasTheScenesInWhichSomethingIsWorn) {
  std::vector<std::string> names;
  for (const ContactCase& one : all_contact_cases()) {
    names.push_back(one.name);
  }
  for (const char* name : {"tshirt-worn", "tshirt-walk", "tshirt-reach", "needles"}) {
    EXPECT_EQ(std::count(names.begin(), names.end(), name), 1) << name;
  }
  EXPECT_EQ(std::count(names.begin(), names.end(), "tshirt-gravity"), 0);
}

TEST(ContactBench, BodiesAreDressedBeforeTheStart) {
  DrawnScene scene = find_scene(
      "tshirt-worn", std::vector{parse_override("garment.file=\"" TAUT_ASSETS_FOLDER "/garments/tshirt_1028.obj\"")});
  const ContactRun dressed = make_run(scene, 1);
  EXPECT_EQ(dressed.start.crossing_pairs, 0U);
  EXPECT_EQ(dressed.first_broken, "");
  scene.bodies.front().source.dress = 0;
  EXPECT_GT(make_run(scene, 0).start.crossing_pairs, 0U) << "on a body that did not grow";
}

// The vector unit that is measured does not depend on any limit set for the library's own detection.
TEST(ContactBench, MeasuresTheVectorsThatMostProcessorsHave) {
  const std::vector<sim::VectorUnit> units = sim::available_vector_units();
  if (std::find(units.begin(), units.end(), sim::VectorUnit::avx2) == units.end()) {
    GTEST_SKIP() << "no AVX2 in this processor or this build";
  }
  EXPECT_STREQ(sim::to_name(measured_vector_unit()), "avx2");
  EXPECT_CONTAINS(contact_head(sim::to_name(measured_vector_unit()), 1), "with avx2. ");
  EXPECT_NE(&sim::bounded::kernels_for(sim::VectorUnit::avx2), &sim::bounded::kernels_for(sim::VectorUnit::sse));
}

TEST(ContactBench, FactsAreThoseOfAllFrames) {
  const sim::ContactReport near = {4, 2, 30, 1e-4}, far = {2, 0, 10, INFINITY};
  std::vector<ContactRun> runs(2);
  runs[0].frames = {{1.0, 2.0, 0.5, near, 0, false}, {9.0, 18.0, 1.0, far, 0, false}};
  runs[1].frames = {{2.0, 4.0, 1.5, far, 5, true}};
  runs[1].stretch = 0.02;
  runs[1].first_broken = "frame 1";
  const ContactFacts facts = summarise_contact(runs);
  EXPECT_EQ(facts.median_ms, 1.5) << "of the medians 1 and 2";
  EXPECT_EQ(facts.p99_ms, 2.0) << "between two frames the faster";
  EXPECT_EQ(facts.search_share, 3.0 / 24.0) << "of what all threads used";
  EXPECT_EQ(facts.worst_ms, 9.0);
  EXPECT_NEAR(facts.detections, 8.0 / 3.0, 1e-15);
  EXPECT_NEAR(facts.partial_detections, 2.0 / 3.0, 1e-15);
  EXPECT_EQ(facts.max_pairs, 30);
  EXPECT_EQ(facts.min_distance_m, 1e-4);
  EXPECT_EQ(facts.stretch, 0.02);
  EXPECT_EQ(facts.crossing_pairs, 5U);
  EXPECT_EQ(facts.broken_frames, 1U);
  EXPECT_EQ(summarise_contact({}).median_ms, 0.0);
}

}  // namespace
}  // namespace taut::app
