#include <gtest/gtest.h>

#include "app/drawing/drawn_scene_file.hpp"
#include "app/scene/promise.hpp"
#include "app/viewer/headless_viewer.hpp"
#include "sim/measures.hpp"

// What people did in the window and what went wrong, as it was recorded.

namespace taut::app {
namespace {

struct Replay {
  Session session;
  HeadlessViewer window;

  explicit Replay(const std::string& name, const std::vector<Override>& overrides = {})
      : session(read_session(std::filesystem::path(TAUT_SESSIONS_FOLDER) / name)),
        window(find_scene(session.start.scene, overrides), session.start, ".", "auto") {}
};

// ideal with 20 steps a frame, which are too few for its springs, then strong: the picture of what flew
// apart ended the program.
TEST(Replays, AClothThatFliesApartIsDrawnAndTheNextSolverStartsAnew) {
  Replay replay("crash.txt", {parse_override("solver.kind=\"ideal\""), parse_override("solver.substeps=20")});
  int drawn = 0;
  bool has_stopped = false;
  for (const SessionFrame& frame : replay.session.frames) {
    replay.window.play(frame);
    const Snapshot& newest = *replay.window.viewer().state().newest;
    has_stopped = has_stopped || newest.stopped;
    EXPECT_EQ(sim::first_lost(newest.positions()), newest.positions().size());
    if (newest.record.frame > 300 || newest.record.stretch.max > 1.0) {
      drawn += ++drawn % 6 == 0 ? replay.window.draw().height_px > 0 : 0;
    }
  }
  EXPECT_EQ(replay.window.draw().width_px, 1280);
  EXPECT_TRUE(has_stopped) << "this test would see nothing";
  EXPECT_EQ(replay.window.viewer().state().scene.simulation.solver.kind, sim::SolverKind::strong);
  for (int i = 0; i < 5; ++i) {
    replay.window.play({});
  }
  EXPECT_FALSE(replay.window.viewer().state().newest->stopped);
}

// Left to choose, ideal takes steps that are short enough.
TEST(Replays, NothingFliesApartOfItself) {
  Replay replay("crash.txt");
  for (const SessionFrame& frame : replay.session.frames) {
    replay.window.play(frame);
    EXPECT_FALSE(replay.window.viewer().state().newest->stopped);
  }
}

// A sleeve is pulled through the shirt. It ends inside out, as nothing but vertices of layers keeps cloth
// from passing through itself yet; once contact does, this test is to ask for an outside that stays outside.
// The bound on stretch holds all the way.
TEST(Replays, AShirtThatIsPulledThroughItselfKeepsItsBound) {
  Replay replay("inside_out.txt");
  for (const SessionFrame& frame : replay.session.frames) {
    replay.window.play(frame);
    const ViewerState& state = replay.window.viewer().state();
    ASSERT_FALSE(state.newest->stopped);
    EXPECT_TRUE(state.newest->record.bound_kept);
    EXPECT_LE(state.newest->record.stretch.max, *stretch_bound(state.newest->loaded->scene));
  }
  EXPECT_TRUE(replay.window.viewer().is_ended());
  EXPECT_EQ(replay.window.draw().width_px, 1280);
}

}  // namespace
}  // namespace taut::app
