#include "app/sweeps/sweep.hpp"

#include <thread>

#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/commands/options.hpp"

namespace taut::app {
namespace {

std::string told(const SweepStatus& status, const Sweep& sweep) {
  const auto& [done, broken, failed] = status.ended;
  return fmt::format("{} of {}: {} done, {} broke a promise, {} failed", done + broken,
                     counted(sweep.runs.size(), "run"), done, broken, failed);
}

void say(std::size_t run, const Attempt& attempt) {
  constexpr std::array ends = {"done", "a promise is broken", "failed", "stopped"};
  std::FILE* const stream = attempt.end == RunEnd::done ? stdout : stderr;
  fmt::print(stream, "run {}: {}{}{}\n", run, ends.at(static_cast<std::size_t>(attempt.end)),
             attempt.reason.empty() ? "" : ": ", attempt.reason);
  std::fflush(stream);
}

int exit_code_of(RunEnd worst) {
  constexpr std::array codes = {0, exit_promise_broken, exit_bad_input, exit_can_be_resumed};
  return codes.at(static_cast<std::size_t>(worst));
}

int run_one(const Sweep& sweep, std::size_t run) {
  if (run >= sweep.runs.size()) {
    throw UsageError("--index: found {}, expected a run from 0 to {}", run, sweep.runs.size() - 1);
  }
  const Attempt attempt = attempt_run(sweep, run);
  say(run, attempt);
  return exit_code_of(attempt.end);
}

int run_all(const SweepOptions& options, const Sweep& sweep) {
  const std::vector<std::size_t> missing = status_of(sweep).missing;
  std::vector<Attempt> attempts(missing.size());
  std::vector<Job> jobs;
  for (std::size_t i = 0; i < missing.size(); ++i) {
    jobs.push_back({"run " + std::to_string(missing[i]), 1.0,
                    [&, i](const ProgressCallback& report) { attempts[i] = attempt_run(sweep, missing[i], report); }});
  }
  const unsigned threads = options.jobs > 0 ? options.jobs : std::max(1U, std::thread::hardware_concurrency());
  RunEnd worst = RunEnd::done;
  try {
    run_jobs(
        jobs, threads,
        [&](std::size_t job) {
          say(missing[job], attempts[job]);
          worst = std::max(worst, attempts[job].end);
        },
        "sweep");
  } catch (const Interrupted&) {
    fmt::print(stderr, "taut: stopped: the same command goes on\n");
    return exit_can_be_resumed;
  }
  const SweepStatus status = status_of(sweep);
  fmt::print("{}\n", told(status, sweep));
  return exit_code_of(status.ended[1] > 0 ? std::max(worst, RunEnd::broken) : worst);
}

int status(const SweepOptions& options, const Sweep& sweep) {
  const SweepStatus status = status_of(sweep);
  fmt::print("{}\n", options.missing ? ranges_text(status.missing) : told(status, sweep));
  if (!options.missing && !status.first_failure.empty())
    fmt::print("the first that failed: {}\n", status.first_failure);
  return 0;
}

}  // namespace

int run(const SweepOptions& options) {
  if (options.action == SweepAction::plan) {
    const Sweep planned = plan_sweep(options.study, options.folder);
    fmt::print("planned {} in {}: {} to be made\n", counted(planned.runs.size(), "run"), options.folder.string(),
               status_of(planned).missing.size());
    return 0;
  }
  const Sweep sweep = read_sweep(options.folder);
  if (options.action == SweepAction::status) return status(options, sweep);
  if (options.action == SweepAction::merge) {
    write_text_file(sweep.folder / "table.csv", sweep_table(sweep));
    fmt::print("wrote {}\n{}\n", (sweep.folder / "table.csv").string(), told(status_of(sweep), sweep));
    return 0;
  }
  require_planned_program(sweep);
  if (options.index.has_value() == options.all) throw UsageError("expected one of --index and --all");
  return options.all ? run_all(options, sweep) : run_one(sweep, *options.index);
}

}  // namespace taut::app
