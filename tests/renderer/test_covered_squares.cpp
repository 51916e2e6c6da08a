#include "renderer/passes/surface_pass.hpp"
#include "scene_support.hpp"

namespace taut::renderer {
namespace {

// One triangle in clip space, on a tile of 96 by 64 pixels: six by four squares.
struct CoveredSquaresTest : testing::Test {
  std::unique_ptr<Context> context = create_context();
  SurfaceBuffers surfaces{context->gl()};
  BaseColourMapTexture maps{context->gl()};
  CoveredSquares squares;

  void find(const std::array<glm::vec3, 3>& positions, const glm::mat4& to_clip = glm::mat4{1.0F}) {
    SurfaceView surface;
    surface.positions = positions;
    surface.normals = up_normals;
    surface.triangles = triangle_indices;
    surfaces.clear();
    surfaces.add(surface, -1, maps);
    squares.find(surfaces, to_clip, {96, 64});
  }
  // Returns the covered area in squares.
  float area() {
    float sum = 0.0F;
    const std::vector<glm::vec2>& corners = squares.corners();
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
      const glm::vec2 a = corners[i + 1] - corners[i];
      const glm::vec2 b = corners[i + 2] - corners[i];
      sum += 0.5F * std::abs(a.x * b.y - a.y * b.x) * 24.0F / 4.0F;
    }
    return sum;
  }
};

TEST_F(CoveredSquaresTest, HoldTheTriangleAndLittleElse) {
  // The triangle spans 50 to 60 px across and 34 to 44 px up, within one square.
  const std::array<glm::vec3, 3> small{{{0.042F, 0.0626F, 0}, {0.25F, 0.0626F, 0}, {0.25F, 0.375F, 0}}};
  find(small);
  EXPECT_NEAR(area(), 1.0F, 1e-3F);
  EXPECT_NEAR(squares.corners()[0].x, 0.0F, 1e-5F);
  EXPECT_NEAR(squares.corners()[0].y, 0.0F, 1e-5F);
}

TEST_F(CoveredSquaresTest, EndWithTheTile) {
  find({{{-3, -3, 0}, {3, -3, 0}, {0, 5, 0}}});
  EXPECT_NEAR(area(), 24.0F, 1e-3F);
  find({{{2, 2, 0}, {3, 2, 0}, {3, 3, 0}}});
  EXPECT_EQ(area(), 0.0F);
}

TEST_F(CoveredSquaresTest, AreAllWhereATrianglePassesTheEye) {
  glm::mat4 to_clip{1.0F};
  to_clip[2][3] = 1.0F;  // w = z
  to_clip[3][3] = 0.0F;
  find({{{0, 0, -1}, {0.1F, 0, 1}, {0, 0.1F, 1}}}, to_clip);
  EXPECT_NEAR(area(), 24.0F, 1e-3F);
  find({{{0, 0, -1}, {0.1F, 0, -1}, {0, 0.1F, -1}}}, to_clip);
  EXPECT_EQ(area(), 0.0F);
}

}  // namespace
}  // namespace taut::renderer
