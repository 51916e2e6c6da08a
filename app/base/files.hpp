#pragma once

#include <filesystem>

#include "app/base/child_process.hpp"

namespace taut::app {

/// The name of this machine.
std::string host_name();

/// Returns the content of a file. Throws InputError that names the file and the reason: missing, a folder,
/// unreadable or empty.
std::string read_text_file(const std::filesystem::path& path);

/// Throws InputError unless `path` is a file that is not empty.
void require_file(const std::filesystem::path& path);

/// Makes the folder of `file`, with its parents, and tests that it can be written to. Call it before a long
/// run, so that the run does not end in an error. Throws InputError that names the folder and the system's
/// reason.
void prepare_folder_of(const std::filesystem::path& file);

/// `folder`/STEM-N.EXTENSION, with the smallest N from 1 that is not taken.
std::filesystem::path free_name(const std::filesystem::path& folder, const std::string& stem,
                                const std::string& extension);

/// A name in the same folder for what will be renamed to `path` when it is complete.
std::filesystem::path temporary_name(const std::filesystem::path& path);

/// Renames a complete file of the same folder to `path`. Not before its bytes are on the disk, and returns
/// when its name is: after a loss of power too, `path` is as it was before or complete. Throws InputError
/// that names `path` and the system's reason; `complete` is left.
void put_in_place(const std::filesystem::path& complete, const std::filesystem::path& path);

/// Throws InputError that names the path and the reason.
[[noreturn]] void fail_to_write(const std::filesystem::path& path, const std::string& reason);

/// Writes to a temporary name in the same folder, then puts it in place. So `path` is never half written: it
/// is absent, as it was before, or complete. Throws InputError that names the path and the system's reason;
/// the temporary file is removed.
void write_text_file(const std::filesystem::path& path, const std::string& text);
/// As write_text_file, for bytes.
void write_file(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);

/// The file that this code is in: the program, or libtaut in a program of someone else. Empty if the system
/// does not say.
std::filesystem::path own_file();

/// The two folders above that of a file, the nearer first: what is installed has its bin, its lib or its
/// lib/ARCH in one of them. None of an empty path.
std::vector<std::filesystem::path> folders_above(const std::filesystem::path& file);

/// A file of which parts are read, by several threads at once if need be.
class SeekableFile {
 public:
  /// Throws InputError that names the file and the reason: missing, a folder, unreadable or empty.
  explicit SeekableFile(std::filesystem::path path);

  const std::filesystem::path& path() const { return path_; }
  /// Returns how many bytes it had when it was opened.
  std::uint64_t size() const { return size_; }
  /// Fills `bytes` with what begins at `offset`. Throws InputError if the file does not have as much.
  void read(std::uint64_t offset, std::span<char> bytes) const;

 private:
  std::filesystem::path path_;
  Descriptor file_;
  std::uint64_t size_ = 0;
};

}  // namespace taut::app
