#include <gtest/gtest.h>

#include <csignal>
#include <numeric>

#include "app/base/errors.hpp"
#include "app/drawing/drawn_scene.hpp"
#include "app/frame_loop.hpp"
#include "app/models/garment_loading.hpp"
#include "app/output/output_pattern.hpp"
#include "app/runs/frame_record.hpp"
#include "sim/mesh/grid.hpp"
#include "temporary_folder.hpp"

namespace taut::app {
namespace {

sim::Simulation small_cloth() {
  sim::Mesh mesh = sim::make_grid({.columns = 3, .rows = 3});
  return {sim::share(sim::make_garment(std::move(mesh))), {0, 2}, {}, {}};
}

TEST(FrameLoop, MeasuresEveryFrameFromOneOn) {
  sim::Simulation simulation = small_cloth();
  const auto records = run_frames(simulation, 5, {});
  ASSERT_EQ(records.size(), 5U);
  EXPECT_EQ(records.front().frame, 1);
  EXPECT_NEAR(records.back().time_s, 5.0 / 60.0, 1e-12);
  EXPECT_EQ(records.back().state_hash, sim::hash(simulation.state()));
  EXPECT_NE(records[0].state_hash, records[1].state_hash);
  EXPECT_GT(records.back().rms_speed_m_per_s, 0.0);
}

TEST(FrameLoop, EndsBeforeAFrameThatCannotBeMade) {
  DrawnScene scene = read_scene_file(TAUT_TESTS_FOLDER "/contact/closing_spheres.toml");
  for (const bool overlap : {false, true}) {
    sim::Simulation simulation = make_simulation(scene, load_garment(scene));
    std::vector<int> pictures(30);
    std::iota(pictures.begin(), pictures.end(), 1);
    std::vector<int> drawn, reported, shapes;
    FrameOutputs outputs;
    outputs.pictures = pictures;
    outputs.overlap = overlap;
    outputs.draw = [](const FrameInWork&) { return renderer::make_image(1, 1); };
    outputs.write_frame = [&](const FrameRecord& record, const auto&) { drawn.push_back(record.frame); };
    outputs.write_shape = [&](int frame, const auto&, const auto&) { shapes.push_back(frame); };
    outputs.report = [&](const FrameRecord& record) { reported.push_back(record.frame); };
    try {
      run_frames(simulation, 30, outputs);
      FAIL() << "it went on";
    } catch (const FrameBlocked& error) {
      EXPECT_CONTAINS(std::string(error.what()),
                      "frame " + std::to_string(error.frame) + ": something would cross at 0.2");
      EXPECT_NEAR(error.frame, 15, 1);
      const std::vector<int> before(pictures.begin(), pictures.begin() + error.frame - 1);
      EXPECT_EQ(reported, before);
      EXPECT_EQ(drawn, before);
      EXPECT_EQ(shapes, before);
    }
  }
}

TEST(FrameLoop, CountsFramesInWhichTheSceneAcceptsACrossing) {
  DrawnScene scene = read_scene_file(TAUT_TESTS_FOLDER "/contact/closing_spheres.toml");
  scene.simulation.solver.bounded.allow_crossing = true;
  sim::Simulation simulation = make_simulation(scene, load_garment(scene));
  RunSummary summary;
  for (const FrameRecord& record : run_frames(simulation, 20, {})) {
    summary.add(record);
  }
  EXPECT_GT(summary.frames_blocked, 0);
  EXPECT_NEAR(summary.first_frame_blocked, 15, 1);
  EXPECT_EQ(summary.frames_over_bound, 0) << "which is another promise";
  testing::internal::CaptureStderr();
  EXPECT_EQ(judge_bound(scene, summary), 0);
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_CONTAINS(said, "of 20 frames pins or bodies closed in so that");
}

TEST(FrameLoop, EndsWithAFrameThatBreaksAPromise) {
  for (const bool overlap : {false, true}) {
    sim::Simulation simulation = small_cloth();
    const std::vector<int> pictures = {2, 3, 4, 5, 6};
    std::vector<int> checked, drawn, written, reported;
    FrameOutputs outputs;
    outputs.pictures = pictures;
    outputs.overlap = overlap;
    outputs.verify = [&](const sim::Simulation&, FrameRecord& record) {
      checked.push_back(record.frame);
      return record.frame == 4 ? "frame 4 is broken" : "";
    };
    outputs.draw = [&](const FrameInWork&) { return renderer::Image{}; };
    outputs.write_frame = [&](const FrameRecord& record, const auto&) { drawn.push_back(record.frame); };
    outputs.write_shape = [&](int frame, const sim::Simulation&, const auto&) { written.push_back(frame); };
    outputs.report = [&](const FrameRecord& record) { reported.push_back(record.frame); };
    EXPECT_EQ(test::error_message<PromiseBroken>([&] { run_frames(simulation, 6, outputs); }), "frame 4 is broken");
    checked.resize(5);  // overlapped checks may have begun with later frames
    EXPECT_EQ(checked, (std::vector<int>{0, 1, 2, 3, 4})) << "the start too";
    EXPECT_EQ(reported, (std::vector<int>{1, 2, 3, 4}));
    EXPECT_EQ(drawn, (std::vector<int>{2, 3}));
    EXPECT_EQ(std::count(written.begin(), written.end(), 4), 0);
  }
}

TEST(FrameLoop, VerifiesAStartThatIsNotHandedOut) {
  sim::Simulation simulation = small_cloth();
  FrameOutputs outputs;
  outputs.verify = [](const sim::Simulation&, FrameRecord& record) {
    return record.frame == 0 ? "the start is broken" : "";
  };
  outputs.report = [](const FrameRecord& record) { ADD_FAILURE() << record.frame; };
  EXPECT_EQ(test::error_message<PromiseBroken>([&] { run_frames(simulation, 6, outputs); }), "the start is broken");
}

TEST(FrameLoop, DrawsAndWritesTheFramesAskedFor) {
  sim::Simulation simulation = small_cloth();
  const std::vector<int> pictures = {0, 2, 3};
  std::vector<int> written;
  std::vector<std::vector<sim::Vec3>> drawn;
  int reported = 0;
  FrameOutputs outputs;
  outputs.pictures = pictures;
  outputs.draw = [&](const FrameInWork& frame) {
    drawn.push_back(frame.positions);
    return renderer::Image{};
  };
  outputs.write_frame = [&](const FrameRecord& record, const renderer::Image&) { written.push_back(record.frame); };
  outputs.report = [&](const FrameRecord&) { ++reported; };
  const auto records = run_frames(simulation, 4, outputs);
  EXPECT_EQ(written, pictures);
  ASSERT_EQ(drawn.size(), 3U);
  EXPECT_EQ(drawn[0], simulation.garment().mesh.positions) << "frame 0 is the cloth as modelled";
  EXPECT_NE(drawn[1], drawn[0]);
  EXPECT_NE(drawn[2], simulation.state().current) << "frame 3, not the last one";
  ASSERT_EQ(records.size(), 5U);
  EXPECT_EQ(records.front().frame, 0);
  EXPECT_EQ(reported, 5);
}

TEST(FrameLoop, HandsOutEveryShape) {
  sim::Simulation simulation = small_cloth();
  std::vector<int> frames;
  FrameOutputs outputs;
  outputs.write_shape = [&](int frame, const sim::Simulation&, const auto&) { frames.push_back(frame); };
  run_frames(simulation, 3, outputs);
  EXPECT_EQ(frames, (std::vector{1, 2, 3}));
}

TEST(FrameLoop, ComputesWhatIsShownOnceForDrawingAndWriting) {
  sim::Simulation simulation = small_cloth();
  const std::vector<int> pictures = {1, 2};
  int shown = 0;
  std::vector<std::vector<sim::Vec3>> drawn;
  std::vector<std::vector<sim::Vec3>> written;
  FrameOutputs outputs;
  outputs.pictures = pictures;
  outputs.show = [&](std::span<const sim::Vec3> positions_m) {
    ++shown;
    return std::vector(1, positions_m.back());
  };
  outputs.write_shape = [&](int, const sim::Simulation& moment, const auto& shown_m) {
    EXPECT_EQ(shown_m, std::vector(1, moment.state().current.back()));
    written.push_back(shown_m);
  };
  outputs.draw = [&](const FrameInWork& frame) {
    drawn.push_back(frame.shown_m);
    return renderer::Image{};
  };
  outputs.write_frame = [](const FrameRecord&, const renderer::Image&) {};
  run_frames(simulation, 2, outputs);
  EXPECT_EQ(shown, 2);
  EXPECT_EQ(written.size(), 2U);
  EXPECT_EQ(drawn, written);
}

TEST(FrameLoop, HandsOutTheClothAsModelledWhereItIsAskedFor) {
  sim::Simulation simulation = small_cloth();
  const std::vector<sim::Vec3> modelled = simulation.garment().mesh.positions;
  std::vector<int> frames;
  FrameOutputs outputs;
  outputs.with_start = true;
  outputs.write_shape = [&](int frame, const sim::Simulation& moment, const auto&) {
    EXPECT_EQ(moment.state().current == modelled, frame == 0);
    frames.push_back(frame);
  };
  EXPECT_EQ(run_frames(simulation, 2, outputs).size(), 3U);
  EXPECT_EQ(frames, (std::vector{0, 1, 2}));
}

TEST(FrameLoop, GoesOnFromAnyFrame) {
  sim::Simulation whole = small_cloth();
  const auto expected = run_frames(whole, 6, {});
  sim::Simulation simulation = small_cloth();
  run_frames(simulation, 3, {});
  FrameOutputs outputs;
  outputs.start_frame = 3;
  outputs.with_start = true;
  const auto records = run_frames(simulation, 6, outputs);
  ASSERT_EQ(records.size(), 4U);
  for (std::size_t i = 0; i < records.size(); ++i) {
    EXPECT_EQ(records[i].frame, static_cast<int>(i) + 3);
    EXPECT_EQ(records[i].state_hash, expected[i + 2].state_hash);
  }
}

TEST(FrameLoopDeathTest, StopsAtTheNextFrameWhenInterrupted) {
  const auto interrupted_run = [] {
    watch_for_interruption();
    sim::Simulation simulation = small_cloth();
    int frames = 0;
    FrameOutputs outputs;
    outputs.report = [&](const FrameRecord& record) {
      frames = record.frame;
      if (record.frame == 2) {
        std::raise(SIGTERM);
      }
    };
    try {
      run_frames(simulation, 1000, outputs);
    } catch (const Interrupted& interrupted) {
      std::exit(interrupted.signal == SIGTERM && frames == 2 ? 42 : 1);
    }
    std::exit(1);
  };
  EXPECT_EXIT(interrupted_run(), testing::ExitedWithCode(42), "");
}

TEST(FrameRange, HasOpenEndsAndALast) {
  const auto range_of = [](const std::string& text) {
    const FrameRange range = frame_range(text, 90);
    return std::pair(range.first, range.last);
  };
  EXPECT_EQ(range_of("5"), std::pair(5, 5));
  EXPECT_EQ(range_of("3:7"), std::pair(3, 7));
  EXPECT_EQ(range_of("0:"), std::pair(0, 90));
  EXPECT_EQ(range_of(":10"), std::pair(0, 10));
  EXPECT_EQ(range_of(":"), std::pair(0, 90));
  EXPECT_EQ(range_of("last"), std::pair(90, 90));
  const auto count_of = [](const std::string& text) {
    const FrameRange range = frame_range(text, 90, NumberMeans::count);
    return std::pair(range.first, range.last);
  };
  EXPECT_EQ(count_of("30"), std::pair(0, 29)) << "30 frames";
  EXPECT_EQ(count_of("last"), std::pair(90, 90));
  EXPECT_EQ(count_of("3:7"), std::pair(3, 7));
  EXPECT_CONTAINS(test::error_message<UsageError>([&] { count_of("0"); }), "at least one frame");
  EXPECT_EQ(range_of("80:last"), std::pair(80, 90));
  EXPECT_EQ(range_of("100:200"), std::pair(100, 200)) << "a run may be longer than its scene says";
}

TEST(FrameRange, SaysWhatItExpects) {
  const auto error = [](const std::string& text) {
    return test::error_message<UsageError>([&] { frame_range(text, 90); });
  };
  EXPECT_CONTAINS(error("1:x"), "--frames 1:x: found 'x', expected a frame from 0");
  EXPECT_CONTAINS(error("-1"), "--frames -1: found '-1'");
  EXPECT_CONTAINS(error("1:2:3"), "found '2:3'");
  EXPECT_CONTAINS(error("91:"), "--frames 91:: the last frame, 90, comes before the first, 91");
}

RunSummary summarise(const std::vector<FrameRecord>& records) {
  RunSummary summary;
  for (const FrameRecord& record : records) {
    summary.add(record);
  }
  return summary;
}

TEST(RunSummary, FindsTheWorstFrameAndTheRest) {
  std::vector<FrameRecord> records(4);
  for (int i = 0; i < 4; ++i) {
    records[static_cast<std::size_t>(i)].frame = i + 1;
    records[static_cast<std::size_t>(i)].sim_ms = 2.0;
  }
  records[1].stretch.max = 0.3;
  records[2].surface_stretch = {0.5, 0.4};
  records[3].surface_stretch = {0.2, 0.1};
  records[3].stretch.max = 0.1;
  records[2].asleep = records[3].asleep = true;
  const RunSummary summary = summarise(records);
  EXPECT_EQ(summary.max_stretch, 0.3);
  EXPECT_EQ(summary.max_stretch_frame, 2);
  EXPECT_EQ(summary.final_max_stretch, 0.1);
  EXPECT_EQ(summary.max_surface_stretch, 0.5);
  EXPECT_EQ(summary.max_surface_stretch_frame, 3);
  EXPECT_EQ(summary.max_p99_surface_stretch, 0.4);
  EXPECT_EQ(summary.final_max_surface_stretch, 0.2);
  EXPECT_EQ(summary.asleep_since_frame, 3);
  EXPECT_EQ(summary.mean_sim_ms(), 2.0);
  records.back().asleep = false;
  EXPECT_EQ(summarise(records).asleep_since_frame, -1);
}

TEST(FrameRecord, IsWithinTheBoundOfWhatItHolds) {
  using enum sim::BoundKind;
  FrameRecord record;
  record.stretch.max = 0.01;
  record.surface_stretch.max = 0.02;
  EXPECT_TRUE(is_within({.bound = springs, .max_stretch = 0.01}, record));
  EXPECT_FALSE(is_within({.bound = surface, .max_stretch = 0.01}, record));
  EXPECT_TRUE(is_within({.bound = surface, .max_stretch = 0.02 - 0.5 * bound_rounding}, record));
  EXPECT_FALSE(is_within({.bound = surface, .max_stretch = 0.02 - 2.0 * bound_rounding}, record));
  record.surface_stretch.max = 0.0;
  for (const sim::BoundKind bound : sim::all_bound_kinds) {
    EXPECT_FALSE(is_within({.bound = bound, .max_stretch = 0.009}, record)) << "springs are held by both";
  }
}

TEST(FrameRecord, MeasuresWhatTheBoundHolds) {
  for (const sim::BoundKind bound : sim::all_bound_kinds) {
    DrawnScene scene = find_scene("pinned-9x9-20", {});
    scene.simulation.solver.kind = sim::SolverKind::bounded;
    scene.simulation.solver.bounded = {.bound = bound, .max_stretch = 0.01, .allow_exceeding = true};
    sim::Simulation simulation = make_simulation(scene, load_garment(scene));
    for (const FrameRecord& record : run_frames(simulation, 20, {})) {
      EXPECT_GE(record.surface_stretch.max, record.stretch.max - 1e-12) << "a spring is one direction of many";
      if (record.frame > 0 && simulation.frame_report().bound_kept) {
        EXPECT_EQ(record.bound_kept, is_within(scene.simulation.solver.bounded, record)) << record.frame;
      }
    }
    const FrameRecord last = measure_frame(simulation, 20);
    const double expected = sim::measure_surface_stretch(simulation.garment(), simulation.state().current).max;
    EXPECT_EQ(last.surface_stretch.max, expected);
    EXPECT_GT(expected, 0.001);
  }
}

TEST(BoundVerdict, SaysWhatExceedsTheBoundAndByHowMuch) {
  std::vector<FrameRecord> records(2);
  records[1].frame = 1;
  records[1].bound_kept = false;
  records[1].stretch.max = 0.04;
  records[1].surface_stretch.max = 0.25;
  Scene scene;
  scene.simulation.solver.bounded.max_stretch = 0.05;
  const auto said = [&](sim::BoundKind bound) {
    scene.simulation.solver.bounded.bound = bound;
    testing::internal::CaptureStderr();
    EXPECT_EQ(judge_bound(scene, summarise(records)), 3);
    return testing::internal::GetCapturedStderr();
  };
  EXPECT_CONTAINS(said(sim::BoundKind::surface),
                  "1 of 2 frames exceeds solver.max_stretch = 0.05 of the surface, the first is frame 1; "
                  "springs are stretched by up to 0.04; the surface is stretched by up to 0.25, 0.2 too much.");
  records[1].stretch.max = 0.06;
  const std::string of_springs = said(sim::BoundKind::springs);
  EXPECT_CONTAINS(of_springs,
                  "0.05 of the springs, the first is frame 1; springs are stretched by up to "
                  "0.06, 0.01 too much. Pins");
  EXPECT_EQ(of_springs.find("surface"), std::string::npos) << "which is not held";
}

TEST(BoundVerdict, EndsTheProgramAsASchedulerCanTell) {
  std::vector<FrameRecord> records(2);
  Scene scene;
  EXPECT_EQ(judge_bound(scene, summarise(records)), 0);
  records[1].bound_kept = false;
  EXPECT_EQ(judge_bound(scene, summarise(records)), 3);
  scene.simulation.solver.bounded.allow_exceeding = true;
  EXPECT_EQ(judge_bound(scene, summarise(records)), 0);
}

}  // namespace
}  // namespace taut::app
