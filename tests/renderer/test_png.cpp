#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "picture_reading.hpp"
#include "renderer/page/png.hpp"

namespace taut::renderer {
namespace {

Image pattern(int width_px, int height_px, int channels) {
  Image image = make_image(width_px, height_px, channels);
  std::uint32_t state = 7;
  for (std::uint8_t& byte : image.pixels) {
    state = state * 1664525U + 1013904223U;
    byte = static_cast<std::uint8_t>(state >> 24U);
  }
  return image;
}

TEST(Png, GivesThePixelsBack) {
  for (const int channels : {3, 4}) {
    const Image image = pattern(37, 11, channels);
    const Image back = tests::decode_png(encode_png(image), channels);
    EXPECT_EQ(back.width_px, 37);
    EXPECT_EQ(back.height_px, 11);
    EXPECT_EQ(back.pixels, image.pixels) << channels << " channels";
  }
}

TEST(Png, CarriesText) {
  const PngText text{"Software", "taut test"};
  const auto bytes = encode_png(pattern(2, 2, 3), {&text, 1});
  const std::string all(bytes.begin(), bytes.end());
  EXPECT_NE(all.find(std::string("tEXtSoftware\0taut test", 22)), std::string::npos);
  const PngText bad{"", "x"};
  EXPECT_THROW(encode_png(pattern(2, 2, 3), {&bad, 1}), std::invalid_argument);
}

TEST(Png, RefusesImagesThatAreNone) {
  Image image = pattern(4, 4, 3);
  image.pixels.pop_back();
  EXPECT_THROW(encode_png(image), std::invalid_argument);
  EXPECT_THROW(encode_png(Image{}), std::invalid_argument);
  EXPECT_THROW(make_image(0, 5), std::invalid_argument);
  EXPECT_THROW(make_image(5, 5, 2), std::invalid_argument);
}

TEST(Png, EveryCutAndEveryChangedLengthIsAnErrorAndNothingWorse) {
  const std::vector<PngText> texts = {{"Software", "taut"}, {"Other", "text"}};
  const std::vector<std::uint8_t> png = encode_png(pattern(4, 3, 3), texts);
  const auto read = read_png_texts(png, "a.png");
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[1].keyword, "Other");
  EXPECT_EQ(read[1].text, "text");
  for (std::size_t size = 0; size < png.size(); ++size) {
    // The bytes are a copy, so that a checked build sees every read beyond the end.
    const std::vector<std::uint8_t> cut(png.begin(), png.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_THROW(read_png_texts(cut, "a.png"), std::runtime_error) << size;
  }
  for (std::size_t at = 8; at < png.size(); ++at) {
    for (const std::uint8_t value : std::vector<std::uint8_t>{0x00, 0x7F, 0xFF}) {
      std::vector<std::uint8_t> damaged = png;
      damaged[at] = value;
      try {
        read_png_texts(damaged, "a.png");
      } catch (const std::runtime_error&) {
      }
    }
  }
}

}  // namespace
}  // namespace taut::renderer
