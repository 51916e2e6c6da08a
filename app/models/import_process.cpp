#include "app/models/import_process.hpp"

#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/landlock.h>
#include <linux/seccomp.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <new>

#include "app/base/errors.hpp"
#include "app/base/files.hpp"

namespace taut::app {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::size_t header_bytes = 1 + sizeof(std::uint64_t);

// Limit on what the child may send: more than the largest model that can be simulated.
constexpr std::uint64_t most_bytes = std::uint64_t{1} << 31;

constexpr const char* nested = "TAUT_IMPORTING";

fs::path importer_program(const fs::path& chosen_program) {
  if (!chosen_program.empty()) return chosen_program;
  if (const char* chosen = std::getenv("TAUT_IMPORTER"); chosen != nullptr && *chosen != '\0') return chosen;
  const fs::path self = own_file();
  if (self.filename().string().starts_with("taut")) return self;
  std::vector<fs::path> candidates = folders_above(self);
  if (candidates.empty()) {
    throw InputError("there is no program that reads models: the file of this program is gone or was replaced");
  }
  for (fs::path& candidate : candidates) candidate = candidate / "libexec" / "taut" / "taut-import";
  std::error_code error;
  const auto found =
      std::ranges::find_if(candidates, [&](const fs::path& candidate) { return fs::exists(candidate, error); });
  if (found == candidates.end()) {
    throw InputError("there is no program that reads models; expected '" + candidates.front().string() + '\'');
  }
  return *found;
}

/// A child process and the pipe it writes to.
struct Importer {
  Descriptor output;
  ChildProcess process;
};

Importer start_importer(const fs::path& model, const ImportLimits& limits, ReadParts parts) {
  // A program that does not know the command would start itself again and again.
  if (std::getenv(nested) != nullptr) throw InputError("the importer was started by itself");
  const fs::path program = importer_program(limits.program);
  try {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category());
    Descriptor ours(ends[0]);
    const Descriptor its(ends[1]);
    return {
        std::move(ours),
        ChildProcess({.arguments = {fs::absolute(program).string(), "import-model", "--memory",
                                    std::to_string(limits.memory_mib), "--seconds", std::to_string(limits.seconds),
                                    "--parts", std::to_string(static_cast<int>(parts)), fs::absolute(model).string()},
                      .variable = std::string(nested) + "=1",
                      .output = its.number()})};
  } catch (const std::system_error& error) {
    throw InputError("the importer '" + program.string() + "' does not start: " + error.code().message());
  }
}

/// Everything that is written to the pipe; nothing where time runs out.
std::optional<std::string> read_all(const Descriptor& output, Clock::time_point deadline) {
  constexpr int look_up_after_ms = 100;
  std::string bytes;
  std::vector<char> part(std::size_t{1} << 18);
  while (Clock::now() < deadline && bytes.size() <= most_bytes + header_bytes) {
    throw_if_interrupted();
    pollfd ready{output.number(), POLLIN, 0};
    if (::poll(&ready, 1, look_up_after_ms) <= 0) continue;
    const ssize_t count = ::read(output.number(), part.data(), part.size());
    if (count == 0) return bytes;
    if (count > 0) {
      bytes.append(part.data(), static_cast<std::size_t>(count));
    } else if (errno != EINTR && errno != EAGAIN) {
      return bytes;
    }
  }
  return std::nullopt;
}

std::string too_slow(const ImportLimits& limits) {
  return fmt::format("reading it takes more than {} s", limits.seconds);
}

std::string describe_failure(int status, const ImportLimits& limits) {
  if (!WIFSIGNALED(status)) {
    return "the library that reads models failed on it (" + describe_end(status) + "); it may be damaged";
  }
  if (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL) return too_slow(limits);
  return fmt::format("the library that reads models crashed on it ({}); it may be damaged",
                     ::strsignal(WTERMSIG(status)));
}

/// The content of the frame, where it is complete.
std::optional<std::string> unframed(const std::string& bytes) {
  std::uint64_t length = 0;
  if (bytes.size() < header_bytes) return std::nullopt;
  std::memcpy(&length, bytes.data() + 1, sizeof(length));
  return length == bytes.size() - header_bytes ? std::optional(bytes.substr(header_bytes)) : std::nullopt;
}

