#include <gtest/gtest.h>

#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/drawing/drawn_scene.hpp"
#include "app/figures/figures.hpp"
#include "app/figures/pictures.hpp"
#include "smallest_print.hpp"
#include "temporary_folder.hpp"
#include "tests/study/claims/csv_file.hpp"
#include "tests/study/claims/trials.hpp"

namespace taut::app {
namespace {

using test::TemporaryFolder;

TEST(FigureTables, HaveTheirColumnsAndARowForEveryMeasurement) {
  Results results;
  results.fall.emplace();
  results.fall->time_step_s = 0.5;
  results.fall->moved_m = {0.25, 0.125};
  EXPECT_EQ(figure3_csv(results), "iteration,time_s,moved_m\n1,0.5,0.25\n2,1,0.125\n");
  results.frame_times = {{1028, 1, 10, {1.5, 2.5}}};
  EXPECT_EQ(figure6_csv(results), "triangles,substeps,sweeps,repeat,frame_ms\n1028,1,10,1,1.5\n1028,1,10,2,2.5\n");
  results.methods = {{sim::SolverKind::provot, 0.5, {0.125}, {0.25}, {}}};
  EXPECT_EQ(figure7_csv(results), "method,time_step_s,time_s,max_stretch,moved_rms_m\nprovot,0.5,0.5,0.125,0.25\n");
}

std::vector<MethodRun> short_runs() {
  std::vector<MethodRun> runs;
  for (const double rate_hz : method_rates_hz) {
    for (const sim::SolverKind kind : compared_methods) runs.push_back(run_method(kind, rate_hz, 0.1));
  }
  return runs;
}

ClaimResults small_results() {
  ClaimResults results;
  const auto nothing = [](double) {};
  for (std::size_t i = 0; i < results.pinned.size(); ++i) {
    results.pinned[i] = record_frames(find_scene(pinned_scenes[i], {}), std::array{0, 7}, nothing);
  }
  results.fall = record_steps(find_scene(fall_scene, {}), std::array{0, 2}, 5, nothing);
  results.frame_times = {{1028, 1, 10, {1.5, 2.5}}, {5280, 1, 10, {3.0}}, {1028, 100, 1, {0.1}}};
  results.methods = short_runs();
  return results;
}

TEST(FigureTables, ReadBackTheyGiveTheSameTables) {
  const TemporaryFolder folder;
  ClaimResults results = small_results(), again;
  const std::vector<Figure> written = all_figures(results), read = all_figures(again);
  for (std::size_t i = 0; i < written.size(); ++i) {
    if (!written[i].csv || written[i].name == "fig5") continue;
    write_text_file(folder / (written[i].name + ".csv"), written[i].csv());
    if (written[i].shapes_csv) write_text_file(folder / (written[i].name + "_shapes.csv"), written[i].shapes_csv());
    read_figure(read[i].name, folder / "", again);
    EXPECT_TRUE(read[i].csv() == written[i].csv()) << written[i].name;
    if (written[i].shapes_csv) {
      EXPECT_TRUE(read[i].shapes_csv() == written[i].shapes_csv()) << written[i].name;
    }
  }
  EXPECT_TRUE(again.fall->came_to_rest) << "a run that ends before its last frame";
  EXPECT_EQ(again.fall->vertex, followed_vertex(again.fall->frames.scene));
  EXPECT_TRUE(again.methods[0].diverged_at_s) << "a run that ends before its last step";
}

// Along the diagonal of its cells a fifth longer, across it as at rest: edges grow by less than the surface.
Recording recording_of_a_diagonal_stretch() {
  Recording recording;
  recording.scene.name = "diagonal";
  recording.garment = sim::share(sim::make_garment(sim::make_grid({.columns = 3, .rows = 3})));
  recording.moments.resize(1);
  for (const sim::Vec3& p : recording.garment->mesh.positions) {
    const double along = 0.5 * (p.x + p.y);
    recording.moments[0].positions.push_back(p + 0.2 * sim::Vec3(along, along, 0.0));
  }
  recording.moments[0].record.stretch =
      sim::measure_stretch(recording.garment->springs, recording.moments[0].positions);
  recording.moments[0].record.surface_stretch =
      sim::measure_surface_stretch(*recording.garment, recording.moments[0].positions);
  return recording;
}

TEST(FigureTables, HaveTheStretchOfSpringsAndOfTheSurface) {
  const TemporaryFolder folder;
  const Recording recording = recording_of_a_diagonal_stretch();
  write_text_file(folder / "moments.csv", moments_csv(std::array{&recording}));
  const CsvFile table(folder / "moments.csv", moment_columns);
  const double edge = std::sqrt(0.5 * (1.2 * 1.2 + 1.0)) - 1.0;
  for (const auto& [column, expected] : {std::pair(5U, edge), {6U, edge}, {7U, 0.2}, {8U, 0.2}, {9U, edge}}) {
    EXPECT_NEAR(table.number(0, column), expected, 1e-12) << column;
  }
}

TEST(FigureCaptions, SayTheStretchOfSpringsAndOfTheSurface) {
  const Recording recording = recording_of_a_diagonal_stretch();
  EXPECT_EQ(largest_stretch_text({&recording, &recording.last()}), "largest stretch: springs 10.5 %, surface 20 %");
}

TEST(FigureTables, WhatIsWrongWithOneIsSaidWithItsLine) {
  const TemporaryFolder folder;
  const std::string head =
      "panel,scene,frame,time_s,at_rest,max_stretch,p99_stretch,max_surface_stretch,p99_surface_stretch,mean_"
      "stretch\n";
  const std::string shapes = "panel,vertex,x_m,y_m,z_m\n";
  const auto error_with = [&](const std::string& moments, const std::string& positions) {
    folder.write("fig4.csv", moments);
    folder.write("fig4_shapes.csv", positions);
    ClaimResults results;
    const std::string error = test::error_message<InputError>([&] { read_figure("fig4", folder / "", results); });
    return error.substr(error.find("fig4") == std::string::npos ? 0 : error.find("fig4"));
  };
  const std::string row = "a,pinned-9x9-5,1,0.1,0,0,0,0,0,0\n";
  EXPECT_EQ(error_with("a,b\n1,2\n", shapes).substr(0, 37), "fig4.csv:1: found the columns a,b, ex");
  EXPECT_EQ(error_with(head + "a,b\n", shapes), "fig4.csv:2: found 2 cells, expected 10");
  EXPECT_EQ(error_with(head, shapes), "fig4.csv: found no rows, expected at least one");
  EXPECT_EQ(error_with(head + "a,\"x, y\",1,0.1,0,0,0,0,0,0\n", shapes + "a,0,0,0,0\n"),
            "fig4.csv: found no moment of the scene pinned-9x9-5, expected one");
  EXPECT_EQ(error_with(head + row, shapes + "a,0,0,0,0\na,2,0,0,0\n"),
            "fig4_shapes.csv:3: panel a: found vertex 2, expected 1");
  EXPECT_EQ(error_with(head + row, shapes + "a,0,0,up,0\n"), "fig4_shapes.csv:2: y_m: found 'up', expected a number");
  EXPECT_EQ(error_with(head + "a,pinned-9x9-5,1.5,0.1,0,0,0,0,0,0\n", shapes + "a,0,0,0,0\n"),
            "fig4.csv:2: frame: found '1.5', expected a whole number");
  EXPECT_EQ(error_with(head + row, shapes + "a,0,0,0,0\n"),
            "fig4_shapes.csv: panel a: found 1 vertices, expected 81, as the garment of pinned-9x9-5 has");
}

TEST(Figures, TextsAreLargeEnoughInPrint) {
  ClaimResults results;
  experiments(results).front().work([](double) {});
  results.methods = short_runs();
  LazyOffscreenRenderer offscreen("auto", 0.02F);
  for (const Figure& figure : all_figures(results)) {
    if (figure.name != "fig7") read_figure(figure.name, TAUT_TESTS_FOLDER "/golden/figures", results);
    EXPECT_GE(test::smallest_print_pt(figure.draw(offscreen)), test::min_text_pt) << figure.name;
  }
}

}  // namespace
}  // namespace taut::app
