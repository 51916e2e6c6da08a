#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "app/base/files.hpp"
#include "app/drawing/drawn_scene.hpp"
#include "app/models/reading/garment_import.hpp"
#include "app/output/picture_record.hpp"
#include "app/viewer/headless_viewer.hpp"
#include "app/viewer/panel/panel.hpp"
#include "app/viewer/picture/viewer_picture.hpp"
#include "person.hpp"
#include "picture_reading.hpp"
#include "temporary_folder.hpp"

namespace taut::app {
namespace {

namespace keys = renderer::keys;
using renderer::PointerButton;
using test::Person;

TEST(Window, EscapeClosesAnOpenListAndTheSheetOfKeys) {
  Person person("pinned-9x9-5");
  for (const auto& [list, entry] : {std::pair("solver", "solver.ideal"), std::pair("scene", "scene.tshirt"),
                                    std::pair("garment", "garment.tshirt_1028"), std::pair("speed", "speed.1/4")}) {
    person.click(list);
    EXPECT_TRUE(person.shows(entry)) << list;
    person.press(keys::escape);
    person.wait(2);
    EXPECT_FALSE(person.shows(entry)) << list;
  }
  EXPECT_EQ(person.viewer.state().scene.name, "pinned-9x9-5");
  person.press('H');
  EXPECT_TRUE(person.viewer.state().show_keys);
  person.press(keys::escape);
  person.wait(1);
  EXPECT_FALSE(person.viewer.state().show_keys);
  EXPECT_FALSE(person.viewer.is_ended());
}

TEST(Window, AFabricIsChosenWhileTheClothHangs) {
  Person person("pinned-9x9-5", {parse_override("solver.kind=bounded")});
  person.wait(10);
  const int frame = person.viewer.state().newest->record.frame;
  person.click("fabric");
  person.click("fabric.denim");
  person.wait(2);
  const ViewerState& state = person.viewer.state();
  EXPECT_EQ(state.scene.fabric, "denim");
  EXPECT_EQ(state.newest->garment->material.bending_rigidity_n_m, 98e-6);
  EXPECT_EQ(state.scene.picture.cloth.weave_kind, renderer::WeaveKind::twill);
  EXPECT_GT(state.newest->record.frame, frame);
}

TEST(Window, TheScenesOwnFabricComesBack) {
  Person person("pinned-9x9-5", {parse_override("solver.kind=bounded")});
  person.wait(2);
  const ViewerState& state = person.viewer.state();
  const double own_rigidity_n_m = state.scene.material.bending_rigidity_n_m;
  const renderer::WeaveKind own_weave = state.scene.picture.cloth.weave_kind;
  person.click("fabric");
  person.click("fabric.denim");
  person.wait(2);
  ASSERT_NE(state.scene.material.bending_rigidity_n_m, own_rigidity_n_m);
  person.click("fabric");
  person.click("fabric.own");
  person.wait(2);
  EXPECT_EQ(state.scene.fabric, "");
  EXPECT_EQ(state.scene.material.bending_rigidity_n_m, own_rigidity_n_m);
  EXPECT_EQ(state.newest->garment->material.bending_rigidity_n_m, own_rigidity_n_m);
  EXPECT_EQ(state.scene.picture.cloth.weave_kind, own_weave);
}

TEST(Window, EveryControlSaysWhatItDoes) {
  Person person("tshirt", {parse_override("garment.file=\"" TAUT_ASSETS_FOLDER "/garments/tshirt_1028.obj\"")});
  for (const sim::SolverKind solver : sim::all_solver_kinds) {
    person.click("solver");
    person.click(std::string("solver.") + sim::to_name(solver));
    person.click("solver");
    for (const auto& [name, place] : person.viewer.state().places) {
      EXPECT_FALSE(hint_for(name).empty()) << name;
    }
    EXPECT_TRUE(person.shows("measured.speed"));
    person.press(keys::escape);
    person.wait(2);
  }
}

// The text beside the readings grows and shrinks while the pointer rests there.
TEST(Window, ReadingsAreExplainedAllAcrossThePanel) {
  Person person("pinned-9x9-5");
  const auto right_of = [&](const char* name) { return person.viewer.state().places.at(name).upper_px.x; };
  for (const char* name : {"measured.size", "measured.speed"}) {
    EXPECT_NEAR(right_of(name), right_of("measured.stretch"), 1.0F) << name;
  }
}

TEST(Window, ExplainsWhatThePointerRestsOn) {
  Person person("pinned-9x9-5");
  person.press(keys::space);
  person.point_at("solver.substeps");
  person.wait(5);
  EXPECT_FALSE(person.viewer.is_still()) << "the explanation is yet to come";
  const std::size_t before = person.viewer.interface().overlay().vertices.size();
  person.wait(40);
  const std::size_t explained = person.viewer.interface().overlay().vertices.size();
  EXPECT_GT(explained, before + 200) << "four vertices for each letter";
  EXPECT_TRUE(person.viewer.is_still());
  person.act(renderer::WindowEvent(renderer::PointerMoved{300.0, 300.0}));
  person.wait(3);
  EXPECT_LT(person.viewer.interface().overlay().vertices.size(), explained - 200);
  EXPECT_FALSE(person.viewer.state().hovered);
}

TEST(Window, TheWheelZoomsToThePointer) {
  Person person("pinned-9x9-5");
  const ViewArea area = scene_area(person.viewer.layout());
  const glm::vec2 place{700.0F, 150.0F};
  const OrbitCamera& camera = person.viewer.state().camera;
  const Ray ray = camera.ray_through(place, area);
  const glm::vec3 near = ray.origin + 0.5F * ray.direction;
  const glm::vec3 far = ray.origin + 4.0F * ray.direction;
  const float distance_m = glm::length(camera.camera().eye - far);
  person.act(renderer::WindowEvent(renderer::PointerMoved{place.x, place.y}));
  person.act(renderer::WindowEvent(renderer::WheelTurned{0.0, 3.0}));
  EXPECT_LT(glm::length(camera.camera().eye - far), 0.95F * distance_m);
  person.act(renderer::WindowEvent(renderer::WheelTurned{0.0, -5.0}));
  for (const glm::vec3& point : {near, far}) {
    const auto seen = camera.project_to_pixel(point, area);
    ASSERT_TRUE(seen);
    EXPECT_NEAR(seen->x, place.x, 0.2F);
    EXPECT_NEAR(seen->y, place.y, 0.2F);
  }
}

// A press often arrives in the same frame as the movement to its place. That movement is no drag.
TEST(Window, ADragBeginsWhereTheButtonGoesDown) {
  const auto at = [](double x, double y) { return renderer::WindowEvent(renderer::PointerMoved{x, y}); };
  for (const PointerButton button : {PointerButton::left, PointerButton::right}) {
    Person person("pinned-9x9-5");
    person.press(keys::space);
    person.act(at(900.0, 600.0));
    const OrbitCamera before = person.viewer.state().camera;
    const OrbitCamera& camera = person.viewer.state().camera;
    person.act({at(30.0, 50.0), renderer::WindowEvent(renderer::ButtonChanged{button, true})});
    EXPECT_TRUE(camera == before);
    person.act(at(90.0, 70.0));
    EXPECT_FALSE(camera == before);
    if (button == PointerButton::right) {
      const ViewArea area = scene_area(person.viewer.layout());
      EXPECT_NEAR(camera.project_to_pixel(before.camera().target, area)->x, 0.5 * area.width_px + 60.0, 0.01);
    }
  }
}

TEST(Window, AThreadLeadsToAHandThatTheClothDoesNotFollow) {
  const auto at = [](glm::vec2 px) { return renderer::WindowEvent(renderer::PointerMoved{px.x, px.y}); };
  const auto left = [](bool down) { return renderer::WindowEvent(renderer::ButtonChanged{PointerButton::left, down}); };
  Person person("pinned-9x9-5");
  person.press(keys::space);
  const ViewerState& state = person.viewer.state();
  const ViewArea area = scene_area(person.viewer.layout());
  const glm::vec3 middle(state.shown->positions()[40]);
  const glm::vec2 middle_px = *state.camera.project_to_pixel(middle, area);
  const auto thread_to = [&](glm::vec2 place_px) {
    person.act(at(place_px));
    return hand_thread(state, *state.shown, area);
  };
  person.act({at(middle_px), left(true)});
  EXPECT_FALSE(hand_thread(state, *state.shown, area)) << "the cloth is in the hand";
  EXPECT_FALSE(thread_to(middle_px + glm::vec2(3.0F, 0.0F))) << "some pixels";
  const glm::vec2 away_px = middle_px + glm::vec2(60.0F, 20.0F);
  const auto thread = thread_to(away_px);
  ASSERT_TRUE(thread);
  EXPECT_EQ((*thread)[0], middle);
  EXPECT_LT(glm::distance(*state.camera.project_to_pixel((*thread)[1], area), away_px), 0.1F);
  thread_to(middle_px);
  person.act(renderer::WindowEvent(renderer::WheelTurned{0.0, 30.0}));
  EXPECT_FALSE(thread_to(middle_px + glm::vec2(20.0F, 0.0F))) << "some millimetres, seen from near";
  EXPECT_TRUE(thread_to(away_px + glm::vec2(200.0F, 0.0F)));
  person.act(left(false));
  EXPECT_FALSE(hand_thread(state, *state.shown, area)) << "let go";
}

// A press is meant for the picture that was shown at that moment.
TEST(Window, AHandTakesTheClothThatWasSeen) {
  Person person("cloth-fall");
  person.wait(20);
  const ViewerState& state = person.viewer.state();
  const ViewArea area = scene_area(person.viewer.layout());
  const SnapshotPtr seen = state.shown;
  const sim::Index vertex = 20 * 33 + 16;  // far from the pinned corners
  SessionFrame late;
  late.elapsed_s = 0.2;
  const glm::vec2 px = *state.camera.project_to_pixel(glm::vec3(seen->positions()[vertex]), area);
  late.events = {renderer::WindowEvent(renderer::PointerMoved{px.x, px.y}),
                 renderer::WindowEvent(renderer::ButtonChanged{PointerButton::left, true})};
  person.viewer.update(late);
  ASSERT_GT(state.shown->record.frame, seen->record.frame + 5) << "the cloth has moved on";
  ASSERT_TRUE(state.held);
  EXPECT_LT(glm::distance(seen->positions()[state.held->vertex], seen->positions()[vertex]), 0.03);
}

TEST(Window, KeysGoToTheNextSceneAndBack) {
  Person person("pinned-9x9-5");
  const ViewerState& state = person.viewer.state();
  const auto own = std::ranges::find(state.scenes, "pinned-9x9-5", &Choice::name);
  ASSERT_NE(own, state.scenes.begin());
  EXPECT_EQ(own->label, "Figure 4, left: a 9x9 cloth held by its upper corners, at rest stretched by less than 5 %");
  person.press(keys::page_down);
  person.wait(3);
  EXPECT_EQ(state.scene.name, std::next(own)->name);
  person.press(keys::page_up);
  person.wait(3);
  person.press(keys::page_up);
  person.wait(3);
  EXPECT_EQ(state.scene.name, std::prev(own)->name);
}

TEST(Window, APictureThatIsDroppedIsItsScene) {
  const TemporaryFolder folder;
  const DrawnScene scene = find_scene("cloth-fall", std::vector{parse_override("wind.speed=3")});
  const std::filesystem::path file = folder / "picture.png";
  write_file(file,
             renderer::encode_png(renderer::make_image(4, 4),
                                  picture_texts({"taut render", scene_text(scene, GarmentNaming::full_path), ""}, {})));
  Person person("pinned-9x9-5");
  person.act(renderer::WindowEvent(renderer::FileDropped{file.string()}));
  person.wait(3);
  EXPECT_EQ(person.viewer.state().scene.surroundings.forces.wind.speed_m_per_s, 3.0);
  EXPECT_EQ(person.viewer.state().scene.garment.grid.columns, scene.garment.grid.columns);
}

TEST(Window, GarmentsAreSortedBySize) {
  std::vector<std::string> names;
  for (const Choice& garment : garment_choices()) names.push_back(garment.name);
  const auto first = std::find(names.begin(), names.end(), "tshirt_1028");
  ASSERT_GE(names.end() - first, 4);
  EXPECT_EQ(std::vector(first, first + 4),
            (std::vector<std::string>{"tshirt_1028", "tshirt_2640", "tshirt_5280", "tshirt_10600"}));
}

TEST(Window, EveryChoiceOfSceneAndGarmentHasAPicture) {
  Person person("pinned-9x9-5");
  person.wait(1);
  const ViewerState& state = person.viewer.state();
  ASSERT_FALSE(state.scenes.empty() || state.garments.empty());
  for (const std::vector<Choice>& choices : {state.scenes, state.garments}) {
    for (const Choice& choice : choices) {
      EXPECT_EQ(std::ranges::count(state.thumbnails, choice.name), 1) << choice.name;
    }
  }
}

TEST(Window, GarmentsWithOtherSeamsHangFromTheirOwn) {
  Person person("tshirt");
  for (const char* garment : {"skirt", "hooded_top", "tshirt_1028"}) {
    person.click("garment");
    person.click(std::string("garment.") + garment);
    person.wait(100);
    EXPECT_EQ(person.viewer.state().scene.garment.file.stem(), garment);
    EXPECT_FALSE(person.viewer.state().newest->stopped) << garment;
  }
}

// Scenes of grids fix the number of substeps for their own solver.
TEST(Window, AnySolverOfTheListTakesItsOwnTimeSteps) {
  Person person("pinned-9x9-5");
  ASSERT_EQ(person.viewer.state().scene.simulation.solver.substeps, 1);
  for (const char* solver : {"ideal", "provot", "bounded", "vassilev", "fast-projection", "implicit"}) {
    person.click("solver");
    person.click(std::string("solver.") + solver);
    person.press('R');
    person.wait(150);
    EXPECT_FALSE(person.viewer.state().newest->stopped) << solver;
    EXPECT_LT(person.viewer.state().newest->record.stretch.max, 2.0) << solver;
  }
  person.click("solver");
  person.click("solver.strong");
  EXPECT_EQ(person.viewer.state().scene.simulation.solver.substeps, 1);
}

TEST(Window, WorkOfAPauseSlowsNothingLater) {
  Person person("pinned-9x9-5");
  person.press(keys::space);
  person.viewer.note_times(1.0, 1.0, 1.0, 10.0);
  person.wait(2);
  person.press(keys::space);
  person.wait(60);
  EXPECT_GT(*person.viewer.state().measurements.real_time.factor(), 0.9);
  EXPECT_EQ(person.viewer.state().measurements.real_time.busy_share(), 0.0);
}

// The reason of a slow simulation would change with it.
TEST(Window, OneQuickFrameDoesNotMakeASlowSimulationQuick) {
  Person person("pinned-9x9-5");
  for (const double simulate_ms : {40.0, 42.0, 10.0}) person.viewer.note_times(1.0, 1.0, simulate_ms, 0.0);
  EXPECT_NEAR(person.viewer.state().measurements.worked_ms, 38.6, 0.1);
}

// Springs diverge, the window reports it, and the person chooses another solver from the list.
TEST(Window, AnySolverOfTheListGoesOnAfterADivergence) {
  for (const sim::SolverKind solver : sim::all_solver_kinds) {
    Person person("pinned-9x9-5", {parse_override("solver.kind=\"ideal\""), parse_override("solver.substeps=1"),
                                   parse_override("solver.stiffness.structural=1e9")});
    person.wait(100);
    ASSERT_TRUE(person.viewer.state().newest->stopped);
    EXPECT_NE(person.viewer.state().warning.find("stopped"), std::string::npos);
    person.click("solver");
    person.click(std::string("solver.") +
                 sim::to_name(solver == sim::SolverKind::ideal ? sim::SolverKind::bounded : solver));
    person.wait(20);
    const bool has_those_springs = solver == sim::SolverKind::provot || solver == sim::SolverKind::vassilev;
    EXPECT_FALSE(person.viewer.state().newest->stopped && !has_those_springs) << sim::to_name(solver);
    EXPECT_LT(person.viewer.state().newest->record.frame, 30) << "from the start";
  }
}

TEST(Window, ClothThatHasLeftIsSaidAndWhatToDo) {
  Person person("pinned-9x9-5", {parse_override("gravity.acceleration=[0, -500, 0]"), parse_override("pins.at=[]")});
  EXPECT_EQ(person.viewer.state().warning, "");
  person.wait(20);
  EXPECT_NE(person.viewer.state().warning.find("F looks at it"), std::string::npos);
  person.press(keys::space);
  person.press('F');
  person.wait(1);
  EXPECT_EQ(person.viewer.state().warning, "");
  person.press('R');
  person.wait(1);
  EXPECT_EQ(person.viewer.state().newest->record.frame, 0);
}

TEST(Window, TheShapeIsExportedAsItIsShown) {
  const test::TemporaryFolder folder;
  Person person("tshirt", {parse_override("garment.file=\"" TAUT_ASSETS_FOLDER "/garments/tshirt_1028.obj\"")},
                folder / "");
  person.wait(3);
  person.press(keys::space);
  person.click("keep.shape");
  const ImportedModel model = import_garment(folder / "tshirt-1.obj");
  EXPECT_EQ(model.positions, person.viewer.state().shown->positions());
  EXPECT_EQ(model.file_triangles, 1028U);
  person.press('E');
  person.wait(1);
  EXPECT_TRUE(std::filesystem::exists(folder / "tshirt-2.obj"));
}

TEST(Window, KeysLookFromTheSides) {
  Person person("pinned-9x9-5", {});
  const auto looks_along = [&](char key) {
    person.press(key);
    person.wait(1);
    const renderer::Camera camera = person.viewer.state().camera.camera();
    return glm::normalize(camera.target - camera.eye);
  };
  EXPECT_LT(looks_along('1').z, -0.99F);
  EXPECT_LT(looks_along('3').x, -0.99F);
  EXPECT_GT(looks_along('7').z, 0.99F);
  EXPECT_LT(looks_along('9').x, -0.5F);
}

TEST(Window, CanBeDrawnBeforeItsFirstFrame) {
  HeadlessViewer window(find_scene("pinned-9x9-5", {}), {}, ".", "auto");
  EXPECT_EQ(window.draw().width_px, 1280);
}

// The picture of F12 and F10 shows the scene and its legends alone.
TEST(Window, APictureHasNothingOfTheWindow) {
  SessionStart start;
  start.size = {900, 600};
  const test::TemporaryFolder folder;
  HeadlessViewer window(find_scene("pinned-9x9-5", {}), start, folder / "", "auto");
  const auto play = [&](std::vector<SessionEvent> events) {
    SessionFrame frame;
    frame.events = std::move(events);
    frame.pace = Pace{0, window.viewer().state().newest->serial};
    window.play(frame);
  };
  const auto key = [](int code, bool down) { return renderer::WindowEvent(renderer::KeyChanged{code, down}); };
  play({});
  play({});
  const renderer::Image plain = window.draw_scene();
  EXPECT_EQ(plain.width_px, 900 - 320);
  EXPECT_EQ(plain.height_px, 600);
  window.viewer().tell("a message over the scene", true);
  play({key('H', true)});
  play({PointAt{"time.pause"}});
  for (int i = 0; i < 60; ++i) play({});
  const renderer::Image with_panel = window.draw();
  play({key(keys::f12, true)});
  EXPECT_EQ(window.draw_scene().pixels, plain.pixels);
  EXPECT_EQ(tests::read_png(folder / "pinned-9x9-5-1.png").pixels, plain.pixels);
  EXPECT_NE(window.draw().pixels, plain.pixels);
  EXPECT_EQ(with_panel.width_px, 900);
  play({PointAt{"look.stretch"}});
  play({renderer::WindowEvent(renderer::ButtonChanged{PointerButton::left, true})});
  play({renderer::WindowEvent(renderer::ButtonChanged{PointerButton::left, false})});
  for (int i = 0; i < 3; ++i) play({});
  const renderer::Image coloured = window.draw_scene();
  EXPECT_FALSE(std::equal(coloured.at(0, 120), coloured.at(100, 120), plain.at(0, 120))) << "the legend is there";
}

}  // namespace
}  // namespace taut::app
