#include "renderer/page/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <system_error>

namespace taut::renderer {

namespace {

[[noreturn]] void fail(const std::filesystem::path& path, int error) {
  throw std::runtime_error("cannot write '" + path.string() + "': " + std::generic_category().message(error));
}

// A file that did not exist before, so that two writers of one path never share a temporary.
struct Temporary {
  std::filesystem::path path;
  int descriptor = -1;
  bool keep = false;

  explicit Temporary(const std::filesystem::path& wanted) {
    for (int attempt = 0; attempt < 1000; ++attempt) {
      path = wanted;
      path += ".part-" + std::to_string(getpid()) + "-" + std::to_string(attempt);
      descriptor = open(path.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
      if (descriptor >= 0) return;
      if (errno != EEXIST) fail(wanted, errno);
    }
    fail(wanted, EEXIST);
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  ~Temporary() {
    if (descriptor >= 0) close(descriptor);
    if (!keep) unlink(path.c_str());
  }
};

}  // namespace

void write_file_atomically(const std::filesystem::path& path, std::span<const std::uint8_t> bytes) {
  Temporary file(path);
  while (!bytes.empty()) {
    const ssize_t written = write(file.descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(path, errno);
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  // Full disks and quotas of network folders may report themselves only here.
  const int closed = close(file.descriptor);
  file.descriptor = -1;
  if (closed != 0) fail(path, errno);
  if (std::rename(file.path.c_str(), path.c_str()) != 0) fail(path, errno);
  file.keep = true;
}

}  // namespace taut::renderer
