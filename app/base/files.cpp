#include "app/base/files.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <fstream>

#include "app/base/errors.hpp"

namespace taut::app {
namespace {

namespace fs = std::filesystem;

std::string system_error_text(int error_number) { return std::generic_category().message(error_number); }

fs::path parent_folder(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

/// Returns true for paths that a rename must not replace, such as /dev/stdout and named pipes. /dev/stdout stays one of
/// them when it is redirected to a regular file.
bool is_special_file(const fs::path& path) {
  std::error_code error;
  const fs::path link = fs::read_symlink(path, error);
  if (link.string().starts_with("/proc/") || path.string().starts_with("/proc/")) return true;
  const fs::file_status status = fs::status(path, error);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

[[noreturn]] void fail_to_read(const fs::path& path, const std::string& reason) {
  throw InputError("cannot read '" + path.string() + "': " + reason);
}

/// Throws InputError if an input of this status cannot be read.
void require_readable(const fs::path& path, const struct stat& status, std::uint64_t max_bytes, InputKind kind) {
  const std::string name = '\'' + path.string() + '\'';
  if (S_ISDIR(status.st_mode)) throw InputError(name + " is a folder, not a file");
  if (S_ISFIFO(status.st_mode) && kind == InputKind::file_or_pipe) return;
  if (!S_ISREG(status.st_mode)) {
    throw InputError("{} is a {}, expected a file", name, S_ISFIFO(status.st_mode) ? "pipe" : "device or a socket");
  }
  if (status.st_size == 0) throw InputError("the file " + name + " is empty");
  if (static_cast<std::uint64_t>(status.st_size) > max_bytes) {
    throw InputError("the file {} has {} bytes, expected at most {}", name, status.st_size, max_bytes);
  }
}

/// Waits for the next bytes of a pipe. Returns false at its end.
bool append_bytes(const Descriptor& pipe, const fs::path& path, std::string& text) {
  constexpr int look_up_after_ms = 100;
  std::array<char, 65536> part;
  for (int waits = 0; waits < max_silence_s * 1000 / look_up_after_ms; ++waits) {
    throw_if_interrupted();
    pollfd ready{pipe.number(), POLLIN, 0};
    if (::poll(&ready, 1, look_up_after_ms) <= 0) continue;
    const ssize_t count = ::read(pipe.number(), part.data(), part.size());
    if (count < 0 && errno != EINTR && errno != EAGAIN) fail_to_read(path, system_error_text(errno));
    if (count < 0) continue;
    text.append(part.data(), static_cast<std::size_t>(count));
    return count > 0;
  }
  fail_to_read(path, fmt::format("the pipe brought nothing for {} s", max_silence_s));
}

std::string read_pipe(const Descriptor& pipe, const fs::path& path, std::uint64_t max_bytes) {
  std::string text;
  while (append_bytes(pipe, path, text)) {
    if (text.size() > max_bytes) fail_to_read(path, fmt::format("the pipe brought more than {} bytes", max_bytes));
  }
  if (text.empty()) throw InputError("the pipe '" + path.string() + "' is empty");
  return text;
}

/// Waits until a file or a folder is on the disk. Some file systems cannot wait for folders.
bool is_on_disk(const fs::path& path, int flags) {
  const Descriptor opened(::open(path.c_str(), O_RDONLY | O_CLOEXEC | flags));
  return opened.number() >= 0 && (::fsync(opened.number()) == 0 || errno == EINVAL || errno == ENOTSUP);
}

bool is_taken(const fs::path& stem, const std::string& ending) {
  std::error_code error;
  return fs::exists(fs::path(stem) += ending, error);
}

/// Returns the first of STEM-1, STEM-2, ... with which no file with one of the endings exists.
fs::path free_stem(const fs::path& stem, const std::vector<std::string>& endings) {
  for (int n = 1;; ++n) {
    fs::path free = stem;
    free += '-' + std::to_string(n);
    if (std::ranges::none_of(endings, [&](const std::string& ending) { return is_taken(free, ending); })) return free;
  }
}

}  // namespace

fs::path temporary_name(const fs::path& path) {
  fs::path name = path;
  // The host is in the name because a machine that shares the folder may have a process of the same number.
  name += ".part-" + host_name() + '-' + std::to_string(::getpid());
  return name;
}

void rename_complete(const fs::path& complete, const fs::path& path) {
  if (!is_on_disk(complete, 0) || ::rename(complete.c_str(), path.c_str()) != 0 ||
      (!is_on_disk(parent_folder(path), O_DIRECTORY) && errno != EACCES)) {  // a folder may be closed to readers
    fail_to_write(path, system_error_text(errno));
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

OpenInput open_input(const fs::path& path, std::uint64_t max_bytes, InputKind kind) {
  struct stat status {};
  const auto look = [&](int failed) {
    if (failed == 0) return require_readable(path, status, max_bytes, kind);
    if (errno == ENOENT || errno == ENOTDIR) throw InputError("there is no file '" + path.string() + "'");
    fail_to_read(path, system_error_text(errno));
  };
  look(::stat(path.c_str(), &status));
  // O_NONBLOCK: opening a pipe that has no writer would wait for ever otherwise.
  OpenInput input{Descriptor(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY))};
  if (input.file.number() < 0) fail_to_read(path, system_error_text(errno));
  look(::fstat(input.file.number(), &status));  // the file may have been replaced meanwhile
  input.is_pipe = S_ISFIFO(status.st_mode);
  input.bytes = input.is_pipe ? 0 : static_cast<std::uint64_t>(status.st_size);
  return input;
}

void require_file(const fs::path& path, std::uint64_t max_bytes) { open_input(path, max_bytes); }

std::string read_text_file(const fs::path& path, std::uint64_t max_bytes) {
  const OpenInput input = open_input(path, max_bytes, InputKind::file_or_pipe);
  if (input.is_pipe) return read_pipe(input.file, path, max_bytes);
  std::string text(input.bytes, '\0');
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t count = ::read(input.file.number(), text.data() + done, text.size() - done);
    if (count < 0 && errno != EINTR) fail_to_read(path, system_error_text(errno));
    if (count == 0) break;  // the file was made shorter meanwhile
    done += count > 0 ? static_cast<std::size_t>(count) : 0;
  }
  text.resize(done);
  return text;
}

Descriptor create_file(const fs::path& temporary, const fs::path& path) {
  ::unlink(temporary.c_str());
  Descriptor file(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666));
  if (file.number() < 0) fail_to_write(path, system_error_text(errno));
  return file;
}

OutputClaim::OutputClaim(const fs::path& path) {
  struct stat folder {};
  if (is_special_file(path) || ::stat(parent_folder(path).c_str(), &folder) != 0) return;
  socket_ = Descriptor(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0));
  // A name that begins with a zero byte is in no folder (abstract socket); the system frees it when the program ends.
  const std::string name = fmt::format("{}taut-output-{}-{}-{:016x}", '\0', folder.st_dev, folder.st_ino,
                                       std::hash<std::string>()(path.filename().string()));
  sockaddr_un address{.sun_family = AF_UNIX, .sun_path = {}};
  std::memcpy(address.sun_path, name.data(), name.size());
  const auto length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + name.size());
  if (::bind(socket_.number(), reinterpret_cast<const sockaddr*>(&address), length) != 0 && errno == EADDRINUSE) {
    fail_to_write(path, "another program is writing it");
  }
}

