#include "app/models/confinement.hpp"

#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/landlock.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>

#include "app/base/child_process.hpp"

namespace taut::app {
namespace {

/// The rights that a version of Landlock knows: all that there are below the number's bit.
std::uint64_t rights_of(long version) {
  constexpr std::array<int, 5> counts = {13, 14, 15, 15, 16};
  return (std::uint64_t{1} << counts[static_cast<std::size_t>(version < 5 ? version - 1 : 4)]) - 1;
}

void allow_to_read(int ruleset, const std::filesystem::path& path) {
  const Descriptor place(::open(path.c_str(), O_PATH | O_CLOEXEC));
  struct stat status {};
  if (place.number() < 0 || ::fstat(place.number(), &status) != 0) {
    return;
  }
  landlock_path_beneath_attr rule{};
  rule.allowed_access = LANDLOCK_ACCESS_FS_READ_FILE;
  if (S_ISDIR(status.st_mode)) {
    rule.allowed_access |= LANDLOCK_ACCESS_FS_READ_DIR;
  }
  rule.parent_fd = place.number();
  ::syscall(SYS_landlock_add_rule, ruleset, LANDLOCK_RULE_PATH_BENEATH, &rule, 0);
}

bool keep_from_files(std::span<const std::filesystem::path> readable) {
  const long version = ::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
  if (version < 1) {
    return false;
  }
  landlock_ruleset_attr all{};
  all.handled_access_fs = rights_of(version);
  const Descriptor ruleset(static_cast<int>(::syscall(SYS_landlock_create_ruleset, &all, sizeof(all), 0)));
  for (const std::filesystem::path& path : readable) {
    allow_to_read(ruleset.number(), path);
  }
  return ::syscall(SYS_landlock_restrict_self, ruleset.number(), 0) == 0;
}

#if defined(__x86_64__)
constexpr std::uint32_t architecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t architecture = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t architecture = 0;  // where the filter would refuse nothing
#endif

/// Has the system refuse these calls. Those of other architectures' numbers end the process.
void keep_from_calls() {
  constexpr std::array refused = {
      SYS_socket, SYS_socketpair,        SYS_execve,        SYS_execveat, SYS_ptrace,
      SYS_kill,   SYS_process_vm_writev, SYS_io_uring_setup};
  std::array<sock_filter, refused.size() + 7> filter = {
      {BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, arch)),
       BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, architecture, 1, 0),
       BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS),
       BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr))}};
  for (std::size_t k = 0; k < refused.size(); ++k) {
    const auto to_refusal = static_cast<std::uint8_t>(refused.size() - k + 1);
    filter[4 + k] =
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<std::uint32_t>(refused[k]), to_refusal, 0);
  }
  constexpr std::uint32_t first_of_x32 = 0x40000000;
  filter[refused.size() + 4] = BPF_JUMP(BPF_JMP | BPF_JGE | BPF_K, first_of_x32, 1, 0);
  filter[refused.size() + 5] = BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW);
  filter[refused.size() + 6] = BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EPERM);
  const sock_fprog program{static_cast<unsigned short>(filter.size()), filter.data()};
  ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program);
}

}  // namespace

bool confine_to(std::span<const std::filesystem::path> readable) {
  ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  const bool is_kept = keep_from_files(readable);
  if constexpr (architecture != 0) {
    keep_from_calls();
  }
  return is_kept;
}

}  // namespace taut::app
