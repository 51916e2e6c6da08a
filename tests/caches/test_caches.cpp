// Frames that are written for other programs.

#include <fmt/core.h>

#include <map>
#include <sstream>

#include "app/base/errors.hpp"
#include "app/bodies/frame_source.hpp"
#include "app/caches/frame_sink.hpp"
#include "temporary_folder.hpp"

namespace taut::app {
namespace {

// Two panels of quads with a seam down the middle, along which texture coordinates differ and vertices are doubled;
// then a polygon of five corners and a triangle. Faces do not use the vertices in the file's order, and no face uses
// the first.
const std::string seamed =
    "mtllib shirt.mtl\n"
    "v 9 9 9\nv 0.5 0.5 0\nv 0 0 0\nv 0.5 0 0\nv 0 0.5 0\n"
    "v 1 0 0\nv 0.5 0 0\nv 1 0.5 0\nv 0.5 0.5 0\nv 0 1 0\nv 0.5 1 0\nv 0.25 1.25 0\nv 1 1 0\n"
    "vt 0.1 0.1\nvt 0.4 0.1\nvt 0.4 0.4\nvt 0.1 0.4\nvt 0.6 0.1\nvt 0.9 0.1\nvt 0.9 0.4\nvt 0.6 0.4\n"
    "vn 0 0 1\n"
    "o shirt\ng left panel\nusemtl red\ns 1\nf 3/1/1 4/2/1 2/3/1 5/4/1\nf 5/4/1 2/3/1 11/3/1 12/2/1 10/1/1\n"
    "g right panel\nusemtl blue\nf 7/5/1 6/6/1 8/7/1 9/8/1\nf 9/8/1 8/7/1 13/6/1\n";

/// Faces of an OBJ, one line each, as numbers of vertices with texture coordinates; also its groups and materials.
std::vector<std::string> faces_in(const std::string& obj) {
  std::vector<std::string> found;
  std::vector<std::string> uv;
  std::istringstream lines(obj);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "vt") {
      double u = 0.0, v = 0.0;
      words >> u >> v;
      uv.push_back(fmt::format("{:.6f},{:.6f}", u, v));
    } else if (kind == "f") {
      std::string text = "f";
      for (std::string corner; words >> corner;) {
        const std::size_t first = corner.find('/'), second = corner.find('/', first + 1);
        const std::string number = corner.substr(first + 1, second - first - 1);
        text += ' ' + corner.substr(0, first) + '/' + uv.at(std::stoul(number) - 1);
      }
      found.push_back(text);
    } else if (kind != "v" && kind != "vn" && kind != "#") {
      found.push_back(line);
    }
  }
  return found;
}

struct Caches : testing::Test {
  Caches() {
    scene.garment.file = folder.write("model.obj", seamed);
    scene.garment.scale = 1.0;
    scene.garment.up = ModelAxis::y;
    loaded = load_garment(scene);
  }

  sim::Simulation simulation() const { return make_simulation(scene, loaded); }
  ExportSettings settings(const std::string& name, FrameRange frames = {3, 6}) const {
    return {(folder / name).string(), frames, 25.0};
  }
  /// Writes the frames from `first` to `last`. Returns their positions in the vertices of the file.
  std::vector<std::vector<sim::Vec3>> write(FrameSink& sink, sim::Simulation& moment, int first, int last) const {
    std::vector<std::vector<sim::Vec3>> written;
    for (int frame = first; frame <= last; ++frame) {
      moment.advance_frame();
      sink.write(frame, moment.state().current);
      std::vector<sim::Vec3>& positions = written.emplace_back(WrittenCloth(loaded).positions(moment.state().current));
      for (sim::Vec3& p : positions) {
        p = sim::Vec3(glm::vec3(p));
      }
    }
    return written;
  }
  static void expect_frames(const FrameSource& cache, const std::vector<std::vector<sim::Vec3>>& expected) {
    ASSERT_EQ(cache.frames(), expected.size());
    ASSERT_EQ(cache.vertices(), 13U);
    std::vector<sim::Vec3> positions(13);
    for (std::size_t k = 0; k < expected.size(); ++k) {
      cache.read(k, positions);
      EXPECT_EQ(positions, expected[k]) << k;
    }
  }

  test::TemporaryFolder folder;
  Scene scene;
  LoadedGarment loaded;
};

TEST_F(Caches, ObjHasTheFacesOfTheFile) {
  ASSERT_LT(loaded.garment->mesh.positions.size(), 12U) << "the seam is welded";
  const std::string obj = WrittenCloth(loaded).obj(simulation().state().current);
  EXPECT_EQ(faces_in(obj), faces_in(seamed));
  EXPECT_CONTAINS(obj, "\nv 9 9 9\nv 0.5 0.5 0\nv 0 0 0\n");
  EXPECT_CONTAINS(obj, "\nvn 0 0 1\n");
  EXPECT_CONTAINS(obj, "f 3/1/3 ");
}

TEST_F(Caches, ObjHasNormalsOnlyWhereTheFileHasSome) {
  std::string plain = seamed;
  plain.erase(plain.find("vn 0 0 1\n"), 9);
  scene.garment.file = folder.write("plain.obj", plain);
  loaded = load_garment(scene);
  EXPECT_EQ(WrittenCloth(loaded).obj_at_rest().find("vn"), std::string::npos);
}

TEST_F(Caches, SubdividedGarmentsAreWrittenAsTheyAreSimulated) {
  scene.garment.subdivisions = 1;
  loaded = load_garment(scene);
  EXPECT_EQ(WrittenCloth(loaded).vertices(), loaded.garment->mesh.positions.size());
}

