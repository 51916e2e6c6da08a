#pragma once

#include <filesystem>

#include "app/base/child_process.hpp"

namespace taut::app {

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
