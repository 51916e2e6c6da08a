#include <gtest/gtest.h>
#include <pmmintrin.h>
#include <xmmintrin.h>

#include <atomic>
#include <cfenv>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <numeric>
#include <sstream>
#include <thread>

#include "cloths.hpp"
#include "temporary_folder.hpp"

namespace taut::test {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

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

// Game engines split vertices where texture coordinates differ, and some tools leave vertices without faces.
TEST(Library, VerticesThatAreOneInSpaceAndThoseWithoutFacesKeepTheirNumbers) {
  const float positions[][4] = {{9, 9, 9, 0}, {0, 0, 0, 0}, {1, 0, 0, 0}, {0, 0, 1, 0},
                                {1, 0, 0, 0}, {1, 0, 1, 0}, {0, 0, 1, 0}};
  const std::uint32_t corners[] = {1, 3, 2, 4, 6, 5};
  auto mesh = make_struct<TautMesh>(taut_mesh_init);
  mesh.positions = {positions, 7, sizeof(positions[0]), TAUT_FLOAT};
  mesh.corners = corners;
  mesh.corner_count = 6;
  auto options = make_struct<TautOptions>(taut_options_init);
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

TEST(Library, WindGravityForcesAndSettingsAct) {
  Square square;
  OwnCloth cloth(square.options);
  ASSERT_EQ(taut_set_gravity(cloth, 0, 0, 0), TAUT_OK);
  cloth.step(2);
  EXPECT_NEAR(cloth.positions()[40][1], 0.0, 1e-6);
  ASSERT_EQ(taut_set_wind(cloth, 0, 5, 0), TAUT_OK);
  const TautFrame blown = cloth.step(2);
  EXPECT_GT(cloth.positions()[40][1], 0.0);
  // A plate of 1 m2 across 5 m/s takes 18 N; this one gives way.
  EXPECT_GT(blown.wind_force_n, 0.5);
  EXPECT_LT(blown.wind_force_n, 18.0);
  EXPECT_GT(blown.wind_power_w, 0.0);
  ASSERT_EQ(taut_set_wind(cloth, 0, 0, 0), TAUT_OK);
  EXPECT_EQ(cloth.step().wind_force_n, 0.0);
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

TEST(Library, DrawsTheClothInItsLookAndTheBodiesWhereTheyAre) {
  constexpr int width_px = 40, height_px = 32;
  Square square;
  const Box box(-0.2);
  const TautBody* const bodies[] = {&box.body};
  const char* settings[] = {"picture.outside_colour = \"#ff0000\"", "camera.elevation = 50"};
  square.options.settings = settings;
  square.options.setting_count = 2;
  square.options.bodies = bodies;
  square.options.body_count = 1;
  OwnCloth cloth(square.options);
  std::vector<std::uint8_t> rgb(3 * width_px * height_px);
  const auto count_red = [&] {
    EXPECT_EQ(taut_draw(cloth, width_px, height_px, rgb.data(), rgb.size()), TAUT_OK) << cloth.error();
    int count = 0;
    for (std::size_t k = 0; k < rgb.size(); k += 3) count += rgb[k] > 2 * rgb[k + 1] ? 1 : 0;
    return count;
  };
  const int red_count = count_red();
  EXPECT_GT(red_count, 300) << "the cloth fills much of the picture";
  Box moved(1.0);
  ASSERT_EQ(taut_place_body(cloth, 0, &moved.mesh.positions), TAUT_OK) << cloth.error();
  EXPECT_LT(count_red(), red_count / 2) << "the picture shows the box far above too";
  ASSERT_EQ(taut_set(cloth, "picture.outside_colour", "\"#00ff00\""), TAUT_OK) << cloth.error();
  EXPECT_EQ(count_red(), 0);
  const auto refusal = [&](int width, int height, std::size_t size) {
    EXPECT_EQ(taut_draw(cloth, width, height, rgb.data(), size), TAUT_ERROR_ARGUMENT);
    return std::string(cloth.error());
  };
  EXPECT_EQ(refusal(15, height_px, rgb.size()), "found 15 pixels, expected 16 to 16384");
  EXPECT_EQ(refusal(width_px, 16385, rgb.size()), "found 16385 pixels, expected 16 to 16384");
  EXPECT_EQ(refusal(width_px, height_px, 3), "found an array of 3, expected 3840");
  ASSERT_EQ(taut_set(cloth, "picture.background", "none"), TAUT_OK) << cloth.error();
  EXPECT_EQ(refusal(width_px, height_px, rgb.size()), "picture.background: found none, expected a background");
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
  auto options = make_struct<TautOptions>(taut_options_init);
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
            "3 found point 4 with a number that is not finite or beyond 1e+30");
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
  auto options = make_struct<TautOptions>(taut_options_init);
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

std::string list_names(std::int32_t kind) {
  std::size_t size = 0;
  EXPECT_EQ(taut_list(kind, nullptr, 0, &size), TAUT_OK);
  std::vector<char> names(size);
  EXPECT_EQ(taut_list(kind, names.data(), size - 1, &size), TAUT_ERROR_ARGUMENT);
  EXPECT_EQ(taut_list(kind, names.data(), size, &size), TAUT_OK);
  EXPECT_EQ(names.back(), '\0');
  return names.data();
}

TEST(Library, ListsWhatComesWithTaut) {
  const std::string fabrics = list_names(TAUT_FABRICS);
  EXPECT_CONTAINS(fabrics, "cotton\n");
  EXPECT_CONTAINS(fabrics, "\nsilk\n");
  const std::string scenes = list_names(TAUT_SCENES);
  EXPECT_CONTAINS(scenes, "\ntshirt\n");
  const std::string first = scenes.substr(0, scenes.find('\n'));
  EXPECT_EQ(OwnCloth(first.c_str()).result, TAUT_OK) << first;
  std::size_t size = 0;
  EXPECT_EQ(taut_list(2, nullptr, 0, &size), TAUT_ERROR_ARGUMENT);
  EXPECT_EQ(taut_list(TAUT_SCENES, nullptr, 0, nullptr), TAUT_ERROR_ARGUMENT);
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
  std::atomic<bool> is_over = false;
  std::thread other([&] {
    // The main thread may be using the cloth.
    int result = TAUT_ERROR_BUSY;
    while (result == TAUT_ERROR_BUSY) result = taut_step(first, nullptr);
    EXPECT_EQ(result, TAUT_OK);
    is_over = true;
  });
  int busy = 0;
  while (!is_over) {
    auto info = make_struct<TautInfo>(taut_info_init);
    busy += taut_get_info(first, &info) == TAUT_ERROR_BUSY ? 1 : 0;
    EXPECT_EQ(taut_step(second, nullptr), TAUT_OK);
  }
  other.join();
  EXPECT_GT(busy, 0);
}

TEST(Library, TheLastErrorIsReadWhileOthersFailAndDestroy) {
  for (int round = 0; round < 20; ++round) {
    OwnCloth cloth("pinned-9x9-5");
    std::thread other([&] {
      for (int k = 0; k < 50; ++k) {
        EXPECT_EQ(taut_set(cloth, k % 2 == 0 ? "none" : "wind.speed", "very fast"), TAUT_ERROR_ARGUMENT);
      }
      EXPECT_EQ(taut_destroy(cloth), TAUT_OK);
    });
    std::string text;
    const char* last = "";
    while (text != "there is no such cloth") {
      last = taut_last_error(cloth);
      text = last;
      EXPECT_TRUE(text.empty() || text.find("none") != text.npos || text.find("speed") != text.npos ||
                  text == "there is no such cloth")
          << text;
    }
    other.join();
  }
}

TEST(Library, TheTextOfTheLastErrorOutlivesItsCloth) {
  OwnCloth cloth("pinned-9x9-5");
  EXPECT_EQ(taut_set(cloth, "none", "1"), TAUT_ERROR_ARGUMENT);
  const char* text = taut_last_error(cloth);
  EXPECT_EQ(taut_destroy(cloth), TAUT_OK);
  EXPECT_CONTAINS(std::string(text), "none");
}

}  // namespace
}  // namespace taut::test
