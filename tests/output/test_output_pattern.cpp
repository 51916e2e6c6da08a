#include <gtest/gtest.h>

#include "app/base/errors.hpp"
#include "app/output/output_pattern.hpp"
#include "temporary_folder.hpp"

namespace taut::app {
namespace {

std::string error_text(const std::string& text) {
  return test::error_message<UsageError>([&] { OutputPattern(text, ".png"); });
}

TEST(OutputPattern, NumbersFrames) {
  EXPECT_EQ(OutputPattern("frames/f_{frame:04}.png", ".png").path_of(7), "frames/f_0007.png");
  EXPECT_EQ(OutputPattern("{frame}.png", ".png").path_of(12345), "12345.png");
  EXPECT_EQ(OutputPattern("{frame:03d}.png", ".png").path_of(12), "012.png");
  EXPECT_EQ(OutputPattern("a.png", ".png").path_of(3), "a.png");
}

TEST(OutputPattern, RefusesOtherFields) {
  for (const char* text : {"{number}.png", "{}.png", "{frame:4}.png", "{frame:0}.png", "{frame:0x}.png",
                           "{frame.png", "frame}.png", "{frame}{frame}.png", "{{frame}}.png", "}{.png"}) {
    EXPECT_CONTAINS(error_text(text), "expected one field {frame}");
  }
}

TEST(OutputPattern, RefusesOtherKindsOfFiles) {
  for (const char* text : {"a.mp4", "frames/", "", ".png", "png"}) {
    EXPECT_CONTAINS(error_text(text), "ends in .png");
  }
}

TEST(OutputPattern, WantsAFieldForSeveralFrames) {
  const OutputPattern single("a.png", ".png");
  EXPECT_NO_THROW(single.require_distinct_names(1));
  EXPECT_THROW(single.require_distinct_names(2), UsageError);
  EXPECT_NO_THROW(OutputPattern("{frame}.png", ".png").require_distinct_names(2));
}

}  // namespace
}  // namespace taut::app