TEST_F(Caches, AStartIsReadFromTheFilesVertices) {
  sim::Simulation moment = simulation();
  const auto sink = open_sink(settings("end.obj", {1, 20}), loaded, moment.state().current);
  write(*sink, moment, 1, 20);
  EXPECT_EQ(sink->finish(), "wrote " + (folder / "end.obj").string());
  scene.garment.start = folder / "end.obj";
  EXPECT_EQ(load_garment(scene).start_m, moment.state().current);
}

TEST_F(Caches, PointCachesAreReadAsTheyWereWritten) {
  sim::Simulation moment = simulation();
  const auto sink = open_sink(settings("clip.pc2"), loaded, moment.state().current);
  const auto expected = write(*sink, moment, 3, 6);
  EXPECT_CONTAINS(sink->finish(), "4 frames of 13 vertices, and ");
  const auto cache = open_pc2(folder / "clip.pc2");
  expect_frames(*cache, expected);
  std::ifstream rest(folder / "clip.obj");
  const std::string obj((std::istreambuf_iterator<char>(rest)), {});
  EXPECT_EQ(obj, WrittenCloth(loaded).obj_at_rest());
  EXPECT_EQ(folder.file_count(), 3U) << "something unfinished is left";
}

TEST_F(Caches, ARunThatEndsEarlyLeavesACacheOfFewerFrames) {
  sim::Simulation moment = simulation();
  const auto sink = open_sink(settings("clip.pc2"), loaded, moment.state().current);
  const auto expected = write(*sink, moment, 3, 4);
  EXPECT_CONTAINS(sink->finish(), "2 frames");
  const auto cache = open_pc2(folder / "clip.pc2");
  expect_frames(*cache, expected);
  EXPECT_EQ(folder.file_count(), 3U);
}

TEST_F(Caches, ARunThatIsGivenUpLeavesNothing) {
  sim::Simulation moment = simulation();
  for (const char* name : {"clip.pc2", "clip.glb"}) {
    const auto sink = open_sink(settings(name), loaded, moment.state().current);
    write(*sink, moment, 3, 4);
  }
  EXPECT_EQ(folder.file_count(), 1U);
}

TEST_F(Caches, GoesOnOnlyFromTheFrameItStoppedAt) {
  ExportSettings stopped = settings("clip.pc2", {1, 4});
  stopped.can_be_resumed = true;
  sim::Simulation moment = simulation();
  const sim::Simulation start = simulation();
  std::vector<std::vector<sim::Vec3>> expected;
  {
    const auto sink = open_sink(stopped, loaded, moment.state().current);
    expected = write(*sink, moment, 1, 2);
    sink->save_frames();
    EXPECT_EQ(std::filesystem::file_size(stopped.name + ".part"), pc2_header_bytes + 2 * 13 * 12)
        << "the frames that a checkpoint counts are in the file";
  }
  stopped.last_kept = 2;
  EXPECT_CONTAINS(test::error_message<InputError>([&] { open_sink(stopped, loaded, start.state().current); }),
                  ".part': its frame 2 is not the one that the run goes on from");
  stopped.last_kept = 3;
  EXPECT_CONTAINS(test::error_message<InputError>([&] { open_sink(stopped, loaded, moment.state().current); }),
                  "for 3 frames of 13 vertices and more");
  stopped.last_kept = 2;
  // The last frame may be another than before.
  stopped.frames.last = 6;
  const auto sink = open_sink(stopped, loaded, moment.state().current);
  for (std::vector<sim::Vec3>& frame : write(*sink, moment, 3, 6)) {
    expected.push_back(std::move(frame));
  }
  sink->finish();
  expect_frames(*open_pc2(folder / "clip.pc2"), expected);
}

TEST_F(Caches, NamesAreRefusedWithWhatIsExpected) {
  const auto refusal = [&](const std::string& name, bool can_be_resumed = false) {
    ExportSettings asked = settings(name);
    asked.can_be_resumed = can_be_resumed;
    return test::error_message<UsageError>([&] { require_export(asked); });
  };
  EXPECT_EQ(refusal("deeper/clip.pc2", true), "");
  EXPECT_EQ(refusal("deeper/{frame:04}.obj", true), "");
  EXPECT_CONTAINS(refusal("clip.abc"), "ends in .obj, .pc2, .glb or .usda");
  EXPECT_CONTAINS(refusal("clip-{frame}.pc2"), "one .pc2 holds all frames; expected a name without {frame}");
  EXPECT_CONTAINS(refusal("clip.glb", true), "expected no --checkpoint and no --resume, or .pc2");
  const auto names = [&](const std::string& name, FrameRange range) { return require_export(settings(name, range)).size(); };
  EXPECT_EQ(names("{frame}.obj", {3, 9}), 7U);
  EXPECT_EQ(names("last.obj", {3, 9}), 1U);
  EXPECT_EQ(names("clip.pc2", {3, 9}), 2U);  // the clip, and an OBJ beside it
}

TEST_F(Caches, GltfHasALimit) {
  const std::string said = test::error_message<InputError>([&] {
    open_sink(settings("clip.glb", {1, 100'000}), loaded, simulation().state().current);
  });
  EXPECT_CONTAINS(said, "clip.glb': 100000 frames of 12 vertices are 37.3 GiB");
  EXPECT_CONTAINS(said, "expected at most 1 GiB: fewer --frames, or .pc2");
}

}  // namespace
}  // namespace taut::app
