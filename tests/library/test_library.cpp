#include <gtest/gtest.h>
#include <pmmintrin.h>
#include <xmmintrin.h>

#include <cfenv>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <limits>
#include <numeric>
#include <sstream>
#include <thread>

#include "cloths.hpp"
#include "temporary_folder.hpp"

namespace taut::test {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// The hashes of the frames that the program counts.
std::vector<std::uint64_t> hashes_of_program(const TemporaryFolder& folder, const std::string& scene,
                                             int frames) {
  const std::string file = (folder / "run.jsonl").string();
  const std::string command = std::string(TAUT_PROGRAM) + " simulate " + scene + " --quiet --frames " +
                              std::to_string(frames) + " --stats " + file;
  EXPECT_EQ(std::system(command.c_str()), 0);
  std::vector<std::uint64_t> hashes;
  std::ifstream lines(file);
  const std::string key = "\"state_hash\":\"";
  for (std::string line; std::getline(lines, line);) {
    if (const std::size_t at = line.find(key); at != std::string::npos) {
      hashes.push_back(std::stoull(line.substr(at + key.size()), nullptr, 16));
    }
  }
  return hashes;
}

struct Run {
  const char* scene;
  std::int32_t threads;
};
class AsTheProgram : public testing::TestWithParam<Run> {};

TEST_P(AsTheProgram, EveryFrameHasTheSameBits) {
  const TemporaryFolder folder;
  const std::vector<std::uint64_t> expected = hashes_of_program(folder, GetParam().scene, 4);
  ASSERT_EQ(expected.size(), 4U);
  OwnCloth cloth(GetParam().scene, GetParam().threads);
  ASSERT_EQ(cloth.result, TAUT_OK) << cloth.text;
  for (const std::uint64_t hash : expected) {
    EXPECT_EQ(cloth.step().state_hash, hash);
    EXPECT_EQ(cloth.hash(), hash);
  }
}

INSTANTIATE_TEST_SUITE_P(Library, AsTheProgram,
                         testing::Values(Run{"pinned-9x9-5", 1}, Run{"pinned-9x9-5", 2}, Run{"tshirt", 1},
                                         Run{"tshirt", 2}),
                         [](const auto& run) {
                           return std::string(run.param.scene[0] == 't' ? "tshirt" : "pinned") + "_threads_" +
                                  std::to_string(run.param.threads);
                         });

TEST(Library, KeepsTheBitsWhereTheCallersProgramRoundsOtherwise) {
  const std::uint64_t expected = OwnCloth("pinned-9x9-5").step(3).state_hash;
  OwnCloth cloth("pinned-9x9-5");
  _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
  _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
  std::fesetround(FE_UPWARD);
  const std::uint64_t hash = cloth.step(3).state_hash;
  EXPECT_EQ(_MM_GET_FLUSH_ZERO_MODE(), static_cast<unsigned>(_MM_FLUSH_ZERO_ON));
  EXPECT_EQ(std::fegetround(), FE_UPWARD);
  std::fesetenv(FE_DFL_ENV);
  EXPECT_EQ(hash, expected);
}

TEST(Library, SaysWhatItIs) {
  EXPECT_EQ(taut_abi_version(), static_cast<std::uint32_t>(TAUT_ABI_VERSION));
  EXPECT_STREQ(taut_version(), TAUT_VERSION);
  EXPECT_CONTAINS(std::string(taut_build_info()), taut_version());
}

TEST(Library, AClothOfArraysKeepsItsBoundAndItsNumbers) {
  Square square;
  const char* settings[] = {"solver.max_stretch = 0.01"};
  square.options.settings = settings;
  square.options.setting_count = 1;
  square.options.counts_crossings = 1;
  OwnCloth cloth(square.options);
  ASSERT_EQ(cloth.result, TAUT_OK) << cloth.text;
  EXPECT_EQ(cloth.info().vertex_count, 81U);
  EXPECT_EQ(cloth.info().triangle_count, 128U);
  EXPECT_EQ(cloth.info().pin_count, 0U);
  EXPECT_EQ(cloth.info().max_stretch, 0.01);
  const std::uint32_t pins[] = {8, 0};
  ASSERT_EQ(taut_set_pins(cloth, pins, 2), TAUT_OK);
  std::uint32_t found[2];
  ASSERT_EQ(taut_get_pins(cloth, found, 2), TAUT_OK);
  EXPECT_TRUE(found[0] == 0 && found[1] == 8);
  const TautFrame frame = cloth.step(30);
  ASSERT_EQ(cloth.result, TAUT_OK) << cloth.error();
  EXPECT_EQ(frame.frame, 30);
  EXPECT_NEAR(frame.time_s, 0.5, 1e-12);
  EXPECT_GT(frame.max_surface_stretch, 0.001);
  EXPECT_LE(frame.max_surface_stretch, 0.01 + 1e-9);
  EXPECT_GE(frame.max_surface_stretch, frame.max_edge_stretch);
  EXPECT_EQ(frame.crossing_pairs, 0);
  EXPECT_EQ(frame.is_bound_kept, 1);
  EXPECT_EQ(frame.is_contact_kept, 1);
  EXPECT_GT(frame.substeps, 0);
  const auto positions = cloth.positions();
  EXPECT_EQ(positions[0], square.positions[0]);
  EXPECT_EQ(positions[8], square.positions[8]);
  EXPECT_LT(positions[80][1], -0.2);
  std::vector<double> stretch(81);
  ASSERT_EQ(taut_get_stretch(cloth, stretch.data(), stretch.size()), TAUT_OK);
  EXPECT_EQ(*std::max_element(stretch.begin(), stretch.end()), frame.max_surface_stretch);
}

TEST(Library, EdgesAndTrianglesAreThoseOfTheMesh) {
  Square square(3, 0.2);
  OwnCloth cloth(square.options);
  const TautInfo info = cloth.info();
  EXPECT_EQ(info.edge_count, 16U);
  std::vector<std::uint32_t> edges(2 * info.edge_count), triangles(3 * info.triangle_count);
  std::vector<double> lengths(info.edge_count);
  ASSERT_EQ(taut_get_edges(cloth, edges.data(), lengths.data(), lengths.size()), TAUT_OK);
  ASSERT_EQ(taut_get_triangles(cloth, triangles.data(), triangles.size()), TAUT_OK);
  for (std::size_t e = 0; e < lengths.size(); ++e) {
    const auto& a = square.positions[edges[2 * e]];
    const auto& b = square.positions[edges[2 * e + 1]];
    EXPECT_DOUBLE_EQ(lengths[e], std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]));
  }
  EXPECT_LT(*std::max_element(triangles.begin(), triangles.end()), 9U);
  EXPECT_EQ(taut_get_triangles(cloth, triangles.data(), 5), TAUT_ERROR_ARGUMENT);
  EXPECT_EQ(cloth.error(), "found an array of 5, expected 24");
}

