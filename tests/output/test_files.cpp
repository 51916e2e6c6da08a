#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <thread>

#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/base/words.hpp"
#include "temporary_folder.hpp"

namespace taut::app {
namespace {

using test::error_message;
using test::TemporaryFolder;

thread_local std::vector<std::string> synced;  ///< names of files and folders at the time of their fsync

}  // namespace
}  // namespace taut::app

/// Replaces the function of the C library and records the name.
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
  EXPECT_CONTAINS(error_message<InputError>([&] { write_text_file(folder / "taken", "text"); }), "cannot write");
  EXPECT_CONTAINS(error_message<InputError>([&] { write_text_file(folder / "none/a.txt", "text"); }), "No such file");
  EXPECT_EQ(folder.file_count(), 1U);
}

TEST(Files, GetTheirFolderMadeAndTried) {
  const TemporaryFolder folder;
  prepare_parent_folder(folder / "a/b/c.png");
  EXPECT_TRUE(std::filesystem::is_directory(folder / "a/b"));
  EXPECT_TRUE(std::filesystem::is_empty(folder / "a/b"));
  folder.write("file", "x");
  EXPECT_CONTAINS(error_message<InputError>([&] { prepare_parent_folder(folder / "file/c.png"); }),
                  "cannot make the output folder");
  EXPECT_CONTAINS(error_message<InputError>([&] { prepare_parent_folder(folder / "a/b"); }),
                  "there is a folder of this name");
}

TEST(Files, GetTheirFolderTriedByManyAtOnce) {
  const TemporaryFolder folder;
  std::vector<std::string> refusals(4);
  std::vector<std::thread> threads;
  for (std::string& refusal : refusals) {
    threads.emplace_back([&] {
      for (int k = 0; k < 200 && refusal.empty(); ++k) {
        refusal = error_message<InputError>([&] { prepare_parent_folder(folder / "runs/a.json"); });
      }
    });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  EXPECT_EQ(refusals, std::vector<std::string>(4));
  EXPECT_TRUE(std::filesystem::is_empty(folder / "runs"));
}

TEST(Files, AreOpenedWhereTheyAreFilesOfAFittingSize) {
  const TemporaryFolder folder;
  const auto refusal = [](const std::filesystem::path& path, std::uint64_t max_bytes = max_text_bytes) {
    return error_message<InputError>([&] { read_text_file(path, max_bytes); });
  };
  const auto text = folder.write("a.txt", "12345678");
  EXPECT_EQ(read_text_file(text, 8), "12345678");
  EXPECT_CONTAINS(refusal(text, 7), "a.txt' has 8 bytes, expected at most 7");
  EXPECT_CONTAINS(refusal(folder.write("empty", "")), "empty' is empty");
  EXPECT_CONTAINS(refusal(folder / "none"), "there is no file '");
  EXPECT_CONTAINS(refusal(text / "below"), "there is no file '");
  EXPECT_CONTAINS(refusal(folder / ""), "is a folder, not a file");
  EXPECT_CONTAINS(refusal("/dev/zero"), "'/dev/zero' is a device or a socket, expected a file");
  EXPECT_CONTAINS(refusal("/dev/null"), "expected a file");
  std::ofstream(folder / "sparse").close();
  std::filesystem::resize_file(folder / "sparse", std::uintmax_t{1} << 32U);
  EXPECT_CONTAINS(refusal(folder / "sparse"), "sparse' has 4294967296 bytes, expected at most 67108864");
}

TEST(Files, ArePipesWhereThatIsEnough) {
  const TemporaryFolder folder;
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_CONTAINS(error_message<InputError>([&] { require_file(folder / "pipe"); }), "is a pipe, expected a file");
  const auto read_from_a_writer = [&](const std::string& text, std::uint64_t max_bytes) {
    std::thread writer([&] { std::ofstream(folder / "pipe") << text; });
    std::string read;
    const std::string refusal = error_message<InputError>([&] { read = read_text_file(folder / "pipe", max_bytes); });
    writer.join();
    return refusal.empty() ? read : refusal;
  };
  const std::string long_text(300'000, 'x');
  EXPECT_EQ(read_from_a_writer(long_text, max_text_bytes), long_text);
  EXPECT_CONTAINS(read_from_a_writer("123456789", 8), "the pipe brought more than 8 bytes");
  EXPECT_CONTAINS(read_from_a_writer("", 8), "pipe' is empty");
}

TEST(Files, AreNotWrittenThroughLinksThatSomebodyLaid) {
  const TemporaryFolder folder;
  const auto precious = folder.write("precious", "text");
  std::filesystem::create_symlink(precious, temporary_name(folder / "a.txt"));
  write_text_file(folder / "a.txt", "other");
  EXPECT_EQ(read_text_file(precious), "text");
  EXPECT_EQ(read_text_file(folder / "a.txt"), "other");
  EXPECT_EQ(folder.file_count(), 2U);
}

TEST(Files, ThatAreReadAreNotWritten) {
  const TemporaryFolder folder;
  const auto input = folder.write("dress.png", "x");
  std::filesystem::create_directory(folder / "inner");
  std::filesystem::create_hard_link(input, folder / "inner/hard.png");
  std::filesystem::create_symlink("../dress.png", folder / "inner/soft.png");
  const std::vector<std::filesystem::path> inputs = {folder / "none", input};
  const auto refusal = [&](const std::vector<std::filesystem::path>& outputs) {
    return error_message<UsageError>([&] { require_distinct_files(outputs, inputs); });
  };
  EXPECT_EQ(refusal({folder / "other.png", folder / "none.png", "/dev/null", "/dev/null"}), "");
  for (const char* name : {"dress.png", "inner/../dress.png", "inner/hard.png", "inner/soft.png"}) {
    EXPECT_CONTAINS(refusal({folder / "other.png", folder / name}), "it would replace '" + input.string() + '\'');
  }
  EXPECT_CONTAINS(refusal({folder / "a.png", folder / "inner/../a.png"}), "two outputs have this name");
}

TEST(Files, AreClaimedByOneProgramAtATime) {
  const TemporaryFolder folder;
  const auto refusal = [](const std::filesystem::path& path) {
    return error_message<InputError>([&] { const OutputClaim again(path); });
  };
  std::filesystem::create_directory_symlink(folder / "", folder / "link");
  {
    const OutputClaim claim(folder / "a.csv");
    EXPECT_CONTAINS(refusal(folder / "a.csv"), "a.csv': another program is writing it");
    EXPECT_CONTAINS(refusal(folder / "link/a.csv"), "another program is writing it");
    EXPECT_EQ(refusal(folder / "b.csv"), "");
  }
  EXPECT_EQ(refusal(folder / "a.csv"), "");
}

TEST(Printable, EscapesWhatATerminalWouldObey) {
  EXPECT_EQ(printable("Gr\u00f6\u00dfe \\ \n'quoted'"), "Gr\u00f6\u00dfe \\ \n'quoted'");
  EXPECT_EQ(printable("\x1b[31mred\x07\r\x7f"), "\\x1b[31mred\\x07\\x0d\\x7f");
  EXPECT_EQ(printable("\u009b2J"), "\xc2\\x9b" "2J");
  EXPECT_EQ(printable(std::string_view("\0", 1)), "\\x00");
  const std::string cut = printable("begin" + std::string(500'000, 'x') + "end");
  EXPECT_LE(cut.size(), max_printed_bytes);
  EXPECT_TRUE(cut.starts_with("begin") && cut.ends_with("end")) << cut;
  EXPECT_CONTAINS(cut, "bytes more");
}

}  // namespace
}  // namespace taut::app
