#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/base/errors.hpp"
#include "app/bodies/body_loading.hpp"
#include "app/models/garment_loading.hpp"
#include "sim/bytes.hpp"
#include "temporary_folder.hpp"

namespace taut::app {
namespace {

/// A tetrahedron with outward faces.
const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
const std::string tetrahedron = corners + "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

using Frame = std::vector<sim::Vec3>;
const Frame modelled = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

std::string pc2(const std::vector<Frame>& frames) {
  sim::ByteWriter out;
  for (const char c : std::string("POINTCACHE2") + '\0') {
    out.put(c);
  }
  out.put<std::int32_t>(1);
  out.put(static_cast<std::int32_t>(frames.front().size()));
  out.put(0.0F);
  out.put(1.0F);
  out.put(static_cast<std::int32_t>(frames.size()));
  for (const Frame& frame : frames) {
    for (const sim::Vec3& p : frame) {
      for (int axis = 0; axis < 3; ++axis) {
        out.put(static_cast<float>(p[axis]));
      }
    }
  }
  return out.bytes();
}

BodySource make_sized_body(double scale, ModelAxis up) {
  BodySource source;
  source.scale = scale;
  source.up = up;
  return source;
}

BodySource file_source(const std::filesystem::path& file) {
  BodySource source;
  source.file = file;
  return source;
}

std::vector<sim::Vec3> frame_positions(const sim::BodyMesh& body, std::size_t frame) {
  std::vector<sim::Vec3> positions_m(body.data->positions_m.size());
  body.frames->positions_in(frame, positions_m);
  return positions_m;
}

struct BodyLoading : testing::Test {
  sim::BodyMesh load(const std::string& obj, const std::string& frames = "", BodySource source = {}) {
    source.file = folder.write("body.obj", obj);
    if (source.motion.empty() && !frames.empty()) {
      source.motion = folder / "body.pc2";
      std::ofstream(source.motion, std::ios::binary) << frames;
    }
    Scene scene;
    scene.bodies.push_back({.body = {.shape = sim::Plane{}}});
    scene.bodies.push_back({.body = {.name = "avatar", .shape = sim::BodyMesh{}}, .source = source});
    const LoadedBodies bodies = load_bodies(scene);
    remarks = bodies.remarks;
    return std::get<sim::BodyMesh>(bodies.all[1].shape);
  }
  std::string error_text(const std::string& obj, const std::string& frames = "") {
    return test::error_message<InputError>([&] { load(obj, frames); });
  }

