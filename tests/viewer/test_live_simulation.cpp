#include <gtest/gtest.h>

#include <chrono>
#include <glm/geometric.hpp>
#include <random>
#include <sstream>
#include <thread>

#include "app/drawing/drawn_scene.hpp"
#include "app/viewer/simulation/simulation_host.hpp"
#include "temporary_folder.hpp"

namespace taut::app {
namespace {

DrawnScene small_scene() { return find_scene("pinned-9x9-5", {}); }

DrawnScene diverging_scene() {
  const std::vector<Override> overrides = {parse_override("solver.kind=\"ideal\""), parse_override("solver.substeps=1"),
                                           parse_override("solver.stiffness.structural=1e9")};
  return find_scene("pinned-9x9-5", overrides);
}

ChangeSettings with_wind(const DrawnScene& scene, double speed) {
  ChangeSettings change(scene);
  change.surroundings.forces.wind.speed_m_per_s = speed;
  return change;
}

void advance(LiveSimulation& simulation, int frames) {
  for (int i = 0; i < frames; ++i) {
    simulation.advance();
  }
}

TEST(LiveSimulation, IsTheSimulationThatRenderRuns) {
  const DrawnScene scene = small_scene();
  LiveSimulation live(scene);
  advance(live, 30);
  sim::Simulation plain = make_simulation(scene, *live.take_snapshot()->loaded);
  for (int i = 0; i < 30; ++i) {
    plain.advance_frame();
  }
  EXPECT_EQ(live.state_hash(), sim::hash(plain.state()));
  EXPECT_TRUE(live.take_snapshot()->pristine);
}

TEST(LiveSimulation, ResetStartsAgainWithTheSettingsOfNow) {
  const DrawnScene scene = small_scene();
  LiveSimulation reference(scene);
  reference.apply(with_wind(scene, 6.0));
  advance(reference, 20);

  LiveSimulation live(scene);
  advance(live, 10);
  live.apply(TogglePin{live.take_snapshot()->pins->front()});
  advance(live, 5);
  live.apply(with_wind(scene, 6.0));
  EXPECT_FALSE(live.take_snapshot()->pristine);
  live.apply(Reset{});
  EXPECT_EQ(live.take_snapshot()->record.frame, 0);
  advance(live, 20);
  EXPECT_EQ(live.state_hash(), reference.state_hash());
  EXPECT_TRUE(live.take_snapshot()->pristine);
}

TEST(LiveSimulation, GoesOnFromAFrameOfThePast) {
  const DrawnScene scene = small_scene();
  LiveSimulation live(scene);
  advance(live, 20);
  const SnapshotPtr past = live.take_snapshot();
  advance(live, 10);
  const std::uint64_t then = live.state_hash();
  live.apply(TogglePin{live.take_snapshot()->pins->front()});
  live.apply(with_wind(scene, 6.0));
  advance(live, 25);
  live.apply(GoBack{past});
  EXPECT_EQ(live.state_hash(), past->record.state_hash);
  EXPECT_EQ(live.take_snapshot()->record.frame, 20);
  EXPECT_EQ(*live.take_snapshot()->pins, *past->pins);
  EXPECT_EQ(live.take_snapshot()->positions(), past->positions());
  EXPECT_FALSE(live.take_snapshot()->pristine);
  live.apply(with_wind(scene, scene.surroundings.forces.wind.speed_m_per_s));
  advance(live, 10);
  EXPECT_EQ(live.state_hash(), then) << "the same frames come again";
}

// Going back also restores the solver's memory.
TEST(LiveSimulation, PlaysOnFromAnyFrameBitForBit) {
  for (const char* solver : {"strong", "bounded"}) {
    const std::vector<Override> overrides = {parse_override(std::string("solver.kind=\"") + solver + '"'),
                                             parse_override("solver.substeps=0"),
                                             parse_override("solver.max_stretch=0.002"), parse_override("wind.speed=5"),
                                             parse_override("wind.gust_amplitude=0.5")};
    LiveSimulation live(find_scene("pinned-9x9-5", overrides));
    std::vector<SnapshotPtr> first = {live.take_snapshot()};
    for (int frame = 1; frame <= 60; ++frame) {
      live.advance();
      first.push_back(live.take_snapshot());
    }
    for (const std::size_t to : {0U, 1U, 17U, 42U}) {
      live.apply(GoBack{first[to]});
      for (std::size_t frame = to + 1; frame < first.size(); ++frame) {
        live.advance();
        ASSERT_EQ(live.state_hash(), first[frame]->record.state_hash) << solver << ' ' << to << ' ' << frame;
      }
    }
  }
}

TEST(LiveSimulation, StopsWithTheClothAsItWasWhereSomethingWouldCross) {
  LiveSimulation live(read_scene_file(TAUT_TESTS_FOLDER "/contact/closing_spheres.toml"));
  SnapshotPtr before = live.take_snapshot();
  for (SnapshotPtr now = before; !now->stopped; now = live.take_snapshot()) {
    before = now;
    ASSERT_LT(before->record.frame, 30);
    live.advance();
  }
  const SnapshotPtr after = live.take_snapshot();
  const Notice& said = after->notices->back();
  EXPECT_TRUE(said.is_error);
  EXPECT_TRUE(
      said.text.starts_with("frame " + std::to_string(before->record.frame + 1) + ": something would cross at 0.2"))
      << said.text;
  EXPECT_CONTAINS(said.text, " m; R or any other setting starts again");
  EXPECT_FALSE(live.wants_to_advance());
  EXPECT_EQ(after->record.frame, before->record.frame);
  EXPECT_EQ(after->positions(), before->positions());
  EXPECT_EQ(live.state_hash(), before->record.state_hash);
  live.apply(Reset{});
  advance(live, 3);
  EXPECT_EQ(live.take_snapshot()->record.frame, 3);
}

TEST(LiveSimulation, GoesBackFromWhereItDiverged) {
  LiveSimulation live(small_scene());
  advance(live, 20);
  const SnapshotPtr past = live.take_snapshot();
  live.apply(ChangeSettings(diverging_scene()));
  advance(live, 100);
  ASSERT_TRUE(live.take_snapshot()->stopped);
  live.apply(ChangeSettings(small_scene()));
  live.apply(GoBack{past});
  advance(live, 5);
  EXPECT_FALSE(live.take_snapshot()->stopped);
  EXPECT_EQ(live.take_snapshot()->record.frame, 25);
}

TEST(LiveSimulation, DoesNotGoBackToAnotherGarment) {
  LiveSimulation live(small_scene());
  const SnapshotPtr past = live.take_snapshot();
  live.apply(LoadScene{std::make_shared<const SceneWithBodies>(find_scene("pinned-9x9-20", {}))});
  advance(live, 5);
  const std::uint64_t state = live.state_hash();
  live.apply(GoBack{past});
  EXPECT_EQ(live.state_hash(), state);
}

// Requires that the record has the stretches of the shown shape, also if that shape is not the result of a frame.
void expect_stretches_of_shape(const SnapshotPtr& shown, const char* when) {
  const sim::Garment& garment = *shown->garment;
  EXPECT_EQ(shown->record.stretch.max, sim::measure_stretch(garment.springs, shown->positions()).max) << when;
  EXPECT_EQ(shown->record.surface_stretch.max, sim::measure_surface_stretch(garment, shown->positions()).max) << when;
  EXPECT_GT(shown->record.surface_stretch.p99, 0.0) << when;
}

TEST(LiveSimulation, MeasuresBothStretchesOfWhatItShows) {
  for (const sim::BoundKind bound : sim::all_bound_kinds) {
    const DrawnScene scene = find_scene("pinned-9x9-20", {});
    LiveSimulation live(scene);
    advance(live, 60);
    const SnapshotPtr past = live.take_snapshot();
    expect_stretches_of_shape(past, "after a frame");
    ChangeSettings change(scene);
    change.simulation.solver.kind = sim::SolverKind::bounded;
    change.simulation.solver.bounded.bound = bound;
    live.apply(change);
    EXPECT_NE(live.take_snapshot()->record.surface_stretch.max, past->record.surface_stretch.max);
    expect_stretches_of_shape(live.take_snapshot(), "after another bound");
    live.apply(GoBack{past});
    expect_stretches_of_shape(live.take_snapshot(), "after going back");
  }
}

// The bound is lowered, and a solver with a bound is chosen, while nothing moves.
TEST(LiveSimulation, ANewBoundHoldsBeforeTheNextFrame) {
  const DrawnScene scene = find_scene("pinned-9x9-20", {});
  LiveSimulation live(scene);
  advance(live, 60);
  ASSERT_GT(live.take_snapshot()->record.stretch.max, 0.06);
  const SnapshotPtr hanging = live.take_snapshot();
  ChangeSettings change(scene);
  change.simulation.solver.kind = sim::SolverKind::bounded;
  for (const double bound : {0.05, 0.01}) {
    change.simulation.solver.bounded.max_stretch = bound;
    live.apply(change);
    const SnapshotPtr shown = live.take_snapshot();
    const sim::Springs& springs = shown->loaded->garment->springs;
    EXPECT_LE(sim::measure_stretch(springs, shown->positions()).max, bound);
    EXPECT_LE(shown->record.stretch.max, bound);
    EXPECT_EQ(shown->positions()[shown->pins->front()], hanging->positions()[shown->pins->front()]);
  }
  advance(live, 1);
  EXPECT_LE(live.take_snapshot()->record.stretch.max, 0.01);
}

TEST(LiveSimulation, ComingBackFromASolverWithoutContactPartsWhatCrossed) {
  const std::vector<Override> small = {parse_override("garment.file=\"tshirt_1028\"")};
  const DrawnScene scene = find_scene("tshirt-wind-10", small);
  const auto crossing = [](LiveSimulation& live) { return live.take_snapshot()->record.contact.crossing_pairs; };
  LiveSimulation live(scene);
  advance(live, 10);
  ASSERT_EQ(crossing(live), 0U);
  ChangeSettings without(scene);
  without.simulation.solver.kind = sim::SolverKind::vassilev;
  live.apply(without);
  advance(live, 60);
  const std::size_t crossed = crossing(live);
  ASSERT_GT(crossed, 20U);
  live.apply(ChangeSettings(scene));
  const Notice& said = live.take_snapshot()->notices->back();
  EXPECT_CONTAINS(said.text, " crossed: ");
  advance(live, 1);
  const std::size_t left = crossing(live);
  EXPECT_LT(left, crossed / 2);
  EXPECT_EQ(said.is_error, left > 0) << said.text;
  advance(live, 20);
  EXPECT_FALSE(live.take_snapshot()->stopped);
  EXPECT_LE(crossing(live), left);
}

TEST(LiveSimulation, AHandPullsTheHemAndLetsGo) {
  LiveSimulation live(small_scene());
  advance(live, 60);
  const SnapshotPtr hanging = live.take_snapshot();
  const sim::Index corner = 80;
  Grip grip = take_grip(*hanging->loaded->garment, hanging->positions(), corner);
  const sim::Vec3 wanted = hanging->positions()[corner] + sim::Vec3(0.0, 0.1, 0.25);
  grip.target_m = wanted;
  live.apply(TakeHold{grip});
  advance(live, 60);
  const SnapshotPtr pulled = live.take_snapshot();
  EXPECT_LT(glm::distance(pulled->positions()[corner], wanted), 0.02);
  EXPECT_LT(pulled->record.stretch.max, hanging->record.stretch.max + 0.05);
  EXPECT_FALSE(pulled->pristine);
  live.apply(LetGo{});
  advance(live, 120);
  EXPECT_GT(glm::distance(live.take_snapshot()->positions()[corner], wanted), 0.1);
}

TEST(LiveSimulation, ABoundHoldsWhileAHandPulls) {
  LiveSimulation live(find_scene(
      "pinned-9x9-5", std::vector{parse_override("solver.kind=\"bounded\""), parse_override("solver.substeps=0"),
                                  parse_override("solver.max_stretch=0.02")}));
  advance(live, 60);
  const SnapshotPtr hanging = live.take_snapshot();
  Grip grip = take_grip(*hanging->loaded->garment, hanging->positions(), 80);
  const sim::Vec3 wanted = hanging->positions()[80] + sim::Vec3(0.0, 0.1, 0.25);
  grip.target_m = wanted;
  live.apply(TakeHold{grip});
  advance(live, 60);
  EXPECT_LT(glm::distance(live.take_snapshot()->positions()[80], wanted), 0.05);
  grip.target_m = {5.0, 2.0, 10.0};
  live.apply(TakeHold{grip});
  for (int frame = 0; frame < 120; ++frame) {
    live.advance();
    EXPECT_LE(live.take_snapshot()->record.stretch.max, 0.02 + 1e-9) << frame;
  }
}

TEST(LiveSimulation, AHandOutOfReachDoesNotTearTheCloth) {
  LiveSimulation live(small_scene());
  advance(live, 10);
  Grip grip = take_grip(*live.take_snapshot()->loaded->garment, live.take_snapshot()->positions(), 80);
  grip.target_m = {50.0, 20.0, 100.0};
  live.apply(TakeHold{grip});
  advance(live, 200);
  const SnapshotPtr pulled = live.take_snapshot();
  EXPECT_FALSE(pulled->stopped);
  EXPECT_LT(pulled->record.stretch.max, 0.5);
}

TEST(LiveSimulation, PinsAreSetWhereTheClothIs) {
  LiveSimulation live(small_scene());
  advance(live, 60);
  const sim::Vec3 place = live.take_snapshot()->positions()[72];
  live.apply(TogglePin{72});
  live.apply(with_wind(small_scene(), 8.0));
  advance(live, 30);
  EXPECT_EQ(live.take_snapshot()->positions()[72], place);
  live.apply(TogglePin{72});
  advance(live, 30);
  EXPECT_NE(live.take_snapshot()->positions()[72], place);
}

TEST(LiveSimulation, DivergesIntoANoticeAndGoesOnAfterAReset) {
  LiveSimulation live(diverging_scene());
  advance(live, 100);
  const SnapshotPtr stopped = live.take_snapshot();
  EXPECT_TRUE(stopped->stopped);
  EXPECT_TRUE(stopped->notices->back().is_error);
  EXPECT_NE(stopped->notices->back().text.find("diverged"), std::string::npos);
  EXPECT_FALSE(live.wants_to_advance());
  EXPECT_EQ(sim::first_lost(stopped->positions()), stopped->positions().size());
  live.apply(ChangeSettings(small_scene()));
  live.apply(Reset{});
  advance(live, 20);
  EXPECT_FALSE(live.take_snapshot()->stopped);
  EXPECT_EQ(live.take_snapshot()->record.frame, 20);
}

TEST(LiveSimulation, ABrokenGarmentLeavesTheOldOne) {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder.write("broken.obj", "v 0 0 0\nf 1 2 3\n");
  LiveSimulation live(small_scene());
  advance(live, 5);
  const std::uint64_t state = live.state_hash();
  DrawnScene broken = small_scene();
  broken.garment.file = file;
  live.apply(LoadScene{std::make_shared<const SceneWithBodies>(broken)});
  EXPECT_TRUE(live.take_snapshot()->notices->back().is_error);
  EXPECT_NE(live.take_snapshot()->notices->back().text.find("broken.obj"), std::string::npos);
  EXPECT_EQ(live.take_snapshot()->loaded->generation, 1U);
  EXPECT_EQ(live.state_hash(), state);
  advance(live, 5);
  EXPECT_EQ(live.take_snapshot()->record.frame, 10);
}

/// Returns an OBJ of a sheet with another one below it, which only narrow ribbons hold.
std::string two_sheets_and_ribbons() {
  std::ostringstream obj;
  int first = 1;
  const auto add_grid = [&](const sim::Vec2& corner_m, const sim::Vec2& size_m, int columns, int rows) {
    for (int row = 0; row <= rows; ++row) {
      for (int column = 0; column <= columns; ++column) {
        obj << "v " << corner_m.x + size_m.x * column / columns << ' ' << corner_m.y + size_m.y * row / rows << " 0\n";
      }
    }
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        const int at = first + row * (columns + 1) + column;
        obj << "f " << at << ' ' << at + 1 << ' ' << at + columns + 2 << ' ' << at + columns + 1 << '\n';
      }
    }
    first += (columns + 1) * (rows + 1);
  };
  add_grid({-0.2, 1.2}, {0.4, 0.2}, 20, 10);
  add_grid({-0.2, 0.85}, {0.4, 0.3}, 20, 15);
  for (int ribbon = 0; ribbon < 12; ++ribbon) add_grid({-0.19 + 0.03 * ribbon, 1.15}, {0.001, 0.05}, 1, 20);
  return obj.str();
}

