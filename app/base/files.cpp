#include "app/base/files.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <fstream>

#include "app/base/errors.hpp"

namespace taut::app {
namespace {

namespace fs = std::filesystem;

std::string reason_of(int error_number) { return std::generic_category().message(error_number); }

fs::path folder_of(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

/// Such as /dev/stdout and named pipes: a rename would put a file in their place. Where the standard output
/// is a regular file, it still is one to be written on and not to be replaced.
bool is_written_straight(const fs::path& path) {
  std::error_code error;
  const fs::path link = fs::read_symlink(path, error);
  if (link.string().starts_with("/proc/") || path.string().starts_with("/proc/")) return true;
  const fs::file_status status = fs::status(path, error);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

/// Returns the reason where it fails, and nothing where it does not.
std::optional<std::string> try_to_write(const fs::path& path, std::span<const std::uint8_t> bytes,
                                        std::ios::openmode mode) {
  std::ofstream file(path, std::ios::binary | mode);
  file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  file.close();
  return file ? std::nullopt : std::optional(reason_of(errno));
}

/// Waits until a file or a folder is on the disk. Some file systems know no such thing of folders.
bool is_on_disk(const fs::path& path, int flags) {
  const Descriptor opened(::open(path.c_str(), O_RDONLY | O_CLOEXEC | flags));
  return opened.number() >= 0 && (::fsync(opened.number()) == 0 || errno == EINVAL || errno == ENOTSUP);
}

}  // namespace

fs::path temporary_name(const fs::path& path) {
  fs::path name = path;
  // Other machines that share the folder count their processes too.
  name += ".part-" + host_name() + '-' + std::to_string(::getpid());
  return name;
}

void put_in_place(const fs::path& complete, const fs::path& path) {
  if (!is_on_disk(complete, 0) || ::rename(complete.c_str(), path.c_str()) != 0 ||
      (!is_on_disk(folder_of(path), O_DIRECTORY) && errno != EACCES)) {  // a folder may be closed to readers
    fail_to_write(path, reason_of(errno));
  }
}

void fail_to_write(const fs::path& path, const std::string& reason) {
  throw InputError("cannot write '" + path.string() + "': " + reason);
}

std::string host_name() {
  std::array<char, 256> name{};
  ::gethostname(name.data(), name.size() - 1);
  return name.data();
}

void require_file(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) throw InputError("there is no file '" + path.string() + "'");
  if (error) throw InputError("cannot read '" + path.string() + "': " + error.message());
  if (fs::is_directory(status)) throw InputError("'" + path.string() + "' is a folder, not a file");
  if (::access(path.c_str(), R_OK) != 0) {
    throw InputError("cannot read '" + path.string() + "': " + reason_of(errno));
  }
  if (fs::is_regular_file(status) && fs::file_size(path, error) == 0) {
    throw InputError("the file '" + path.string() + "' is empty");
  }
}

std::string read_text_file(const fs::path& path) {
  require_file(path);
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file) throw InputError("cannot read '" + path.string() + "': " + reason_of(errno));
  return text.str();
}

void prepare_folder_of(const fs::path& file) {
  const fs::path folder = folder_of(file);
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw InputError("cannot make the output folder '" + folder.string() + "': " + error.message());
  if (fs::is_directory(file, error)) {
    throw InputError("cannot write '" + file.string() + "': there is a folder of this name");
  }
  if (is_written_straight(file)) return;
  // Asking for permissions is not enough: a read-only file system, a full quota. Another thread may ask too.
  std::string probe = folder / ".taut.part-XXXXXX";
  const int descriptor = ::mkostemp(probe.data(), O_CLOEXEC);
  if (descriptor < 0) {
    throw InputError("cannot write to the output folder '" + folder.string() + "': " + reason_of(errno));
  }
  ::close(descriptor);
  ::unlink(probe.c_str());
}

fs::path free_name(const fs::path& folder, const std::string& stem, const std::string& extension) {
  std::error_code error;
  for (int n = 1;; ++n) {
    fs::path path = folder / (stem + '-' + std::to_string(n) + extension);
    if (!fs::exists(path, error)) return path;
  }
}

void write_text_file(const fs::path& path, const std::string& text) {
  write_file(path, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

void write_file(const fs::path& path, std::span<const std::uint8_t> bytes) {
  if (is_written_straight(path)) {
    if (const auto reason = try_to_write(path, bytes, std::ios::app)) fail_to_write(path, *reason);
    return;
  }
  const fs::path temporary = temporary_name(path);
  // By which the temporary file is also found in a folder that somebody renames meanwhile.
  const Descriptor folder(::open(folder_of(path).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  try {
    if (const auto reason = try_to_write(temporary, bytes, std::ios::trunc)) fail_to_write(path, *reason);
    put_in_place(temporary, path);
  } catch (...) {
    ::unlinkat(folder.number() >= 0 ? folder.number() : AT_FDCWD,
               (folder.number() >= 0 ? temporary.filename() : temporary).c_str(), 0);
    throw;
  }
}

std::vector<std::filesystem::path> folders_above(const std::filesystem::path& file) {
  const std::filesystem::path above = file.parent_path().parent_path();
  return file.empty() ? std::vector<std::filesystem::path>{}
                      : std::vector<std::filesystem::path>{above, above.parent_path()};
}

SeekableFile::SeekableFile(std::filesystem::path path) : path_(std::move(path)) {
  require_file(path_);
  file_ = Descriptor(::open(path_.c_str(), O_RDONLY | O_CLOEXEC));
  if (file_.number() < 0) throw InputError("cannot read '" + path_.string() + "': " + reason_of(errno));
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
