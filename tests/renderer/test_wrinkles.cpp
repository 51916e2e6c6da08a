#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/surface/smooth_surface.hpp"
#include "renderer/surface/wrinkles.hpp"

namespace taut::renderer {
namespace {

constexpr float sheet_edge = 0.013F;
constexpr float wavelength = 2.5F * sheet_edge;
constexpr std::uint32_t sheet_side = 41;

/// A square of cloth in the xy plane.
struct WrinkledSheet {
  std::vector<glm::vec3> rest;
  std::vector<std::uint32_t> triangles;
  SmoothSurface smooth;
  Wrinkles wrinkles;

  WrinkledSheet()
      : rest(places()), triangles(corners()), smooth(rest, triangles, 2, {}), wrinkles(rest, triangles, wavelength) {
    smooth.place(rest);
    wrinkles.refine(smooth.positions(), smooth.mesh().parents());
  }
  static std::vector<glm::vec3> places() {
    std::vector<glm::vec3> all;
    for (std::uint32_t v = 0; v < sheet_side * sheet_side; ++v) {
      all.emplace_back(sheet_edge * static_cast<float>(v % sheet_side), sheet_edge * static_cast<float>(v / sheet_side),
                       0.0F);
    }
    return all;
  }
  static std::vector<std::uint32_t> corners() {
    std::vector<std::uint32_t> all;
    for (std::uint32_t v = 0; v + sheet_side < sheet_side * sheet_side; ++v) {
      if (v % sheet_side + 1 < sheet_side)
        all.insert(all.end(), {v, v + 1, v + sheet_side + 1, v, v + sheet_side + 1, v + sheet_side});
    }
    return all;
  }
  std::vector<glm::vec3> scaled(float x, float y) const {
    std::vector<glm::vec3> all = rest;
    for (glm::vec3& p : all) p = {x * p.x, y * p.y, p.z};
    return all;
  }
  /// Returns the mean squares of the heights' slopes along x and along y.
  glm::vec2 squared_slopes(std::span<const float> heights) const {
    glm::vec2 sum(0.0F);
    const std::vector<std::uint32_t>& t = smooth.mesh().triangles();
    for (std::size_t i = 0; i < t.size(); i += 3) {
      const glm::vec3 ab = smooth.positions()[t[i + 1]] - smooth.positions()[t[i]];
      const glm::vec3 ac = smooth.positions()[t[i + 2]] - smooth.positions()[t[i]];
      const float b = heights[t[i + 1]] - heights[t[i]], c = heights[t[i + 2]] - heights[t[i]];
      const float area = ab.x * ac.y - ab.y * ac.x;
      const glm::vec2 slope = glm::vec2(b * ac.y - c * ab.y, c * ab.x - b * ac.x) / area;
      sum += slope * slope;
    }
    return sum * (3.0F / static_cast<float>(t.size()));
  }
};

float max_height(std::span<const float> heights) {
  return std::ranges::max(heights, {}, [](float h) { return std::abs(h); });
}

TEST(Wrinkles, ClothThatIsNotShortHasNone) {
  WrinkledSheet sheet;
  EXPECT_EQ(max_height(sheet.wrinkles.heights(sheet.rest)), 0.0F);
  EXPECT_EQ(max_height(sheet.wrinkles.heights(sheet.scaled(1.05F, 1.02F))), 0.0F);
  EXPECT_EQ(max_height(sheet.wrinkles.heights(sheet.scaled(0.998F, 1.0F))), 0.0F) << "as meshes tremble";
}

TEST(Wrinkles, RunAlongWhatIsShortenedAndTakeUpTheirShareOfIt) {
  WrinkledSheet sheet;
  const float shortened = 0.04F;
  const glm::vec2 along_x = sheet.squared_slopes(sheet.wrinkles.heights(sheet.scaled(1.0F - shortened, 1.0F)));
  const glm::vec2 along_y = sheet.squared_slopes(sheet.wrinkles.heights(sheet.scaled(1.0F, 1.0F - shortened)));
  EXPECT_GT(along_x.x, 2.0F * along_x.y);
  EXPECT_GT(along_y.y, 2.0F * along_y.x);
  // A slope of s makes a path longer by half of its square.
  EXPECT_NEAR(0.5F * along_x.x / (shortened - 0.003F), 0.5F, 0.2F);
  const glm::vec2 half = sheet.squared_slopes(sheet.wrinkles.heights(sheet.scaled(1.0F - 0.0215F, 1.0F)));
  EXPECT_NEAR(half.x / along_x.x, 0.5F, 0.05F) << "half the lack, half the square";
}

TEST(Wrinkles, MoveASurfaceWithinItsRoomsAndTurnItsNormals) {
  WrinkledSheet sheet;
  const std::vector<glm::vec3> shortened = sheet.scaled(0.96F, 1.0F);
  const std::span<const float> heights = sheet.wrinkles.heights(shortened);
  const auto most = [&](std::span<const float> rooms) {
    sheet.smooth.place(shortened, rooms, heights);
    return std::ranges::max(sheet.smooth.positions(), {}, [](const glm::vec3& p) { return std::abs(p.z); }).z;
  };
  EXPECT_NEAR(std::abs(most({})), max_height(heights), 1e-6F);
  const auto tilted = std::ranges::min(sheet.smooth.normals(), {}, [](const glm::vec3& n) { return n.z; });
  EXPECT_LT(tilted.z, 0.97F);
  const std::vector<float> rooms(sheet.rest.size(), 1e-4F);
  EXPECT_NEAR(std::abs(most(rooms)), 1e-4F, 1e-7F);
}

}  // namespace
}  // namespace taut::renderer
