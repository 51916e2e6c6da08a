#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "app/base/errors.hpp"
#include "app/scene/scene.hpp"
#include "app/viewer/panel/panel.hpp"
#include "app/viewer/picture/viewer_picture.hpp"
#include "app/viewer/simulation/live_simulation.hpp"
#include "app/viewer/state/viewer_state.hpp"
#include "app/viewer/viewer.hpp"
#include "sim/mesh/grid.hpp"
#include "sim/mesh/welding.hpp"

namespace taut::app {
namespace {

constexpr ViewArea area{960, 720};

OrbitCamera from_the_front() {
  renderer::Camera camera;
  camera.eye = {0.0F, 1.0F, 4.0F};
  camera.target = {0.0F, 1.0F, 0.0F};
  return OrbitCamera(camera);
}

TEST(OrbitCamera, IsTheCameraItWasMadeOf) {
  renderer::Camera camera;
  camera.eye = {1.0F, 2.0F, -3.0F};
  camera.target = {0.5F, 0.1F, 0.2F};
  camera.vertical_fov_rad = 0.4F;
  const renderer::Camera again = OrbitCamera(camera).camera();
  EXPECT_LT(glm::distance(again.eye, camera.eye), 1e-5F);
  EXPECT_EQ(again.target, camera.target);
  EXPECT_EQ(again.vertical_fov_rad, camera.vertical_fov_rad);
}

TEST(OrbitCamera, LooksFromTheSameSideWhereItComesFromTooFarOrTooNear) {
  for (const float times : {1e-3F, 1e3F}) {
    renderer::Camera camera;
    camera.eye = times * glm::vec3(3.0F, 4.0F, 0.0F);
    const glm::vec3 side = glm::normalize(OrbitCamera(camera).camera().eye);
    EXPECT_LT(glm::distance(side, glm::vec3(0.6F, 0.8F, 0.0F)), 1e-5F) << times;
  }
}

TEST(OrbitCamera, TurnsAboutItsTargetAndNeverOverThePole) {
  OrbitCamera camera = from_the_front();
  camera.orbit({360.0F, 0.0F}, area);  // a drag by half the height turns by a quarter
  EXPECT_LT(glm::distance(camera.camera().eye, glm::vec3(-4.0F, 1.0F, 0.0F)), 1e-4F);
  camera.orbit({0.0F, 1e6F}, area);
  EXPECT_LT(camera.camera().eye.y, 5.0F);
  EXPECT_GT(camera.camera().eye.y, 4.99F);
}

TEST(OrbitCamera, PanMovesWhatIsUnderThePointerWithIt) {
  OrbitCamera camera = from_the_front();
  const glm::vec3 target = camera.camera().target;
  const glm::vec2 before = *camera.project_to_pixel(target, area);
  camera.pan({50.0F, -30.0F}, area);
  const glm::vec2 after = *camera.project_to_pixel(target, area);
  EXPECT_NEAR(after.x - before.x, 50.0F, 0.01F);
  EXPECT_NEAR(after.y - before.y, -30.0F, 0.01F);
}

TEST(OrbitCamera, RayThroughAPixelLeadsToWhatIsSeenThere) {
  OrbitCamera camera = from_the_front();
  camera.orbit({77.0F, 55.0F}, area);
  const glm::vec3 point{0.3F, 1.2F, -0.4F};
  const Ray ray = camera.ray_through(*camera.project_to_pixel(point, area), area);
  const glm::vec3 way = point - ray.origin;
  EXPECT_LT(glm::length(glm::cross(way, ray.direction)), 1e-4F);
}

TEST(OrbitCamera, FramesABoxAndStaysWithinBoundsHoweverFarTheWheelTurns) {
  OrbitCamera camera = from_the_front();
  camera.zoom(1e9F, {5.0F, 700.0F}, area);
  camera.zoom(-1e9F, {950.0F, 3.0F}, area);
  camera.fit({{-1.0F, -1.0F, -1.0F}, {1.0F, 1.0F, 1.0F}}, area);
  for (const float x : {-1.0F, 1.0F}) {
    EXPECT_TRUE(area.contains(*camera.project_to_pixel({x, x, x}, area)));
  }
}

TEST(Picking, FindsTheNearestOfTwoTriangles) {
  const std::vector<sim::Vec3> positions = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, {-1, -1, -1}, {1, -1, -1}, {0, 1, -1}};
  const std::vector<sim::Triangle> triangles = {{3, 4, 5}, {0, 1, 2}};
  const auto picked = pick({{0.4F, -0.8F, 5.0F}, {0.0F, 0.0F, -1.0F}}, positions, triangles);
  ASSERT_TRUE(picked);
  EXPECT_EQ(picked->vertex, 1U);
  EXPECT_NEAR(picked->distance_m, 5.0, 1e-6);
  EXPECT_FALSE(pick({{3.0F, 0.0F, 5.0F}, {0.0F, 0.0F, -1.0F}}, positions, triangles));
  EXPECT_FALSE(pick({{0.0F, 0.0F, -5.0F}, {0.0F, 0.0F, -1.0F}}, positions, triangles)) << "behind the eye";
}

TEST(Picking, FindsWhatIsNearBesideWhatIsLost) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<sim::Triangle> triangles = {{3, 4, 5}, {0, 3, 1}, {0, 1, 2}};
  for (const double lost : {nan, inf, -inf, 1e30, 1e308}) {
    const std::vector<sim::Vec3> positions = {{-1, -1, 0},       {1, -1, 0},      {0, 1, 0},
                                              {lost, lost, 0.5}, {0, lost, lost}, {lost, -lost, lost}};
    const auto picked = pick({{0.4F, -0.8F, 5.0F}, {0.0F, 0.0F, -1.0F}}, positions, triangles);
    ASSERT_TRUE(picked) << lost;
    EXPECT_TRUE(std::isfinite(picked->distance_m) && std::isfinite(picked->point_m.x)) << lost;
  }
}

