// The parts of the tool that makes the garments, on cases small enough to know the answer.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "sim/mesh/adjacency.hpp"
#include "tailor/crossings.hpp"
#include "tailor/dressing/flat_lengths.hpp"
#include "tailor/dressing/lift.hpp"
#include "tailor/flat/random.hpp"
#include "tailor/flat/triangulate.hpp"
#include "tailor/quality.hpp"
#include "tailor/recipe.hpp"
#include "tailor/sewing/sew.hpp"

namespace taut::test {
namespace {

using sim::Triangle;
using sim::Vec3;
using tailor::Vec2;

const std::filesystem::path pattern_file =
    std::filesystem::path(TAUT_ASSETS_DIR) / "patterns/tshirt/teagan.toml";

std::size_t crossings_of(const sim::Mesh& mesh) {
  return tailor::count_crossings(mesh, sim::make_adjacency(mesh));
}

/// The pattern with one piece of text replaced, as a file of its own.
std::filesystem::path altered_pattern(const std::string& from, const std::string& to) {
  std::ifstream in(pattern_file);
  std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  text.replace(text.find(from), from.size(), to);
  const auto file = std::filesystem::path(testing::TempDir()) / "altered_pattern.toml";
  std::ofstream(file) << text;
  return file;
}

std::string message_of_reading(const std::filesystem::path& file) {
  try {
    tailor::read_pattern(file);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no error";
}

TEST(Random, IsSplitMix64) {
  // The generator's published first value for the seed 1234567 is 6457827717110365317.
  tailor::Random random(1234567);
  EXPECT_EQ(random.uniform(), static_cast<double>(6457827717110365317ULL >> 11) * 0x1.0p-53);
}

TEST(Planar, FindsPointsAlongALine) {
  const std::vector<Vec2> line = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 3.0}};
  EXPECT_EQ(tailor::length_of(line), 4.0);
  EXPECT_EQ(tailor::point_at_fraction(line, 0.5), Vec2(1.0, 1.0));
}

TEST(Triangulate, KeepsAConcaveOutline) {
  // An L of area 3 with one interior point.
  const std::vector<Vec2> points = {{0, 0}, {1, 0}, {2, 0}, {2, 1},     {1, 1},
                                    {1, 2}, {0, 2}, {0, 1}, {0.4, 0.45}};
  EXPECT_EQ(tailor::triangulate(points, 8).size(), 8U);
}

TEST(Triangulate, RefusesAPointTooNearTheOutline) {
  // The last point lies so near the right edge of the notch that it is joined to the notch's other side.
  const std::vector<Vec2> points = {{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}, {3.2, 2}};
  EXPECT_THROW(tailor::triangulate(points, 5), std::runtime_error);
}

TEST(Crossings, CountsAnEdgeThroughATriangle) {
  const sim::Mesh apart = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.2, 1}, {0.3, 0.2, 2}, {0.2, 0.3, 2}},
                           {{0, 1, 2}, {3, 4, 5}},
                           {}};
  EXPECT_EQ(crossings_of(apart), 0U);
  sim::Mesh crossing = apart;
  crossing.positions[3].z = -1.0;
  EXPECT_EQ(crossings_of(crossing), 2U);
}

TEST(Quality, MeasuresARightTriangle) {
  const tailor::MeshQuality quality =
      tailor::measure_quality({{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}, {{0, 1, 2}}, {}});
  EXPECT_NEAR(quality.smallest_angle_deg, 36.8699, 1e-4);
  EXPECT_EQ(quality.shortest_edge_m, 3.0);
  EXPECT_EQ(quality.mean_edge_m, 4.0);
  EXPECT_EQ(quality.longest_edge_m, 5.0);
  EXPECT_EQ(quality.area_m2, 6.0);
}

TEST(Quality, KnowsTheInsideFromTheOutside) {
  const std::vector<Vec3> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::vector<Triangle> outwards = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  std::vector<Triangle> inwards = outwards;
  for (Triangle& t : inwards) {
    std::swap(t[0], t[1]);
  }
  EXPECT_NEAR(tailor::measure_quality({corners, outwards, {}}).volume_m3, 1.0 / 6.0, 1e-12);
  EXPECT_NEAR(tailor::measure_quality({corners, inwards, {}}).volume_m3, -1.0 / 6.0, 1e-12);
}