  test::TemporaryFolder folder;
  std::vector<std::string> remarks;  ///< messages about the body that was loaded last
};

double volume_m3(const sim::BodyMeshData& mesh) {
  double sum = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    sum += glm::dot(mesh.positions_m[a], glm::cross(mesh.positions_m[b], mesh.positions_m[c]));
  }
  return sum / 6.0;
}

TEST_F(BodyLoading, ReadsAMeshInItsUnitAndAxes) {
  EXPECT_EQ(load(tetrahedron).data->positions_m.size(), 4U);
  EXPECT_NEAR(volume_m3(*load(tetrahedron).data), 1.0 / 6.0, 1e-15) << "in metres where nobody says otherwise";
  const auto data =
      load("v 9 9 9\n" + corners + "f 2 4 3\nf 2 3 5\nf 2 5 4\nf 3 4 5\n", "", make_sized_body(0.1, ModelAxis::z)).data;
  EXPECT_NEAR(volume_m3(*data), 1e-3 / 6.0, 1e-15);
  EXPECT_EQ(data->positions_m.size(), 4U) << "no face uses the first";
  EXPECT_NE(std::find(data->positions_m.begin(), data->positions_m.end(), sim::Vec3(0, 0.1, 0)),
            data->positions_m.end());
}

TEST_F(BodyLoading, WeldsWhatWasCutAlongSeams) {
  const auto data = load(corners + "v 0 0 0\nv 1 0 0\nf 1 3 2\nf 5 6 4\nf 1 4 3\nf 2 3 4\n").data;
  EXPECT_EQ(data->positions_m.size(), 4U);
}

TEST_F(BodyLoading, FacesOutwardsHoweverItsTrianglesWereTurned) {
  EXPECT_GT(volume_m3(*load(corners + "f 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n").data), 0.1) << "inside out";
  EXPECT_GT(volume_m3(*load(corners + "f 1 2 3\nf 1 2 4\nf 1 4 3\nf 2 3 4\n").data), 0.1) << "one is turned";
}

TEST_F(BodyLoading, LeavesAGivenMeshAlone) {
  Scene scene;
  scene.bodies.push_back({.body = {.shape = sim::BodyMesh{std::make_shared<const sim::BodyMeshData>()}},
                          .source = file_source("none.obj")});
  EXPECT_TRUE(std::get<sim::BodyMesh>(load_bodies(scene).all[0].shape).data->positions_m.empty());
}

TEST_F(BodyLoading, NamesWhatIsNotClosed) {
  const std::string hole = error_text(corners + "f 1 3 2\nf 1 2 4\nf 1 4 3\n");
  EXPECT_CONTAINS(hole, "body 'avatar': '");
  EXPECT_CONTAINS(hole, "body.obj': found the edge from [");
  EXPECT_CONTAINS(hole, "with 1 triangle, expected two at every edge: a body has no holes");
  const std::string fin = error_text(tetrahedron + "v 2 2 2\nf 1 2 5\n");
  EXPECT_CONTAINS(fin, "with 3 triangles, expected two at every edge");
}

/// A cube of this size. Its top is open if `top` is empty.
std::string cube(double size, const std::string& top) {
  std::string obj;
  for (int k = 0; k < 8; ++k) {
    obj += "v " + std::to_string(k % 2 * size) + ' ' + std::to_string(k / 4 * size) + ' ' +
           std::to_string(k / 2 % 2 * size) + '\n';
  }
  return obj + "f 1 2 4 3\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n" + top;
}

TEST_F(BodyLoading, ClosesSmallHolesAndSaysWhere) {
  const sim::BodyMesh body = load(cube(0.1, ""));
  EXPECT_EQ(body.data->triangles.size(), 12U);
  EXPECT_NEAR(volume_m3(*body.data), 1e-3, 1e-12) << "closed by triangles that face outwards";
  ASSERT_EQ(remarks.size(), 1U);
  EXPECT_CONTAINS(remarks[0], "body 'avatar': 1 hole was closed, it is 0.4 m around at [");
  load(cube(0.145, ""));
  EXPECT_EQ(remarks.size(), 1U);
  load(cube(0.1, "f 5 7 8 6\n"));
  EXPECT_TRUE(remarks.empty());
  EXPECT_CONTAINS(error_text(cube(0.155, "")), "with 1 triangle, expected two at every edge: a body has no holes");
}

TEST_F(BodyLoading, LeavesHolesOpenThatAFanCannotClose) {
  const std::string line = "v 0 0 0\nv 0.1 0 0\nv 0.05 0 0\nv 0.05 0.1 0\nv 0.05 0.05 0.1\n";
  // The hole runs along a straight edge and back.
  EXPECT_CONTAINS(error_text(line + "f 1 3 5\nf 3 2 5\nf 2 4 5\nf 4 1 5\nf 1 2 4\n"), "a body has no holes");
  EXPECT_CONTAINS(error_text("v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nf 1 2 3\n"), "a body has no holes") << "a triangle";
}

TEST_F(BodyLoading, TakesSeveralShells) {
  const sim::BodyMesh body =
      load(tetrahedron + "v 5 0 0\nv 6 0 0\nv 5 1 0\nv 5 0 1\n" + "f 5 6 7\nf 5 8 6\nf 5 7 8\nf 6 8 7\n");
  EXPECT_EQ(body.data->positions_m.size(), 8U);
  EXPECT_NEAR(volume_m3(*body.data), 1.0 / 3.0, 1e-12) << "the second was inside out";
}

TEST_F(BodyLoading, GuessesTheUnitOfAPersonAloneAndSaysIt) {
  EXPECT_NEAR(volume_m3(*load(cube(170.0, "f 5 7 8 6\n")).data), 1.7 * 1.7 * 1.7, 1e-9);
  ASSERT_EQ(remarks.size(), 1U);
  EXPECT_CONTAINS(remarks[0], "its unit is the centimetre, guessed: in metres it would be 170 m large");
  EXPECT_NEAR(volume_m3(*load(cube(15.0, "f 5 7 8 6\n")).data), 15.0 * 15.0 * 15.0, 1e-6) << "a floor";
  EXPECT_TRUE(remarks.empty());
  load("v 0 0 0\nv 0.3 0 0\nv 0 0.3 0\nv 0 0 1.7\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  ASSERT_EQ(remarks.size(), 1U);
  EXPECT_CONTAINS(remarks[0], "it is 1.7 m along z and 0.3 m along y, which is taken as up (up, --body-up)");
}

TEST_F(BodyLoading, NamesFacesWithoutAreaAndThoseThatAreThereTwice) {
  EXPECT_CONTAINS(error_text(corners + "v 0.5 0 0\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\nf 1 5 2\n"),
                  "body.obj': found a face without area at [0, 0, 0]");
  EXPECT_CONTAINS(error_text(tetrahedron + "f 1 3 2\n"), "found a triangle that is there twice");
}

// Remeshing leaves such faces. So do polygons that are split along three corners in a line.
TEST_F(BodyLoading, MendsFacesWithoutArea) {
  const sim::BodyMesh body = load(corners + "v 0.5 0 0\nf 1 3 5\nf 5 3 2\nf 1 5 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  EXPECT_EQ(body.data->triangles.size(), 6U);
  EXPECT_NEAR(volume_m3(*body.data), 1.0 / 6.0, 1e-15);
  for (const sim::Triangle& t : body.data->triangles) {
    EXPECT_GT(glm::length(sim::doubled_area_vector(body.data->positions_m, t)), 0.4);
  }
  ASSERT_EQ(remarks.size(), 1U);
  EXPECT_CONTAINS(remarks[0], "of its faces without area 0 left out and 1 turned");
  // Two faces without area in a row, between seams.
  const std::string row = "v 0.25 0 0\nv 0.5 0 0\nv 0 0 0\nv 1 0 0\n";
  load(corners + row + "f 1 3 5\nf 5 3 6\nf 6 3 2\nf 1 5 6\nf 1 6 2\nf 7 8 4\nf 1 4 3\nf 2 3 4\n");
  EXPECT_CONTAINS(remarks.at(0), "0 left out and 2 turned");
}

// The third vertex occurs three times, each time with triangles all around it.
TEST_F(BodyLoading, LeavesOutFacesThatArePointsOrLines) {
  const sim::BodyMesh body =
      load(corners + "v 0 1 0\nv 0 1 0\nf 1 3 2\nf 1 2 4\nf 1 4 5\nf 2 6 4\nf 3 6 2\nf 3 1 5\nf 3 5 6\nf 6 5 4\n");
  EXPECT_EQ(body.data->triangles.size(), 4U);
  EXPECT_EQ(body.data->positions_m.size(), 4U);
  EXPECT_NEAR(volume_m3(*body.data), 1.0 / 6.0, 1e-15);
  EXPECT_CONTAINS(remarks.at(0), "of its faces without area 4 left out and 0 turned");
}

// A Klein bottle: a torus of quads whose last ring is joined to the first in the opposite direction.
TEST_F(BodyLoading, NamesASurfaceWithOneSide) {
  constexpr int n = 8;
  std::string obj;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const double a = 2.0 * 3.14159265 * i / n, b = 2.0 * 3.14159265 * j / n;
      obj += "v " + std::to_string(std::cos(a) * (2 + std::cos(b))) + ' ' + std::to_string(std::sin(b)) + ' ' +
             std::to_string(std::sin(a) * (2 + std::cos(b))) + '\n';
    }
  }
  const auto vertex = [](int i, int j) {
    return ' ' + std::to_string(1 + i % n * n + (i == n ? (2 * n - j) % n : j % n));
  };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      obj += 'f' + vertex(i, j) + vertex(i, j + 1) + vertex(i + 1, j + 1) + '\n';
      obj += 'f' + vertex(i, j) + vertex(i + 1, j + 1) + vertex(i + 1, j) + '\n';
    }
  }
  EXPECT_CONTAINS(error_text(obj), "found triangles that face different sides at the edge from [");
}