// As game engines have them, where texture coordinates differ; and as tools leave them.
TEST(Library, VerticesThatAreOneInSpaceAndThoseWithoutFacesKeepTheirNumbers) {
  const float positions[][4] = {{9, 9, 9, 0}, {0, 0, 0, 0}, {1, 0, 0, 0}, {0, 0, 1, 0},
                                {1, 0, 0, 0}, {1, 0, 1, 0}, {0, 0, 1, 0}};
  const std::uint32_t corners[] = {1, 3, 2, 4, 6, 5};
  auto mesh = made<TautMesh>(taut_mesh_init);
  mesh.positions = {positions, 7, sizeof(positions[0]), TAUT_FLOAT};
  mesh.corners = corners;
  mesh.corner_count = 6;
  auto options = made<TautOptions>(taut_options_init);
  options.mesh = &mesh;
  OwnCloth cloth(options);
  ASSERT_EQ(cloth.result, TAUT_OK) << cloth.text;
  EXPECT_EQ(cloth.info().vertex_count, 7U);
  EXPECT_EQ(cloth.info().edge_count, 5U);
  cloth.step(5);
  float out[7][5] = {};
  const TautPointsOut points = {out, 7, sizeof(out[0]), TAUT_FLOAT};
  ASSERT_EQ(taut_get_positions(cloth, &points), TAUT_OK);
  EXPECT_EQ(out[0][1], 9.0F);
  EXPECT_LT(out[2][1], 0.0F);
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(out[2][k], out[4][k]);
    EXPECT_EQ(out[3][k], out[6][k]);
  }
  const std::uint32_t lonely = 0;
  EXPECT_EQ(taut_set_pins(cloth, &lonely, 1), TAUT_ERROR_ARGUMENT);
  EXPECT_CONTAINS(cloth.error(), "found vertex 0, expected one of a face");
}