TEST(LiveSimulation, ShowsTheSimulatedMeshOnceTheModelIsTorn) {
  const test::TemporaryFolder folder;
  DrawnScene scene;
  scene.garment.file = folder.write("torn.obj", two_sheets_and_ribbons());
  scene.garment.mesh = MeshChoice::fitted;
  scene.garment.max_triangles = 1500;
  scene.garment.scale = 1.0;
  scene.garment.up = ModelAxis::y;
  scene.pins = std::vector<PinSelector>{sim::Index{210}, sim::Index{230}};
  LiveSimulation live(scene);
  advance(live, 2);
  const SnapshotPtr past = live.take_snapshot();
  EXPECT_TRUE(past->loaded->following);
  advance(live, 30);
  const SnapshotPtr shown = live.take_snapshot();
  EXPECT_FALSE(shown->loaded->following);
  EXPECT_FALSE(shown->loaded->drawn_colours.following);
  EXPECT_EQ(&shown->loaded->shown_mesh(), &shown->loaded->garment->mesh);
  EXPECT_TRUE(shown->notices->back().is_error);
  EXPECT_NE(shown->notices->back().text.find("the simulated mesh is shown"), std::string::npos);
  live.apply(GoBack{past});
  advance(live, 30);
  EXPECT_EQ(live.state_hash(), sim::hash(shown->checkpoint->state)) << "what is shown changed what is simulated";
}

