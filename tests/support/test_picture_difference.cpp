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

TEST(PictureDifference, OnePixelInTenThousandMayDifferButNotTwo) {
  renderer::Image actual = grey();
  actual.at(30, 40)[1] = 131;
  EXPECT_TRUE(alike(grey(), actual));
  actual.at(31, 40)[2] = 125;
  EXPECT_FALSE(alike(grey(), actual));
}

TEST(PictureDifference, DifferencesOfTwoDoNotCountAsPixelsButInTheMean) {
  renderer::Image actual = grey();
  for (int x = 0; x < 25; ++x) {
    actual.at(x, 7)[0] = 130;
  }
  EXPECT_TRUE(alike(grey(), actual));  // mean 50 / 30000
  for (int x = 0; x < 25; ++x) {
    actual.at(x, 8)[0] = 130;
  }
  EXPECT_FALSE(alike(grey(), actual));  // mean 100 / 30000
}

TEST(PictureDifference, OtherSizesFail) {
  EXPECT_FALSE(alike(grey(100, 100), grey(100, 99)));
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
}

}  // namespace
}  // namespace taut::tests
