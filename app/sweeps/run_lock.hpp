#pragma once

#include <chrono>
#include <filesystem>

#include "prelude.hpp"

namespace taut::app {

/// A file that says who works on a run, so that others leave it alone. Made by a hard link, which works on
/// network file systems too. It saves work and nothing depends on it: results are the same whoever makes
/// them, and are renamed into place.
///
/// A lock that was left behind is taken over: at once where its process was one of this machine or of the
/// same job of Slurm, which has ended, else when it was not touched for stale_after.
class RunLock {
 public:
  static constexpr std::chrono::minutes stale_after{10};

  /// Tries to take the lock. Throws InputError if the file cannot be written.
  explicit RunLock(std::filesystem::path file);
  ~RunLock();
  RunLock(const RunLock&) = delete;
  RunLock& operator=(const RunLock&) = delete;

  bool is_held() const { return is_held_; }
  /// Who has it: "HOST PROCESS JOB"; JOB is that of Slurm, or -.
  const std::string& owner() const { return owner_; }
  /// Touches the file now and then. Call it at least every minute.
  void beat();

 private:
  std::filesystem::path file_;
  std::string owner_;
  bool is_held_ = false;
  std::chrono::steady_clock::time_point touched_;
};

}  // namespace taut::app
