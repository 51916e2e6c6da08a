#include <gtest/gtest.h>

#include <numbers>

#include "app/base/errors.hpp"
#include "app/drawing/drawn_scene.hpp"
#include "app/scene/scene.hpp"
#include "app/scene/scene_format.hpp"
#include "temporary_folder.hpp"

namespace taut::app {
namespace {

using test::error_message;
using test::TemporaryFolder;

constexpr const char* grid = "[garment.grid]\ncolumns = 3\nrows = 4\n";

std::string file_error(const TemporaryFolder& folder, const std::string& text) {
  const auto path = folder.write("scene.toml", text);
  return error_message<InputError>([&] { read_scene_file(path); });
}

std::string set_error(const std::string& text) {
  DrawnScene scene;
  return error_message<UsageError>([&] { apply_overrides(std::vector{parse_override(text)}, scene); });
}

TEST(SceneFile, RefusesStiffnessBesideWhichMassesAreRoundedAway) {
  for (const std::string key : {"solver.implicit.stretch", "solver.implicit.shear"}) {
    EXPECT_EQ(set_error(key + "=1e7"), "");
    EXPECT_CONTAINS(set_error(key + "=1.1e7"), "expected a number from 0 to");
  }
}

TEST(SceneFile, ReadsEveryKindOfKey) {
  const TemporaryFolder folder;
  const auto path = folder.write("scene.toml", R"(
title = "A test"
[garment]
areal_density = 0.2
flexural_angle = 120
grid = { columns = 5, rows = 7, plane = "horizontal", top = [1, 2, 3.5] }
[pins]
at = ["top-left", 4, { nearest = [0, 1, 0] }]
[solver]
kind = "ideal"
substeps = 7
[cloth]
friction = 0.7
[[forces]]
vertex = 3
force = [0, 1, 0]
[[bodies]]
shape = "sphere"
centre = [0, -1, 0]
radius = 0.25
[[bodies]]
shape = "plane"
normal = [0, 2, 0]
friction = 0.5
[camera]
box = [[-1, -2, -3], [1, 2, 3]]
[picture]
ground = -1.5
outside_colour = "#ff8000"
stretch_range = [-0.1, 0.2]
shadows = false
)");
  const DrawnScene scene = read_scene_file(path);
  EXPECT_EQ(scene.title, "A test");
  EXPECT_EQ(scene.garment.grid.rows, 7U);
  EXPECT_EQ(scene.garment.grid.plane, sim::GridPlane::horizontal);
  EXPECT_EQ(scene.garment.grid.top_centre_m, sim::Vec3(1, 2, 3.5));
  EXPECT_EQ(scene.material.areal_density_kg_per_m2, 0.2);
  EXPECT_NEAR(scene.mapping.min_flexural_angle_rad, 2.0 * std::numbers::pi / 3.0, 1e-12);
  ASSERT_EQ(scene.pins->size(), 3U);
  EXPECT_EQ(std::get<std::string>((*scene.pins)[0]), "top-left");
  EXPECT_EQ(std::get<sim::Index>((*scene.pins)[1]), 4U);
  EXPECT_EQ(std::get<NearestTo>((*scene.pins)[2]).point_m, sim::Vec3(0, 1, 0));
  EXPECT_EQ(scene.simulation.solver.kind, sim::SolverKind::ideal);
  EXPECT_EQ(scene.simulation.solver.substeps, 7);
  EXPECT_EQ(scene.surroundings.forces.artificial_forces, (std::vector<sim::PointForce>{{3, sim::Vec3(0, 1, 0)}}));
  const std::vector<sim::Body> bodies = named_bodies(scene);
  ASSERT_EQ(bodies.size(), 2U);
  EXPECT_EQ(std::get<sim::Sphere>(bodies[0].shape), (sim::Sphere{sim::Vec3(0, -1, 0), 0.25}));
  EXPECT_EQ(std::get<sim::Plane>(bodies[1].shape).normal, sim::Vec3(0, 1, 0));
  EXPECT_EQ(bodies[0].friction, std::nullopt) << "the cloth's";
  EXPECT_EQ(bodies[1].friction, 0.5);
  EXPECT_EQ(scene.material.friction, 0.7);
  EXPECT_EQ(scene.camera.box->upper, glm::vec3(1, 2, 3));
  EXPECT_EQ(scene.picture.ground.kind, GroundKind::fixed);
  EXPECT_EQ(scene.picture.ground.height_m, -1.5);
  EXPECT_EQ(scene.picture.cloth.outside_colour, renderer::rgb(0xFF8000));
  EXPECT_EQ(scene.picture.stretch_range, std::optional(std::array{-0.1, 0.2}));
  EXPECT_FALSE(scene.picture.settings.shadows);
}

TEST(SceneFile, TakesGarmentFilesRelativeToItself) {
  const TemporaryFolder folder;
  const auto path = folder.write("scene.toml", "[garment]\nfile = \"shirts/a.obj\"\n");
  std::filesystem::create_directory(folder / "shirts");
  folder.write("shirts/a.obj", "f");
  EXPECT_EQ(read_scene_file(path).garment.file, folder / "shirts/a.obj");
}

TEST(SceneFile, NamesTheLineOfAGarmentThatIsNotThere) {
  const TemporaryFolder folder;
  const std::string text = "title = \"Lost\"\n[garment]\nfile = \"a.obj\"\n";
  EXPECT_CONTAINS(file_error(folder, text),
                  "scene.toml:3: garment.file: there is no file '" + (folder / "a.obj").string() + '\'');
  folder.write("b.obj", "f");
  const Override other = {"garment.file", (folder / "b.obj").string(), "--set garment.file=b.obj"};
  EXPECT_EQ(read_scene_file(folder / "scene.toml", std::span(&other, 1)).garment.file, folder / "b.obj")
      << "what takes its place is there";
}

TEST(SceneFile, TakesKeysOfEverySolverInAnyOrderAndTheKindLast) {
  const TemporaryFolder folder;
  const std::string keys =
      "[solver]\niterations = 7\nprojections = 9\nmax_stretch = 0.2\n"
      "stiffness.structural = 30\nimplicit.shear = 3\n";
  const auto method_of = [&](const std::string& kind) {
    const auto path = folder.write("scene.toml", grid + keys + "kind = \"" + kind + "\"\n");
    return simulation_settings(read_scene_file(path).simulation).solver.method;
  };
  const sim::SpringStiffness soft = {.structural_n_per_m = 30.0};
  EXPECT_EQ(method_of("ideal"), sim::SolverMethod(sim::IdealSettings{soft}));
  EXPECT_EQ(method_of("provot"), sim::SolverMethod(sim::ProvotSettings{soft, 0.2}));
  EXPECT_EQ(method_of("vassilev"), sim::SolverMethod(sim::VassilevSettings{soft, 0.2}));
  EXPECT_EQ(method_of("fast-projection"), sim::SolverMethod(sim::FastProjectionSettings{soft, 0.2, 9}));
  EXPECT_EQ(method_of("implicit"), sim::SolverMethod(sim::ImplicitSettings{.shear_n_per_m = 3.0}));
  EXPECT_EQ(method_of("strong"), sim::SolverMethod(sim::StrongSettings{.iterations = 7}));
  EXPECT_EQ(method_of("bounded"), sim::SolverMethod(sim::BoundedSettings{.max_stretch = 0.2}));
}

TEST(SceneFile, SaysWhatABoundHoldsAndWhatColoursShow) {
  const TemporaryFolder folder;
  for (const sim::BoundKind bound : sim::all_bound_kinds) {
    for (const StretchOf shown : all_stretch_of) {
      const std::string text = std::string(grid) + "[solver]\nbound = \"" + sim::to_name(bound) +
                               "\"\n[picture]\nstretch_of = \"" + to_name(shown) + "\"\n";
      const DrawnScene scene = read_scene_file(folder.write("scene.toml", text));
      EXPECT_EQ(scene.simulation.solver.bounded.bound, bound);
      EXPECT_EQ(bound_kind(scene), bound);
      EXPECT_EQ(scene.picture.stretch_of, shown);
      const std::string saved = scene_text(scene);
      EXPECT_EQ(scene_text(read_scene_file(folder.write("saved.toml", saved))), saved);
      EXPECT_CONTAINS(saved, std::string("bound = \"") + sim::to_name(bound) + '"');
      EXPECT_CONTAINS(saved, std::string("stretch_of = \"") + to_name(shown) + '"');
    }
  }
  const std::string strong = std::string(grid) + "[solver]\nbound = \"surface\"\nkind = \"strong\"\n";
  EXPECT_EQ(bound_kind(read_scene_file(folder.write("scene.toml", strong))), sim::BoundKind::springs)
      << "as solver.max_stretch, for solvers that have it";
  EXPECT_CONTAINS(file_error(folder, std::string(grid) + "[solver]\nbound = \"edges\"\n"),
                  "solver.bound: found \"edges\", expected \"springs\" or \"surface\"");
  EXPECT_CONTAINS(file_error(folder, std::string(grid) + "[picture]\nstretch_of = 2\n"),
                  "picture.stretch_of: found 2, expected \"springs\" or \"surface\"");
}

TEST(SceneFile, LeavesOutWhatIsLeftToTheProgram) {
  const TemporaryFolder folder;
  const std::string text = std::string(grid) + "[solver]\nsubsteps = 0\nthreads = 3\n";
  const Scene scene = read_scene_file(folder.write("scene.toml", text));
  EXPECT_EQ(scene.simulation.solver.substeps, std::nullopt);
  EXPECT_EQ(scene.simulation.solver.bounded.threads, 3);
  EXPECT_EQ(scene.garment.scale, std::nullopt);
}

TEST(SceneFile, SaysWhetherThereIsContact) {
  const TemporaryFolder folder;
  EXPECT_TRUE(read_scene_file(folder.write("scene.toml", grid)).simulation.solver.bounded.contact);
  const std::string without = std::string(grid) + "[solver]\ncontact = false\n";
  const DrawnScene scene = read_scene_file(folder.write("scene.toml", without));
  EXPECT_FALSE(scene.simulation.solver.bounded.contact);
  EXPECT_CONTAINS(scene_text(scene), "contact = false");
  EXPECT_CONTAINS(file_error(folder, std::string(grid) + "[solver]\ncontact = 1\n"),
                  "solver.contact: found 1, expected true or false");
}

TEST(SceneFile, NamesAStartThatIsNotThere) {
  const TemporaryFolder folder;
  EXPECT_CONTAINS(file_error(folder, "[garment]\nstart = \"end.obj\"\ngrid.rows = 3\n"),
                  "scene.toml:2: garment.start: there is no file '" + (folder / "end.obj").string() + '\'');
  EXPECT_CONTAINS(set_error("garment.start=\"no.obj\""), "garment.start: there is no file 'no.obj'");
}

TEST(SceneFile, NamesFileLineKeyAndNearestKeyOfAnUnknownOne) {
  const TemporaryFolder folder;
  const std::string error = file_error(folder, std::string(grid) + "[wind]\nspeeed = 3\n");
  EXPECT_CONTAINS(error, (folder / "scene.toml").string() + ":5: unknown key 'wind.speeed'");
  EXPECT_CONTAINS(error, "did you mean 'wind.speed'?");
  EXPECT_CONTAINS(error, "keys of wind: speed, direction");
}

TEST(SceneFile, NamesUnknownSections) {
  const TemporaryFolder folder;
  const std::string error = file_error(folder, std::string(grid) + "[solvr]\nsubsteps = 3\n");
  EXPECT_CONTAINS(error, ":4: unknown key 'solvr'; did you mean 'solver'?");
}

TEST(SceneFile, RefusesWrongTypes) {
  const TemporaryFolder folder;
  EXPECT_CONTAINS(file_error(folder, std::string(grid) + "[wind]\nspeed = \"3\"\n"),
                  ":5: wind.speed: found \"3\", expected a number from 0 to 200 (m/s)");
  EXPECT_CONTAINS(file_error(folder, std::string(grid) + "[solver]\nsubsteps = 2.5\n"),
                  ":5: solver.substeps: found 2.5, expected a whole number from 0");
  EXPECT_CONTAINS(file_error(folder, "wind = 3\n" + std::string(grid)),
                  ":1: wind: found 3, expected a table with the keys speed");
  EXPECT_CONTAINS(file_error(folder, std::string(grid) + "[pins]\nat = [1.5]\n"), "pins.at: found [1.5]");
  EXPECT_CONTAINS(file_error(folder, std::string(grid) + "[picture]\nshadows = 1\n"), "expected true or false");
  EXPECT_CONTAINS(file_error(folder, std::string(grid) + "[picture]\ninside_colour = \"#12345g\"\n"),
                  "expected a colour");
  EXPECT_CONTAINS(file_error(folder, std::string(grid) + "[gravity]\nacceleration = [1, 2]\n"),
                  "expected three numbers");
}

TEST(SceneFile, RefusesValuesOutOfRange) {
  const TemporaryFolder folder;
  EXPECT_CONTAINS(file_error(folder, "[garment]\nareal_density = 0\ngrid.rows = 3\n"),
                  "expected a number from 1e-06 to 10000");
  for (const std::string wrong : {"garment.areal_density=1e300", "cloth.thickness=1e-300", "wind.gust_period=1e-300",
                                  "air.drag=1e300", "solver.max_stretch=1e300", "cloth.bending_rigidity=1e300",
                                  "cloth.tensile_warp=1e300", "cloth.warp_limit=1e-300", "rest.speed=1e300"}) {
    EXPECT_CONTAINS(set_error(wrong), ": found 1e");
  }
  EXPECT_CONTAINS(file_error(folder, std::string(grid) + "[solver]\ncompression = 1.1\n"), "from 0 to 1");
  EXPECT_CONTAINS(file_error(folder, std::string(grid) + "[air]\ndrag = nan\n"), "expected a number from 0 to 1000000");
  EXPECT_CONTAINS(file_error(folder, std::string(grid) + "[wind]\ndirection = [0, 0, 0]\n"), "not all zero");
  EXPECT_CONTAINS(file_error(folder, std::string(grid) + "[picture]\nstretch_range = [1, 0]\n"), "lower first");
  EXPECT_CONTAINS(file_error(folder, std::string(grid) + "[camera]\nbox = [[1,0,0],[0,1,1]]\n"), "camera.box");
}

TEST(SceneFile, ListsTheChoices) {
  const TemporaryFolder folder;
  EXPECT_CONTAINS(file_error(folder, std::string(grid) + "[solver]\nkind = \"stronk\"\n"),
                  "found \"stronk\", expected \"ideal\" or ");
}

TEST(SceneFile, ChecksBodiesByTheirShape) {
  const TemporaryFolder folder;
  const std::string start = std::string(grid) + "[[bodies]]\n";
  EXPECT_CONTAINS(file_error(folder, start + "radius = 1\n"), "has no shape");
  EXPECT_CONTAINS(file_error(folder, start + "shape = \"cube\"\n"), "found \"cube\"");
  EXPECT_CONTAINS(file_error(folder, start + "shape = \"plane\"\nradius = 1\n"), ":6: unknown key 'radius'");
  EXPECT_CONTAINS(file_error(folder, start + "shape = \"sphere\"\nradius = -1\n"), ":6: radius: found -1");
}

TEST(SceneFile, NeedsExactlyOneGarment) {
  const TemporaryFolder folder;
  EXPECT_CONTAINS(file_error(folder, "title = \"x\"\n"), "no garment is given");
  EXPECT_CONTAINS(file_error(folder, "[garment]\nfile = \"a.obj\"\ngrid.rows = 3\n"), "both garment.file and");
}

TEST(SceneFile, NeedsEyeAndTargetTogether) {
  const TemporaryFolder folder;
  EXPECT_CONTAINS(file_error(folder, std::string(grid) + "[camera]\neye = [0, 0, 1]\n"), "needed together");
}

TEST(SceneFile, SaysWhatIsNoToml) {
  const TemporaryFolder folder;
  EXPECT_CONTAINS(file_error(folder, "a = 1\nb = = 2\n"), "scene.toml:2: this is not TOML");
}

TEST(SceneFile, RefusesWhatIsNestedTooDeeply) {
  const TemporaryFolder folder;
  std::string dotted = "a";
  for (int k = 0; k < 100000; ++k) dotted += ".a";
  std::string quoted = "\"a,b\"";
  for (int k = 0; k < 100000; ++k) quoted += ".\"a,b\"";
  for (const std::string& key : {dotted, quoted}) {
    EXPECT_CONTAINS(file_error(folder, key + " = 1\n"), "more than 32 deep");
    EXPECT_CONTAINS(file_error(folder, '[' + key + "]\n"), "more than 32 deep");
    EXPECT_CONTAINS(file_error(folder, "x = \"\"\"\"a\"\"\"\"\n" + key + " = 1\n"), "more than 32 deep");
    EXPECT_CONTAINS(file_error(folder, "x = {a = \"\"\" \" \"\"\", " + key + " = 1}\n"), "more than 32 deep");
  }
  EXPECT_CONTAINS(file_error(folder, "x = " + std::string(100000, '[')), "more than 32 deep");
  EXPECT_NE(set_error("title=" + std::string(100000, '[')), "more than 32 deep");
  const std::string rule(1000, '.');
  EXPECT_EQ(file_error(folder, "# " + rule + "\ntitle = \"" + rule + "\"\n" + grid), "");
}

TEST(Overrides, ReplaceAnyKey) {
  DrawnScene scene;
  const std::vector<Override> overrides = {parse_override("solver.kind=ideal"), parse_override("wind.speed=4"),
                                           parse_override("camera.eye=[0,0,1]"),
                                           parse_override("camera.target=[0,0,0]"), parse_override("pins.at=none")};
  apply_overrides(overrides, scene);
  EXPECT_EQ(scene.simulation.solver.kind, sim::SolverKind::ideal);
  EXPECT_EQ(scene.surroundings.forces.wind.speed_m_per_s, 4.0);
  EXPECT_EQ(*scene.camera.eye, glm::vec3(0, 0, 1));
  EXPECT_TRUE(scene.pins->empty());
}

TEST(Overrides, AreCheckedLikeFiles) {
  EXPECT_CONTAINS(set_error("solver.substep=4"), "--set solver.substep=4: unknown key");
  EXPECT_CONTAINS(set_error("solver.iterations=0"), "--set solver.iterations=0: solver.iterations: found 0, expected");
  EXPECT_CONTAINS(set_error("solver=3"), "expected a table with the keys kind");
  EXPECT_CONTAINS(set_error("camera.eye=[0,0,1]"), "needed together");
  EXPECT_CONTAINS(error_message<UsageError>([] { parse_override("wind"); }), "expected KEY=VALUE");
}

// A default that its own key refuses would make the help wrong.
TEST(SceneKeys, AcceptTheirOwnDefaults) {
  const Source source{"defaults", true};
  for (const Key<DrawnScene>& key : drawn_scene_format().keys) {
    DrawnScene scene;
    const Json value = key.write(scene);
    if (!value.is_null()) {
      EXPECT_TRUE(key.read(*read_toml_value(toml_text(value)).get("value"), source, scene)) << key.name;
      EXPECT_EQ(to_text(key.write(scene)), to_text(value)) << key.name;
    }
    EXPECT_FALSE(key_meaning(key.name).empty()) << key.name;
  }
}

TEST(SceneKeys, StandInTheHelp) {
  const std::string help = scene_help();
  for (const Key<DrawnScene>& key : drawn_scene_format().keys) {
    EXPECT_CONTAINS(help, "  " + key.name + " = ");
  }
  EXPECT_CONTAINS(help, "start_radius");
}

}  // namespace
}  // namespace taut::app