TEST(LiveSimulation, RefusesASettingWithANotice) {
  LiveSimulation live(small_scene());
  ChangeSettings change(small_scene());
  change.simulation.solver.max_substeps = 0;
  live.apply(change);
  EXPECT_TRUE(live.take_snapshot()->notices->back().is_error);
  advance(live, 3);
  EXPECT_EQ(live.take_snapshot()->record.frame, 3);
}

TEST(LiveSimulation, StepsOnceWhilePaused) {
  LiveSimulation live(small_scene());
  live.apply(SetPaused{true});
  EXPECT_FALSE(live.wants_to_advance());
  live.apply(StepOnce{});
  EXPECT_TRUE(live.wants_to_advance());
  live.advance();
  EXPECT_FALSE(live.wants_to_advance());
}

TEST(SteppedSimulation, FollowsTheClockInSlowMotion) {
  SimulationHost simulation(small_scene(), SimulationHost::Runs::when_asked);
  simulation.post({SetSpeed{0.25}});
  for (int frame = 0; frame < 40; ++frame) {
    simulation.begin_frame(1.0 / 60.0, std::nullopt);
  }
  EXPECT_EQ(simulation.begin_frame(0.0, std::nullopt)->record.frame, 10);
}

// Commands at odd moments, in a window that draws frames at an uneven rate.
std::vector<SimulationCommand> commands_at(int frame, const DrawnScene& scene, const Snapshot& newest,
                                           const SnapshotPtr& past) {
  switch (frame) {
    case 3:
      return {with_wind(scene, 7.0)};
    case 9:
      return {TogglePin{newest.pins->back()}};
    case 14:
      return {TakeHold{take_grip(*newest.loaded->garment, newest.positions(), 40)}};
    case 15:
      return {with_wind(scene, 3.0)};
    case 22:
      return {LetGo{}, SetSpeed{0.5}};
    case 26:
      return {Reset{}};
    case 30:
      return {TogglePin{44}, SetSpeed{4.0}};
    case 34:
    case 36:
      return {GoBack{past}};
    default:
      return {};
  }
}

