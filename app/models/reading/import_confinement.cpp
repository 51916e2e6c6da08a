#include "app/models/reading/import_confinement.hpp"

#include <fcntl.h>
#include <linux/landlock.h>
#include <seccomp.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <csignal>

#include "app/base/child_process.hpp"
#include "app/base/errors.hpp"

namespace taut::app {
namespace {

void limit(decltype(RLIMIT_AS) resource, std::size_t maximum) {
  const rlimit both{maximum, maximum};
  ::setrlimit(resource, &both);
}

void set_limits(const std::filesystem::path& model, const ImportLimits& limits) {
  constexpr std::size_t max_descriptors = 64;
  if (memory_is_limited) limit(RLIMIT_AS, limits.memory_mib << 20U);
  limit(RLIMIT_CPU, static_cast<std::size_t>(max_processor_s(model, limits)));
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, 0);
  limit(RLIMIT_NPROC, 0);
  limit(RLIMIT_NOFILE, max_descriptors);
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

/// Redirects the standard streams, because some readers print, which must not mix with the answer's bytes.
void close_descriptors(int output) {
  ::dup2(output, import_output);
  const int nowhere = ::open("/dev/null", O_RDWR);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::dup2(nowhere, stream);
  ::closefrom(import_output + 1);
}

/// Returns the rights that a version of Landlock knows: all bits below their count.
std::uint64_t known_rights(long version) {
  constexpr std::array<int, 5> counts = {13, 14, 15, 15, 16};
  return (std::uint64_t{1} << counts[static_cast<std::size_t>(std::min(version, 5L) - 1)]) - 1;
}

void allow_to_read(int ruleset, const std::filesystem::path& path) {
  const Descriptor file(::open(path.c_str(), O_PATH | O_NOFOLLOW | O_CLOEXEC));
  struct stat status {};
  if (file.number() < 0 || ::fstat(file.number(), &status) != 0 || !S_ISREG(status.st_mode)) return;
  landlock_path_beneath_attr rule{};
  rule.allowed_access = LANDLOCK_ACCESS_FS_READ_FILE;
  rule.parent_fd = file.number();
  ::syscall(SYS_landlock_add_rule, ruleset, LANDLOCK_RULE_PATH_BENEATH, &rule, 0);
}

bool refuse_files_except(std::span<const std::filesystem::path> readable) {
  const long version = ::syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
  if (version < 1) return false;
  landlock_ruleset_attr all{};
  all.handled_access_fs = known_rights(version);
  const Descriptor ruleset(static_cast<int>(::syscall(SYS_landlock_create_ruleset, &all, sizeof(all), 0)));
  for (const std::filesystem::path& path : readable) allow_to_read(ruleset.number(), path);
  return ::syscall(SYS_landlock_restrict_self, ruleset.number(), 0) == 0;
}

void refuse_calls() {
  constexpr scmp_datum_t writing = O_ACCMODE | O_CREAT | O_TRUNC | O_TMPFILE;
  const std::unique_ptr<void, void (*)(scmp_filter_ctx)> filter(seccomp_init(SCMP_ACT_ERRNO(EPERM)), seccomp_release);
  int error = seccomp_attr_set(filter.get(), SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_KILL_PROCESS);
  if (error == 0) error = seccomp_attr_set(filter.get(), SCMP_FLTATR_API_SYSRAWRC, 1);  // the kernel's own reason
  const auto allow = [&](int call, std::initializer_list<scmp_arg_cmp> conditions = {}) {
    const auto count = static_cast<unsigned>(conditions.size());
    // Calls that this processor does not have are skipped.
    if (error == 0) error = seccomp_rule_add_array(filter.get(), SCMP_ACT_ALLOW, call, count, conditions.begin());
  };
  for (const int call :
       {// files, which Landlock judges
        SCMP_SYS(read), SCMP_SYS(readv), SCMP_SYS(pread64), SCMP_SYS(lseek), SCMP_SYS(_llseek), SCMP_SYS(close),
        SCMP_SYS(write), SCMP_SYS(writev), SCMP_SYS(stat), SCMP_SYS(lstat), SCMP_SYS(fstat), SCMP_SYS(newfstatat),
        SCMP_SYS(stat64), SCMP_SYS(lstat64), SCMP_SYS(fstat64), SCMP_SYS(fstatat64), SCMP_SYS(statx), SCMP_SYS(access),
        SCMP_SYS(faccessat), SCMP_SYS(faccessat2), SCMP_SYS(readlink), SCMP_SYS(readlinkat), SCMP_SYS(getcwd),
        // memory
        SCMP_SYS(munmap), SCMP_SYS(mremap), SCMP_SYS(brk), SCMP_SYS(madvise),
        // the process itself
        SCMP_SYS(futex), SCMP_SYS(futex_time64), SCMP_SYS(sched_yield), SCMP_SYS(rt_sigaction),
        SCMP_SYS(rt_sigprocmask), SCMP_SYS(rt_sigreturn), SCMP_SYS(restart_syscall), SCMP_SYS(getpid), SCMP_SYS(gettid),
        SCMP_SYS(exit), SCMP_SYS(exit_group), SCMP_SYS(getrandom), SCMP_SYS(clock_gettime), SCMP_SYS(clock_gettime64),
        SCMP_SYS(gettimeofday), SCMP_SYS(time)}) {
    allow(call);
  }
  allow(SCMP_SYS(open), {{1, SCMP_CMP_MASKED_EQ, writing, 0}});
  allow(SCMP_SYS(openat), {{2, SCMP_CMP_MASKED_EQ, writing, 0}});
  for (const int call : {SCMP_SYS(mmap), SCMP_SYS(mmap2), SCMP_SYS(mprotect)}) {
    allow(call, {{2, SCMP_CMP_MASKED_EQ, PROT_EXEC, 0}});
  }
  allow(SCMP_SYS(tgkill), {{0, SCMP_CMP_EQ, static_cast<scmp_datum_t>(::getpid()), 0}});  // abort()
  if (!memory_is_limited) {
    for (const int call : {SCMP_SYS(pipe), SCMP_SYS(pipe2), SCMP_SYS(sigaltstack)}) allow(call);  // the sanitizers' own
  }
  if (error == 0) error = seccomp_load(filter.get());
  if (error != 0) {
    throw InputError("no model is read, because this system refuses to confine the reader of models (seccomp: {})",
                     std::generic_category().message(-error));
  }
}

}  // namespace

int max_processor_s(const std::filesystem::path& model, const ImportLimits& limits) {
  constexpr int small_file_s = 8;
  constexpr std::uintmax_t bytes_per_s = std::uintmax_t{1} << 24U;
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(model, error);
  return std::min(limits.seconds, small_file_s + (error ? 0 : static_cast<int>(bytes / bytes_per_s)));
}

bool confine_import(const std::filesystem::path& model, const ImportLimits& limits, int output) {
  close_descriptors(output);
  set_limits(model, limits);
  const std::vector<std::filesystem::path> readable = named_files(model);
  ::prctl(PR_SET_DUMPABLE, 0, 0, 0, 0);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL, 0, 0, 0);
  ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  const bool are_files_refused = refuse_files_except(readable);
  refuse_calls();
  return are_files_refused;
}

}  // namespace taut::app