std::vector<fs::path> list_files(const fs::path& folder, const std::string& ending) {
  std::vector<fs::path> files;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    if (entry.path().extension() == ending) files.push_back(entry.path());
  }
  std::ranges::sort(files, {}, [](const fs::path& file) { return file.stem().string(); });
  return files;
}

void prepare_parent_folder(const fs::path& file) {
  const fs::path folder = parent_folder(file);
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw InputError("cannot make the output folder '" + folder.string() + "': " + error.message());
  if (fs::is_directory(file, error)) {
    throw InputError("cannot write '" + file.string() + "': there is a folder of this name");
  }
  if (is_special_file(file)) return;
  // Permissions do not show a read-only file system or a full quota. The name is unique because other threads may probe
  // too.
  std::string probe = folder / ".taut.part-XXXXXX";
  const int descriptor = ::mkostemp(probe.data(), O_CLOEXEC);
  if (descriptor < 0) {
    throw InputError("cannot write to the output folder '" + folder.string() + "': " + system_error_text(errno));
  }
  ::close(descriptor);
  ::unlink(probe.c_str());
}

void require_distinct_files(std::span<const fs::path> outputs, std::span<const fs::path> inputs) {
  struct stat status {};
  std::map<std::pair<dev_t, ino_t>, fs::path> read;
  for (const fs::path& input : inputs) {
    if (::stat(input.c_str(), &status) == 0) read.try_emplace({status.st_dev, status.st_ino}, input);
  }
  std::set<fs::path> written;
  for (const fs::path& output : outputs) {
    if (!is_special_file(output) && !written.insert(fs::absolute(output).lexically_normal()).second) {
      throw UsageError("output '{}': two outputs have this name; expected another for each", output.string());
    }
    const auto found = ::stat(output.c_str(), &status) == 0 ? read.find({status.st_dev, status.st_ino}) : read.end();
    if (found != read.end()) {
      throw UsageError("output '{}': it would replace '{}', which is read for it; expected another name",
                       output.string(), found->second.string());
    }
  }
}

fs::path free_name(const fs::path& folder, const std::string& stem, const std::string& extension) {
  return free_stem(folder / stem, {extension}) += extension;
}

fs::path choose_free_stem(const fs::path& stem, bool own, const std::vector<std::string>& endings) {
  const auto taken = std::ranges::find_if(endings, [&](const std::string& ending) { return is_taken(stem, ending); });
  if (own || taken == endings.end()) return stem;
  fs::path other = free_stem(stem, endings);
  fmt::print(stderr, "taut: warning: '{}{}' is there and was not made by this program; writing '{}{}'\n", stem.string(),
             *taken, other.string(), endings.front());
  return other;
}

bool write_bytes(int descriptor, std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
    if (count < 0 && errno != EINTR) return false;
    bytes = bytes.subspan(count > 0 ? static_cast<std::size_t>(count) : 0);
  }
  return true;
}

void write_text_file(const fs::path& path, const std::string& text) {
  write_file(path, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

void write_file(const fs::path& path, std::span<const std::uint8_t> bytes) {
  if (is_special_file(path)) {
    const Descriptor file(::open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC));
    if (file.number() < 0) fail_to_write(path, system_error_text(errno));
    if (!write_bytes(file.number(), bytes)) fail_to_write(path, system_error_text(errno));
    return;
  }
  const fs::path temporary = temporary_name(path);
  // The open folder still leads to the temporary file if somebody renames the folder meanwhile.
  const Descriptor folder(::open(parent_folder(path).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  try {
    const Descriptor file = create_file(temporary, path);
    if (!write_bytes(file.number(), bytes)) fail_to_write(path, system_error_text(errno));
    rename_complete(temporary, path);
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
  OpenInput input = open_input(path_, std::numeric_limits<std::int64_t>::max());
  file_ = std::move(input.file);
  size_ = input.bytes;
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