TEST(LostCloth, IsSaidWhereNothingOfItCanBeSeen) {
  const OrbitCamera camera = from_the_front();
  constexpr double inf = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<sim::Triangle> points = {{0, 0, 0}, {1, 1, 1}};
  const auto said = [&](const sim::Vec3& one, const sim::Vec3& other) {
    return lost_cloth(std::vector<sim::Vec3>{one, other}, points, camera, area);
  };
  EXPECT_EQ(said({0.0, 1.0, 0.0}, {0.0, -70.0, 0.0}), "") << "a part of it is seen";
  for (const double far : {-70.0, 70.0}) {
    EXPECT_NE(said({0.0, far, 0.0}, {far, 1.0, 0.0}).find("F looks at it"), std::string::npos);
  }
  EXPECT_NE(said({0.0, 1.0, 5.0}, {0.0, 1.0, 9.0}).find("F looks at it"), std::string::npos) << "behind the eye";
  for (const double far : {1e4, 1e30, inf, nan}) {
    EXPECT_NE(said({0.0, -far, 0.0}, {far, far, far}).find("left the world"), std::string::npos) << far;
  }
}

TEST(LostCloth, IsNotWhatFillsThePicture) {
  const std::vector<sim::Triangle> triangles = {{0, 1, 2}};
  const auto said = [&](double depth) {
    const std::vector<sim::Vec3> corners = {{-9.0, -9.0, depth}, {9.0, -9.0, depth}, {0.0, 30.0, depth}};
    return lost_cloth(corners, triangles, from_the_front(), area);
  };
  EXPECT_EQ(said(0.0), "");
  EXPECT_NE(said(3.99), "") << "nearer than anything that is drawn";
  EXPECT_NE(said(5.0), "") << "behind the eye";
}

TEST(BoundWord, PromisesOnlyWhatIsKept) {
  DrawnScene scene;
  scene.simulation.solver.kind = sim::SolverKind::bounded;
  EXPECT_STREQ(bound_word(scene), "bound");
  scene.simulation.solver.kind = sim::SolverKind::provot;
  EXPECT_STREQ(bound_word(scene), "threshold");
}