TEST(Library, PinsGoToTheirTargetsAndStay) {
  Square square;
  for (const char* solver : {"solver.kind = bounded", "solver.kind = strong"}) {
    square.options.settings = &solver;
    square.options.setting_count = 1;
    OwnCloth cloth(square.options);
    const std::uint32_t pins[] = {0, 8};
    ASSERT_EQ(taut_set_pins(cloth, pins, 2), TAUT_OK);
    double targets[2][3] = {{square.positions[0][0], 0.0, square.positions[0][2]},
                            {square.positions[8][0], 0.0, square.positions[8][2]}};
    const TautPoints points = {targets, 2, sizeof(targets[0]), TAUT_DOUBLE};
    for (int frame = 0; frame < 10; ++frame) {
      targets[0][1] += 0.01;
      targets[1][2] -= 0.02;
      targets[0][0] += 0.01;
      ASSERT_EQ(taut_move_pins(cloth, pins, &points), TAUT_OK);
      EXPECT_EQ(cloth.step().is_bound_kept, 1);
      const auto positions = cloth.positions();
      for (int k = 0; k < 3; ++k) {
        EXPECT_NEAR(positions[0][k], targets[0][k], 1e-8) << solver << ' ' << frame;
        EXPECT_NEAR(positions[8][k], targets[1][k], 1e-8) << solver << ' ' << frame;
      }
    }
    const auto before = cloth.positions();
    cloth.step(3);
    EXPECT_EQ(cloth.positions()[0], before[0]);
    EXPECT_NE(cloth.positions()[40], before[40]);
    const std::uint32_t loose = 40;
    const TautPoints one = {targets, 1, sizeof(targets[0]), TAUT_DOUBLE};
    EXPECT_EQ(taut_move_pins(cloth, &loose, &one), TAUT_ERROR_ARGUMENT);
    EXPECT_EQ(cloth.error(), "found vertex 40, expected one that is pinned");
  }
}

/// A mesh of faces as an OBJ file has it and as a caller has it.
struct AnyMesh {
  /// With the vertices in another order, some of them in no face.
  void shuffle() {
    const std::size_t count = positions.size();
    std::vector<std::uint32_t> place(count);
    std::vector<std::array<double, 3>> shuffled(count + count / 7 + 1, {0.3, 0.4, 0.5});
    for (std::size_t v = 0; v < count; ++v) {
      const std::size_t other = v * 31 % count;
      place[v] = static_cast<std::uint32_t>(other + other / 7 + 1);
      shuffled[place[v]] = positions[v];
    }
    positions = std::move(shuffled);
    for (std::vector<std::uint32_t>& face : faces) {
      for (std::uint32_t& corner : face) {
        corner = place[corner];
      }
    }
    for (std::size_t f = 0; f < faces.size(); ++f) {
      std::swap(faces[f], faces[f * 17 % faces.size()]);
      std::rotate(faces[f].begin(), faces[f].begin() + static_cast<std::ptrdiff_t>(f % 3), faces[f].end());
    }
  }

  void write(const std::string& file) const {
    std::ofstream out(file);
    out.precision(17);
    for (const auto& [x, y, z] : positions) {
      out << "v " << x << ' ' << y << ' ' << z << '\n';
    }
    for (const std::vector<std::uint32_t>& face : faces) {
      out << 'f';
      for (const std::uint32_t corner : face) {
        out << ' ' << corner + 1;
      }
      out << '\n';
    }
  }

  TautMesh* lend() {
    corners.clear();
    sizes.clear();
    for (const std::vector<std::uint32_t>& face : faces) {
      corners.insert(corners.end(), face.begin(), face.end());
      sizes.push_back(static_cast<std::uint32_t>(face.size()));
    }
    mesh = made<TautMesh>(taut_mesh_init);
    mesh.positions = {positions.data(), positions.size(), sizeof(positions[0]), TAUT_DOUBLE};
    mesh.corners = corners.data();
    mesh.corner_count = corners.size();
    mesh.corners_per_face = sizes.data();
    mesh.face_count = sizes.size();
    return &mesh;
  }

  std::vector<std::array<double, 3>> positions;
  std::vector<std::vector<std::uint32_t>> faces;
  std::vector<std::uint32_t> corners, sizes;
  TautMesh mesh;
};

