#include <thread>

#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/commands/options.hpp"
#include "app/sweeps/sweep_run.hpp"

namespace taut::app {
namespace {

int plan(const SweepOptions& options) {
  const PlannedSweep planned = plan_sweep(options.study, options.folder);
  const bool is_new = write_sweep(planned);
  fmt::print("{} {} in {}\n", is_new ? "planned" : "there already:", counted(planned.sweep.runs(), "run"),
             options.folder.string());
  return 0;
}

void say(std::size_t run, const Attempt& attempt) {
  constexpr std::array ends = {"done", "a promise is broken", "failed", "stopped", "busy"};
  std::FILE* const stream = attempt.end == AttemptEnd::done ? stdout : stderr;
  fmt::print(stream, "run {}: {}{}{}{}\n", run, ends[static_cast<std::size_t>(attempt.end)],
             attempt.is_new ? "" : " already", attempt.what.empty() ? "" : ": ", attempt.what);
  std::fflush(stream);
}

void require_index(const Sweep& sweep, std::size_t index) {
  if (index >= sweep.runs()) {
    throw UsageError("--index: found {}, expected a run from 0 to {}", index, sweep.runs() - 1);
  }
}

int run_one(const Sweep& sweep, std::size_t run) {
  require_index(sweep, run);
  const Attempt attempt = attempt_run(sweep, run);
  say(run, attempt);
  WorstEnd worst;
  worst.add(attempt.end);
  return worst.exit_code();
}

std::string told(const SweepStatus& status, const Sweep& sweep) {
  return fmt::format("{} of {}: {} done, {} broke a promise, {} failed; {} being worked on, {} stopped on their way",
                     status.done + status.broken, counted(sweep.runs(), "run"), status.done, status.broken,
                     status.failed, status.working, status.stopped);
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
  WorstEnd worst;
  try {
    run_jobs(
        jobs, threads,
        [&](std::size_t job) {
          say(missing[job], attempts[job]);
          worst.add(attempts[job].end);
        },
        "sweep");
  } catch (const Interrupted&) {
    fmt::print(stderr, "taut: stopped: the same command goes on\n");
    return exit_can_be_resumed;
  }
  const SweepStatus status = status_of(sweep);
  fmt::print("{}\n", told(status, sweep));
  if (status.broken > 0) worst.add(AttemptEnd::broken);
  return worst.exit_code();
}

int status(const SweepOptions& options, const Sweep& sweep) {
  const SweepStatus status = status_of(sweep);
  if (options.missing) {
    fmt::print("{}\n", ranges_text(status.missing));
    return 0;
  }
  fmt::print("{}\n", told(status, sweep));
  if (!status.first_failure.empty()) fmt::print("the first that failed: {}\n", status.first_failure);
  return 0;
}

int merge(const Sweep& sweep) {
  const std::filesystem::path table = sweep.folder / "table.csv";
  write_text_file(table, sweep_table(sweep));
  fmt::print("wrote {}\n", table.string());
  if (const renderer::Image sheet = sweep_sheet(sweep); sheet.width_px > 0) {
    write_file(sweep.folder / "sheet.png", renderer::encode_png(sheet));
    fmt::print("wrote {}\n", (sweep.folder / "sheet.png").string());
  }
  const SweepStatus status = status_of(sweep);
  fmt::print("{}\n", told(status, sweep));
  return 0;
}

}  // namespace

int run(const SweepOptions& options) {
  if (options.action == SweepAction::plan) return plan(options);
  const Sweep sweep = read_sweep(options.folder);
  switch (options.action) {
    case SweepAction::run:
      require_planned_program(sweep);
      if (options.index.has_value() == options.all) throw UsageError("expected one of --index and --all");
      return options.all ? run_all(options, sweep) : run_one(sweep, *options.index);
    case SweepAction::status:
      return status(options, sweep);
    case SweepAction::merge:
      return merge(sweep);
    default:
      require_index(sweep, *options.index);
      fmt::print("{}", scene_text(sweep.scene(*options.index), GarmentNaming::full_path));
      return 0;
  }
}

}  // namespace taut::app