TEST(Measurements, SayBothStretches) {
  FrameRecord record;
  record.stretch.max = 0.0097;
  record.stretch.p99 = 0.005;
  record.surface_stretch = {0.223, 0.034};
  EXPECT_EQ(other_stretches(record, sim::BoundKind::springs), "largest of the surface 22.30 %\n99 of 100: surface 3.40 %, springs 0.50 %");
  EXPECT_EQ(other_stretches(record, sim::BoundKind::surface), "largest of springs 0.97 %\n99 of 100: surface 3.40 %, springs 0.50 %");
  record.surface_stretch.max = 1e30;
  EXPECT_EQ(other_stretches(record, sim::BoundKind::springs), "largest of the surface 1.0e+32 %\n99 of 100: surface 3.40 %, springs 0.50 %");
  Measurements measured;
  measured.add(record);
  EXPECT_EQ(measured.max_stretch.last(), 0.0097F);
  EXPECT_EQ(measured.max_surface_stretch.last(), 1e30F);
  measured.forget();
  EXPECT_TRUE(measured.max_surface_stretch.values().empty());
}

TEST(RealTime, IsWhatWentByLately) {
  RealTime time;
  EXPECT_FALSE(time.factor());
  for (int i = 0; i < 300; ++i) time.add(1.0 / 60.0, 0.5 / 60.0, 0.004);
  EXPECT_NEAR(*time.factor(), 0.5, 1e-6);
  EXPECT_NEAR(time.busy_share(), 0.24, 1e-6);
  for (int i = 0; i < 300; ++i) time.add(1.0 / 60.0, 1.0 / 60.0, 0.0);
  EXPECT_NEAR(*time.factor(), 1.0, 0.01);
  time.forget();
  EXPECT_FALSE(time.factor());
}

TEST(RealTime, TellsWhySimulatingIsSlow) {
  const double frame_ms = 1000.0 / 60.0;
  EXPECT_EQ(find_slowdown(0.99, 1.0, 12.0, frame_ms, 0.9), SlowedBy::nothing);
  EXPECT_EQ(find_slowdown(0.1, 0.1, 60.0, 10.0 * frame_ms, 0.0), SlowedBy::nothing) << "slow as asked";
  EXPECT_EQ(find_slowdown(0.3, 1.0, 55.0, frame_ms, 0.9), SlowedBy::simulation);
  EXPECT_EQ(find_slowdown(0.6, 1.0, 10.0, frame_ms, 0.8), SlowedBy::drawing);
  EXPECT_EQ(find_slowdown(0.6, 1.0, 10.0, frame_ms, 0.2), SlowedBy::other_programs);
}

TEST(Picking, DragsInThePlaneThatFacesTheCamera) {
  const OrbitCamera camera = from_the_front();
  const glm::dvec3 through(0.2, 1.1, -0.5);
  const auto point = drag_point(camera.ray_through({100.0F, 650.0F}, area), through, camera.camera());
  ASSERT_TRUE(point);
  EXPECT_NEAR(point->z, -0.5, 1e-6);
}

TEST(Grip, SharesThePullAndReachesNotFar) {
  sim::GridSettings grid;
  grid.columns = grid.rows = 101;
  const sim::Garment garment = sim::make_garment(sim::make_grid(grid));
  const sim::Index middle = 50 * 101 + 50;
  const Grip grip = take_grip(garment, garment.mesh.positions, middle);
  double total = 0.0;
  for (const GripVertex& held : grip.vertices) {
    total += held.share;
    EXPECT_LT(glm::length(held.offset_m), 0.03);
  }
  EXPECT_NEAR(total, 1.0, 1e-12);
  EXPECT_EQ(grip.vertices.front().vertex, middle);
  EXPECT_GT(grip.vertices.size(), 8U);
  EXPECT_LT(grip.vertices.size(), 40U);
}

TEST(Grip, MovesNoFasterThanAnArm) {
  const sim::Vec3 hand = moved_hand({0, 0, 0}, {1, 0, 0}, 0.01);
  EXPECT_NEAR(hand.x, 0.04, 1e-12);
  EXPECT_EQ(moved_hand(hand, {0.05, 0, 0}, 0.01), sim::Vec3(0.05, 0, 0));
}

LoadedScene no_scene(std::uint64_t generation = 1) { return {{}, DrawnScene(), {}, generation}; }

