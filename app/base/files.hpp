#pragma once

#include <filesystem>

#include "app/base/child_process.hpp"

namespace taut::app {

/// The name of this machine.
std::string host_name();

/// Limits on the bytes of one input.
inline constexpr std::uint64_t max_text_bytes = std::uint64_t{1} << 26U;   ///< scenes, patterns, sessions, motions
inline constexpr std::uint64_t max_model_bytes = std::uint64_t{1} << 29U;  ///< models and images
inline constexpr std::uint64_t max_run_bytes = std::uint64_t{1} << 30U;    ///< checkpoints and statistics of a run

enum class InputKind { file, file_or_pipe };

/// A file that is open for reading.
struct OpenInput {
  Descriptor file;
  std::uint64_t bytes = 0;  ///< 0 for a pipe, whose size is unknown
  bool is_pipe = false;
};

/// Opens an input; every reader of files opens them by this function. Throws InputError that names the file and the
/// reason: missing, a folder, a device, a pipe although `kind` excludes pipes, unreadable, empty, or larger than
/// `max_bytes`.
OpenInput open_input(const std::filesystem::path& path, std::uint64_t max_bytes, InputKind kind = InputKind::file);

/// Returns the content of a file or a pipe. Throws InputError as open_input() does, and for a pipe that sends nothing
/// for `max_silence_s` or more than `max_bytes`. Throws Interrupted while it waits for a pipe.
std::string read_text_file(const std::filesystem::path& path, std::uint64_t max_bytes = max_text_bytes);

/// Longest time in seconds for which a pipe may send nothing.
inline constexpr int max_silence_s = 10;

/// Throws InputError as open_input() does.
void require_file(const std::filesystem::path& path, std::uint64_t max_bytes = max_model_bytes);

/// Returns the files of a folder with this ending, such as ".toml", sorted by name; none if there is no such folder.
std::vector<std::filesystem::path> list_files(const std::filesystem::path& folder, const std::string& ending);

/// Makes the folder of `file`, with its parents, and tests that it can be written to. Call it before a long run, which
/// would otherwise fail at its end. Throws InputError that names the folder and the system's reason.
void prepare_parent_folder(const std::filesystem::path& file);

/// Throws UsageError if an output is the same file as an input or another output, even under another name.
void require_distinct_files(std::span<const std::filesystem::path> outputs,
                            std::span<const std::filesystem::path> inputs);

/// Returns `folder`/STEM-N.EXTENSION, with the smallest N from 1 that is not taken.
std::filesystem::path free_name(const std::filesystem::path& folder, const std::string& stem,
                                const std::string& extension);

/// Returns a name in the same folder for a file that is renamed to `path` when it is complete.
std::filesystem::path temporary_name(const std::filesystem::path& path);

/// Makes an empty file, to be renamed to `path` later, and returns it open for writing. Removes a file or link of the
/// temporary name first, so that nothing is written through a link. Throws InputError that names `path` and the
/// system's reason.
Descriptor create_file(const std::filesystem::path& temporary, const std::filesystem::path& path);

/// Returns `stem`, a default that the user did not choose, for files with these endings, such as ".png". If one of them
/// exists and is not this program's (`own`), returns instead the first of STEM-1, STEM-2, ... of which none exists, and
/// prints a warning with it.
std::filesystem::path choose_free_stem(const std::filesystem::path& stem, bool own,
                                       const std::vector<std::string>& endings);

/// Writes all bytes to a file or a pipe. Returns false if that fails, with the reason in errno.
bool write_bytes(int descriptor, std::span<const std::uint8_t> bytes);

/// Renames a complete file to `path` in the same folder, once its bytes are on the disk, and returns when its name is
/// too. Even after a loss of power `path` is unchanged or complete. Throws InputError that names `path` and the
/// system's reason; the file `complete` stays.
void rename_complete(const std::filesystem::path& complete, const std::filesystem::path& path);

/// Throws InputError that names the path and the reason.
[[noreturn]] void fail_to_write(const std::filesystem::path& path, const std::string& reason);

/// Writes a file under a temporary name in the same folder, then renames it. So `path` is always absent, unchanged or
/// complete. Throws InputError that names the path and the system's reason; the temporary file is removed.
void write_text_file(const std::filesystem::path& path, const std::string& text);
/// Writes bytes as write_text_file writes text.
void write_file(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);

/// Returns the file that holds this code: the program, or libtaut in another program. Empty if the system does not
/// know.
std::filesystem::path own_file();

/// Returns the two folders above the folder of a file, the nearer first. One of them is the prefix of an installation
/// in bin, lib or lib/ARCH. Returns none for an empty path.
std::vector<std::filesystem::path> folders_above(const std::filesystem::path& file);

/// Keeps other programs on this machine from claiming the same output file, as long as this object lives.
class OutputClaim {
 public:
  /// Claims `path`, whose folder must exist. Throws InputError if another program has claimed the same file.
  explicit OutputClaim(const std::filesystem::path& path);

 private:
  Descriptor socket_;  ///< bound to a name derived from the file; the system frees it when a program ends
};

/// A file that can be read in any order, by several threads at once.
class SeekableFile {
 public:
  /// Throws InputError as open_input() does.
  explicit SeekableFile(std::filesystem::path path);

  const std::filesystem::path& path() const { return path_; }
  /// Size in bytes when the file was opened.
  std::uint64_t size() const { return size_; }
  /// Fills `bytes` from the file, starting at `offset`. Throws InputError if the file ends before.
  void read(std::uint64_t offset, std::span<char> bytes) const;

 private:
  std::filesystem::path path_;
  Descriptor file_;
  std::uint64_t size_ = 0;
};

}  // namespace taut::app
