#include "app/sweeps/run_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <fstream>

#include "app/base/child_process.hpp"
#include "app/base/files.hpp"

namespace taut::app {
namespace {

namespace fs = std::filesystem;

std::string this_job() {
  const char* job = std::getenv("SLURM_JOB_ID");
  return job != nullptr && *job != '\0' ? job : "-";
}

std::string owner_in(const fs::path& file) {
  std::ifstream in(file);
  std::string owner;
  std::getline(in, owner);
  return owner;
}

/// Whether a process of this machine is gone, or has ended and was not waited for.
bool is_over(pid_t process) {
  if (::kill(process, 0) != 0) return errno == ESRCH;
  std::ifstream in("/proc/" + std::to_string(process) + "/stat");
  std::string line;
  std::getline(in, line);
  const std::size_t name_end = line.rfind(") ");  // the name may have anything in it
  return name_end != std::string::npos && line.find_first_of("ZX", name_end + 2) == name_end + 2;
}

bool has_ended(const std::string& owner) {
  std::istringstream in(owner);
  std::string host, job;
  pid_t process = 0;
  in >> host >> process >> job;
  // A job that was put back in the queue has the same number, in another process.
  const bool is_this_job = job != "-" && job == this_job() && process != ::getpid();
  return is_this_job || (host == host_name() && process > 0 && is_over(process));
}

/// Both times are of the file's machine: clocks may differ.
bool is_stale(const fs::path& lock, const fs::path& just_written) {
  std::error_code error;
  const auto touched = fs::last_write_time(lock, error);
  return !error && fs::last_write_time(just_written, error) - touched > RunLock::stale_after;
}

/// Puts `own` in the place of a lock that was left behind. Of several that try only one does: they queue at
/// what was left, and who comes later finds that another lock is there. Where files cannot be locked nobody
/// queues, and the last one has it.
bool take_over(const fs::path& own, const fs::path& lock) {
  const Descriptor left(::open(lock.c_str(), O_RDWR | O_CLOEXEC));
  if (::flock(left.number(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) return false;
  struct stat opened {
  }, named{};
  if (::fstat(left.number(), &opened) != 0 || ::stat(lock.c_str(), &named) != 0 ||
      opened.st_ino != named.st_ino || !(has_ended(owner_in(lock)) || is_stale(lock, own))) {
    return false;
  }
  return ::rename(own.c_str(), lock.c_str()) == 0;
}

/// Where there are no hard links.
bool take_without_link(const fs::path& own, const fs::path& lock) {
  return ::renameat2(AT_FDCWD, own.c_str(), AT_FDCWD, lock.c_str(), RENAME_NOREPLACE) == 0 ||
         (errno == EINVAL && ::rename(own.c_str(), lock.c_str()) == 0);
}

}  // namespace

RunLock::RunLock(fs::path file)
    : file_(std::move(file)), owner_(host_name() + ' ' + std::to_string(::getpid()) + ' ' + this_job()) {
  const fs::path own = file_.string() + '-' + host_name() + '-' + std::to_string(::getpid());
  write_text_file(own, owner_ + '\n');
  std::error_code error;
  // The answer of a network file system may be lost, and it says to the second try that the name is taken.
  bool is_taken = ::link(own.c_str(), file_.c_str()) == 0 || fs::hard_link_count(own, error) == 2;
  const std::string other = owner_in(file_);
  if (!is_taken) is_taken = fs::exists(file_, error) ? take_over(own, file_) : take_without_link(own, file_);
  is_held_ = is_taken && owner_in(file_) == owner_;
  owner_ = is_held_ ? owner_ : other;
  fs::remove(own, error);
  touched_ = std::chrono::steady_clock::now();
}

RunLock::~RunLock() {
  if (is_held_ && owner_in(file_) == owner_) {
    std::error_code ignored;
    fs::remove(file_, ignored);
  }
}

void RunLock::beat() {
  constexpr std::chrono::seconds often_enough{20};
  if (const auto now = std::chrono::steady_clock::now(); now - touched_ > often_enough) {
    ::utimensat(AT_FDCWD, file_.c_str(), nullptr, 0);  // now, by the clock of the file's machine
    touched_ = now;
  }
}

}  // namespace taut::app