SnapshotPtr make_snapshot(const std::shared_ptr<const LoadedScene>& loaded, std::uint64_t serial, int frame) {
  Snapshot snapshot;
  snapshot.serial = serial;
  snapshot.loaded = loaded;
  sim::Checkpoint checkpoint;
  checkpoint.state.current.resize(3);
  snapshot.checkpoint = std::make_shared<const sim::Checkpoint>(std::move(checkpoint));
  snapshot.record.frame = frame;
  return std::make_shared<const Snapshot>(snapshot);
}

TEST(Timeline, ReachesTenSecondsBackAndForgetsWhatIsBeyond) {
  const auto loaded = std::make_shared<const LoadedScene>(no_scene());
  Timeline timeline;
  for (int frame = 0; frame <= 2000; ++frame) {
    timeline.add(make_snapshot(loaded, static_cast<std::uint64_t>(frame) + 1, frame));
  }
  const SnapshotPtr now = timeline.newest();
  EXPECT_EQ(first_frame_in_reach(*now), 1400);
  EXPECT_EQ(timeline.of_frame(now, 1400)->record.frame, 1400);
  EXPECT_EQ(timeline.of_frame(now, 1999)->record.frame, 1999);
  EXPECT_GT(timeline.of_frame(now, 3)->record.frame, 1000);
  EXPECT_EQ(timeline.with_serial(1500)->serial, 1500U);
}

TEST(Timeline, WhatWasBeforeAResetIsNotThePastOfWhatCameAfter) {
  const auto loaded = std::make_shared<const LoadedScene>(no_scene());
  Timeline timeline;
  timeline.add(make_snapshot(loaded, 1, 40));
  timeline.add(make_snapshot(loaded, 2, 41));
  const SnapshotPtr before = timeline.newest();
  timeline.add(make_snapshot(loaded, 3, 0));
  EXPECT_EQ(timeline.of_frame(timeline.newest(), 41)->serial, 3U);
  EXPECT_EQ(timeline.of_frame(before, 40)->serial, 1U) << "a window that is one snapshot behind";
  EXPECT_EQ(timeline.with_serial(2)->serial, 2U);
  timeline.add(make_snapshot(std::make_shared<const LoadedScene>(no_scene(2)), 4, 50));
  EXPECT_EQ(timeline.of_frame(timeline.newest(), 41)->serial, 4U);
}

// Frames 0 to 99, back to 60, 60 to 79, back to 30, then 30 to the last.
TEST(Timeline, GoingBackTwiceLeavesOnePast) {
  const auto loaded = std::make_shared<const LoadedScene>(no_scene());
  for (const int last : {35, 900}) {
    Timeline timeline;
    std::uint64_t serial = 0;
    for (const auto& [first, end] : {std::pair(0, 100), std::pair(60, 80), std::pair(30, last + 1)}) {
      for (int frame = first; frame < end; ++frame) {
        timeline.add(make_snapshot(loaded, ++serial, frame));
      }
    }
    const SnapshotPtr now = timeline.newest();
    const int reach = first_frame_in_reach(*now);
    for (int frame = reach; frame <= last; ++frame) {
      const SnapshotPtr past = timeline.of_frame(now, frame);
      EXPECT_EQ(past->record.frame, frame);
      EXPECT_EQ(past->serial, static_cast<std::uint64_t>(frame < 30 ? frame + 1 : frame - 30 + 121));
    }
    EXPECT_LT(timeline.count(), 900U);
  }
}

TEST(Timeline, ManyChangesOfOneFrameDoNotGrowIt) {
  const auto loaded = std::make_shared<const LoadedScene>(no_scene());
  Timeline timeline;
  for (std::uint64_t serial = 1; serial <= 10000; ++serial) {
    timeline.add(make_snapshot(loaded, serial, 7));
  }
  EXPECT_LT(timeline.count(), 200U);
  EXPECT_EQ(timeline.newest()->serial, 10000U);
}

TEST(QualityControl, GivesWayStepByStepAndComesBack) {
  QualityControl quality;
  std::size_t level = quality.level();
  for (int frame = 0; frame < 200; ++frame) {
    quality.note(80.0, 0.0);
    EXPECT_LE(quality.level(), level + 2);
    level = quality.level();
  }
  EXPECT_EQ(level, picture_qualities.size() - 1);
  for (int frame = 0; frame < 1000; ++frame) {
    quality.note(4.0, 0.0);
  }
  EXPECT_EQ(quality.level(), 0U);
  for (std::size_t i = 1; i < picture_qualities.size(); ++i) {
    EXPECT_LT(picture_qualities[i].cost, picture_qualities[i - 1].cost);
  }
}

