#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>

#include "cloths.hpp"
#include "temporary_folder.hpp"

namespace taut::test {
namespace {

/// State hashes of the frames that the program simulates.
std::vector<std::uint64_t> hashes_of_program(const TemporaryFolder& folder, const std::string& scene,
                                             int frames) {
  const std::string file = (folder / "run.jsonl").string();
  std::ostringstream command;
  command << TAUT_PROGRAM << " simulate " << scene << " --quiet --frames " << frames << " --stats " << file;
  EXPECT_EQ(std::system(command.str().c_str()), 0);
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

/// A mesh of faces that is written as OBJ or handed over as arrays.
struct AnyMesh {
  /// Reorders vertices and faces, and adds vertices that belong to no face.
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
    mesh = make_struct<TautMesh>(taut_mesh_init);
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

/// Adds quads between rings of points, ring after ring. All points of a ring may coincide.
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

/// Two squares to be sewn to each other, and a tube whose outside faces inwards.
AnyMesh some_garment() {
  AnyMesh mesh;
  for (const double x : {-0.2, 2e-4}) {
    add_rings(
        17, 16, false,
        [&](double u, double v) {
          return std::array{x + 0.2 * v, 0.42 + 0.01 * std::sin(3.0 * u * u + 2.0 * v), 0.2 * u - 0.1};
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

/// A ball with a small hole at each pole.
AnyMesh some_body() {
  AnyMesh mesh;
  add_rings(
      8, 16, true,
      [](double u, double v) {
        const double low = 2.8 - 2.5 * u, round = 6.283185307179586 * v;
        return std::array{0.125 * std::sin(low) * std::sin(round), 0.28 + 0.125 * std::cos(low),
                          0.125 * std::sin(low) * std::cos(round)};
      },
      mesh);
  return mesh;
}

double in_single_precision(double number) { return static_cast<float>(number); }

/// Writes the shapes as a point cache, which has single precision.
void write_pc2(const std::filesystem::path& file, const std::vector<AnyMesh>& shapes) {
  std::ofstream out(file, std::ios::binary);
  const auto put = [&](auto number) { out.write(reinterpret_cast<const char*>(&number), sizeof(number)); };
  out.write("POINTCACHE2", 12);
  put(std::int32_t{1});
  put(static_cast<std::int32_t>(shapes.front().positions.size()));
  put(0.0F);
  put(1.0F);
  put(static_cast<std::int32_t>(shapes.size()));
  for (const AnyMesh& shape : shapes) {
    for (const auto& position : shape.positions) {
      for (const double number : position) put(static_cast<float>(number));
    }
  }
}

// Files and arrays take different paths, and the caller's arrays have another order. The last bits are the same.
TEST(Library, MeshesOfFilesAndOfArraysHaveTheSameBitsInAnyOrder) {
  const TemporaryFolder folder;
  AnyMesh garment = some_garment(), body = some_body();
  garment.shuffle();
  body.shuffle();
  for (auto& position : body.positions) std::ranges::transform(position, position.begin(), in_single_precision);
  garment.write((folder / "garment.obj").string());
  body.write((folder / "body.obj").string());
  // The body is lifted.
  std::vector<AnyMesh> shapes(13, body);
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    for (auto& position : shapes[k].positions) {
      position[0] = in_single_precision(position[0] + 0.002 * static_cast<double>(k));
      position[1] = in_single_precision(position[1] + 0.01 * static_cast<double>(k));
    }
  }
  write_pc2(folder / "motion.pc2", shapes);
  const std::filesystem::path scene = folder.write(
      "scene.toml",
      "garment = { file = \"garment.obj\", scale = 1.0, up = \"y\" }\npins = { at = [] }\n"
      "wind = { speed = 2.0 }\n[[bodies]]\nshape = \"mesh\"\nfile = \"body.obj\"\nmotion = \"motion.pc2\"\n");
  const std::vector<std::uint64_t> expected = hashes_of_program(folder, scene.string(), 12);
  ASSERT_EQ(expected.size(), 12U);

  auto options = make_struct<TautOptions>(taut_options_init);
  options.mesh = garment.lend();
  const char* settings[] = {"pins.at = []", "wind.speed = 2.0"};
  options.settings = settings;
  options.setting_count = 2;
  OwnCloth cloth(options);
  ASSERT_EQ(cloth.result, TAUT_OK) << cloth.text;
  auto added = make_struct<TautBody>(taut_body_init);
  added.mesh = body.lend();
  ASSERT_EQ(taut_add_body(cloth, &added, nullptr), TAUT_OK) << cloth.error();
  for (std::size_t k = 0; k < expected.size(); ++k) {
    ASSERT_EQ(taut_move_body(cloth, 0, &shapes[k + 1].lend()->positions), TAUT_OK) << cloth.error();
    EXPECT_EQ(cloth.step().state_hash, expected[k]) << k;
  }
  EXPECT_EQ(cloth.result, TAUT_OK) << cloth.error();
}

TEST(Library, RestsWhenTheProgramDoes) {
  const TemporaryFolder folder;
  OwnCloth cloth("pinned-9x9-5");
  TautFrame frame{};
  for (const std::uint64_t hash : hashes_of_program(folder, "pinned-9x9-5", 100)) {
    frame = cloth.step();
    ASSERT_EQ(frame.state_hash, hash) << frame.frame;
  }
  EXPECT_EQ(frame.is_asleep, 1);
}

// Prescribing the position of pins and bodies at rest, as a loop over frames does, changes nothing.
class LedNowhere : public testing::TestWithParam<double> {};

TEST_P(LedNowhere, PinsAndBodiesChangeNoBitAndMayRest) {
  Square square(7, 0.3, 0.02);
  const std::uint32_t pins[] = {0, 6, 3};
  Box box(-0.11);
  std::vector<std::uint64_t> hashes[2];
  for (const bool are_led : {false, true}) {
    OwnCloth cloth(square.options);
    ASSERT_EQ(taut_set_pins(cloth, pins, 2), TAUT_OK);
    ASSERT_EQ(taut_add_body(cloth, &box.body, nullptr), TAUT_OK);
    ASSERT_EQ(taut_set_gravity(cloth, 0.0, GetParam(), 0.0), TAUT_OK);
    const double targets[2][3] = {{-0.15, 0.02, -0.15}, {0.15, 0.02, -0.15}};
    const TautPoints points = {targets, 2, sizeof(targets[0]), TAUT_DOUBLE};
    for (int frame = 0; frame < 40; ++frame) {
      if (are_led) {
        ASSERT_EQ(taut_move_pins(cloth, pins, &points), TAUT_OK);
        ASSERT_EQ(taut_move_body(cloth, 0, &box.mesh.positions), TAUT_OK);
      }
      const TautFrame made_frame = cloth.step();
      hashes[are_led].push_back(made_frame.state_hash + made_frame.is_asleep);
    }
    EXPECT_EQ(cloth.positions()[6][0], targets[1][0]);
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

INSTANTIATE_TEST_SUITE_P(Library, LedNowhere, testing::Values(-9.81, 0.0));

}  // namespace
}  // namespace taut::test
