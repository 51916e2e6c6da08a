#pragma once

#include "prelude.hpp"

namespace taut::app {

/// A job calls this from time to time with the fraction of its work that is done, 0 to 1. Throws when the job
/// has to stop.
using ProgressCallback = std::function<void(double fraction)>;

/// One piece of work that may run at the same time as others.
struct Job {
  std::string name;
  double cost = 1.0;  ///< relative to the other jobs; the most expensive begin first
  std::function<void(const ProgressCallback&)> work;
};

/// Runs the jobs on at most `threads` threads. `finished` is called with the index of each finished job, on
/// the calling thread, so it may draw while other jobs run.
///
/// The first exception of a job, of `finished` or of an interruption stops all jobs at their next call of the
/// progress callback. It is then thrown from here. Shows the total progress if standard error is a terminal.
void run_jobs(std::span<const Job> jobs, unsigned threads, const std::function<void(std::size_t)>& finished);

}  // namespace taut::app