TEST_F(BodyLoading, NamesWhatIsNoModel) {
  EXPECT_CONTAINS(error_text("v 0 nan 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
                  "body.obj': vertex 0 has a coordinate that is not finite: found [0, nan, 0], expected numbers");
  EXPECT_CONTAINS(error_text("v 0 0 0\nv 1 0 0\n"), "it has no faces");
  Scene scene;
  scene.bodies.push_back({.body = {.shape = sim::BodyMesh{}}, .source = file_source(folder / "none.obj")});
  EXPECT_CONTAINS(test::error_message<InputError>([&] { load_bodies(scene); }), "body 1: there is no file '");
}

TEST_F(BodyLoading, ReadsFramesInTheOrderOfTheFile) {
  Frame grown = modelled;
  for (sim::Vec3& p : grown) {
    p *= 1.5;
  }
  // The faces use the vertices in another order than the file lists them, and one vertex occurs twice.
  Frame first = modelled;
  first.emplace_back(0, 0, 0);
  grown.emplace_back(0, 0, 0);
  BodySource source;
  source.frame_rate_hz = 24.0;
  source.scale = 0.5;
  const sim::BodyMesh body =
      load(corners + "v 0 0 0\nf 4 2 3\nf 5 3 2\nf 1 2 4\nf 1 4 3\n", pc2({first, grown}), source);
  ASSERT_EQ(body.frames->count(), 2U);
  EXPECT_EQ(body.frames->rate_hz(), 24.0);
  EXPECT_EQ(frame_positions(body, 0), body.data->positions_m);
  for (std::size_t v = 0; v < 4; ++v) {
    EXPECT_EQ(frame_positions(body, 1)[v], 1.5 * body.data->positions_m[v]);
  }
}

// Blender writes caches with z up beside OBJ with y up. Other programs write left-handed axes.
TEST_F(BodyLoading, GuessesTheAxesOfFramesFromTheFirst) {
  const auto written = [&](auto turned) {
    std::vector<Frame> frames = {modelled, modelled};
    for (sim::Vec3& p : frames[1]) {
      p += sim::Vec3(0.125, 0.25, 0.5);
    }
    for (Frame& frame : frames) {
      std::transform(frame.begin(), frame.end(), frame.begin(), turned);
    }
    return pc2(frames);
  };
  const auto moved_to = [](const sim::BodyMesh& body) {
    return frame_positions(body, 1)[3] - body.data->positions_m[3];
  };
  BodySource at_60_hz;
  at_60_hz.frame_rate_hz = 60.0;
  for (const auto& frames : {written([](const sim::Vec3& p) { return sim::Vec3(p.x, -p.z, p.y); }),
                             written([](const sim::Vec3& p) { return sim::Vec3(p.x, p.z, -p.y); }),
                             written([](const sim::Vec3& p) { return sim::Vec3(p.x, p.y, -p.z); }),
                             written([](const sim::Vec3& p) { return sim::Vec3(p.x, p.z, p.y); })}) {
    EXPECT_EQ(moved_to(load(tetrahedron, frames, at_60_hz)), sim::Vec3(0.125, 0.25, 0.5));
    ASSERT_EQ(remarks.size(), 1U);
    EXPECT_CONTAINS(remarks[0], "its motion is in other axes than it, guessed from its first frame: there (x, ");
  }
  load(tetrahedron, written([](const sim::Vec3& p) { return p + sim::Vec3(0.0, 0.3, 0.0); }), at_60_hz);
  EXPECT_TRUE(remarks.empty()) << "it only begins elsewhere";
}

TEST_F(BodyLoading, NamesWhatIsWrongWithFrames) {
  const std::string good = pc2({modelled, modelled});
  load(tetrahedron, good);
  EXPECT_CONTAINS(error_text(tetrahedron, pc2({{{0, 0, 0}}})), "body.pc2': found 1 vertex, expected the 4 of '");
  EXPECT_CONTAINS(error_text(tetrahedron, good.substr(0, good.size() - 1)),
                  "found 127 bytes, expected 128 for 2 frames of 4 vertices");
  EXPECT_CONTAINS(error_text(tetrahedron, good.substr(0, 20)), "body.pc2': byte 20, the first frame: found 0 bytes");
  EXPECT_CONTAINS(error_text(tetrahedron, "POINTCACHE3" + good.substr(11)), "what the file is: found 'POINTCACHE3");
  Frame jumped = modelled;
  jumped[2] = {0, 2.5, 0};
  EXPECT_CONTAINS(error_text(tetrahedron, pc2({modelled, modelled, jumped})),
                  "frame 2, vertex 2: found at [0, 2.5, 0] m, 1.5 m from where it is in the frame before");
  jumped[2].x = NAN;
  EXPECT_CONTAINS(error_text(tetrahedron, pc2({modelled, jumped})),
                  "body.pc2': frame 1, vertex 2: found at [nan, 2.5, 0], expected numbers");
}

}  // namespace
}  // namespace taut::app