TEST(SimulationThread, AReplayOfItsPaceEndsInTheSameState) {
  const DrawnScene scene = small_scene();
  std::vector<Pace> paces;
  std::mt19937 random(5);
  SimulationHost live(scene, SimulationHost::Runs::by_itself);
  for (int frame = 0; frame < 40; ++frame) {
    const SnapshotPtr newest = live.begin_frame(0.0, std::nullopt);
    const SnapshotPtr past = live.past_frame(newest, newest->record.frame - 3);
    const std::uint64_t advances = live.post(commands_at(frame, scene, *newest, past));
    paces.push_back({advances, newest->serial});
    std::this_thread::sleep_for(std::chrono::milliseconds(random() % 40));
  }
  live.end();
  paces.push_back({live.advances(), paces.back().shown});

  SimulationHost replay(scene, SimulationHost::Runs::when_asked);
  for (std::size_t frame = 0; frame < paces.size(); ++frame) {
    const SnapshotPtr shown = replay.begin_frame(0.0, paces[frame]);
    EXPECT_EQ(shown->serial, paces[frame].shown);
    const SnapshotPtr past = replay.past_frame(shown, shown->record.frame - 3);
    replay.post(commands_at(static_cast<int>(frame), scene, *shown, past));
  }
  EXPECT_GT(live.advances(), 5U);
  EXPECT_EQ(replay.state_hash(), live.state_hash());
}

