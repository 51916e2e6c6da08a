#include <fcntl.h>
#include <fmt/core.h>
#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <new>

#include "app/models/confinement.hpp"
#include "app/models/import_process.hpp"
#include "app/models/model_reading.hpp"

namespace taut::app {
namespace {

std::string too_big(const ImportLimits& limits) {
  return fmt::format("reading it takes more than {} MiB of memory", limits.memory_mib);
}

std::string framed(ImportAnswer kind, const std::string& content) {
  const std::uint64_t length = content.size();
  std::string bytes(1, static_cast<char>(kind));
  bytes.append(reinterpret_cast<const char*>(&length), sizeof(length));
  return bytes + content;
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

// The file as well as its folder: where it is a link it lies elsewhere.
int serve_import(const std::filesystem::path& path, const ImportLimits& limits, ReadParts parts) {
  const int output = take_standard_output();
  keep_to(limits);
  confine_to(std::array{path, path.parent_path()});
  std::string answer;
  try {
    answer = framed(ImportAnswer::arrays, encode(read_model(path, parts)));
  } catch (const std::exception& error) {
    answer = framed(ImportAnswer::reason, reason_of(error, limits));
  }
  // Not through exit: what a reader left behind may crash while it is cleared away.
  ::_exit(write_all(output, answer) ? 0 : 1);
}

}  // namespace taut::app