/// Quads between rings of points, which may be all at one place; ring after ring.
void add_rings(std::uint32_t rings, std::uint32_t around, bool is_closed,
               const std::function<std::array<double, 3>(double, double)>& at, AnyMesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const std::uint32_t points = is_closed ? around : around + 1;
  for (std::uint32_t v = 0; v < rings * points; ++v) {
    mesh.positions.push_back(
        at(static_cast<double>(v / points) / (rings - 1), static_cast<double>(v % points) / around));
  }
  for (std::uint32_t ring = 0; ring + 1 < rings; ++ring) {
    for (std::uint32_t k = 0; k < around; ++k) {
      const std::uint32_t a = first + ring * points + k, b = first + ring * points + (k + 1) % points;
      mesh.faces.push_back({a, a + points, b + points, b});
    }
  }
}

/// Two squares that are to be sewn to each other, and a tube that is inside out.
AnyMesh some_garment() {
  AnyMesh mesh;
  for (const double x : {-0.2, 2e-4}) {
    add_rings(
        7, 6, false,
        [&](double u, double v) {
          return std::array{x + 0.2 * v, 0.4 + 0.01 * std::sin(3.0 * u * u + 2.0 * v), 0.2 * u - 0.1};
        },
        mesh);
  }
  add_rings(
      5, 9, true,
      [](double u, double v) {
        return std::array{0.05 * std::sin(6.283185307179586 * v), 0.55 + 0.2 * u,
                          0.05 * std::cos(6.283185307179586 * v)};
      },
      mesh);
  return mesh;
}

/// A ball without poles, that has a small hole at each.
AnyMesh some_body() {
  AnyMesh mesh;
  add_rings(
      6, 8, true,
      [](double u, double v) {
        const double low = 2.6 - 2.2 * u, round = 6.283185307179586 * v;
        return std::array{0.11 * std::sin(low) * std::sin(round), 0.28 + 0.1 * std::cos(low),
                          0.13 * std::sin(low) * std::cos(round)};
      },
      mesh);
  return mesh;
}

// A file is read in its own way, and arrays are handed over in the caller's order: the last bits are the
// same.
TEST(Library, MeshesOfFilesAndOfArraysHaveTheSameBitsInAnyOrder) {
  const TemporaryFolder folder;
  AnyMesh garment = some_garment(), body = some_body();
  garment.shuffle();
  body.shuffle();
  garment.write((folder / "garment.obj").string());
  body.write((folder / "body.obj").string());
  const std::filesystem::path scene =
      folder.write("scene.toml",
                   "garment = { file = \"garment.obj\", scale = 1.0, up = \"y\" }\npins = { at = [5] }\n"
                   "wind = { speed = 2.0 }\n[[bodies]]\nshape = \"mesh\"\nfile = \"body.obj\"\n");
  const std::vector<std::uint64_t> expected = hashes_of_program(folder, scene.string(), 12);
  ASSERT_EQ(expected.size(), 12U);

  auto options = made<TautOptions>(taut_options_init);
  options.mesh = garment.lend();
  const char* settings[] = {"pins.at = [5]", "wind.speed = 2.0"};
  options.settings = settings;
  options.setting_count = 2;
  OwnCloth cloth(options);
  ASSERT_EQ(cloth.result, TAUT_OK) << cloth.text;
  auto added = made<TautBody>(taut_body_init);
  added.mesh = body.lend();
  ASSERT_EQ(taut_add_body(cloth, &added, nullptr), TAUT_OK) << cloth.error();
  for (const std::uint64_t hash : expected) {
    EXPECT_EQ(cloth.step().state_hash, hash);
  }
  EXPECT_EQ(cloth.result, TAUT_OK) << cloth.error();
}

/// A closed box.
struct Box {
  explicit Box(double height_m) {
    for (int v = 0; v < 8; ++v) {
      positions.push_back({v & 1 ? 0.1 : -0.1, height_m + (v & 2 ? 0.1 : -0.1), v & 4 ? 0.1 : -0.1});
    }
    mesh = made<TautMesh>(taut_mesh_init);
    mesh.positions = {positions.data(), 8, sizeof(positions[0]), TAUT_DOUBLE};
    mesh.corners = corners;
    mesh.corner_count = 24;
    mesh.corners_per_face = sizes;
    mesh.face_count = 6;
    body = made<TautBody>(taut_body_init);
    body.mesh = &mesh;
    body.name = "box";
  }
  Box(const Box&) = delete;

