#pragma once

#include <functional>
#include <span>
#include <string>

namespace taut::app {

/// Long work says how far it is, from 0 to 1. Throws where the work shall be given up.
using Checkpoint = std::function<void(double fraction)>;

struct Job {
  std::string name;
  double cost = 1.0;  ///< relative to the others; the most expensive begin first
  std::function<void(const Checkpoint&)> work;
};

/// Does the jobs on that many threads. `finished` is called with a job's number on the calling thread, which
/// so can draw while others still simulate. The first thing thrown by a job, by `finished` or by an
/// interruption stops all jobs at their next checkpoint and is thrown again here. Shows the progress of the
/// whole where standard error is a terminal.
void run_jobs(std::span<const Job> jobs, unsigned threads, const std::function<void(std::size_t)>& finished);

}  // namespace taut::app