TEST(Quality, IsRequired) {
  tailor::MeshQuality good;
  good.triangles = 1028;
  good.smallest_angle_deg = 10.0;
  good.area_m2 = 1.0;
  good.volume_m3 = 0.1;
  good.topology.components = 1;
  good.topology.boundary_loops = 4;
  good.topology.euler_characteristic = -2;
  EXPECT_NO_THROW(tailor::require_quality(good, 1028, 1.0));
  const auto expect_refused = [&](auto spoil) {
    tailor::MeshQuality spoilt = good;
    spoil(spoilt);
    EXPECT_THROW(tailor::require_quality(spoilt, 1028, 1.0), std::runtime_error);
  };
  expect_refused([](auto& q) { q.triangles = 1027; });
  expect_refused([](auto& q) { q.smallest_angle_deg = 9.99; });
  expect_refused([](auto& q) { q.area_m2 = 1.011; });
  expect_refused([](auto& q) { q.area_m2 = 0.989; });
  expect_refused([](auto& q) { q.volume_m3 = -0.1; });
  expect_refused([](auto& q) { q.crossings = 1; });
  expect_refused([](auto& q) { q.topology.components = 2; });
  expect_refused([](auto& q) { q.topology.boundary_loops = 3; });
  expect_refused([](auto& q) { q.topology.euler_characteristic = -1; });
  expect_refused([](auto& q) { q.topology.non_manifold_edges = 1; });
  expect_refused([](auto& q) { q.topology.non_manifold_vertices = 1; });
  expect_refused([](auto& q) { q.topology.misoriented_edges = 1; });
}

TEST(Fit, IsRequired) {
  EXPECT_NO_THROW(tailor::require_fit({0.015, 0.10}));
  EXPECT_THROW(tailor::require_fit({0.0151, 0.05}), std::runtime_error);
  EXPECT_THROW(tailor::require_fit({0.001, 0.101}), std::runtime_error);
}

TEST(Pattern, NamesWhatIsWrong) {
  EXPECT_NE(message_of_reading("no_such_file.toml").find("no_such_file.toml"), std::string::npos);
  EXPECT_NE(
      message_of_reading(altered_pattern("[back.armhole]", "[back.armpit]")).find("back.armhole.points_mm"),
      std::string::npos);
  EXPECT_NE(message_of_reading(altered_pattern("[260.780, 713.000]", "[260.780, nan]")).find("front.hem"),
            std::string::npos);
  EXPECT_NE(message_of_reading(altered_pattern("[260.780, 713.000]", "[250.780, 713.000]"))
                .find("segment 2 of front"),
            std::string::npos);
  EXPECT_NE(message_of_reading(altered_pattern("[0.000, 713.000], ", "[0.000, 713.000] ")).find("line"),
            std::string::npos);
}

TEST(Sew, MakesExactlyAsManyTrianglesAsAsked) {
  const auto pieces = tailor::cut_pieces(tailor::read_pattern(pattern_file));
  for (const std::size_t count : {600U, 601U, 1001U}) {
    EXPECT_EQ(tailor::sew_shirt(pieces, count, 1).triangles().size(), count);
  }
  EXPECT_THROW(tailor::sew_shirt(pieces, 10, 1), std::exception);
}

TEST(Sew, DependsOnItsSeedAlone) {
  const auto pieces = tailor::cut_pieces(tailor::read_pattern(pattern_file));
  const auto flat = [&](std::uint64_t seed) { return tailor::sew_shirt(pieces, 800, seed).panels[0].flat_m; };
  EXPECT_EQ(flat(7), flat(7));
  EXPECT_NE(flat(7), flat(8));
}

TEST(Lift, KeepsEveryPointsPlaceOnThePiece) {
  // The coarse front is bent into a bowl, so that only the triangle a point lies in gives nearly its height.
  const auto pieces = tailor::cut_pieces(tailor::read_pattern(pattern_file));
  const tailor::Shirt coarse = tailor::sew_shirt(pieces, 700, 1);
  const tailor::Shirt fine = tailor::sew_shirt(pieces, 2000, 1);
  const auto bowl = [](const Vec2& p) { return Vec3(p, p.x * p.x + p.y * p.y); };
  std::vector<Vec3> positions(coarse.vertex_count);
  const tailor::Panel& coarse_front = coarse.panels[0];
  for (std::size_t i = 0; i < coarse_front.flat_m.size(); ++i) {
    positions[coarse_front.vertices[i]] = bowl(coarse_front.flat_m[i]);
  }
  const std::vector<Vec3> lifted = tailor::lift_onto(fine, coarse, positions);
  const tailor::Panel& front = fine.panels[0];
  for (std::size_t i = front.outline_count; i < front.flat_m.size(); ++i) {
    const Vec3 expected = bowl(front.flat_m[i]);
    const Vec3& found = lifted[front.vertices[i]];
    EXPECT_NEAR(found.x, expected.x, 1e-12);
    EXPECT_NEAR(found.y, expected.y, 1e-12);
    // A triangle of edges of at most 8 cm lies at most its circumradius squared above the bowl.
    EXPECT_NEAR(found.z, expected.z, 0.08 * 0.08 / 3.0);
  }
}

}  // namespace
}  // namespace taut::test
