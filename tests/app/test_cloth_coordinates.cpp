#include <gtest/gtest.h>

#include <algorithm>

#include "app/drawing/garment_surface.hpp"

namespace taut::app {
namespace {

// Two separate squares of 1 m, side by side. The left one is a quarter of the image wide. The right one is a tenth of
// it wide and mirrored.
struct TwoPieces {
  sim::Garment garment;
  std::vector<glm::vec2> corner_uv;

  TwoPieces() {
    sim::Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}};
    mesh.triangles = {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}};
    for (std::size_t t = 0; t < 4; ++t) {
      for (const sim::Index v : mesh.triangles[t]) {
        const glm::vec2 place(mesh.positions[v]);
        corner_uv.push_back(t < 2 ? 0.25F * place
                                  : glm::vec2{0.9F - 0.1F * (place.x - 1.0F), 0.1F * place.y});
      }
    }
    garment = sim::make_garment(std::move(mesh));
  }
};

TEST(ClothCoordinates, AreMetresOnEachPieceAndNotMirrored) {
  const TwoPieces pieces;
  const std::vector<glm::vec2> places = cloth_coordinates(pieces.garment, pieces.corner_uv);
  ASSERT_EQ(places.size(), 12);
  for (std::size_t t = 0; t < 4; ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const sim::Vec3 at_rest = pieces.garment.mesh.positions[pieces.garment.mesh.triangles[t][i]] -
                                pieces.garment.mesh.positions[pieces.garment.mesh.triangles[t][0]];
      const glm::vec2 laid = places[3 * t + i] - places[3 * t];
      EXPECT_NEAR(laid.x, at_rest.x, 1e-5) << t;
      EXPECT_NEAR(laid.y, at_rest.y, 1e-5) << t;
    }
  }
}

TEST(ClothCoordinates, AreNoneWithoutAnAreaToScaleBy) {
  TwoPieces pieces;
  EXPECT_TRUE(cloth_coordinates(pieces.garment, {}).empty());
  std::fill(pieces.corner_uv.begin() + 6, pieces.corner_uv.end(), glm::vec2{0.5F});
  EXPECT_TRUE(cloth_coordinates(pieces.garment, pieces.corner_uv).empty());
}

TEST(GarmentSurface, TheWeaveOfEachPieceIsItsOwn) {
  const TwoPieces pieces;
  for (const float min_edge_px : {1e6F, 200.0F}) {
    GarmentSurface surface(pieces.garment, pieces.corner_uv);
    surface.set_detail(1000.0F, min_edge_px);
    std::vector<glm::vec3> moved;
    for (const sim::Vec3& place : pieces.garment.mesh.positions) {
      moved.emplace_back(place.x, place.y, 0.1 * place.x);
    }
    surface.place(moved);
    const renderer::SurfaceView view = surface.view();
    ASSERT_EQ(view.material_coordinates.size(), view.positions.size());
    const std::size_t triangles =
        pieces.garment.mesh.triangles.size() * (view.positions.size() > 100 ? 16 : 1);
    for (std::size_t i = 0; i < 3 * triangles; ++i) {
      const std::uint32_t own = view.triangles[i], first = view.triangles[i - i % 3];
      const glm::vec3 laid = view.material_coordinates[own] - view.material_coordinates[first];
      EXPECT_NEAR(laid.x, view.positions[own].x - view.positions[first].x, 2e-3F) << i;
      EXPECT_NEAR(laid.y, view.positions[own].y - view.positions[first].y, 2e-3F) << i;
      EXPECT_NEAR(view.positions[own].z, 0.1F * view.positions[own].x, 2e-3F) << i;
    }
  }
}

}  // namespace
}  // namespace taut::app