TEST(SimulationThread, GivesUpAFrameThatTakesLong) {
  DrawnScene scene = small_scene();
  scene.garment.grid.columns = 60;
  scene.garment.grid.rows = 60;
  scene.simulation.frame_rate_hz = 1.0;
  scene.simulation.solver.substeps = scene.simulation.solver.max_substeps = 10000;
  SimulationHost live(scene, SimulationHost::Runs::by_itself);
  while (live.post({}) == 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  const auto asked = std::chrono::steady_clock::now();
  live.end();
  EXPECT_LT(std::chrono::steady_clock::now() - asked, std::chrono::seconds(2));
  EXPECT_TRUE(live.gave_up_frame());
  EXPECT_EQ(live.state_hash(), SimulationHost(scene, SimulationHost::Runs::when_asked).state_hash());
}

TEST(SteppedSimulation, RefusesAPaceThatGoesBack) {
  SimulationHost simulation(small_scene(), SimulationHost::Runs::when_asked);
  simulation.begin_frame(0.0, Pace{5, 6});
  EXPECT_THROW(simulation.begin_frame(0.0, Pace{4, 6}), std::runtime_error);
}

// The wind blows the shirt into itself, where contact stops corrections towards the bound. They push the cloth in their
// way.
TEST(LiveSimulation, KeepsItsBoundInAStormThatBlowsTheShirtIntoItself) {
  for (const auto& [direction, speed] : {std::pair("[0, 1, 0]", "10"), {"[0, 1, 0]", "20"}, {"[-1, 0, 0]", "20"}}) {
    const std::string storm = std::string(speed) + " m/s towards " + direction;
    const std::vector<Override> overrides = {
        parse_override("garment.file=\"tshirt_1028\""), parse_override("solver.max_stretch=0.01"),
        parse_override("wind.direction=" + std::string(direction)), parse_override("wind.speed=" + std::string(speed))};
    DrawnScene scene = find_scene("tshirt-wind-10", overrides);
    LiveSimulation live(scene);
    for (int frame = 1; frame <= 60; ++frame) {
      live.advance();
      const FrameRecord record = live.take_snapshot()->record;
      ASSERT_EQ(record.frame, frame) << storm;
      EXPECT_TRUE(is_within(sim::BoundedSettings{.max_stretch = 0.01}, record)) << storm << ", frame " << frame;
    }
  }
}

}  // namespace
}  // namespace taut::app
