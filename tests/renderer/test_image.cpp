#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "renderer/page/image.hpp"

namespace taut::renderer {
namespace {

namespace fs = std::filesystem;

// An empty folder of this test's own.
fs::path fresh_folder() {
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  const fs::path folder = fs::path(TAUT_TEST_FOLDER) / (std::string("image-") + info->name());
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

std::size_t files_in(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

Image pattern(int width_px, int height_px, int channels) {
  Image image = make_image(width_px, height_px, channels);
  std::uint32_t state = 7;
  for (std::uint8_t& byte : image.pixels) {
    state = state * 1664525U + 1013904223U;
    byte = static_cast<std::uint8_t>(state >> 24U);
  }
  return image;
}

TEST(Png, EveryFilterAndLevelGivesThePixelsBack) {
  for (const int channels : {3, 4}) {
    const Image image = pattern(37, 11, channels);
    for (int filter = -1; filter <= 4; ++filter) {
      for (const int level : {0, 1, 6, 12}) {
        const Image back = decode_png(encode_png(image, {}, {level, filter}), channels);
        EXPECT_EQ(back.width_px, 37);
        EXPECT_EQ(back.height_px, 11);
        EXPECT_EQ(back.pixels, image.pixels) << "filter " << filter << " level " << level;
      }
    }
  }
}

TEST(Png, FileRoundTrip) {
  const fs::path path = fresh_folder() / "a.png";
  const Image image = pattern(64, 48, 3);
  write_png(path, image);
  EXPECT_EQ(read_png(path).pixels, image.pixels);
  write_png(path, pattern(5, 5, 3));
  EXPECT_EQ(read_png(path).width_px, 5) << "an existing file is replaced";
  EXPECT_EQ(files_in(path.parent_path()), 1U) << "nothing temporary stays";
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

std::string message_of_write(const fs::path& path) {
  try {
    write_png(path, pattern(4, 4, 3));
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(Png, MissingFolderIsNamedWithTheReason) {
  const fs::path path = fresh_folder() / "not-there" / "a.png";
  const std::string message = message_of_write(path);
  EXPECT_NE(message.find(path.string()), std::string::npos) << message;
  EXPECT_NE(message.find("No such file or directory"), std::string::npos) << message;
}

TEST(Png, UnwritableFolderIsNamedAndStaysEmpty) {
  const fs::path folder = fresh_folder();
  fs::permissions(folder, fs::perms::owner_read | fs::perms::owner_exec);
  // The superuser writes anywhere; /proc refuses even that.
  const bool superuser = geteuid() == 0;
  const fs::path path = superuser ? fs::path("/proc/taut.png") : folder / "a.png";
  const std::string message = message_of_write(path);
  fs::permissions(folder, fs::perms::owner_all);
  EXPECT_NE(message.find(path.string() + "': "), std::string::npos) << message;
  EXPECT_EQ(files_in(folder), 0U);
}

TEST(Png, FailureAfterWritingLeavesNothingBehind) {
  const fs::path folder = fresh_folder();
  fs::create_directories(folder / "a.png" / "inside");  // a folder in the way of the rename
  EXPECT_NE(message_of_write(folder / "a.png"), "");
  EXPECT_EQ(files_in(folder), 1U);
}

TEST(Png, ReadingNamesThePathAndTheReason) {
  const fs::path path = fresh_folder() / "text.png";
  std::ofstream(path) << "this is not an image";
  try {
    read_png(path);
    FAIL() << "text was taken for an image";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::strstr(error.what(), path.c_str()), nullptr) << error.what();
  }
  EXPECT_THROW(read_png(path.parent_path() / "none.png"), std::runtime_error);
}

}  // namespace
}  // namespace taut::renderer