  void lift(double by_m) {
    for (auto& position : positions) {
      position[1] += by_m;
    }
  }

  std::vector<std::array<double, 3>> positions;
  const std::uint32_t corners[24] = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
  const std::uint32_t sizes[6] = {4, 4, 4, 4, 4, 4};
  TautMesh mesh;
  TautBody body;
};

double lowest(const OwnCloth& cloth) {
  double y = infinite;
  for (const auto& position : cloth.positions()) {
    y = std::min(y, position[1]);
  }
  return y;
}

TEST(Library, ClothFallsOnThePlaneAndIsLiftedByABodyThatMoves) {
  Square square(9, 0.15, 0.02);
  square.options.counts_crossings = 1;
  OwnCloth cloth(square.options);
  auto plane = made<TautBody>(taut_body_init);
  plane.plane_normal[1] = 3.0;
  std::int32_t number = -1;
  ASSERT_EQ(taut_add_body(cloth, &plane, &number), TAUT_OK) << cloth.error();
  EXPECT_EQ(number, 0);
  EXPECT_EQ(taut_move_body(cloth, 0, &square.mesh.positions), TAUT_ERROR_ARGUMENT);
  EXPECT_EQ(taut_move_body(cloth, -1, &square.mesh.positions), TAUT_ERROR_ARGUMENT);
  Box box(-0.15);
  ASSERT_EQ(taut_add_body(cloth, &box.body, &number), TAUT_OK) << cloth.error();
  EXPECT_EQ(number, 1);
  cloth.step(20);
  EXPECT_GT(lowest(cloth), 0.0);
  EXPECT_LT(lowest(cloth), 0.01);
  for (int frame = 0; frame < 20; ++frame) {
    box.lift(0.01);
    ASSERT_EQ(taut_move_body(cloth, number, &box.mesh.positions), TAUT_OK) << cloth.error();
    const TautFrame made_frame = cloth.step();
    ASSERT_EQ(cloth.result, TAUT_OK) << cloth.error();
    EXPECT_EQ(made_frame.crossing_pairs, 0);
    EXPECT_LT(made_frame.smallest_distance_m, 0.02);
  }
  EXPECT_GT(lowest(cloth), 0.15);
  box.lift(2.0);
  EXPECT_EQ(taut_move_body(cloth, number, &box.mesh.positions), TAUT_ERROR_ARGUMENT);
  EXPECT_CONTAINS(cloth.error(), "m from where it is, expected at most 1 m in a frame");
  EXPECT_EQ(taut_place_body(cloth, number, &box.mesh.positions), TAUT_OK);
  box.mesh.corner_count = 20;
  box.mesh.face_count = 5;
  EXPECT_EQ(taut_add_body(cloth, &box.body, &number), TAUT_ERROR_INPUT);
  EXPECT_CONTAINS(cloth.error(), "a body has no holes");
}

TEST(Library, AFrameThatCannotBeMadeLeavesTheClothAsItWas) {
  Square square(5, 0.1, 0.3);
  OwnCloth cloth(square.options);
  std::vector<std::uint32_t> all(25);
  std::iota(all.begin(), all.end(), 0U);
  ASSERT_EQ(taut_set_pins(cloth, all.data(), all.size()), TAUT_OK);
  Box box(0.1);
  std::int32_t number = 0;
  ASSERT_EQ(taut_add_body(cloth, &box.body, &number), TAUT_OK);
  cloth.step();
  const std::uint64_t hash = cloth.hash();
  box.lift(0.3);
  ASSERT_EQ(taut_move_body(cloth, number, &box.mesh.positions), TAUT_OK);
  EXPECT_EQ(taut_step(cloth, nullptr), TAUT_ERROR_PROMISE);
  EXPECT_CONTAINS(cloth.error(), "box");
  EXPECT_EQ(cloth.hash(), hash);
  EXPECT_EQ(cloth.info().frame, 1);
  EXPECT_EQ(taut_step(cloth, nullptr), TAUT_OK) << "the body stayed too: " << cloth.error();
}