/// The rights that a version of Landlock knows: all that there are below the number's bit.
std::uint64_t rights_of(long version) {
  constexpr std::array<int, 5> counts = {13, 14, 15, 15, 16};
  return (std::uint64_t{1} << counts[static_cast<std::size_t>(version < 5 ? version - 1 : 4)]) - 1;
}

void allow_to_read(int ruleset, const std::filesystem::path& path) {
  const Descriptor place(::open(path.c_str(), O_PATH | O_CLOEXEC));
  struct stat status {};
  if (place.number() < 0 || ::fstat(place.number(), &status) != 0) return;
  landlock_path_beneath_attr rule{};
  rule.allowed_access = LANDLOCK_ACCESS_FS_READ_FILE;
  if (S_ISDIR(status.st_mode)) rule.allowed_access |= LANDLOCK_ACCESS_FS_READ_DIR;
  rule.parent_fd = place.number();
  ::syscall(SYS_landlock_add_rule, ruleset, LANDLOCK_RULE_PATH_BENEATH, &rule, 0);
}

bool keep_from_files(std::span<const std::filesystem::path> readable) {
  const long version = ::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
  if (version < 1) return false;
  landlock_ruleset_attr all{};
  all.handled_access_fs = rights_of(version);
  const Descriptor ruleset(static_cast<int>(::syscall(SYS_landlock_create_ruleset, &all, sizeof(all), 0)));
  for (const std::filesystem::path& path : readable) allow_to_read(ruleset.number(), path);
  return ::syscall(SYS_landlock_restrict_self, ruleset.number(), 0) == 0;
}

#if defined(__x86_64__)
constexpr std::uint32_t architecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t architecture = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t architecture = 0;  // where the filter would refuse nothing
#endif

/// Has the system refuse these calls. Calls by other architectures' numbers end the process.
void keep_from_calls() {
  constexpr std::array refused = {SYS_socket, SYS_socketpair,        SYS_execve,        SYS_execveat, SYS_ptrace,
                                  SYS_kill,   SYS_process_vm_writev, SYS_io_uring_setup};
  std::array<sock_filter, refused.size() + 7> filter = {
      {BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, arch)),
       BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, architecture, 1, 0), BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS),
       BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr))}};
  for (std::size_t k = 0; k < refused.size(); ++k) {
    const auto to_refusal = static_cast<std::uint8_t>(refused.size() - k + 1);
    filter[4 + k] = BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(refused[k]), to_refusal, 0);
  }
  constexpr std::uint32_t first_of_x32 = 0x40000000;
  filter[refused.size() + 4] = BPF_JUMP(BPF_JMP | BPF_JGE | BPF_K, first_of_x32, 1, 0);
  filter[refused.size() + 5] = BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW);
  filter[refused.size() + 6] = BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EPERM);
  const sock_fprog program{static_cast<unsigned short>(filter.size()), filter.data()};
  ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program);
}

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
  if (memory_is_limited) limit(RLIMIT_AS, limits.memory_mib << 20U);
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
    if (count < 0 && errno != EINTR) return false;
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

ModelArrays read_model_in_process(const fs::path& path, const ImportLimits& limits, ReadParts parts) {
  const auto deadline = Clock::now() + std::chrono::seconds(limits.seconds);
  Importer importer = start_importer(path, limits, parts);
  const std::optional<std::string> bytes = read_all(importer.output, deadline);
  if (!bytes) {
    throw InputError(Clock::now() < deadline ? "it is larger than anything that can be simulated" : too_slow(limits));
  }
  const int status = importer.process.wait();
  const std::optional<std::string> content = unframed(*bytes);
  if (!content) throw InputError(describe_failure(status, limits));
  if (bytes->front() == static_cast<char>(ImportAnswer::reason)) throw InputError(*content);
  return decode(*content);
}

TextureImage read_image(const fs::path& path) {
  require_file(path);
  try {
    ModelArrays answer = read_model_in_process(path, {}, ReadParts::image);
    if (answer.colours.maps.size() != 1) throw InputError("nothing came of it");
    return std::move(answer.colours.maps.front());
  } catch (const Interrupted&) {
    throw;
  } catch (const std::exception& error) {
    throw InputError("cannot read an image from '" + path.string() + "': " + error.what());
  }
}

bool confine_to(std::span<const std::filesystem::path> readable) {
  ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  const bool is_kept = keep_from_files(readable);
  if constexpr (architecture != 0) {
    keep_from_calls();
  }
  return is_kept;
}

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
