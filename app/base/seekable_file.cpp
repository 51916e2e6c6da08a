#include "app/base/seekable_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include "app/base/errors.hpp"
#include "app/base/files.hpp"

namespace taut::app {

SeekableFile::SeekableFile(std::filesystem::path path) : path_(std::move(path)) {
  require_file(path_);
  file_ = Descriptor(::open(path_.c_str(), O_RDONLY | O_CLOEXEC));
  if (file_.number() < 0) {
    throw InputError("cannot read '" + path_.string() + "': " + std::generic_category().message(errno));
  }
  size_ = std::filesystem::file_size(path_);
}

void SeekableFile::read(std::uint64_t offset, std::span<char> bytes) const {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t count =
        ::pread(file_.number(), bytes.data() + done, bytes.size() - done, static_cast<off_t>(offset + done));
    if (count == 0 || (count < 0 && errno != EINTR)) {
      throw InputError("'{}': found {} bytes from byte {} on, expected {}{}", path_.string(), done, offset,
                       bytes.size(), count == 0 ? "; it was changed while it was read" : "");
    }
    done += count > 0 ? static_cast<std::size_t>(count) : 0;
  }
}

}  // namespace taut::app