TEST(Library, WindGravityForcesAndSettingsAct) {
  Square square;
  OwnCloth cloth(square.options);
  ASSERT_EQ(taut_set_gravity(cloth, 0, 0, 0), TAUT_OK);
  cloth.step(2);
  EXPECT_NEAR(cloth.positions()[40][1], 0.0, 1e-6);
  ASSERT_EQ(taut_set_wind(cloth, 0, 5, 0), TAUT_OK);
  cloth.step(2);
  EXPECT_GT(cloth.positions()[40][1], 0.0);
  ASSERT_EQ(taut_set_wind(cloth, 0, 0, 0), TAUT_OK);
  const double force[3] = {0.5, 0, 0};
  const TautPoints forces = {force, 1, sizeof(force), TAUT_DOUBLE};
  const std::uint32_t vertex = 40;
  ASSERT_EQ(taut_set_forces(cloth, &vertex, &forces), TAUT_OK);
  cloth.step(3);
  EXPECT_GT(cloth.positions()[40][0], square.positions[40][0] + 0.001);
  ASSERT_EQ(taut_set(cloth, "cloth.fabric", "silk"), TAUT_OK) << cloth.error();
  ASSERT_EQ(taut_set(cloth, "solver.max_stretch", "0.02"), TAUT_OK) << cloth.error();
  EXPECT_EQ(cloth.info().max_stretch, 0.02);
  EXPECT_EQ(taut_set(cloth, "garment.file", "x.obj"), TAUT_ERROR_ARGUMENT);
  EXPECT_EQ(taut_set(cloth, "solver.max_stretch", "soft"), TAUT_ERROR_ARGUMENT);
  EXPECT_CONTAINS(cloth.error(),
                  "solver.max_stretch = soft: solver.max_stretch: found \"soft\", expected a number");
  EXPECT_EQ(taut_set_wind(cloth, infinite, 0, 0), TAUT_ERROR_ARGUMENT);
  EXPECT_EQ(taut_set_wind(cloth, 0, 1e6, 0), TAUT_ERROR_ARGUMENT) << "the bound is not promised then";
  EXPECT_EQ(cloth.info().max_stretch, 0.02);
  EXPECT_EQ(taut_step(cloth, nullptr), TAUT_OK) << cloth.error();
}

TEST(Library, GoesOnFromABufferAndAFileWithTheSameBits) {
  const TemporaryFolder folder;
  Square square;
  OwnCloth cloth(square.options);
  const std::uint32_t pins[] = {0, 8};
  taut_set_pins(cloth, pins, 2);
  const auto go_on = [&](OwnCloth& some) {  // a pin moves in every other frame
    for (int frame = 0; frame < 6; ++frame) {
      const double target[3] = {square.positions[0][0], 0.01 * frame, square.positions[0][2]};
      const TautPoints points = {target, 1, sizeof(target), TAUT_DOUBLE};
      EXPECT_EQ(frame % 2 != 0 ? TAUT_OK : taut_move_pins(some, pins, &points), TAUT_OK);
      some.step();
    }
    return some.hash();
  };
  cloth.step(7);
  std::size_t size = 0;
  ASSERT_EQ(taut_save(cloth, nullptr, 0, &size), TAUT_OK);
  std::vector<char> bytes(size);
  EXPECT_EQ(taut_save(cloth, bytes.data(), size - 1, &size), TAUT_ERROR_ARGUMENT);
  ASSERT_EQ(taut_save(cloth, bytes.data(), size, &size), TAUT_OK);
  const std::string file = (folder / "state").string();
  ASSERT_EQ(taut_save_file(cloth, file.c_str()), TAUT_OK);
  const std::uint64_t saved = cloth.hash();
  const std::uint64_t expected = go_on(cloth);

  OwnCloth other(square.options);
  taut_set_pins(other, pins, 2);
  ASSERT_EQ(taut_restore_file(other, file.c_str()), TAUT_OK) << other.error();
  EXPECT_EQ(other.hash(), saved);
  EXPECT_EQ(other.info().frame, 7);
  EXPECT_EQ(go_on(other), expected);
  ASSERT_EQ(taut_restore(cloth, bytes.data(), size), TAUT_OK);
  EXPECT_EQ(go_on(cloth), expected);

  bytes[size / 2] ^= 1;
  const std::uint64_t before = cloth.hash();
  EXPECT_EQ(taut_restore(cloth, bytes.data(), size), TAUT_ERROR_INPUT);
  EXPECT_EQ(taut_restore(cloth, bytes.data(), 3), TAUT_ERROR_INPUT);
  EXPECT_EQ(taut_restore_file(cloth, "/none/state"), TAUT_ERROR_INPUT);
  EXPECT_EQ(cloth.hash(), before);
}

