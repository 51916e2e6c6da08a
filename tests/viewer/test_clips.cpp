// Clips of what is simulated, which the window writes for other programs.

#include <gtest/gtest.h>

#include <functional>

#include "app/bodies/point_cache.hpp"
#include "app/models/garment_loading.hpp"
#include "person.hpp"
#include "temporary_folder.hpp"

namespace taut::app {
namespace {

namespace fs = std::filesystem;
namespace keys = renderer::keys;

struct Clips : testing::Test {
  test::TemporaryFolder folder;
  test::Person person{"pinned-9x9-5", {}, folder / ""};
  const ViewerState& state = person.viewer.state();
  const fs::path file = folder / "pinned-9x9-5-1-clip/pinned-9x9-5.pc2";

  std::string said() const { return state.messages.empty() ? "" : state.messages.back().text; }
  int frame() const { return state.newest->record.frame; }
  /// Draws so slowly that some frames are never shown.
  void wait_slowly(int frames) {
    for (int i = 0; i < frames; ++i) {
      SessionFrame late;
      late.elapsed_s = 0.05;
      person.viewer.update(late);
    }
  }
  void expect_frames(int first, int last) const {
    const auto cache = open_pc2(file);
    ASSERT_EQ(cache->frames(), static_cast<std::size_t>(last - first + 1));
    sim::Simulation simulation = make_simulation(state.scene, *state.newest->loaded);
    std::vector<sim::Vec3> written(cache->vertices());
    for (int frame = 0; frame <= last; ++frame) {
      if (frame >= first) {
        cache->read(static_cast<std::size_t>(frame - first), written);
        EXPECT_EQ(glm::vec3(written[40]), glm::vec3(simulation.state().current[40])) << frame;
      }
      simulation.advance_frame();
    }
  }
};

TEST_F(Clips, HaveEveryFrameOnceWhateverIsDrawn) {
  person.press('X');
  const int first = frame() - 1;
  EXPECT_TRUE(state.clip);
  wait_slowly(20);
  person.press(keys::space);
  const int paused = frame();
  EXPECT_GT(paused, first + 50);
  person.wait(10);
  EXPECT_EQ(state.clip->frames, paused - first + 1);
  EXPECT_EQ(state.clip->file, "pinned-9x9-5.pc2");
  EXPECT_TRUE(person.shows("keep.clip_frames"));
  person.press(keys::period);
  person.press(keys::space);
  wait_slowly(5);
  person.press(keys::space);
  person.press('X');
  EXPECT_FALSE(state.clip);
  EXPECT_CONTAINS(said(), "wrote " + file.string() + ", ");
  expect_frames(first, frame());
  person.click("keep.clip");
  EXPECT_TRUE(fs::exists(folder / "pinned-9x9-5-2-clip")) << "another name";
}

TEST_F(Clips, EndWhereTimeGoesBack) {
  person.wait(10);
  person.press('X');
  const int first = frame() - 1;
  person.wait(10);
  person.click("timeline");
  EXPECT_TRUE(state.clip) << "the past is only looked at";
  const int last = frame();
  person.press(keys::space);
  person.wait(3);
  ASSERT_LT(frame(), last);
  EXPECT_FALSE(state.clip);
  EXPECT_CONTAINS(said(), "wrote " + file.string());
  EXPECT_CONTAINS(said(), "; it ended as the simulation began elsewhere");
  expect_frames(first, last);
}

TEST_F(Clips, EndWithTheirRunAndTheirScene) {
  for (const auto& end : std::vector<std::function<void()>>{[&] { person.press('R'); },
                                                            [&] { person.click("preset.pinned-9x9-20"); }}) {
    person.press('X');
    person.wait(5);
    EXPECT_TRUE(state.clip);
    end();
    person.wait(3);
    EXPECT_FALSE(state.clip);
  }
  EXPECT_EQ(open_pc2(file)->frames(), 8U);
  EXPECT_TRUE(fs::exists(folder / "pinned-9x9-5-2-clip/pinned-9x9-5.pc2"));
}

TEST_F(Clips, BeginWithThePresent) {
  person.wait(10);
  person.click("timeline");
  person.press('X');
  EXPECT_FALSE(state.clip);
  EXPECT_CONTAINS(said(), "this is past");
}

TEST_F(Clips, AreCompletedWithTheWindow) {
  person.press('X');
  person.wait(5);
  const std::vector<std::string> outcomes = person.viewer.finish_recordings();
  ASSERT_EQ(outcomes.size(), 1U);
  EXPECT_CONTAINS(outcomes[0], "wrote " + file.string() + ", 7 frames");
  EXPECT_EQ(open_pc2(file)->frames(), 7U);
}

TEST_F(Clips, SayWhatCannotBeWritten) {
  folder.write("file", "");
  test::Person elsewhere("pinned-9x9-5", {}, folder / "file");
  elsewhere.press('X');
  EXPECT_FALSE(elsewhere.viewer.state().clip);
  EXPECT_CONTAINS(elsewhere.viewer.state().messages.back().text, "cannot make the output folder '");
  EXPECT_TRUE(elsewhere.viewer.state().messages.back().is_error);

  person.click("keep.clip_format");
  person.click("keep.clip_format.OBJ");
  person.press('X');
  ASSERT_TRUE(state.clip);
  EXPECT_CONTAINS(state.clip->file, "pinned-9x9-5_00");
  fs::remove_all(file.parent_path());
  for (int i = 0; i < 500 && state.clip; ++i) {
    person.wait(1);
  }
  EXPECT_FALSE(state.clip);
  EXPECT_CONTAINS(said(), "cannot write '" + file.parent_path().string());
}

// What the window cannot look back on any more cannot be written either.
TEST_F(Clips, EndRatherThanLeaveFramesOut) {
  person.press('X');
  person.wait(3);
  const int last = frame();
  for (int i = 0; i < 300; ++i) {
    person.simulation.begin_frame(0.05, std::nullopt);
  }
  person.wait(1);
  EXPECT_FALSE(state.clip);
  EXPECT_CONTAINS(said(), "; it ended as frames could not be written as fast as they were simulated");
  expect_frames(last - 4, last);
}

}  // namespace
}  // namespace taut::app
