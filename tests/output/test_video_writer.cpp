#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>

#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/output/video_writer.hpp"
#include "temporary_folder.hpp"

namespace taut::app {
namespace {

using test::error_message;
using test::TemporaryFolder;

constexpr VideoSettings small = {.width_px = 32, .height_px = 16, .frame_rate_hz = 25.0};

// Installs a script as ffmpeg. In it, "$out" is the file to write. An empty script means that there is no ffmpeg.
void use_ffmpeg(const TemporaryFolder& folder, const std::string& script) {
  const auto bin = folder / "bin";
  std::filesystem::create_directories(bin);
  if (!script.empty()) {
    std::ofstream(bin / "ffmpeg") << "#!/bin/sh\nPATH=/usr/bin:/bin\nfor out; do :; done\nout=${out#file:}\n"
                                  << script << '\n';
    std::filesystem::permissions(bin / "ffmpeg", std::filesystem::perms::owner_all);
  }
  ::setenv("PATH", bin.c_str(), 1);
}

renderer::Image grey(int width_px, int height_px, std::uint8_t value) {
  renderer::Image image = renderer::make_image(width_px, height_px);
  std::fill(image.pixels.begin(), image.pixels.end(), value);
  return image;
}

void write_video(const std::filesystem::path& file, int frames) {
  VideoWriter video(file, small);
  for (int frame = 0; frame < frames; ++frame) {
    video.add(grey(32, 16, static_cast<std::uint8_t>(frame)));
  }
  video.finish();
}

TEST(VideoWriter, HandsRawRgbToFfmpegAndNamesTheFileAtTheEnd) {
  const TemporaryFolder folder;
  use_ffmpeg(folder, "cat > \"$out\"");
  write_video(folder / "film.mp4", 3);
  const std::string bytes = read_text_file(folder / "film.mp4");
  ASSERT_EQ(bytes.size(), 3U * 32U * 16U * 3U);
  EXPECT_EQ(bytes.back(), 2);
  EXPECT_EQ(folder.file_count(), 2U);  // the film and the folder bin
}

TEST(VideoWriter, SaysThatThereIsNoFfmpeg) {
  const TemporaryFolder folder;
  use_ffmpeg(folder, "");
  const std::string message = error_message<InputError>([&] { write_video(folder / "film.mp4", 1); });
  EXPECT_CONTAINS(message, "the program ffmpeg does not start (No such file or directory); install it");
  EXPECT_EQ(folder.file_count(), 1U);
}

TEST(VideoWriter, AnFfmpegThatDiesInTheMiddleIsReportedInItsOwnWords) {
  const TemporaryFolder folder;
  use_ffmpeg(folder, "echo half > \"$out\"; head -c 5000 > /dev/null; echo 'the disk is full' >&2; exit 3");
  const std::string message = error_message<InputError>([&] { write_video(folder / "film.mp4", 10000); });
  EXPECT_CONTAINS(message, "ffmpeg stopped with exit code 3 after ");
  EXPECT_CONTAINS(message, "frames: the disk is full");
  EXPECT_EQ(folder.file_count(), 1U) << "something half-written is left";
}

TEST(VideoWriter, AKilledFfmpegIsReported) {
  const TemporaryFolder folder;
  use_ffmpeg(folder, "echo half > \"$out\"; kill -9 $$");
  EXPECT_CONTAINS(error_message<InputError>([&] { write_video(folder / "film.mp4", 10000); }), "signal 9");
  EXPECT_EQ(folder.file_count(), 1U);
}

TEST(VideoWriter, AnFfmpegThatFailsAtTheEndIsReported) {
  const TemporaryFolder folder;
  use_ffmpeg(folder, "echo half > \"$out\"; cat > /dev/null; echo 'no such encoder' >&2; exit 1");
  const std::string message = error_message<InputError>([&] { write_video(folder / "film.mp4", 3); });
  EXPECT_CONTAINS(message, "ffmpeg failed with exit code 1 after 3 frames: no such encoder");
  EXPECT_EQ(folder.file_count(), 1U);
}

TEST(VideoWriter, AnFfmpegThatWritesNothingIsReported) {
  const TemporaryFolder folder;
  use_ffmpeg(folder, "cat > /dev/null");
  EXPECT_CONTAINS(error_message<InputError>([&] { write_video(folder / "film.mp4", 3); }),
                  "ffmpeg failed with exit code 0 after 3 frames");
  EXPECT_EQ(folder.file_count(), 1U);
}

TEST(VideoWriter, LeavesNothingWhenAbandoned) {
  const TemporaryFolder folder;
  use_ffmpeg(folder, "echo half > \"$out\"; cat >> \"$out\"; sleep 60");
  {
    VideoWriter video(folder / "film.mp4", small);
    video.add(grey(32, 16, 0));
  }
  EXPECT_EQ(folder.file_count(), 1U);
}

TEST(VideoWriterDeathTest, CanBeInterruptedWhileFfmpegHangs) {
  const TemporaryFolder folder;
  use_ffmpeg(folder, "exec sleep 60");
  const auto interrupted = [&] {
    watch_for_interruption();
    std::raise(SIGTERM);
    const bool stopped = !error_message<Interrupted>([&] { write_video(folder / "film.mp4", 10000); }).empty();
    std::exit(stopped ? 42 : 1);
  };
  EXPECT_EXIT(interrupted(), testing::ExitedWithCode(42), "");
  EXPECT_EQ(folder.file_count(), 1U);
}

TEST(VideoWriterDeathTest, ALiveVideoIsCompletedAfterAnInterruption) {
  const TemporaryFolder folder;
  use_ffmpeg(folder, "sleep 0.3; cat > \"$out\"");
  constexpr int frames = 1000;  // more frames than can wait between the two programs
  const auto interrupted = [&] {
    watch_for_interruption();
    std::raise(SIGTERM);
    VideoSettings live = small;
    live.is_live = true;
    VideoWriter video(folder / "film.mp4", live);
    for (int frame = 0; frame < frames; ++frame) {
      video.add(grey(32, 16, 7));
    }
    video.finish();
    std::exit(42);
  };
  EXPECT_EXIT(interrupted(), testing::ExitedWithCode(42), "");
  EXPECT_EQ(std::filesystem::file_size(folder / "film.mp4"), 32U * 16U * 3U * frames);
}

TEST(VideoWriter, AnOddSizeIsRefused) {
  const VideoSettings odd = {.width_px = 641, .height_px = 480};
  EXPECT_CONTAINS(error_message<UsageError>([&] { require_video_size("film.mp4", odd); }),
                  "needs an even width and height, found 641 x 480");
}

// The ffmpeg of this machine, if there is one.
TEST(RealFfmpeg, MakesTheSameFilmEveryTime) {
  if (std::system("ffmpeg -version > /dev/null 2>&1") != 0) {
    GTEST_SKIP() << "there is no ffmpeg";
  }
  const TemporaryFolder folder;
  for (const auto& [ending, word] :
       {std::pair(".mp4", "ftypisom"), std::pair(".gif", "GIF89a"), std::pair(".webp", "WEBPVP8X")}) {
    const std::filesystem::path first = folder / (std::string("first") + ending);
    const std::filesystem::path second = folder / (std::string("second") + ending);
    write_video(first, 30);
    write_video(second, 30);
    const std::string bytes = read_text_file(first);
    EXPECT_GT(bytes.size(), 400U) << ending;
    EXPECT_LT(bytes.substr(0, 20).find(word), 20U) << ending;
    EXPECT_EQ(bytes, read_text_file(second)) << ending;
  }
}

}  // namespace
}  // namespace taut::app
