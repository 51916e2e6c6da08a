#include <gtest/gtest.h>

#include "support/picture_difference.hpp"

namespace taut::tests {
namespace {

renderer::Image grey(int width_px = 100, int height_px = 100) {
  renderer::Image image = renderer::make_image(width_px, height_px);
  std::fill(image.pixels.begin(), image.pixels.end(), std::uint8_t{128});
  return image;
}

bool alike(const renderer::Image& a, const renderer::Image& b) {
  const PictureLimit limit;
  return passes(compare(a, b, limit), limit);
}

TEST(PictureDifference, EqualPicturesPass) {
  EXPECT_TRUE(alike(grey(), grey()));
}

TEST(PictureDifference, ProposesTwiceTheNoiseAndAtLeastTheDefaults) {
  renderer::Image noisy = grey();
  EXPECT_EQ(propose_limit(grey(), {noisy}).differing_fraction, PictureLimit().differing_fraction);
  for (int x = 0; x < 100; ++x) std::fill_n(noisy.at(x, 7), 3, std::uint8_t{138});
  const PictureLimit limit = propose_limit(grey(), {grey(), noisy});
  EXPECT_DOUBLE_EQ(limit.differing_fraction, 0.02);
  EXPECT_DOUBLE_EQ(limit.mean_difference, 0.2);
  EXPECT_THROW(propose_limit(grey(), {grey(50, 50)}), std::invalid_argument);
}

TEST(PictureDifference, OnePixelInTenThousandMayDifferButNotTwo) {
  renderer::Image actual = grey();
  actual.at(30, 40)[1] = 131;
  EXPECT_TRUE(alike(grey(), actual));
  actual.at(31, 40)[2] = 125;
  EXPECT_FALSE(alike(grey(), actual));
}

TEST(PictureDifference, DifferencesOfTwoDoNotCountAsPixelsButInTheMean) {
  renderer::Image actual = grey();
  for (int x = 0; x < 100; ++x) {
    for (int y = 0; y < 4; ++y) {
      actual.at(x, y)[0] = 130;
    }
  }
  EXPECT_TRUE(alike(grey(), actual));  // mean 800 / 30000
  for (int x = 0; x < 100; ++x) {
    actual.at(x, 8)[0] = 130;
  }
  EXPECT_FALSE(alike(grey(), actual));  // mean 1000 / 30000
}

TEST(PictureDifference, OtherSizesFail) {
  EXPECT_FALSE(alike(grey(100, 100), grey(100, 99)));
}

TEST(PictureDifference, ANegativeDifferenceCountsAsAPositiveOne) {
  renderer::Image actual = grey();
  for (int x = 0; x < 2; ++x) {
    actual.at(x, 0)[x] = 125;
  }
  EXPECT_FALSE(alike(grey(), actual));
}

TEST(PictureDifference, EachLimitAloneFails) {
  renderer::Image one_pixel = grey();
  one_pixel.at(5, 5)[0] = 131;
  EXPECT_FALSE(passes(compare(grey(), one_pixel, {.differing_fraction = 0.0}), {.differing_fraction = 0.0}));
  const PictureLimit none = {.channel_difference = 0, .differing_fraction = 0.0, .mean_difference = 0.0};
  EXPECT_TRUE(passes(compare(grey(), grey(), none), none));
  renderer::Image by_one = grey();
  by_one.pixels.back() = 129;
  EXPECT_TRUE(alike(grey(), by_one));
  EXPECT_FALSE(passes(compare(grey(), by_one, none), none));
  EXPECT_FALSE(passes(compare(by_one, grey(), none), none));
}

TEST(PictureDifference, APictureShiftedByOnePixelFails) {
  renderer::Image expected = grey();
  renderer::Image actual = grey();
  for (int y = 0; y < 100; ++y) {
    expected.at(50, y)[0] = 140;
    actual.at(51, y)[0] = 140;
  }
  EXPECT_FALSE(alike(expected, actual));
}

TEST(PictureDifference, ABlackPictureFails) {
  EXPECT_FALSE(alike(grey(), renderer::make_image(100, 100)));
}

TEST(PictureDifference, NamesTheTenWorstPixels) {
  renderer::Image actual = grey();
  for (int x = 0; x < 20; ++x) {
    actual.at(x, 3)[0] = static_cast<std::uint8_t>(128 + x);
  }
  const PictureDifference difference = compare(grey(), actual, {});
  ASSERT_EQ(difference.worst.size(), 10u);
  EXPECT_EQ(difference.worst[0].x_px, 19);
  EXPECT_EQ(difference.worst[0].y_px, 3);
  EXPECT_EQ(difference.worst[0].difference, 19);
  EXPECT_EQ(difference.worst[9].difference, 10);
  EXPECT_NE(describe(difference, {}).find("x 19  y 3  difference 19"), std::string::npos);
}

TEST(PictureDifference, SheetShowsExpectedActualAndAmplifiedDifference) {
  renderer::Image actual = grey(4, 2);
  actual.at(1, 1)[0] = 133;
  const renderer::Image sheet = side_by_side(grey(4, 2), actual);
  EXPECT_EQ(sheet.width_px, 12);
  EXPECT_EQ(sheet.at(1, 1)[0], 128);
  EXPECT_EQ(sheet.at(5, 1)[0], 133);
  EXPECT_EQ(sheet.at(9, 1)[0], 80);
  EXPECT_EQ(sheet.at(9, 0)[0], 0);
  EXPECT_EQ(sheet.at(3, 1)[0], 128);
  EXPECT_EQ(sheet.at(4, 0)[2], 128);
  EXPECT_EQ(amplified_difference(grey(4, 2), actual).at(1, 1)[0], 80);
  EXPECT_EQ(amplified_difference(grey(4, 2), renderer::make_image(4, 2)).at(0, 0)[0], 255);
}

}  // namespace
}  // namespace taut::tests
