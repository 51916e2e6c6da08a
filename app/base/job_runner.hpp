#pragma once

#include "prelude.hpp"

namespace taut::app {

/// A job calls this regularly with the fraction of its work that is done, 0 to 1. Throws when the job must stop.
using ProgressCallback = std::function<void(double fraction)>;

/// Work that may run at the same time as other jobs.
struct Job {
  std::string name;
  double cost = 1.0;  ///< estimate, relative to the other jobs; the most expensive begin first
  std::function<void(const ProgressCallback&)> work;
};

/// Runs the jobs on at most `threads` threads. Calls `finished` with the index of each finished job on the calling
/// thread, so it may draw while other jobs run.
///
/// The first exception of a job or of `finished`, or an interruption, stops all jobs at their next call of the progress
/// callback. The exception is then thrown from here. Shows the total progress if standard error is a terminal.
void run_jobs(std::span<const Job> jobs, unsigned threads, const std::function<void(std::size_t)>& finished);

}  // namespace taut::app
