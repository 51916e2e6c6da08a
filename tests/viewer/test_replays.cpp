#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <numeric>

#include "app/drawing/drawn_scene.hpp"
#include "app/scene/scene.hpp"
#include "app/verify/crossing_pairs.hpp"
#include "app/viewer/headless_viewer.hpp"
#include "sim/measures.hpp"

// Recorded sessions of people in the window in which something went wrong.

namespace taut::app {
namespace {

struct Replay {
  RecordedSession session;
  HeadlessViewer window;

  explicit Replay(const std::string& name, const std::vector<Override>& overrides = {})
      : session(read_session(std::filesystem::path(TAUT_SESSIONS_FOLDER) / name)),
        window(find_scene(session.start.scene, overrides), session.start, ".", "auto") {}
};

// First ideal with 20 substeps a frame, too few for its springs, then strong. The picture of the diverged cloth once
// ended the program.
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

// Without a fixed number of substeps, ideal takes substeps that are short enough.
TEST(Replays, NothingFliesApartOfItself) {
  Replay replay("crash.txt");
  for (const SessionFrame& frame : replay.session.frames) {
    replay.window.play(frame);
    EXPECT_FALSE(replay.window.viewer().state().newest->stopped);
  }
}

/// Volume that triangles enclose about their middle, in m^3; negative if their insides face outwards.
double enclosed_m3(std::span<const sim::Vec3> positions_m, std::span<const sim::Triangle> triangles) {
  const sim::Vec3 middle =
      std::reduce(positions_m.begin(), positions_m.end(), sim::Vec3(0.0)) / static_cast<double>(positions_m.size());
  double sum = 0.0;
  for (const auto& [a, b, c] : triangles) {
    sum += glm::dot(positions_m[a] - middle, glm::cross(positions_m[b] - middle, positions_m[c] - middle)) / 6.0;
  }
  return sum;
}

// One pull in a strong wind once left half the shirt inside out for good.
TEST(Replays, AShirtThatIsPulledHardCrossesNothingAndEndsRightSideOut) {
  Replay replay("inside_out.txt");
  constexpr int looked_at_every = 10;
  int frames = 0;
  for (const SessionFrame& frame : replay.session.frames) {
    replay.window.play(frame);
    const Snapshot& newest = *replay.window.viewer().state().newest;
    ASSERT_FALSE(newest.stopped);
    EXPECT_TRUE(newest.record.bound_kept);
    EXPECT_LE(newest.record.stretch.max, *stretch_bound(newest.loaded->scene));
    if (++frames % looked_at_every == 0) {
      const sim::Surface cloth = {newest.positions(), newest.loaded->garment->mesh.triangles};
      EXPECT_TRUE(crossing_pairs(cloth).empty()) << frames;
      EXPECT_GT(enclosed_m3(cloth.positions_m, cloth.triangles), 0.0) << frames;
    }
  }
  EXPECT_TRUE(replay.window.viewer().is_ended());
  EXPECT_EQ(replay.window.draw().width_px, 1280);
}

}  // namespace
}  // namespace taut::app
