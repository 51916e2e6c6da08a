#include <gtest/gtest.h>

#include "app/base/errors.hpp"
#include "app/viewer/headless_viewer.hpp"
#include "app/viewer/panel/panel.hpp"
#include "app/viewer/simulation/simulation_host.hpp"
#include "person.hpp"
#include "temporary_folder.hpp"

// The same garment twice, by two solvers.

namespace taut::app {
namespace {

namespace keys = renderer::keys;
using renderer::PointerButton;
using test::Person;

constexpr const char* own_steps = "solver.substeps=0";

DrawnScene make_scene(const char* solver, double wind = 0.0) {
  return find_scene("pinned-9x9-5", std::vector<Override>{parse_override(std::string("solver.kind=") + solver),
                                                          parse_override(own_steps),
                                                          parse_override("wind.speed=" + std::to_string(wind))});
}

// Springs with these settings diverge at once.
const std::vector<Override> too_stiff = {parse_override("solver.kind=ideal"), parse_override("solver.substeps=1"),
                                         parse_override("solver.stiffness.structural=1e9"),
                                         parse_override("wind.speed=5")};

void advance(auto& simulation, int frames) {
  for (int i = 0; i < frames; ++i) {
    simulation.advance();
  }
}

std::vector<sim::Vec3> alone(const char* solver, int frames, double wind = 0.0) {
  LiveSimulation live(make_scene(solver, wind));
  advance(live, frames);
  return live.take_snapshot()->positions();
}

ChangeSettings with_wind(const DrawnScene& scene, double speed) {
  ChangeSettings change(scene);
  change.surroundings.forces.wind.speed_m_per_s = speed;
  return change;
}

TEST(SimulationPair, EachIsItsSolverAlone) {
  for (const sim::SolverKind kind : sim::all_solver_kinds) {
    SimulationPair pair(make_scene("bounded"));
    advance(pair, 5);
    pair.apply(Compare{kind});
    advance(pair, 12);
    const SnapshotPtr now = pair.take_snapshot();
    ASSERT_TRUE(now->compared);
    EXPECT_EQ(now->record.frame, 12);
    EXPECT_EQ(now->compared->record.frame, 12);
    EXPECT_EQ(now->positions(), alone("bounded", 12));
    EXPECT_EQ(now->compared->positions(), alone(sim::to_name(kind), 12)) << sim::to_name(kind);
  }
}

TEST(SimulationPair, SettingsReachBothAndOutliveAReset) {
  const DrawnScene scene = make_scene("bounded");
  SimulationPair pair(scene);
  pair.apply(Compare{sim::SolverKind::provot});
  pair.apply(SetPaused{true});
  pair.apply(with_wind(scene, 6.0));
  for (int run = 0; run < 2; ++run) {
    advance(pair, 20);
    EXPECT_EQ(pair.take_snapshot()->positions(), alone("bounded", 20, 6.0));
    EXPECT_EQ(pair.take_snapshot()->compared->positions(), alone("provot", 20, 6.0)) << run;
    pair.apply(Reset{});
    EXPECT_EQ(pair.take_snapshot()->compared->record.frame, 0);
    EXPECT_FALSE(pair.wants_to_advance()) << "both are paused";
  }
  pair.apply(Compare{});
  EXPECT_FALSE(pair.take_snapshot()->compared);
}

TEST(SimulationPair, BothGoBack) {
  SimulationPair pair(make_scene("strong", 5.0));
  pair.apply(Compare{sim::SolverKind::bounded});
  advance(pair, 10);
  const SnapshotPtr past = pair.take_snapshot();
  advance(pair, 10);
  const SnapshotPtr then = pair.take_snapshot();
  pair.apply(TogglePin{past->pins->front()});
  advance(pair, 5);
  EXPECT_NE(*pair.take_snapshot()->compared->pins, *past->compared->pins);
  pair.apply(GoBack{past});
  EXPECT_EQ(pair.take_snapshot()->compared->positions(), past->compared->positions());
  advance(pair, 10);
  EXPECT_EQ(pair.take_snapshot()->positions(), then->positions());
  EXPECT_EQ(pair.take_snapshot()->compared->positions(), then->compared->positions());
}

TEST(SimulationPair, OneThatIsLostDoesNotStopTheOther) {
  const DrawnScene scene = find_scene("pinned-9x9-5", too_stiff);
  ChangeSettings change(scene);
  change.simulation = make_scene("bounded").simulation;
  SimulationPair pair(scene);
  pair.apply(change);
  pair.apply(Compare{sim::SolverKind::ideal});
  advance(pair, 60);
  const SnapshotPtr now = pair.take_snapshot();
  EXPECT_TRUE(now->compared->stopped);
  EXPECT_LT(now->compared->record.frame, 60);
  EXPECT_TRUE(now->notices->back().text.starts_with("ideal: ")) << now->notices->back().text;
  EXPECT_CONTAINS(now->notices->back().text, "; R starts both again");
  EXPECT_FALSE(now->stopped);
  EXPECT_TRUE(moves(*now));
  EXPECT_FALSE(has_stopped(*now));
  change.surroundings.forces.wind.speed_m_per_s = 3.0;
  pair.apply(change);
  advance(pair, 1);
  EXPECT_EQ(pair.take_snapshot()->record.frame, 61) << "it goes on";
  EXPECT_TRUE(pair.take_snapshot()->compared->stopped);
  pair.apply(GoBack{now});
  EXPECT_TRUE(pair.take_snapshot()->compared->stopped) << "as it was then";
  pair.apply(Reset{});
  EXPECT_FALSE(pair.take_snapshot()->compared->stopped);
  EXPECT_EQ(pair.take_snapshot()->compared->surroundings.forces.wind.speed_m_per_s, 3.0);
}

TEST(SimulationPair, TheSecondGoesOnWhereTheFirstIsLost) {
  const DrawnScene scene = find_scene("pinned-9x9-5", too_stiff);
  SimulationPair pair(scene);
  pair.apply(Compare{sim::SolverKind::bounded});
  advance(pair, 60);
  EXPECT_TRUE(pair.take_snapshot()->stopped);
  EXPECT_TRUE(pair.wants_to_advance());
  EXPECT_TRUE(moves(*pair.take_snapshot()));
  EXPECT_FALSE(has_stopped(*pair.take_snapshot()));
  EXPECT_EQ(pair.take_snapshot()->compared->record.frame, 60);
  pair.apply(with_wind(scene, 2.0));
  EXPECT_FALSE(pair.take_snapshot()->stopped);
  EXPECT_EQ(pair.take_snapshot()->compared->record.frame, 0) << "both again from the start";
}

TEST(SimulationPair, SaysWhichHoldsBothBack) {
  SimulationPair pair(make_scene("bounded"));
  EXPECT_STREQ(slower_solver(*pair.take_snapshot()), "bounded");
  pair.apply(Compare{sim::SolverKind::provot});
  Snapshot second = *pair.take_snapshot()->compared;
  second.record.sim_ms = 3.0;
  Snapshot now = *pair.take_snapshot();
  now.compared = std::make_shared<const Snapshot>(second);
  now.record.sim_ms = 2.0;
  EXPECT_STREQ(slower_solver(now), "provot");
  now.record.sim_ms = 4.0;
  EXPECT_STREQ(slower_solver(now), "bounded");
}

// The two garments share the memory for the past.
TEST(SimulationPair, TwoGarmentsReachHalfAsFarBack) {
  SimulationPair pair(make_scene("bounded"));
  Snapshot now = *pair.take_snapshot();
  sim::Checkpoint large = *now.checkpoint;
  large.state.current.resize(20000);
  now.checkpoint = std::make_shared<const sim::Checkpoint>(std::move(large));
  now.record.frame = 10000;
  const int alone = 10000 - first_frame_in_reach(now);
  now.compared = std::make_shared<const Snapshot>(now);
  EXPECT_EQ((10000 - first_frame_in_reach(now)), alone / 2);
  EXPECT_LT(alone, 600) << "memory decides";
}

TEST(SimulationPair, WhatASolverRefusesLeavesTheFirstAlone) {
  DrawnScene scene = make_scene("ideal");
  scene.simulation.solver.bounded.max_stretch = 1e-9;
  SimulationPair pair(scene);
  pair.apply(Compare{sim::SolverKind::bounded});
  advance(pair, 2);
  const SnapshotPtr now = pair.take_snapshot();
  EXPECT_FALSE(now->compared);
  EXPECT_EQ(now->record.frame, 2);
  EXPECT_TRUE(now->notices->back().is_error);
  EXPECT_TRUE(now->notices->back().text.starts_with("bounded: ")) << now->notices->back().text;
}

TEST(Comparison, IsChosenInThePanelAndSharesTheWind) {
  Person person("pinned-9x9-5", {parse_override("solver.kind=bounded"), parse_override(own_steps)});
  const ViewerState& state = person.viewer.state();
  const ViewArea whole = garment_area(state, person.viewer.layout());
  person.click("compare");
  for (const auto& [name, place] : state.places) {
    EXPECT_FALSE(hint_for(name).empty()) << name;
  }
  const OrbitCamera before = state.camera;
  person.click("compare.provot");
  ASSERT_TRUE(compared_garment(state));
  EXPECT_FALSE(state.camera == before) << "half the room";
  const ViewArea half = garment_area(state, person.viewer.layout());
  EXPECT_EQ(half.width_px, whole.width_px / 2);
  for (const sim::Vec3& position : compared_garment(state)->positions()) {
    EXPECT_TRUE(half.contains(*state.camera.project_to_pixel(glm::vec3(position), half)));
  }
  person.press(keys::up);
  person.wait(10);
  EXPECT_EQ(state.newest->compared->surroundings.forces.wind.speed_m_per_s, 0.5);
  EXPECT_EQ(state.newest->surroundings, state.newest->compared->surroundings);
  EXPECT_EQ(state.newest->record.frame, state.newest->compared->record.frame);
  person.press('R');
  person.press(keys::space);
  EXPECT_LT(state.newest->compared->record.frame, 4);
  EXPECT_EQ(state.newest->compared->record.frame, state.newest->record.frame);
  person.click("compare");
  person.click("compare.none");
  EXPECT_FALSE(compared_garment(state));
  EXPECT_EQ(garment_area(state, person.viewer.layout()).width_px, whole.width_px);
}

// Either half of the window can be pulled, and both cloths follow.
TEST(Comparison, TheHandPullsBoth) {
  const auto at = [](glm::vec2 px) { return renderer::WindowEvent(renderer::PointerMoved{px.x, px.y}); };
  const auto left = [](bool down) { return renderer::WindowEvent(renderer::ButtonChanged{PointerButton::left, down}); };
  Person person("pinned-9x9-5", {parse_override("solver.kind=bounded"), parse_override(own_steps)});
  person.click("compare");
  person.click("compare.implicit");
  person.wait(10);
  const ViewerState& state = person.viewer.state();
  const ViewArea half = garment_area(state, person.viewer.layout());
  const glm::vec3 middle(compared_garment(state)->positions()[40]);
  const glm::vec2 place = *state.camera.project_to_pixel(middle, half) + glm::vec2(half.width_px, 0.0F);
  person.act({at(place), left(true)});
  ASSERT_TRUE(state.held);
  EXPECT_EQ(state.held->vertex, 40U);
  const OrbitCamera before = state.camera;
  person.act(at(place - glm::vec2(1.2F * static_cast<float>(half.width_px), 40.0F)));
  person.wait(2);
  EXPECT_TRUE(state.camera == before);
  EXPECT_TRUE(state.is_over_second) << "it began there";
  EXPECT_LT(state.held->hand_m.x, middle.x - 0.1);
  for (const Snapshot* garment : {state.newest.get(), state.newest->compared.get()}) {
    EXPECT_FALSE(garment->surroundings.forces.grabbed_vertices.empty());
  }
  person.act(left(false));
  person.wait(1);
  EXPECT_TRUE(state.newest->compared->surroundings.forces.grabbed_vertices.empty());
}

TEST(Comparison, IsDrawnSideBySideAndInPicturesToo) {
  SessionStart start;
  start.compared_with = sim::SolverKind::ideal;
  HeadlessViewer window(find_scene("pinned-9x9-5", {}), start, ".", "auto");
  for (int i = 0; i < 30; ++i) {
    window.play({});
  }
  const ViewArea half = garment_area(window.viewer().state(), window.viewer().layout());
  const renderer::Image scene = window.draw_scene();
  const renderer::Image whole = window.draw();
  EXPECT_EQ(scene.width_px, 2 * half.width_px);
  std::array<int, 2> cloth{};
  for (int y = 0; y < 600; ++y) {
    for (int x = 0; x < scene.width_px; ++x) {
      const std::uint8_t* const pixel = scene.at(x, y);
      cloth[x < half.width_px ? 0 : 1] += pixel[2] > pixel[0] + 40 ? 1 : 0;  // the cloth is blue
      ASSERT_TRUE(std::equal(pixel, pixel + 3, whole.at(x, y))) << x << ' ' << y;
    }
  }
  EXPECT_GT(cloth[0], 5000);
  EXPECT_GT(cloth[1], 5000);
}

TEST(Comparison, ASessionSaysIt) {
  const RecordedSession session = parse_session(R"(["taut-session", 2]
["scene", "pinned-9x9-5"]
["compare", "provot"]
["frame", 1])",
                                                "s");
  EXPECT_EQ(session.start.compared_with, sim::SolverKind::provot);
  EXPECT_CONTAINS(session_head(session.start), R"(["compare","provot"])");
  EXPECT_THROW(parse_session(R"(["taut-session", 2]
["compare", "provo"]
["frame", 1])",
                             "s"),
               InputError);
}

}  // namespace
}  // namespace taut::app
