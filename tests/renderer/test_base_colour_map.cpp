#include <stdexcept>

#include "scene_support.hpp"

namespace taut::renderer {
namespace {

using BaseColourMapTest = SceneRendererTest;

BaseColourMap make_map(int width_px, int height_px, std::vector<std::uint8_t> rgba) {
  return {width_px, height_px, std::make_shared<const std::vector<std::uint8_t>>(std::move(rgba))};
}

// Two by two pixels: red, green over blue, and one through which the cloth is seen.
const BaseColourMap four = make_map(2, 2, {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 90, 90, 90, 0});

constexpr std::array<glm::vec3, 4> corners{{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}};
constexpr std::array<glm::vec3, 4> normals{{{0, 1, 0}, {0, 1, 0}, {0, 1, 0}, {0, 1, 0}}};
constexpr std::array<std::uint32_t, 6> indices{0, 1, 2, 0, 2, 3};

// A square that fills the middle of the picture, 64 by 64 pixels.
struct Square {
  std::vector<glm::vec2> places = {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}};
  std::vector<BaseColour> colours = {{rgb(0x808080), rgb(0x404040), four}};
  std::vector<std::uint32_t> colour_of_triangle;

  FrameView frame() const {
    FrameView frame = triangle_frame();
    SurfaceView& surface = frame.surfaces[0];
    surface.positions = corners;
    surface.normals = normals;
    surface.triangles = indices;
    surface.corner_coordinates = places;
    surface.base_colours = colours;
    surface.base_colour_of_triangle = colour_of_triangle;
    return frame;
  }
};

TEST_F(BaseColourMapTest, StandsUprightOverTheColourOfTheCloth) {
  const Image image = renderer.draw(Square().frame(), small_picture());
  // Middles of the map's pixels are at a quarter and three quarters of the square, from its upper left.
  const Image plain = [&] {
    Square square;
    square.colours[0].map = {};
    return renderer.draw(square.frame(), small_picture());
  }();
  EXPECT_GT(image.at(32, 16)[0], 150);
  EXPECT_LT(image.at(32, 16)[1], 45);
  EXPECT_GT(image.at(64, 16)[1], 150);
  EXPECT_LT(image.at(64, 16)[0], 45);
  EXPECT_GT(image.at(32, 48)[2], 150);
  EXPECT_LT(image.at(32, 48)[1], 45);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(image.at(64, 48)[k], plain.at(64, 48)[k], 8);
}

TEST_F(BaseColourMapTest, IsFilteredInLinearLightAndRepeated) {
  Square square;
  // Black alternates with half of the light; far away, the mean is a quarter of the light.
  square.colours = {{rgb(0xFF0000), rgb(0xFF0000), make_map(2, 1, {0, 0, 0, 255, 188, 188, 188, 255})}};
  for (glm::vec2& place : square.places) place *= 200.0F;
  Square grey;
  grey.colours = {{rgb(0x898989), rgb(0x898989), {}}};
  const Image far = renderer.draw(square.frame(), small_picture());
  const Image same = renderer.draw(grey.frame(), small_picture());
  for (int x = 30; x < 66; x += 7) EXPECT_NEAR(far.at(x, 32)[1], same.at(x, 32)[1], 2);
}

TEST_F(BaseColourMapTest, TransparentPixelsDoNotTintEdges) {
  Square square;
  // The opaque pixel has the cloth's own colour, and the transparent one beside it would be white.
  square.colours = {{rgb(0x808080), rgb(0x808080), make_map(2, 1, {128, 128, 128, 255, 255, 255, 255, 0})}};
  const Image image = renderer.draw(square.frame(), small_picture());
  for (int x = 20; x < 76; ++x) EXPECT_NEAR(image.at(x, 32)[0], image.at(20, 32)[0], 2) << x;
}

TEST_F(BaseColourMapTest, ShinesThroughToTheInside) {
  Square square;
  square.colours = {{rgb(0xFFFFFF), rgb(0xC0C0C0), make_map(1, 1, {0, 0, 0, 255})}};
  FrameView frame = square.frame();
  const int outside = renderer.draw(frame, small_picture()).at(48, 32)[0];
  frame.camera.eye.z = -4.0F;
  const int inside = renderer.draw(frame, small_picture()).at(48, 32)[0];
  square.colours[0].map = {};
  FrameView bare = square.frame();
  bare.camera.eye.z = -4.0F;
  const int without = renderer.draw(bare, small_picture()).at(48, 32)[0];
  EXPECT_LT(outside, 10);
  EXPECT_GT(inside, outside + 60);
  EXPECT_LT(inside, without - 10);
}

TEST_F(BaseColourMapTest, TrianglesHaveColoursAndMapsOfTheirOwnOfAnySize) {
  Square square;
  square.colours = {{rgb(0xFFFFFF), rgb(0xFFFFFF), four},
                    {rgb(0x00FF00), rgb(0x00FF00), {}},
                    {rgb(0xFFFFFF), rgb(0xFFFFFF), make_map(5, 3, std::vector<std::uint8_t>(60, 255))}};
  square.colour_of_triangle = {1, 0};
  FrameView frame = square.frame();
  // Another surface, without a map, comes first.
  frame.surfaces.insert(frame.surfaces.begin(), triangle_frame().surfaces[0]);
  frame.surfaces[0].casts_shadow = false;
  const Image image = renderer.draw(frame, small_picture());
  EXPECT_LT(image.at(74, 40)[0], 45);  // below the diagonal: plain green
  EXPECT_GT(image.at(74, 40)[1], 150);
  EXPECT_GT(image.at(32, 16)[0], 150);  // above it: the map's red
  EXPECT_LT(image.at(32, 16)[1], 80);   // enlarged to five by three pixels, of which none is in the middle
}

TEST_F(BaseColourMapTest, CostsNothingWhereThereIsNone) {
  FrameView frame = triangle_frame();
  const Image before = renderer.draw(frame, small_picture());
  renderer.draw(Square().frame(), small_picture());
  EXPECT_EQ(renderer.draw(frame, small_picture()).pixels, before.pixels);
}

TEST_F(BaseColourMapTest, WhatDoesNotFitIsRefused) {
  const auto refuses = [&](const auto& change) {
    Square square;
    change(square);
    EXPECT_THROW(renderer.draw(square.frame(), small_picture()), std::invalid_argument);
  };
  refuses([](Square& square) { square.places.pop_back(); });
  refuses([](Square& square) { square.places.clear(); });
  refuses([](Square& square) { square.places[2].y = NAN; });
  refuses([](Square& square) { square.colours[0].map.width_px = 3; });
  refuses([](Square& square) { square.colours[0].map.height_px = 0; });
  refuses([](Square& square) { square.colour_of_triangle = {0}; });
  refuses([](Square& square) { square.colour_of_triangle = {0, 1}; });
}

}  // namespace
}  // namespace taut::renderer
