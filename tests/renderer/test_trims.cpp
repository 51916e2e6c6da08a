#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "renderer/surface/lines.hpp"
#include "renderer/surface/refined_mesh.hpp"
#include "scene_support.hpp"

namespace taut::renderer {
namespace {

// A sheet of unit cells in the xy plane, the first vertex at the origin, rows along x.
struct Sheet {
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> triangles;

  Sheet(std::uint32_t columns, std::uint32_t rows) {
    for (std::uint32_t i = 0; i < (columns + 1) * (rows + 1); ++i) {
      positions.emplace_back(i % (columns + 1), i / (columns + 1), 0);
    }
    for (std::uint32_t i = 0; i < columns * rows; ++i) {
      const std::uint32_t a = i + i / columns, b = a + 1, c = a + columns + 1;
      triangles.insert(triangles.end(), {a, b, c, b, c + 1, c});
    }
  }
};

TEST(LineChains, AreChainsAndLoops) {
  const Sheet sheet(3, 2);
  const std::vector<VertexPair> open{{5, 6}, {4, 5}};
  const LineChains two = make_lines(open, sheet.positions);
  ASSERT_EQ(two.chains.size(), 1U);
  EXPECT_FALSE(two.chains[0].is_closed);
  EXPECT_EQ(two.chains[0].length, 2.0F);
  EXPECT_EQ(two.segments[0].ends[1], two.segments[1].ends[0]);
  EXPECT_EQ(two.segments[1].start, 1.0F);
  const std::vector<VertexPair> around{{0, 1}, {1, 5}, {5, 4}, {4, 0}};
  EXPECT_TRUE(make_lines(around, sheet.positions).chains[0].is_closed);
  const std::vector<VertexPair> cross{{1, 5}, {5, 9}, {4, 5}, {5, 6}};
  EXPECT_EQ(make_lines(cross, sheet.positions).chains.size(), 4U) << "they part where four meet";
}

TEST(LineChains, AreNearAlongTheClothAlone) {
  Sheet sheet(1, 6);
  // The sheet is folded in the middle, so that its far end lies on the line.
  for (std::size_t i = 8; i < sheet.positions.size(); ++i) {
    sheet.positions[i].y = 6.0F - sheet.positions[i].y;
    sheet.positions[i].z = 0.01F;
  }
  const std::vector<VertexPair> edge{{0, 1}};
  const LineChains lines = make_lines(edge, sheet.positions);
  const std::vector<NearestOnLine> nearest = nearest_on_lines(lines, sheet.positions, sheet.triangles, 2.5F);
  EXPECT_EQ(nearest[0].distance, 0.0F);
  EXPECT_EQ(nearest[3].distance, 1.0F);
  EXPECT_EQ(nearest[3].along, 1.0F);
  EXPECT_EQ(nearest[4].distance, 2.0F);
  EXPECT_EQ(nearest[6].segment, NearestOnLine::none) << "beyond reach";
  EXPECT_EQ(nearest[12].segment, NearestOnLine::none) << "another layer";
}

TEST(Seams, AreWhereTextureCoordinatesDiffer) {
  const Sheet sheet(2, 1);
  std::vector<glm::vec2> coordinates;
  for (const std::uint32_t corner : sheet.triangles) coordinates.emplace_back(sheet.positions[corner]);
  EXPECT_TRUE(seam_edges(sheet.positions, sheet.triangles, coordinates).empty());
  for (std::size_t i = 6; i < 12; ++i) coordinates[i].x += 5.0F;  // the right cell
  EXPECT_EQ(seam_edges(sheet.positions, sheet.triangles, coordinates), (std::vector<VertexPair>{{1, 4}}));
}

TEST(Seams, AreSharpEdgesWithoutTextureCoordinates) {
  Sheet sheet(2, 1);
  EXPECT_TRUE(seam_edges(sheet.positions, sheet.triangles).empty());
  for (const std::size_t right : {2U, 5U}) sheet.positions[right] += glm::vec3{-0.5F, 0.0F, 0.6F};
  EXPECT_TRUE(seam_edges(sheet.positions, sheet.triangles, {}).size() == 1) << "bent by 50.2 degrees";
  for (const std::size_t right : {2U, 5U}) sheet.positions[right].z = 0.58F;
  EXPECT_TRUE(seam_edges(sheet.positions, sheet.triangles, {}).empty()) << "by 49.2";
}

TEST(Rim, ClosesTheBorderAsThickAsTheCloth) {
  const Sheet sheet(2, 2);
  SmoothSurface surface(sheet.positions, sheet.triangles, 1, {0.1F}, 0.05F);
  surface.place(sheet.positions);
  const std::size_t without = surface.mesh().vertex_count();
  ASSERT_EQ(surface.positions().size(), without + 4U * 16U);
  EXPECT_EQ(surface.parent_triangles().size(), surface.triangles().size() / 3);
  float lowest = 0.0F, highest = 0.0F, leftmost = 0.0F;
  for (std::size_t i = without; i < surface.positions().size(); ++i) {
    lowest = std::min(lowest, surface.positions()[i].z);
    highest = std::max(highest, surface.positions()[i].z);
    leftmost = std::min(leftmost, surface.positions()[i].x);
    EXPECT_NEAR(glm::length(surface.normals()[i]), 1.0F, 1e-5F);
    EXPECT_EQ(surface.parents()[i - 9][0], surface.parents()[i - 9][1]);
  }
  EXPECT_NEAR(lowest, -0.1F, 1e-6F);
  EXPECT_EQ(highest, 0.0F) << "flush with the outside";
  EXPECT_NEAR(leftmost, -0.0433F, 1e-4F);
}

TEST(Trims, SayHowFarTheBorderIs) {
  const Sheet sheet(4, 4);
  SmoothSurface surface(sheet.positions, sheet.triangles, 1, {0.1F});
  surface.place(sheet.positions);
  const std::vector<BorderBand> bands(sheet.positions.size(), {0.9F, true});
  const std::vector<TrimmedTriangle> trims =
      trimmed_triangles(surface, surface.positions(), {bands, {}, 0.25F, 0.01F});
  ASSERT_FALSE(trims.empty());
  EXPECT_LT(trims.size(), surface.triangles().size() / 3);
  for (const TrimmedTriangle& trim : trims) {
    EXPECT_EQ(trim.band_m, 0.9F);
    EXPECT_TRUE(trim.ribbed);
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::vec3& place = surface.positions()[surface.triangles()[3 * trim.triangle + i]];
      const float distance = std::min({place.x, place.y, 4.0F - place.x, 4.0F - place.y});
      EXPECT_NEAR(trim.corners[i].x, distance, 1e-6F);
      EXPECT_LT(std::abs(trim.corners[i].y - trim.corners[(i + 1) % 3].y), 4.1F)
          << "goes on around the sheet";
    }
  }
}

TEST(Trims, SayOnWhichSideOfASeamATriangleIs) {
  const Sheet sheet(6, 3);
  SmoothSurface surface(sheet.positions, sheet.triangles, 1, {0.1F});
  surface.place(sheet.positions);
  const std::vector<VertexPair> seam{{3, 10}, {10, 17}, {17, 24}};
  const std::vector<TrimmedTriangle> trims =
      trimmed_triangles(surface, surface.positions(), {{}, seam, 1.0F, 0.01F});
  ASSERT_FALSE(trims.empty());
  const float on_right = trims.back().corners[0].z;
  for (const TrimmedTriangle& trim : trims) {
    EXPECT_EQ(trim.band_m, 0.0F);
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::vec3& place = surface.positions()[surface.triangles()[3 * trim.triangle + i]];
      EXPECT_NEAR(trim.corners[i].z, std::copysign(1.0F, on_right) * (place.x - 3.0F), 1e-6F);
      EXPECT_NEAR(std::abs(trim.corners[i].w - trims[0].corners[0].w),
                  std::abs(place.y - surface.positions()[surface.triangles()[3 * trims[0].triangle]].y),
                  1e-5F);
    }
  }
}

