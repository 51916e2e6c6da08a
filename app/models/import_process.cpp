#include "app/models/import_process.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <poll.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <new>
#include <optional>
#include <system_error>
#include <vector>

#include "app/base/errors.hpp"
#include "app/base/interruption.hpp"
#include "app/models/model_reading.hpp"

namespace taut::app {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

// What goes through the pipe: one byte that says which, eight with the length, and the arrays or the reason.
enum class Kind : char { arrays = 'A', reason = 'R' };
constexpr std::size_t header_bytes = 1 + sizeof(std::uint64_t);

// Limit on what the child may send: more than the largest model that can be simulated.
constexpr std::uint64_t most_bytes = std::uint64_t{1} << 31;

constexpr const char* nested = "TAUT_IMPORTING";

fs::path importer_program() {
  if (const char* chosen = std::getenv("TAUT_IMPORTER"); chosen != nullptr && *chosen != '\0') {
    return chosen;
  }
  std::error_code error;
  const fs::path self = fs::read_symlink("/proc/self/exe", error);
  const bool is_taut = self.filename().string().starts_with("taut");
  return !is_taut && fs::exists(TAUT_BUILT_PROGRAM, error) ? fs::path(TAUT_BUILT_PROGRAM) : self;
}

/// A child process and the pipe it writes to; ended with this object.
class ImportProcess {
 public:
  ImportProcess(const fs::path& model, const ImportLimits& limits);
  ~ImportProcess();
  ImportProcess(const ImportProcess&) = delete;
  ImportProcess& operator=(const ImportProcess&) = delete;

  /// Everything it writes; nothing where time runs out.
  std::optional<std::string> read_all(Clock::time_point deadline);
  /// The status of waitpid. To be called after all was read.
  int wait();

