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
  std::uint64_t bytes = 0;  ///< 0: a pipe, which does not say
  bool is_pipe = false;
};

/// Opens an input. Whatever reads a file opens it by this function. Throws InputError that names the file and the
/// reason: missing, a folder, a device, a pipe where `kind` takes none, unreadable, empty, or larger than `max_bytes`.
OpenInput open_input(const std::filesystem::path& path, std::uint64_t max_bytes, InputKind kind = InputKind::file);

/// Returns the content of a file or a pipe. Throws InputError as open_input() does, also for a pipe that brings
/// nothing for `max_silence_s` or more than `max_bytes`; Interrupted while it waits for a pipe.
std::string read_text_file(const std::filesystem::path& path, std::uint64_t max_bytes = max_text_bytes);

/// Longest time in which a pipe brings nothing, in s.
inline constexpr int max_silence_s = 10;

/// Throws InputError as open_input() does.
void require_file(const std::filesystem::path& path, std::uint64_t max_bytes = max_model_bytes);

/// Makes the folder of `file`, with its parents, and tests that it can be written to. Call it before a long
/// run, so that the run does not end in an error. Throws InputError that names the folder and the system's
/// reason.
void prepare_folder_of(const std::filesystem::path& file);

/// Throws UsageError if one of the outputs is one of the inputs, whatever its name, or another output.
void require_apart(std::span<const std::filesystem::path> outputs, std::span<const std::filesystem::path> inputs);

/// `folder`/STEM-N.EXTENSION, with the smallest N from 1 that is not taken.
std::filesystem::path free_name(const std::filesystem::path& folder, const std::string& stem,
                                const std::string& extension);

/// A name in the same folder for what will be renamed to `path` when it is complete.
std::filesystem::path temporary_name(const std::filesystem::path& path);

/// Makes an empty file, which will be renamed to `path`, and returns it open for writing. A file or link that has the
/// temporary name is removed first, so that nothing is written through a link. Throws InputError that names `path` and the
/// system's reason.
Descriptor create_file(const std::filesystem::path& temporary, const std::filesystem::path& path);

/// Returns `name` for files that nobody named; the next free name, which it prints on the standard error, where one of
/// `files` is there and is not `own`.
std::filesystem::path choose_free_name(const std::filesystem::path& name, bool own,
                                       std::span<const std::filesystem::path> files);

/// Writes all bytes to a file or a pipe. Returns false if that fails, with the reason in errno.
bool write_bytes(int descriptor, std::span<const std::uint8_t> bytes);

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

/// Keeps other programs of this machine from writing a file as long as it lives, if they claim it too.
class OutputClaim {
 public:
  /// The folder of `path` must be there. Throws InputError if another program has claimed the same file.
  explicit OutputClaim(const std::filesystem::path& path);

 private:
  Descriptor socket_;  ///< bound to a name that stands for the file; the system frees it when a program ends
};

/// A file of which parts are read, by several threads at once if need be.
class SeekableFile {
 public:
  /// Throws InputError as open_input() does.
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
