#include <gtest/gtest.h>

#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/bodies/body_loading.hpp"
#include "app/drawing/drawn_scene.hpp"
#include "app/models/garment_loading.hpp"
#include "app/runs/run_checkpoint.hpp"
#include "temporary_folder.hpp"

namespace taut::app {
namespace {

class BuiltIn : public testing::TestWithParam<BuiltInScene> {};

TEST_P(BuiltIn, GoesOnWithTheSameBits) {
  DrawnScene scene = find_scene(GetParam().name, {});
  const LoadedBodies bodies = load_bodies(scene);
  const LoadedGarment loaded = load_garment(scene);
  // Scenes about contact are ten times as large, and their contacts begin in the first frames.
  const int last = GetParam().is_of_contact ? 4 : 16;
  sim::Simulation whole = make_simulation(scene, loaded, bodies.all);
  go_to_start(scene, bodies, whole);  // some scenes dress a body first
  std::vector<std::string> saved;
  for (int frame = 0; frame < last; ++frame) {
    saved.push_back(sim::encode(whole.save(), whole.garment()));
    whole.advance_frame();
  }
  for (const int from : GetParam().is_of_contact ? std::vector{2} : std::vector{0, 1, 9}) {
    sim::Simulation simulation = make_simulation(scene, loaded, bodies.all);
    simulation.restore(sim::decode(saved[static_cast<std::size_t>(from)], simulation.garment()));
    for (int frame = from; frame < last; ++frame) {
      simulation.advance_frame();
    }
    EXPECT_EQ(sim::hash(simulation.state()), sim::hash(whole.state())) << "from frame " << from;
    EXPECT_EQ(simulation.frame_report(), whole.frame_report());
  }
}

INSTANTIATE_TEST_SUITE_P(RunCheckpoint, BuiltIn, testing::ValuesIn(built_in_scenes()), [](const auto& scene) {
  std::string name = scene.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

RunCheckpoint small_run(const sim::Simulation& simulation) {
  RunCheckpoint run{"small", "[wind]\nspeed = 4.0\n", 7, {}, {}};
  run.summary.max_stretch = 0.25;
  run.summary.max_surface_stretch = 0.5;
  run.summary.max_surface_stretch_frame = 6;
  run.summary.max_p99_surface_stretch = 0.375;
  run.summary.final_max_surface_stretch = 0.125;
  run.summary.frames_over_bound = 3;
  run.simulation = sim::encode(simulation.save(), simulation.garment());
  return run;
}

TEST(RunCheckpoint, ComesBackFromItsFile) {
  const test::TemporaryFolder folder;
  const DrawnScene scene = find_scene("pinned-9x9-5", {});
  sim::Simulation simulation = make_simulation(scene, load_garment(scene));
  const RunCheckpoint run = small_run(simulation);
  write_run_checkpoint(folder / "run", run);
  const RunCheckpoint read = read_run_checkpoint(folder / "run");
  EXPECT_EQ(read.scene_name, run.scene_name);
  EXPECT_EQ(read.scene, run.scene);
  EXPECT_EQ(read.frame, run.frame);
  EXPECT_EQ(read.simulation, run.simulation);
  EXPECT_EQ(read.summary.max_stretch, 0.25);
  EXPECT_EQ(read.summary.max_surface_stretch, 0.5);
  EXPECT_EQ(read.summary.max_surface_stretch_frame, 6);
  EXPECT_EQ(read.summary.max_p99_surface_stretch, 0.375);
  EXPECT_EQ(read.summary.final_max_surface_stretch, 0.125);
  EXPECT_EQ(read.summary.frames_over_bound, 3);
  EXPECT_EQ(read.summary.first_frame_over_bound, -1);
}

TEST(RunCheckpoint, RefusesEveryDamage) {
  const test::TemporaryFolder folder;
  const DrawnScene scene = find_scene("pinned-9x9-5", {});
  sim::Simulation simulation = make_simulation(scene, load_garment(scene));
  write_run_checkpoint(folder / "run", small_run(simulation));
  const std::string whole = read_text_file(folder / "run");
  for (std::size_t at = 0; at < whole.size(); at += at < 300 ? 7 : 311) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 4);
    const auto file = folder.write("damaged", damaged);
    EXPECT_CONTAINS(test::error_message<InputError>([&] { read_run_checkpoint(file); }), "damaged': byte ");
  }
}

TEST(RunCheckpoint, BelongsToItsScene) {
  const RunCheckpoint run{"small", "title = \"a\"\n\n[garment]\nfile = \"x.obj\"\n\n[wind]\nspeed = 4.0\n", 0, {}, ""};
  EXPECT_NO_THROW(require_same_scene("run", run, "moved",
                                     "title = \"a\"\n\n[garment]\nfile = \"/y/x.obj\"\n\n[wind]\nspeed = 4.0\n"));
  const auto refusal = [&](const std::string& text) {
    return test::error_message<InputError>([&] { require_same_scene("run", run, "other", text); });
  };
  EXPECT_EQ(refusal("title = \"a\"\n\n[wind]\nspeed = 5.0\n"),
            "cannot go on from 'run': it was saved of the scene 'small', which has wind.speed = 4.0; found the "
            "scene 'other' with wind.speed = 5.0");
  EXPECT_CONTAINS(refusal("title = \"a\"\n"), "which has wind.speed = 4.0; found the scene 'other' with nothing");
  EXPECT_CONTAINS(refusal("title = \"a\"\n\n[wind]\nspeed = 4.0\nseed = 2\n"),
                  "nothing; found the scene 'other' with wind.seed = 2");
}

// The window stores a moment in this way: as a scene that starts from a checkpoint.
TEST(RunCheckpoint, IsWhereASceneBegins) {
  const test::TemporaryFolder folder;
  DrawnScene scene = find_scene("pinned-9x9-5", {});
  sim::Simulation simulation = make_simulation(scene, load_garment(scene));
  for (int frame = 0; frame < 7; ++frame) {
    simulation.advance_frame();
  }
  write_run_checkpoint(folder / "moment", small_run(simulation));
  scene.checkpoint = "moment";
  const auto file = folder.write("kept.toml", scene_text(scene, GarmentNaming::full_path));
  const DrawnScene kept = read_scene_file(file);
  EXPECT_EQ(kept.checkpoint, folder / "moment");
  sim::Simulation begun = make_simulation(kept, load_garment(kept));
  EXPECT_EQ(go_to_start(kept, {}, begun), 7);
  EXPECT_EQ(sim::hash(begun.state()), sim::hash(simulation.state()));
  EXPECT_EQ(go_to_start(find_scene("pinned-9x9-5", {}), {}, begun), 0);
  EXPECT_EQ(sim::hash(begun.state()), sim::hash(simulation.state()));
  const std::vector<Override> none = {parse_override("start.checkpoint=\"\"")};
  EXPECT_TRUE(read_scene_file(file, none).checkpoint.empty());
}

}  // namespace
}  // namespace taut::app