TEST(Library, BeginsAndGoesOnInAShapeThatIsGiven) {
  Square square(9, 0.4), lifted(9, 0.4, 1.0);
  const TautPoints start = lifted.points();
  square.options.start = &start;
  OwnCloth cloth(square.options);
  EXPECT_NEAR(cloth.positions()[40][1], 1.0, 1e-12);
  cloth.step(5);
  const TautPoints back = square.points();
  ASSERT_EQ(taut_set_positions(cloth, &back), TAUT_OK);
  EXPECT_EQ(cloth.positions(), square.positions);
  EXPECT_EQ(cloth.step().frame, 6);
  const TautPoints few = {square.positions.data(), 80, 24, TAUT_DOUBLE};
  EXPECT_EQ(taut_set_positions(cloth, &few), TAUT_ERROR_ARGUMENT);
  EXPECT_EQ(cloth.error(), "found 80 points, expected 81");
}

TEST(Library, ALostClothSaysSoUntilItIsRestored) {
  OwnCloth cloth([] {
    auto options = OwnCloth::options_of("pinned-9x9-5", 0);
    static const char* const settings[] = {"solver.kind=ideal", "solver.substeps=1",
                                           "solver.stiffness.structural=1e9"};
    options.settings = settings;
    options.setting_count = 3;
    return options;
  }());
  ASSERT_EQ(cloth.result, TAUT_OK) << cloth.text;
  const auto start = cloth.positions();
  cloth.step(100);
  EXPECT_EQ(cloth.result, TAUT_ERROR_DIVERGED);
  EXPECT_CONTAINS(cloth.error(), "diverged");
  EXPECT_EQ(taut_step(cloth, nullptr), TAUT_ERROR_DIVERGED);
  const TautPoints points = {start.data(), start.size(), sizeof(start[0]), TAUT_DOUBLE};
  ASSERT_EQ(taut_set_positions(cloth, &points), TAUT_OK);
  EXPECT_EQ(taut_step(cloth, nullptr), TAUT_OK);
}

TEST(Library, ReadsScenesAndModelsOfFiles) {
  auto options = made<TautOptions>(taut_options_init);
  options.scene_text =
      "[garment.grid]\ncolumns = 5\nrows = 4\n[picture]\nwidth = 99\n[camera]\nfollow = true\n";
  OwnCloth grid(options);
  ASSERT_EQ(grid.result, TAUT_OK) << grid.text;
  EXPECT_EQ(grid.info().vertex_count, 20U);
  std::string told;
  options.log_user = &told;
  options.log = [](void* user, const char* line) { *static_cast<std::string*>(user) += line; };
  options.scene_text = nullptr;
  options.scene = TAUT_ASSETS_FOLDER "/garments/tshirt_1028.obj";
  OwnCloth shirt(options);
  ASSERT_EQ(shirt.result, TAUT_OK) << shirt.text;
  EXPECT_EQ(shirt.info().triangle_count, 1028U);
  EXPECT_GT(shirt.info().pin_count, 0U);
  EXPECT_NE(told, "");
  options.importer = "/none/taut-import";
  OwnCloth none(options);
  EXPECT_EQ(none.result, TAUT_ERROR_INPUT);
  EXPECT_CONTAINS(none.text, "/none/taut-import");
}

TEST(Library, HandlesThatAreNoneAreSaidAndDoNoHarm) {
  TautCloth stale = {};
  {
    OwnCloth cloth("pinned-9x9-5");
    stale = cloth;
    EXPECT_EQ(taut_step(stale, nullptr), TAUT_OK);
  }
  OwnCloth next("pinned-9x9-5");
  for (const TautCloth none : {TautCloth{0}, TautCloth{1}, stale, TautCloth{0xDEADBEEF}, TautCloth{~0ULL}}) {
    EXPECT_EQ(taut_step(none, nullptr), TAUT_ERROR_HANDLE);
    EXPECT_EQ(taut_destroy(none), TAUT_ERROR_HANDLE);
    EXPECT_STREQ(taut_last_error(none), "there is no such cloth");
  }
}

