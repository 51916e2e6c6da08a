#include <gtest/gtest.h>

#include "app/viewer/headless_viewer.hpp"
#include "app/viewer/viewer.hpp"
#include "app/viewer/panel/panel.hpp"
#include "person.hpp"
#include "sim/measures.hpp"
#include "temporary_folder.hpp"

// Stretch in the window: its readings and choices.

namespace taut::app {
namespace {

namespace keys = renderer::keys;
using renderer::PointerButton;
using test::Person;

// The kind of bound is a choice of the bounded solver alone. It takes effect at once and is saved with the scene.
TEST(Window, TheBoundHoldsWhatIsChosen) {
  Person person("pinned-9x9-5");
  EXPECT_FALSE(person.shows("solver.bound")) << "the scene's solver has no bound";
  person.click("solver");
  person.click("solver.provot");
  EXPECT_TRUE(person.shows("solver.max_stretch"));
  EXPECT_FALSE(person.shows("solver.bound")) << "a threshold is for springs";
  person.click("solver");
  person.click("solver.bounded");
  for (const sim::BoundKind bound : {sim::BoundKind::surface, sim::BoundKind::springs}) {
    person.click("solver.bound");
    for (const auto& [name, place] : person.viewer.state().places) {
      EXPECT_FALSE(hint_for(name).empty()) << name;
    }
    person.click(std::string("solver.bound.") + sim::to_name(bound));
    const auto& method = person.viewer.state().newest->settings.solver.method;
    EXPECT_EQ(std::get<sim::BoundedSettings>(method).bound, bound) << "while it runs";
    EXPECT_CONTAINS(scene_text(kept_scene(person.viewer.state(), {640, 480})),
                    std::string("bound = \"") + sim::to_name(bound) + '"');
  }
}

TEST(Window, ContactIsASwitchOfBoundedAlone) {
  Person person("pinned-9x9-5");
  EXPECT_FALSE(person.shows("solver.contact")) << "the scene's solver has none";
  person.click("solver");
  person.click("solver.bounded");
  EXPECT_FALSE(hint_for("solver.contact").empty());
  person.click("solver.contact");
  const auto& method = person.viewer.state().newest->settings.solver.method;
  EXPECT_FALSE(std::get<sim::BoundedSettings>(method).contact) << "while it runs";
  EXPECT_CONTAINS(scene_text(kept_scene(person.viewer.state(), {640, 480})), "contact = false");
}

// A moment of the past, projected into the present bound.
TEST(Window, MeasuresWhatItShowsOfThePast) {
  Person person("pinned-9x9-20");
  person.wait(60);
  person.press(keys::space);
  person.click("timeline");
  const Snapshot before = *person.viewer.state().shown;
  ASSERT_LT(before.record.frame, person.viewer.state().newest->record.frame);
  person.click("solver");
  person.click("solver.bounded");
  const Snapshot& shown = *person.viewer.state().shown;
  EXPECT_NE(shown.record.surface_stretch.max, before.record.surface_stretch.max);
  EXPECT_EQ(shown.record.surface_stretch.max,
            sim::measure_surface_stretch(*shown.garment, shown.positions()).max);
  EXPECT_EQ(shown.record.stretch.max, sim::measure_stretch(shown.garment->springs, shown.positions()).max);
}

TEST(Window, ColoursShowTheStretchOfWhatIsChosen) {
  Person person("pinned-9x9-5");
  EXPECT_FALSE(person.shows("look.stretch_of"));
  person.click("look.stretch");
  for (const StretchOf shown : {StretchOf::surface, StretchOf::springs}) {
    person.click("look.stretch_of");
    for (const auto& [name, place] : person.viewer.state().places) {
      EXPECT_FALSE(hint_for(name).empty()) << name;
    }
    person.click(std::string("look.stretch_of.") + to_name(shown));
    EXPECT_EQ(person.viewer.state().scene.picture.stretch_of, shown);
    EXPECT_CONTAINS(scene_text(kept_scene(person.viewer.state(), {640, 480})),
                    std::string("stretch_of = \"") + to_name(shown) + '"');
  }
  person.click("look.shaded");
  EXPECT_FALSE(person.shows("look.stretch_of"));
}

// The panel fits the initial size of the window with every solver.
TEST(Window, ThePanelNeedsNoScrolling) {
  Person person("pinned-9x9-5");
  person.click("look.stretch");
  for (const sim::SolverKind solver : sim::all_solver_kinds) {
    person.click("solver");
    person.click(std::string("solver.") + sim::to_name(solver));
    EXPECT_LE(person.viewer.state().places.at("keep.video").upper_px.y, 720.0F) << sim::to_name(solver);
  }
}

TEST(Window, DrawsTheColoursOfWhatIsChosen) {
  const std::vector<Override> coloured = {parse_override("picture.surface=\"stretch\"")};
  HeadlessViewer window(find_scene("pinned-9x9-20", coloured), {}, ".", "auto");
  const auto play = [&](const std::vector<SessionEvent>& events) {
    SessionFrame frame;
    frame.events = events;
    window.play(frame);
  };
  const auto click = [&](const std::string& item) {
    play({PointAt{item}});
    play({renderer::WindowEvent(renderer::ButtonChanged{PointerButton::left, true})});
    play({renderer::WindowEvent(renderer::ButtonChanged{PointerButton::left, false})});
    play({});
    play({});
  };
  for (int i = 0; i < 30; ++i) play({});
  click("time.pause");
  const renderer::Image surface = window.draw_scene();
  click("look.stretch_of");
  click("look.stretch_of.springs");
  const renderer::Image springs = window.draw_scene();
  int changed = 0;
  for (int y = 0; y < springs.height_px; ++y) {
    const int beside_the_legend_px = 250;
    for (int x = beside_the_legend_px; x < springs.width_px; ++x) {
      changed += std::equal(springs.at(x, y), springs.at(x, y) + 3, surface.at(x, y)) ? 0 : 1;
    }
  }
  EXPECT_GT(changed, 1000);
}

}  // namespace
}  // namespace taut::app
