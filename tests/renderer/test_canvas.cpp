#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "renderer/page/canvas.hpp"

namespace taut::renderer {
namespace {

Colour pixel(const Image& image, int x, int y) {
  const std::uint8_t* p = image.at(x, y);
  return rgb((static_cast<std::uint32_t>(p[0]) << 16U) | (static_cast<std::uint32_t>(p[1]) << 8U) | p[2]);
}

int dark_pixels(const Image& image, int x0, int y0, int x1, int y1) {
  int count = 0;
  for (int y = y0; y < y1; ++y) {
    for (int x = x0; x < x1; ++x) count += image.at(x, y)[0] < 128 ? 1 : 0;
  }
  return count;
}

TEST(Canvas, KeepsAnImageAndCoversWholePixels) {
  Image image = make_image(8, 6);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = static_cast<std::uint8_t>(i * 3 % 251);
  Canvas canvas(image);
  EXPECT_EQ(canvas.to_image().pixels, image.pixels);
  canvas.fill_rectangle(2, 1, 3, 2, rgb(0x12AB34));
  const Image drawn = canvas.to_image();
  for (int y = 0; y < 6; ++y) {
    for (int x = 0; x < 8; ++x) {
      const bool inside = x >= 2 && x < 5 && y >= 1 && y < 3;
      EXPECT_EQ(pixel(drawn, x, y), inside ? rgb(0x12AB34) : pixel(image, x, y)) << x << "," << y;
    }
  }
}

TEST(Canvas, KeepsTheAlphaOfAnImage) {
  Image image = make_image(2, 1, 4);
  const std::array<std::uint8_t, 8> pixels{200, 100, 0, 255, 120, 60, 30, 100};
  image.pixels.assign(pixels.begin(), pixels.end());
  const Image kept = Canvas(image).to_image();
  ASSERT_EQ(kept.channels, 4);
  EXPECT_EQ(kept.at(0, 0)[0], 200);
  EXPECT_EQ(kept.at(1, 0)[3], 100);
  EXPECT_NEAR(kept.at(1, 0)[0], 120, 2) << "Cairo keeps what is left of it by the alpha";
}

TEST(Canvas, KnowsItsSmallestText) {
  Canvas canvas(10, 4);
  canvas.text(0, 0, "large", {.size_px = 9.0F});
  canvas.text(0, 0, "small", {.size_px = 4.0F});
  canvas.text(0, 0, "", {.size_px = 2.0F});
  EXPECT_EQ(canvas.min_text_px(), 4.0F) << "nothing is no text";
}

TEST(Canvas, PlacesImagesSideBySide) {
  Image red = make_image(4, 4);
  for (std::size_t i = 0; i < red.pixels.size(); i += 3) red.pixels[i] = 255;
  Canvas canvas(10, 4);
  canvas.image(0, 0, red);
  canvas.image(6, 0, red);
  const Image drawn = canvas.to_image();
  EXPECT_EQ(pixel(drawn, 3, 3), rgb(0xFF0000));
  EXPECT_EQ(pixel(drawn, 4, 0), rgb(0xFFFFFF));
  EXPECT_EQ(pixel(drawn, 6, 0), rgb(0xFF0000));
}

TEST(Canvas, TextIsWhereItWasMeasured) {
  Canvas canvas(200, 60);
  TextStyle style;
  style.size_px = 20;
  style.horizontal = HorizontalAlign::right;
  const TextSize size = canvas.measure("Stretch", style);
  EXPECT_GT(size.width_px, 60.0F);
  EXPECT_LT(size.width_px, 100.0F);
  canvas.text(180, 40, "Stretch", style);
  const Image drawn = canvas.to_image();
  const int left = 180 - static_cast<int>(size.width_px);
  EXPECT_GT(dark_pixels(drawn, left, 40 - 20, 181, 42), 100);
  EXPECT_EQ(dark_pixels(drawn, 0, 0, left - 1, 60), 0);
  EXPECT_EQ(dark_pixels(drawn, 182, 0, 200, 60), 0);
  EXPECT_EQ(dark_pixels(drawn, 0, 42, 200, 60), 0) << "nothing below the baseline but antialiasing";
}

TEST(Canvas, ScaledTakesAPictureOfThatManyPixelsAsItIs) {
  Canvas canvas(15, 11, 0.5F);
  Image checks = make_image(5, 4);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 5; ++x) checks.at(x, y)[0] = (x + y) % 2 == 0 ? 255 : 0;
  }
  canvas.image(2.5F, 2.5F, 10, 8, checks);
  const Image drawn = canvas.to_image();
  ASSERT_EQ(drawn.width_px, 8) << "rounded";
  ASSERT_EQ(drawn.height_px, 6);
  for (int y = 1; y < 3; ++y) {
    for (int x = 1; x < 4; ++x) {
      EXPECT_EQ(drawn.at(1 + x, 1 + y)[0], checks.at(x, y)[0]) << x << ' ' << y;
    }
  }
}

