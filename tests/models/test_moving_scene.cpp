// Scenes in which pins and bodies move, from their text to the cloth.

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "app/base/errors.hpp"
#include "app/bodies/body_loading.hpp"
#include "app/drawing/drawn_scene.hpp"
#include "app/models/garment_loading.hpp"
#include "temporary_folder.hpp"

namespace taut::app {
namespace {

sim::Simulation make_simulation(const std::string& text) {
  const DrawnScene scene = read_scene_text(text, "scene.toml");
  return make_simulation(scene, load_garment(scene));
}

const std::string grid = "[garment.grid]\ncolumns = 9\nrows = 9\ntop = [0, 1, 0]\n";

TEST(MovingScene, ACapsulePushesClothAlong) {
  sim::Simulation simulation = make_simulation(grid + R"(
[[bodies]]
shape = "capsule"
start = [-1, 0.3, -0.3]
end = [1, 0.3, -0.3]
shift = { velocity = [0, 0, 0.5], until = 1 }
)");
  for (int frame = 0; frame < 90; ++frame) {
    simulation.advance_frame();
  }
  for (std::size_t v = 6 * 9; v < 9 * 9; ++v) {
    EXPECT_GT(simulation.state().current[v].z, 0.2) << v;
  }
}

TEST(MovingScene, PinsThatMoveAreHeldBesidesTheOthers) {
  sim::Simulation simulation = make_simulation(grid + R"(
[pins]
at = ["top-left"]
[[pins.moving]]
at = ["bottom-right", "top-right"]
shift = { velocity = [-0.2, 0, 0] }
)");
  EXPECT_EQ(simulation.pins().vertices, (std::vector<sim::Index>{0, 8, 80}));
  for (int frame = 0; frame < 30; ++frame) {
    simulation.advance_frame();
  }
  const std::vector<sim::Vec3>& modelled = simulation.garment().mesh.positions;
  EXPECT_EQ(simulation.state().current[0], modelled[0]);
  for (const sim::Index pin : {8U, 80U}) {
    EXPECT_LT(glm::distance(simulation.state().current[pin], modelled[pin] + sim::Vec3(-0.1, 0, 0)), 1e-12);
  }
}

TEST(MovingScene, NamesPinsThatAreNotThereOrLedTwice) {
  const auto error_text = [](const std::string& rest) {
    return test::error_message<InputError>([&] { make_simulation(grid + rest); });
  };
  EXPECT_CONTAINS(error_text("[[pins.moving]]\nat = [81]\n"), "pins.moving: found vertex 81, expected");
  EXPECT_CONTAINS(error_text("[[pins.moving]]\nat = \"top-lift\"\n"), "pins.moving: the garment has no part named");
  EXPECT_CONTAINS(error_text("[[pins.moving]]\nat = [8]\n[[pins.moving]]\nat = \"top-edge\"\n"),
                  "pins.moving: found vertex 8 in two entries");
}

TEST(MovingScene, AModelThatIsSubdividedKeepsItsMovingBordersWhole) {
  const test::TemporaryFolder folder;
  const auto file = folder.write("square.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 4 3\n");
  sim::Simulation simulation = make_simulation("[garment]\nfile = \"" + file.string() +
                                               "\"\nsubdivisions = 2\n[pins]\nat = [0]\n[[pins.moving]]\nat = [2, 3]\n"
                                               "shift = { velocity = [0, 0, 0.1] }\n");
  for (int frame = 0; frame < 6; ++frame) {
    simulation.advance_frame();
  }
  const std::vector<sim::Vec3>& modelled = simulation.garment().mesh.positions;
  int moved = 0;
  for (std::size_t v = 0; v < modelled.size(); ++v) {
    if (modelled[v].y == 1.0) {
      EXPECT_LT(glm::distance(simulation.state().current[v], modelled[v] + sim::Vec3(0, 0, 0.01)), 1e-12);
      ++moved;
    }
  }
  EXPECT_EQ(moved, 5);
}

TEST(MovingScene, ABodyWhoseMeshWasNotReadIsRefused) {
  EXPECT_THROW(make_simulation(grid + "[[bodies]]\nname = \"x\"\nshape = \"mesh\"\nfile = \"x.obj\"\n"),
               std::invalid_argument);
}

}  // namespace
}  // namespace taut::app