TEST(Library, WhatCannotBeACloth) {
  const auto refusal = [](const TautOptions& options) {
    OwnCloth cloth(options);
    EXPECT_EQ(cloth.cloth.id, 0U);
    return std::to_string(cloth.result) + ' ' + cloth.text;
  };
  const auto of_mesh = [&](auto change) {
    Square square(3);
    change(square);
    return refusal(square.options);
  };
  EXPECT_EQ(of_mesh([](Square& s) { s.mesh.corners = nullptr; }), "3 found vertices of NULL");
  EXPECT_EQ(of_mesh([](Square& s) { s.corners[5] = 9; }),
            "3 found vertex 9 at place 5, expected one below 9");
  EXPECT_EQ(of_mesh([](Square& s) { s.mesh.positions.stride = 0; }),
            "3 found a stride of 0 bytes, expected at least 24");
  EXPECT_EQ(of_mesh([](Square& s) { s.positions[4][1] = std::nan(""); }),
            "3 found point 4 with a number that is not finite");
  EXPECT_EQ(of_mesh([](Square& s) { s.mesh.positions.count = ~std::size_t{0}; }),
            "3 found 18446744073709551615 points, expected at most 12000000");
  EXPECT_CONTAINS(of_mesh([](Square& s) { s.mesh.corner_count = ~std::size_t{0} / 3 * 3; }),
                  "corners of faces, expected at most 12000000");
  EXPECT_EQ(of_mesh([](Square& s) { s.mesh.positions.type = 7; }),
            "3 found an unknown type of numbers, expected TAUT_FLOAT or TAUT_DOUBLE");
  EXPECT_EQ(of_mesh([](Square& s) { s.sizes[1] = 2; }).substr(0, 2), "3 ");
  EXPECT_EQ(of_mesh([](Square& s) { s.mesh.struct_size = 3; }).substr(0, 23), "3 found a struct with a");
  EXPECT_CONTAINS(of_mesh([](Square& s) { s.options.scene = "tshirt"; }), "exactly one of");
  EXPECT_CONTAINS(of_mesh([](Square& s) { s.options.threads = 65; }), "threads: expected 1 to 64");
  auto options = made<TautOptions>(taut_options_init);
  EXPECT_EQ(refusal(options), "3 expected exactly one of scene, scene_text and mesh");
  options.scene = "tshirtt";
  EXPECT_CONTAINS(refusal(options), "4 there is no scene 'tshirtt'; did you mean");
  options.scene = "tshirt";
  const char* setting = "wind.sped = 4";
  options.settings = &setting;
  options.setting_count = 1;
  EXPECT_CONTAINS(refusal(options), "wind.sped = 4: unknown key 'wind.sped'; did you mean 'wind.speed'");
  EXPECT_EQ(taut_create(nullptr, nullptr, nullptr), TAUT_ERROR_ARGUMENT);
}

TEST(Library, StructsMayGrow) {
  struct {
    TautFrame frame;
    char later[16];
  } grown;
  EXPECT_EQ(taut_frame_init(&grown.frame, sizeof(grown)), TAUT_OK);
  OwnCloth cloth("pinned-9x9-5");
  EXPECT_EQ(taut_step(cloth, &grown.frame), TAUT_OK) << cloth.error();
  EXPECT_EQ(grown.frame.frame, 1);
  EXPECT_EQ(grown.frame.struct_size, sizeof(grown));
  grown.later[3] = 1;
  EXPECT_EQ(taut_step(cloth, &grown.frame), TAUT_ERROR_ARGUMENT);
  EXPECT_CONTAINS(cloth.error(), "members that this version does not know");
  EXPECT_EQ(cloth.info().frame, 1);
  EXPECT_EQ(taut_frame_init(&grown.frame, 4), TAUT_ERROR_ARGUMENT);
}

TEST(Library, AClothInUseIsBusyAndOthersGoOn) {
  OwnCloth first("tshirt"), second("pinned-9x9-5");
  std::thread other([&] { EXPECT_EQ(taut_step(first, nullptr), TAUT_OK); });
  int busy = 0;
  for (bool is_over = false; !is_over;) {
    auto info = made<TautInfo>(taut_info_init);
    const TautResult result = taut_get_info(first, &info);
    busy += result == TAUT_ERROR_BUSY ? 1 : 0;
    is_over = result == TAUT_OK && info.frame == 1;
    EXPECT_EQ(taut_step(second, nullptr), TAUT_OK);
  }
  other.join();
  EXPECT_GT(busy, 0);
}

}  // namespace
}  // namespace taut::test
