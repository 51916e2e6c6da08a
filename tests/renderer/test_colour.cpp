#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "renderer/page/colour.hpp"

namespace taut::renderer {
namespace {

TEST(Srgb, MatchesKnownValues) {
  // IEC 61966-2-1: 18 % grey and one value on the straight part near black.
  EXPECT_NEAR(linear_to_srgb(0.18F), 0.46136F, 1e-4F);
  EXPECT_NEAR(linear_to_srgb(0.001F), 0.01292F, 1e-6F);
  EXPECT_NEAR(srgb_to_linear(0.5F), 0.21404F, 1e-4F);
  EXPECT_EQ(linear_to_srgb(2.0F), linear_to_srgb(1.0F));
}

TEST(Srgb, BothWaysGiveTheByteBack) {
  for (int byte = 0; byte < 256; ++byte) {
    const float encoded = static_cast<float>(byte) / 255.0F;
    EXPECT_EQ(std::lround(linear_to_srgb(srgb_to_linear(encoded)) * 255.0F), byte);
  }
}

float lightness(const Colour& colour) {
  return 0.2126F * srgb_to_linear(colour.r) + 0.7152F * srgb_to_linear(colour.g) +
         0.0722F * srgb_to_linear(colour.b);
}

TEST(Reverse, IsPalerAndGreyer) {
  const auto range = [](const Colour& colour) {
    return std::max({colour.r, colour.g, colour.b}) - std::min({colour.r, colour.g, colour.b});
  };
  for (const Colour& outside : {rgb(0x3F6FA8), rgb(0xA63D40), rgb(0x4F7F5B), rgb(0x101010)}) {
    EXPECT_GT(lightness(reverse_colour(outside)), 1.2F * lightness(outside));
    EXPECT_LE(range(reverse_colour(outside)), 0.6F * range(outside) + 1e-6F);
  }
  EXPECT_EQ(reverse_colour(rgb(0xFFFFFF)), rgb(0xFFFFFF));
}

TEST(ColourMap, SequentialMapGetsLighterAllTheWay) {
  for (int i = 1; i <= 100; ++i) {
    const auto t = static_cast<float>(i);
    EXPECT_GT(lightness(colour_at(ColourMap::viridis, t / 100.0F)),
              lightness(colour_at(ColourMap::viridis, (t - 1.0F) / 100.0F)))
        << i;
  }
}

TEST(ColourMap, DivergingMapIsLightestInTheMiddle) {
  for (int i = 1; i <= 50; ++i) {
    const float near = static_cast<float>(i - 1) / 100.0F;
    const float far = static_cast<float>(i) / 100.0F;
    EXPECT_LT(lightness(colour_at(ColourMap::blue_orange, 0.5F + far)),
              lightness(colour_at(ColourMap::blue_orange, 0.5F + near)));
    EXPECT_LT(lightness(colour_at(ColourMap::blue_orange, 0.5F - far)),
              lightness(colour_at(ColourMap::blue_orange, 0.5F - near)));
  }
}

TEST(ColourMap, OutsideIsClampedAndNotANumberIsGrey) {
  EXPECT_EQ(colour_at(ColourMap::viridis, -3.0F), rgb(0x440154));
  EXPECT_EQ(colour_at(ColourMap::viridis, 7.0F), rgb(0xFDE725));
  EXPECT_EQ(colour_at(ColourMap::viridis, NAN), Colour{0.5F});
}

}  // namespace
}  // namespace taut::renderer