TEST(Canvas, PdfIsCompleteAndTheSameEveryTime) {
  std::string first;
  for (int i = 0; i < 2; ++i) {
    Canvas canvas = Canvas::pdf(600, 300, 300.0F, "Cloth falls");
    canvas.text(20, 40, "Figure 1");
    EXPECT_THROW(static_cast<void>(canvas.to_image()), std::logic_error);
    const std::vector<std::uint8_t> page = canvas.finish_pdf();
    const std::string bytes(page.begin(), page.end());
    EXPECT_EQ(bytes.substr(0, 5), "%PDF-");
    EXPECT_NE(bytes.find("%%EOF"), std::string::npos);
    EXPECT_NE(bytes.find("/Title (Cloth falls)"), std::string::npos);
    EXPECT_NE(bytes.find("/CreationDate (20000101"), std::string::npos) << "the time of day must stay out";
    if (i == 0) first = bytes;
    EXPECT_EQ(bytes, first);
  }
  EXPECT_THROW(Canvas(10, 10).finish_pdf(), std::logic_error);
}

TEST(Legend, BarRunsFromTheMinimumBelowToTheMaximumAbove) {
  Canvas canvas(200, 320);
  Legend legend{"stretch", 0.0F, 0.02F, ColourMap::viridis, 100.0F, " %", 0.01F, false};
  LegendPlace place;
  draw_legend(canvas, legend, place);
  const Image drawn = canvas.to_image();
  const int x = static_cast<int>(place.x_px + 0.5F * place.bar_width_px);
  const int top = static_cast<int>(place.y_px) + 1;
  const int bottom = static_cast<int>(place.y_px + place.bar_height_px) - 2;
  EXPECT_NEAR(pixel(drawn, x, top).g, rgb(0xFDE725).g, 0.02F);
  EXPECT_NEAR(pixel(drawn, x, bottom).b, rgb(0x440154).b, 0.02F);
  const int middle = static_cast<int>(place.y_px + 0.5F * place.bar_height_px);
  EXPECT_LT(pixel(drawn, x, middle).g, 0.15F) << "the bound is marked";
  EXPECT_GT(dark_pixels(drawn, x + 12, middle - 8, 190, middle + 8), 40) << "and labelled";
}

// Half a pixel off in both directions every row has two soft edges.
TEST(Legend, BarKeepsItsColoursBetweenPixels) {
  Canvas canvas(200, 320);
  Legend legend{"stretch", 0.0F, 0.02F, ColourMap::viridis, 100.0F, " %", {}, true};
  LegendPlace place;
  place.x_px = 24.5F;
  place.y_px = 48.5F;
  draw_legend(canvas, legend, place);
  const Image drawn = canvas.to_image();
  for (int y = 50; y < 287; ++y) {
    const Colour expected = colour_at(legend.map, 1.0F - (static_cast<float>(y) - 48.0F) / place.bar_height_px);
    for (const int x : {26, 32, 39}) {
      for (int k = 0; k < 3; ++k) EXPECT_NEAR(pixel(drawn, x, y)[k], expected[k], 0.02F) << x << "," << y;
    }
  }
  for (int y = 40; y < 45; ++y) EXPECT_LT(pixel(drawn, 32, y).b, 0.2F) << "the arrow, " << y;
}

}  // namespace
}  // namespace taut::renderer
