#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/frame_loop.hpp"
#include "app/models/garment_loading.hpp"
#include "app/models/inspecting/inspection.hpp"
#include "app/output/run_report.hpp"
#include "temporary_folder.hpp"

namespace taut::app {
namespace {

using nlohmann::json;
using enum StatisticsFormat;

TEST(RunReport, HoldsWhatTheDesignPromises) {
  DrawnScene scene;
  scene.name = "test";
  scene.garment.grid = {.columns = 3, .rows = 3};
  scene.simulation.solver.substeps = 7;
  sim::Simulation simulation = make_simulation(scene, load_garment(scene));
  const auto records = run_frames(simulation, 2, {});
  const json report = json::parse(statistics_header(
      json_lines, {scene, simulation.garment(), simulation.pins().vertices.size(), "llvmpipe"}));
  EXPECT_EQ(report["scene"], "test");
  EXPECT_EQ(report["garment"]["vertices"], 9);
  EXPECT_EQ(report["garment"]["triangles"], 8);
  EXPECT_EQ(report["garment"]["pins"], 3);
  EXPECT_EQ(report["garment"]["springs"], (json{{"structural", 12}, {"shear", 8}, {"flexural", 6}}));
  EXPECT_EQ(report["settings"]["solver"]["substeps"], 7);
  EXPECT_EQ(report["settings"]["garment"]["grid"]["columns"], 3);
  EXPECT_EQ(report["versions"]["gl_renderer"], "llvmpipe");
  EXPECT_TRUE(report["versions"].contains("program"));
  EXPECT_TRUE(report["versions"].contains("compiler"));
  const std::string line = statistics_line(json_lines, records[1]);
  EXPECT_EQ(line.find('\n'), line.size() - 1);
  EXPECT_TRUE(line.starts_with(statistics_line_start(json_lines, 2))) << line;
  const json frame = json::parse(line);
  for (const char* key :
       {"frame", "time_s", "max_stretch", "p99_stretch", "max_surface_stretch", "p99_surface_stretch",
        "mean_stretch", "max_compression", "rms_speed", "kinetic_energy", "potential_energy", "convergence",
        "sim_ms", "draw_ms", "encode_ms"}) {
    EXPECT_TRUE(frame[key].is_number()) << key;
  }
  EXPECT_EQ(frame["state_hash"].get<std::string>().size(), 16U);
  EXPECT_EQ(frame["asleep"], false);
  FrameRecord stretched;
  stretched.surface_stretch = {0.75, 0.25};
  const json numbers = json::parse(statistics_line(json_lines, stretched));
  EXPECT_EQ(numbers["max_surface_stretch"], 0.75);
  EXPECT_EQ(numbers["p99_surface_stretch"], 0.25);
  EXPECT_TRUE(numbers["smallest_distance"].is_null()) << "nothing near";
  stretched.contact = {5, 4, 300, 0.25};
  const json contact = json::parse(statistics_line(json_lines, stretched));
  EXPECT_EQ(contact["detections"], 5);
  EXPECT_EQ(contact["partial_detections"], 4);
  EXPECT_EQ(contact["contact_pairs"], 300);
  EXPECT_EQ(contact["smallest_distance"], 0.25);
  RunSummary summary;
  summary.add(records[0]);
  summary.max_surface_stretch = 0.5;
  summary.max_surface_stretch_frame = 4;
  summary.max_p99_surface_stretch = 0.25;
  summary.final_max_surface_stretch = 0.125;
  const json end = json::parse(statistics_end(json_lines, summary))["summary"];
  EXPECT_EQ(end["max_surface_stretch"], 0.5);
  EXPECT_EQ(end["max_surface_stretch_frame"], 4);
  EXPECT_EQ(end["max_p99_surface_stretch"], 0.25);
  EXPECT_EQ(end["final_max_surface_stretch"], 0.125);
  EXPECT_EQ(json::parse(statistics_end(json_lines, summary))["summary"]["frames"], 1);
}

// Spreadsheets read the table, and it has the same numbers as the JSON.
TEST(RunReport, IsATableWhereTheNameSaysCsv) {
  DrawnScene scene;
  scene.garment.grid = {.columns = 3, .rows = 3};
  sim::Simulation simulation = make_simulation(scene, load_garment(scene));
  const auto records = run_frames(simulation, 3, {});
  std::string table =
      statistics_header(csv, {scene, simulation.garment(), simulation.pins().vertices.size(), ""});
  std::vector<json> frames;
  for (const FrameRecord& record : records) {
    const std::string row = statistics_line(csv, record);
    EXPECT_TRUE(row.starts_with(statistics_line_start(csv, record.frame))) << row;
    table += row;
    frames.push_back(json::parse(statistics_line(json_lines, record)));
  }
  EXPECT_EQ(statistics_end(csv, {}), "");
  std::istringstream lines(table);
  const auto split_cells = [&] {
    std::string line;
    std::getline(lines, line);
    std::istringstream words(line);
    std::vector<std::string> cells;
    for (std::string cell; std::getline(words, cell, ',');) {
      cells.push_back(cell);
    }
    return cells;
  };
  const std::vector<std::string> names = split_cells();
  EXPECT_EQ(names.size(), frames[0].size());
  for (const json& frame : frames) {
    const std::vector<std::string> row = split_cells();
    ASSERT_EQ(row.size(), names.size());
    for (std::size_t i = 0; i < names.size(); ++i) {
      const json& value = frame.at(names[i]);
      EXPECT_EQ(row[i], value.is_string() ? value.get<std::string>() : value.dump()) << names[i];
    }
  }
  EXPECT_TRUE(split_cells().empty());
}

TEST(RunReport, CountsCrossingPairsWhereSomebodyHasCounted) {
  const DrawnScene scene;
  const RunDescription run = {scene, {}, 0, ""}, verified = {scene, {}, 0, "", true};
  FrameRecord record;
  EXPECT_FALSE(json::parse(statistics_line(json_lines, record)).contains("crossing_pairs"));
  EXPECT_EQ(statistics_header(csv, run).find("crossing_pairs"), std::string::npos);
  const std::string row = statistics_line(csv, record);
  record.crossing_pairs = 7;
  EXPECT_EQ(json::parse(statistics_line(json_lines, record))["crossing_pairs"], 7);
  EXPECT_TRUE(statistics_header(csv, verified).ends_with(",crossing_pairs\n"));
  EXPECT_EQ(statistics_line(csv, record), row.substr(0, row.size() - 1) + ",7\n");

  const test::TemporaryFolder folder;
  const auto file = folder.write("run.csv", statistics_header(csv, run) + row);
  EXPECT_CONTAINS(test::error_message<InputError>([&] { StatisticsFile(file, verified, 0); }),
                  "run.csv': found the columns frame,");
}

TEST(RunReport, RefusesAnEndingThatIsNeither) {
  EXPECT_CONTAINS(test::error_message<UsageError>([] { statistics_format("run.json"); }),
                  "--stats run.json: expected a file name that ends in .jsonl or .csv");
  EXPECT_EQ(statistics_format("/dev/stdout"), json_lines);
  EXPECT_EQ(statistics_format("run.csv"), csv);
}

TEST(RunReport, ExplainsEveryColumn) {
  const DrawnScene scene;
  const std::string header = statistics_header(csv, {scene, {}, 0, ""});
  const std::string help = statistics_help();
  std::istringstream words(header.substr(0, header.find('\n')));
  for (std::string name; std::getline(words, name, ',');) {
    EXPECT_CONTAINS(help, "\n  " + name + ' ');
  }
}

TEST(RunReport, NamesNoRendererWhereNothingWasDrawn) {
  const DrawnScene scene;
  EXPECT_FALSE(
      json::parse(statistics_header(json_lines, {scene, {}, 0, ""}))["versions"].contains("gl_renderer"));
}

TEST(StatisticsFile, HoldsEveryFrameAsItComesAndGoesOnBehindOne) {
  const test::TemporaryFolder folder;
  const DrawnScene scene;
  const sim::Garment garment;
  std::vector<FrameRecord> records(4);
  for (std::size_t i = 0; i < records.size(); ++i) {
    records[i].frame = static_cast<int>(i) + 8;
  }
  for (const char* name : {"run.jsonl", "run.csv"}) {
    const auto file = folder / name;
    const StatisticsFormat format = statistics_format(file);
    std::string expected = statistics_header(format, {scene, garment, 0, ""});
    {
      StatisticsFile statistics(file, {scene, garment, 0, ""}, {});
      EXPECT_EQ(read_text_file(file), expected);
      for (const FrameRecord& record : records) {
        statistics.add(record);
        expected += statistics_line(format, record);
        EXPECT_EQ(read_text_file(file), expected);
      }
      statistics.finish({});
    }
    const std::string whole = expected + statistics_end(format, {});
    EXPECT_EQ(read_text_file(file), whole);
    StatisticsFile resumed(file, {scene, garment, 0, ""}, 9);
    resumed.add(records[2]);
    resumed.add(records[3]);
    resumed.finish({});
    EXPECT_EQ(read_text_file(file), whole);
    EXPECT_CONTAINS(test::error_message<InputError>([&] {
                      StatisticsFile(file, {scene, garment, 0, ""}, 12);
                    }),
                    "it has no line of frame 12");
    EXPECT_EQ(read_text_file(file), whole);
  }
}

// One triangle: every count is 1.
TEST(Inspection, HasALineForEachFact) {
  const test::TemporaryFolder folder;
  DrawnScene scene;
  scene.garment.file = folder.write("one.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const LoadedGarment loaded = load_garment(scene);
  const std::string text = describe(inspect_garment(scene, loaded).facts);
  EXPECT_CONTAINS(text, "import                    format Wavefront OBJ, meshes 1, triangles 1, quads 0, polygons 0, ");
  EXPECT_CONTAINS(text, "\nbounding_box_m            [[0, 0, 0], [1, 1, 0]]\n");
  EXPECT_CONTAINS(text, "\ntopology                  components 1, boundary_edges 3, boundary_loops 1, ");
  EXPECT_CONTAINS(text, "\nvertex_numbers            vertices of the file, 0 to 2\n");
  EXPECT_CONTAINS(text, "\nhanging                   part 1 of 1: 3 vertices, ");
  EXPECT_EQ(text.find("start"), std::string::npos) << "there is none";
}

// The thin triangle's height is half a thousandth of its longest edge, which is enough not to be removed.
TEST(Inspection, CountsTrianglesWithoutASurface) {
  const test::TemporaryFolder folder;
  DrawnScene scene;
  const std::string square = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n";
  scene.garment.file = folder.write("needle.obj", square + "v 0.5 1.0005 0\nf 1 2 3\nf 2 4 3\nf 3 4 5\n");
  const Inspection inspection = inspect_garment(scene, load_garment(scene));
  EXPECT_CONTAINS(describe(inspection.facts),
                  "remarks                   1 triangle is too thin to have a surface, of which only the edges are held");
  EXPECT_EQ(inspection.facts["triangles_without_surface"], 1);
  scene.garment.file = folder.write("square.obj", square + "f 1 2 3\nf 2 4 3\n");
  const Inspection whole = inspect_garment(scene, load_garment(scene));
  EXPECT_EQ(whole.facts["triangles_without_surface"], 0);
  EXPECT_TRUE(whole.facts["start"].is_null());
}

// A square sheared so that its sides keep their length. The diagonal without a spring grows.
TEST(Inspection, MeasuresTheShapeAtTheStart) {
  const test::TemporaryFolder folder;
  DrawnScene scene;
  scene.garment.scale = 1.0;
  scene.garment.up = ModelAxis::y;
  const std::string faces = "f 1 2 3\nf 2 4 3\n";
  scene.garment.file = folder.write("square.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n" + faces);
  scene.garment.start =
      folder.write("sheared.obj", "v 0 0 0\nv 1 0 0\nv 0.28 0.96 0\nv 1.28 0.96 0\n" + faces);
  const Inspection inspection = inspect_garment(scene, load_garment(scene));
  const Json& start = inspection.facts["start"];
  EXPECT_NEAR(start["max_stretch"].get<double>(), 0.0, 1e-12);
  // The angle between the sides has the cosine 0.28.
  EXPECT_NEAR(start["max_surface_stretch"].get<double>(), std::sqrt(1.28) - 1.0, 1e-12);
  EXPECT_CONTAINS(
      describe(inspection.facts),
      "max_surface_stretch 0.131371, p99_surface_stretch 0.131371\n");
  EXPECT_LE(start["p99_surface_stretch"].get<double>(), start["max_surface_stretch"].get<double>());
}

TEST(Inspection, MeasuresTheTShirt) {
  DrawnScene scene;
  scene.garment.file = TAUT_ASSETS_FOLDER "/garments/tshirt_1028.obj";
  const Json report = inspect_garment(scene, load_garment(scene)).facts;
  EXPECT_EQ(report["triangles"], 1028);
  EXPECT_EQ(report["topology"]["components"], 1);
  EXPECT_EQ(report["topology"]["boundary_loops"], 4);
  const Json& edges = report["edge_length_m"];
  EXPECT_LT(edges["min"].get<double>(), edges["mean"].get<double>());
  EXPECT_LT(edges["mean"].get<double>(), edges["max"].get<double>());
  EXPECT_EQ(report["bounding_box_m"].size(), 2U);
  EXPECT_GT(report["springs"]["structural"].get<int>(), 1028);
  EXPECT_GT(report["landmarks"]["hem"].get<int>(), 4);
}

}  // namespace
}  // namespace taut::app
