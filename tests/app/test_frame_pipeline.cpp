#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>
#include <stdexcept>
#include <string>
#include <thread>

#include "app/frame_loop.hpp"
#include "sim/mesh/grid.hpp"

namespace taut::app {
namespace {

constexpr int frame_count = 40;

// Stages that record the frames they process. One stage can be made to fail.
struct Trace {
  int next = 1;
  std::vector<int> drawn;
  std::vector<int> written;
  std::string failing_stage;
  int failing_frame = 0;

  void fail_at(const std::string& stage, int frame) const {
    if (stage == failing_stage && frame == failing_frame) {
      throw std::runtime_error(stage + " failed");
    }
  }

  FrameStages stages() {
    FrameStages stages;
    stages.simulate = [this]() -> std::optional<FrameInWork> {
      fail_at("simulate", next);
      FrameInWork work;
      work.record.frame = next;
      return next++ > frame_count ? std::nullopt : std::optional(work);
    };
    stages.draw = [this](FrameInWork& work) {
      fail_at("draw", work.record.frame);
      drawn.push_back(work.record.frame);
    };
    stages.write = [this](FrameInWork& work) {
      fail_at("write", work.record.frame);
      written.push_back(work.record.frame);
    };
    return stages;
  }
};

TEST(FramePipeline, PassesEveryFrameThroughAllStagesInOrder) {
  Trace in_turn;
  run_in_turn(in_turn.stages());
  Trace overlapped;
  run_overlapped(overlapped.stages());
  ASSERT_EQ(in_turn.written.size(), 40U);
  EXPECT_EQ(overlapped.drawn, in_turn.drawn);
  EXPECT_EQ(overlapped.written, in_turn.written);
}

TEST(FramePipeline, AnErrorOfAnyStageComesOutAndEarlierFramesAreFinished) {
  for (const char* stage : {"simulate", "draw", "write"}) {
    for (const int frame : {1, 2, 17, frame_count}) {
      Trace trace;
      trace.failing_stage = stage;
      trace.failing_frame = frame;
      try {
        run_overlapped(trace.stages());
        FAIL() << stage << " at " << frame << " did not stop the run";
      } catch (const std::runtime_error& error) {
        EXPECT_EQ(error.what(), std::string(stage) + " failed");
      }
      EXPECT_EQ(trace.written.size(), static_cast<std::size_t>(frame - 1)) << stage;
      EXPECT_LE(trace.next, frame + 12) << stage << ": the simulation ran on";
    }
  }
}

TEST(FramePipeline, SimulatesAndDrawsLaterFramesWhileOneIsWritten) {
  std::promise<void> third_is_drawn;
  std::future<void> drawn = third_is_drawn.get_future();
  Trace trace;
  FrameStages stages = trace.stages();
  stages.draw = [&](FrameInWork& work) {
    if (work.record.frame == 3) {
      third_is_drawn.set_value();
    }
  };
  bool overlapped = false;
  stages.write = [&](FrameInWork& work) {
    if (work.record.frame == 1) {
      overlapped = drawn.wait_for(std::chrono::seconds(20)) == std::future_status::ready;
    }
  };
  run_overlapped(stages);
  EXPECT_TRUE(overlapped);
}

TEST(FramePipeline, AFastStageWaitsForASlowOne) {
  Trace trace;
  FrameStages stages = trace.stages();
  std::atomic<int> simulated = 0;
  const auto simulate = stages.simulate;
  stages.simulate = [&] {
    ++simulated;
    return simulate();
  };
  int max_frames_ahead = 0;
  stages.write = [&](FrameInWork& work) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    max_frames_ahead = std::max(max_frames_ahead, simulated - work.record.frame);
  };
  run_overlapped(stages);
  EXPECT_GT(max_frames_ahead, 0);
  EXPECT_LE(max_frames_ahead, 10);  // two queues of three frames, and the frames inside the stages
}

TEST(FramePipeline, GathersAllFramesBeforeItDrawsOne) {
  Trace trace;
  std::size_t gathered = 0;
  run_simulation_first(trace.stages(), [&](std::span<const FrameInWork> frames) {
    gathered = frames.size();
    EXPECT_TRUE(trace.drawn.empty());
  });
  EXPECT_EQ(gathered, static_cast<std::size_t>(frame_count));
  EXPECT_EQ(trace.written.size(), gathered);
  EXPECT_EQ(trace.written.front(), 1);
}

TEST(FramePipeline, DrawsWhatWasGatheredBeforeASimulationFailed) {
  Trace trace;
  trace.failing_stage = "simulate";
  trace.failing_frame = 17;
  EXPECT_THROW(run_simulation_first(trace.stages(), [](std::span<const FrameInWork>) {}), std::runtime_error);
  EXPECT_EQ(trace.written.size(), 16U);
}

TEST(FramePipeline, DrawsWhatWasGatheredBeforeAnInterruption) {
  Trace trace;
  FrameStages stages = trace.stages();
  stages.simulate = [next = 0]() mutable -> std::optional<FrameInWork> {
    if (++next > 3) {
      throw Interrupted(2);
    }
    return FrameInWork();
  };
  EXPECT_THROW(run_simulation_first(stages, [](std::span<const FrameInWork>) {}), Interrupted);
  EXPECT_EQ(trace.written.size(), 3U);
}

sim::Simulation small_cloth() {
  sim::Mesh mesh = sim::make_grid({.columns = 5, .rows = 5});
  return {sim::share(sim::make_garment(std::move(mesh))), {0, 4}, {}, {}};
}

// Makes a picture from the bytes of the positions.
renderer::Image draw_picture(const FrameInWork& frame) {
  renderer::Image image;
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(frame.positions.data());
  image.pixels.assign(bytes, bytes + frame.positions.size() * sizeof(sim::Vec3));
  return image;
}

struct Outcome {
  std::vector<FrameRecord> records;
  std::vector<std::vector<std::uint8_t>> pictures;
  std::vector<int> reported;
};

Outcome run_with(bool overlap) {
  Outcome run;
  sim::Simulation simulation = small_cloth();
  const std::vector<int> frames = {0, 1, 2, 3, 5, 8, 13, 14};
  FrameOutputs outputs;
  outputs.pictures = frames;
  outputs.overlap = overlap;
  outputs.draw = draw_picture;
  outputs.write_frame = [&](const FrameRecord& record, const renderer::Image& picture) {
    run.reported.push_back(record.frame);
    run.pictures.push_back(picture.pixels);
  };
  run.records = run_frames(simulation, 15, outputs);
  return run;
}

TEST(FrameLoop, OverlapChangesNeitherStatesNorPictures) {
  const Outcome in_turn = run_with(false);
  const Outcome overlapped = run_with(true);
  EXPECT_EQ(overlapped.reported, in_turn.reported);
  EXPECT_EQ(overlapped.pictures, in_turn.pictures);
  ASSERT_EQ(in_turn.records.size(), 16U);
  ASSERT_EQ(overlapped.records.size(), 16U);
  for (std::size_t i = 0; i < 16; ++i) {
    EXPECT_EQ(overlapped.records[i].frame, static_cast<int>(i));
    EXPECT_EQ(overlapped.records[i].state_hash, in_turn.records[i].state_hash);
  }
}

}  // namespace
}  // namespace taut::app