TEST(QualityControl, KeepsWhatJustGivesThirtyFrames) {
  QualityControl quality;
  for (int frame = 0; frame < 1000; ++frame) {
    quality.note(31.0, 0.0);
  }
  EXPECT_EQ(quality.level(), QualityControl().level());
}

TEST(QualityControl, GivesWayToTheSimulationAndInTheEndRests) {
  QualityControl quality;
  for (int frame = 0; frame < 300; ++frame) {
    quality.note(15.0, 5.0);
  }
  EXPECT_EQ(quality.level(), picture_qualities.size() - 1);
  EXPECT_GT(quality.rest_ms(), 20.0);
  EXPECT_LE(quality.rest_ms(), QualityControl::max_rest_ms);
  for (int frame = 0; frame < 1000; ++frame) {
    quality.note(15.0, 0.0);
  }
  EXPECT_EQ(quality.rest_ms(), 0.0);
  EXPECT_LT(quality.level(), picture_qualities.size() - 1);
}

// A machine on which one level is fast and the next better one too slow.
TEST(QualityControl, SettlesInsteadOfPumping) {
  constexpr std::array<double, picture_qualities.size()> cost_ms = {70.0, 60.0, 35.0, 24.0, 22.0, 20.0};
  QualityControl quality;
  int changes = 0;
  int frames_at_best = 0;
  for (int frame = 0; frame < 5000; ++frame) {
    const std::size_t before = quality.level();
    quality.note(cost_ms[before], 0.0);
    changes += quality.level() != before ? 1 : 0;
    frames_at_best += before == 3 ? 1 : 0;
  }
  EXPECT_LT(changes, 20);
  EXPECT_GT(frames_at_best, 4800);
}

TEST(QualityControl, OneSlowFrameChangesNothing) {
  QualityControl quality;
  for (int frame = 0; frame < 300; ++frame) {
    quality.note(frame == 150 ? 90.0 : 28.0, 0.0);
  }
  EXPECT_EQ(quality.level(), QualityControl().level());
}

TEST(Panel, LeavesNarrowWindowsToTheScene) {
  EXPECT_EQ(scene_area({1280, 720, 1.0F, true}).width_px, 960);
  EXPECT_EQ(scene_area({1280, 720, 1.0F, false}).width_px, 1280);
  EXPECT_EQ(scene_area({300, 720, 1.0F, true}).width_px, 300);
  EXPECT_EQ(scene_area({0, 0, 1.0F, true}).width_px, 1);
}

// The mesh has other numbers: vertex 0 of the file belongs to no face, and 3 is welded to 1.
TEST(KeptScene, NumbersItsPinsAsTheGarmentsFile) {
  LoadedScene loaded = no_scene();
  loaded.file_vertices.mesh_vertex = {sim::no_vertex, 2, 0, 2, 1};
  Snapshot snapshot;
  snapshot.loaded = std::make_shared<const LoadedScene>(loaded);
  snapshot.pins = std::make_shared<const std::vector<sim::Index>>(std::vector<sim::Index>{1, 2});
  ViewerState state;
  state.camera = from_the_front();
  state.shown = std::make_shared<const Snapshot>(snapshot);
  const auto number_of = [](const PinSelector& pin) { return std::get<sim::Index>(pin); };
  const DrawnScene kept = kept_scene(state, area);
  ASSERT_EQ(kept.pins.value().size(), 2U);
  EXPECT_EQ(number_of((*kept.pins)[0]), 4U);
  EXPECT_EQ(number_of((*kept.pins)[1]), 1U);

  snapshot.pins = std::make_shared<const std::vector<sim::Index>>(std::vector<sim::Index>{3});
  state.shown = std::make_shared<const Snapshot>(snapshot);
  EXPECT_THROW(kept_scene(state, area), InputError) << "a vertex that subdivision made";
}

}  // namespace
}  // namespace taut::app