using TrimsPicture = SceneRendererTest;

// Returns the standard deviation of green in the middle of the picture, in steps of 255.
double unevenness(const Image& image) {
  double sum = 0.0, squares = 0.0;
  constexpr int count = 16 * 24;
  for (int i = 0; i < count; ++i) {
    const double value = image.at(36 + i % 24, 44 + i / 24)[1];
    sum += value;
    squares += value * value;
  }
  return std::sqrt(std::max(squares / count - sum * sum / count / count, 0.0));
}

TEST_F(TrimsPicture, StitchesShowUpCloseAndFadeFarAway) {
  FrameView frame = triangle_frame();
  TrimmedTriangle trim;
  const auto at_scale = [&](float scale) {
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::vec3& place = triangle_positions[i];
      trim.corners[i] = {1.0F, 0.0F, scale * 0.004F * (place.y + 0.7F), scale * place.x};
    }
    frame.surfaces[0].trims = std::span(&trim, 1);
    return unevenness(renderer.draw(frame, small_picture()));
  };
  const double plain = unevenness(renderer.draw(frame, small_picture()));
  EXPECT_GT(at_scale(2.0F), plain + 3.0);
  EXPECT_LT(at_scale(500.0F), plain + 2.0);
}

TEST_F(TrimsPicture, AHemShowsTheOutsideOnTheInside) {
  FrameView frame = triangle_frame();
  frame.camera.eye.z = -4.0F;
  TrimmedTriangle trim;
  for (glm::vec4& corner : trim.corners) corner = {0.002F, 0.0F, 1.0F, 0.0F};
  trim.band_m = 0.02F;
  const Image plain = renderer.draw(frame, small_picture());
  frame.surfaces[0].trims = std::span(&trim, 1);
  const Image hem = renderer.draw(frame, small_picture());
  EXPECT_GT(plain.at(48, 40)[0], plain.at(48, 40)[1]) << "its inside is red";
  EXPECT_LT(hem.at(48, 40)[0], hem.at(48, 40)[1]) << "its outside is green";
}

}  // namespace
}  // namespace taut::renderer
