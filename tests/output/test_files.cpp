#include <gtest/gtest.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <thread>

#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "temporary_folder.hpp"

namespace taut::app {
namespace {

using test::message_of;
using test::TemporaryFolder;

thread_local std::vector<std::string> synced;  ///< which names they had then

}  // namespace
}  // namespace taut::app

/// In the place of the C library's.
extern "C" int fsync(int file) {
  taut::app::synced.push_back(std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(file)));
  return static_cast<int>(::syscall(SYS_fsync, file));
}

namespace taut::app {
namespace {

TEST(Files, AreWrittenWholeAndLeaveNothingElse) {
  const TemporaryFolder folder;
  write_text_file(folder / "a.txt", "first");
  write_text_file(folder / "a.txt", "second");
  EXPECT_EQ(read_text_file(folder / "a.txt"), "second");
  EXPECT_EQ(folder.file_count(), 1U);
}

TEST(Files, AreOnTheDiskBeforeTheyHaveTheirNamesAndThoseAfterwards) {
  const TemporaryFolder folder;
  synced.clear();
  write_text_file(folder / "a.txt", "text");
  ASSERT_EQ(synced.size(), 2U);
  EXPECT_EQ(synced[0], temporary_name(folder / "a.txt").string());
  EXPECT_EQ(synced[1] + "/", folder / "");
}

TEST(Files, LeaveNothingWhereTheyCannotBeWritten) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "taken/inner");
  EXPECT_CONTAINS(message_of<InputError>([&] { write_text_file(folder / "taken", "text"); }), "cannot write");
  EXPECT_CONTAINS(message_of<InputError>([&] { write_text_file(folder / "none/a.txt", "text"); }),
                  "No such file");
  EXPECT_EQ(folder.file_count(), 1U);
}

TEST(Files, GetTheirFolderMadeAndTried) {
  const TemporaryFolder folder;
  prepare_folder_of(folder / "a/b/c.png");
  EXPECT_TRUE(std::filesystem::is_directory(folder / "a/b"));
  EXPECT_TRUE(std::filesystem::is_empty(folder / "a/b"));
  folder.write("file", "x");
  EXPECT_CONTAINS(message_of<InputError>([&] { prepare_folder_of(folder / "file/c.png"); }),
                  "cannot make the output folder");
  EXPECT_CONTAINS(message_of<InputError>([&] { prepare_folder_of(folder / "a/b"); }),
                  "there is a folder of this name");
}

TEST(Files, GetTheirFolderTriedByManyAtOnce) {
  const TemporaryFolder folder;
  std::vector<std::string> refusals(4);
  std::vector<std::thread> threads;
  for (std::string& refusal : refusals) {
    threads.emplace_back([&] {
      for (int k = 0; k < 200 && refusal.empty(); ++k) {
        refusal = message_of<InputError>([&] { prepare_folder_of(folder / "runs/a.json"); });
      }
    });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  EXPECT_EQ(refusals, std::vector<std::string>(4));
  EXPECT_TRUE(std::filesystem::is_empty(folder / "runs"));
}

}  // namespace
}  // namespace taut::app