 private:
  pid_t process_ = -1;
  int output_ = -1;
};

int spawn(std::vector<std::string> arguments, int output, pid_t& process) {
  std::vector<char*> pointers;
  for (std::string& argument : arguments) {
    pointers.push_back(argument.data());
  }
  pointers.push_back(nullptr);
  std::string mark = std::string(nested) + "=1";
  std::vector<char*> environment;
  for (char** variable = environ; *variable != nullptr; ++variable) {
    environment.push_back(*variable);
  }
  environment.push_back(mark.data());
  environment.push_back(nullptr);

  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&files, output, STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  const int error = posix_spawn(&process, pointers[0], &files, nullptr, pointers.data(), environment.data());
  posix_spawn_file_actions_destroy(&files);
  return error;
}

ImportProcess::ImportProcess(const fs::path& model, const ImportLimits& limits) {
  // A program that does not know the command would start itself again and again.
  if (std::getenv(nested) != nullptr) {
    throw InputError("the importer was started by itself");
  }
  const fs::path program = importer_program();
  std::array<int, 2> ends{};
  int error = ::pipe2(ends.data(), O_CLOEXEC) == 0 ? 0 : errno;
  if (error == 0) {
    error = spawn({program.string(), "import-model", "--memory", std::to_string(limits.memory_mib),
                   "--seconds", std::to_string(limits.seconds), fs::absolute(model).string()},
                  ends[1], process_);
    ::close(ends[1]);
    output_ = ends[0];
  }
  if (error != 0) {
    process_ = -1;
    if (output_ >= 0) {
      ::close(output_);
    }
    throw InputError("the importer '" + program.string() +
                     "' does not start: " + std::generic_category().message(error));
  }
}

ImportProcess::~ImportProcess() {
  if (process_ > 0) {
    ::kill(process_, SIGKILL);
    wait();
  }
  ::close(output_);
}

std::optional<std::string> ImportProcess::read_all(Clock::time_point deadline) {
  constexpr int look_up_after_ms = 100;
  std::string bytes;
  std::vector<char> part(std::size_t{1} << 18);
  while (Clock::now() < deadline && bytes.size() <= most_bytes + header_bytes) {
    throw_if_interrupted();
    pollfd ready{output_, POLLIN, 0};
    if (::poll(&ready, 1, look_up_after_ms) <= 0) {
      continue;
    }
    const ssize_t count = ::read(output_, part.data(), part.size());
    if (count == 0) {
      return bytes;
    }
    if (count > 0) {
      bytes.append(part.data(), static_cast<std::size_t>(count));
    } else if (errno != EINTR && errno != EAGAIN) {
      return bytes;
    }
  }
  return std::nullopt;
}

int ImportProcess::wait() {
  int status = 0;
  while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  return status;
}

std::string too_slow(const ImportLimits& limits) {
  return fmt::format("reading it takes more than {} s", limits.seconds);
}

std::string too_big(const ImportLimits& limits) {
  return fmt::format("reading it takes more than {} MiB of memory", limits.memory_mib);
}

std::string describe_failure(int status, const ImportLimits& limits) {
  if (!WIFSIGNALED(status)) {
    return fmt::format("the library that reads models failed on it (exit code {}); it may be damaged",
                       WEXITSTATUS(status));
  }
  if (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL) {
    return too_slow(limits);
  }
  return fmt::format("the library that reads models crashed on it ({}); it may be damaged",
                     ::strsignal(WTERMSIG(status)));
}

std::string framed(Kind kind, const std::string& content) {
  const std::uint64_t length = content.size();
  std::string bytes(1, static_cast<char>(kind));
  bytes.append(reinterpret_cast<const char*>(&length), sizeof(length));
  return bytes + content;
}

/// What the frame holds, where it is complete.
std::optional<std::string> unframed(const std::string& bytes) {
  std::uint64_t length = 0;
  if (bytes.size() < header_bytes) {
    return std::nullopt;
  }
  std::memcpy(&length, bytes.data() + 1, sizeof(length));
  return length == bytes.size() - header_bytes ? std::optional(bytes.substr(header_bytes)) : std::nullopt;
}

void limit(decltype(RLIMIT_AS) resource, std::size_t most) {
  const rlimit both{most, most};
  ::setrlimit(resource, &both);
}

void keep_to(const ImportLimits& limits) {
  if (memory_is_limited) {
    limit(RLIMIT_AS, limits.memory_mib << 20U);
  }
  limit(RLIMIT_CPU, static_cast<std::size_t>(limits.seconds));
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, 0);
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

/// Standard output for this program alone: some readers print to it.
int take_standard_output() {
  const int output = ::dup(STDOUT_FILENO);
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  ::dup2(nowhere, STDOUT_FILENO);
  return output;
}

bool write_all(int file, const std::string& bytes) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t count = ::write(file, bytes.data() + done, bytes.size() - done);
    if (count < 0 && errno != EINTR) {
      return false;
    }
    done += count > 0 ? static_cast<std::size_t>(count) : 0;
  }
  return true;
}

std::string reason_of(const std::exception& error, const ImportLimits& limits) {
  const std::string reason = error.what();
  const bool memory =
      dynamic_cast<const std::bad_alloc*>(&error) != nullptr || reason.find("bad_alloc") != std::string::npos;
  return memory ? too_big(limits) : reason;
}

}  // namespace

ModelArrays read_model_in_process(const fs::path& path, const ImportLimits& limits) {
  const auto deadline = Clock::now() + std::chrono::seconds(limits.seconds);
  ImportProcess importer(path, limits);
  const std::optional<std::string> bytes = importer.read_all(deadline);
  if (!bytes) {
    throw InputError(Clock::now() < deadline ? "it is larger than anything that can be simulated"
                                             : too_slow(limits));
  }
  const int status = importer.wait();
  const std::optional<std::string> content = unframed(*bytes);
  if (!content) {
    throw InputError(describe_failure(status, limits));
  }
  if (bytes->front() == static_cast<char>(Kind::reason)) {
    throw InputError(*content);
  }
  return decode(*content);
}

int serve_import(const fs::path& path, const ImportLimits& limits) {
  const int output = take_standard_output();
  keep_to(limits);
  std::string answer;
  try {
    answer = framed(Kind::arrays, encode(read_model(path)));
  } catch (const std::exception& error) {
    answer = framed(Kind::reason, reason_of(error, limits));
  }
  // Not through exit: what a reader left behind may crash while it is cleared away.
  ::_exit(write_all(output, answer) ? 0 : 1);
}

}  // namespace taut::app
