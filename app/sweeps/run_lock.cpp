#include "app/sweeps/run_lock.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <system_error>

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

bool has_ended(const std::string& owner) {
  std::istringstream in(owner);
  std::string host, job;
  pid_t process = 0;
  in >> host >> process >> job;
  // A job that was put back in the queue has the same number, in another process.
  const bool is_this_job = job != "-" && job == this_job() && process != ::getpid();
  return is_this_job || (host == host_name() && process > 0 && ::kill(process, 0) != 0 && errno == ESRCH);
}

/// Both times are of the file's machine: clocks may differ.
bool is_stale(const fs::path& lock, const fs::path& just_written) {
  std::error_code error;
  const auto touched = fs::last_write_time(lock, error);
  return !error && fs::last_write_time(just_written, error) - touched > RunLock::stale_after;
}

}  // namespace

RunLock::RunLock(fs::path file)
    : file_(std::move(file)), owner_(host_name() + ' ' + std::to_string(::getpid()) + ' ' + this_job()) {
  const fs::path own = file_.string() + '-' + host_name() + '-' + std::to_string(::getpid());
  write_text_file(own, owner_ + '\n');
  std::error_code error;
  // What a network file system answers may be lost, and it says to the second try that the name is taken.
  bool is_taken = ::link(own.c_str(), file_.c_str()) == 0 || fs::hard_link_count(own, error) == 2;
  const std::string other = owner_in(file_);
  // Where there are no hard links, nothing is there either.
  const bool is_left = !fs::exists(file_, error) || has_ended(other) || is_stale(file_, own);
  if (!is_taken && is_left) {
    fs::rename(own, file_, error);  // of two that do so, the last one has it
    is_taken = !error;
  }
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
