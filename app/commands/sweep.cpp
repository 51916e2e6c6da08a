#include <thread>

#include "app/base/counted.hpp"
#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/commands/options.hpp"
#include "app/output/picture_record.hpp"
#include "app/sweeps/farm.hpp"
#include "app/sweeps/sweep_results.hpp"
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

std::size_t task_of_slurm() {
  const char* text = std::getenv("SLURM_ARRAY_TASK_ID");
  const std::optional<std::size_t> task = number_in<std::size_t>(text != nullptr ? text : "");
  if (!task) throw UsageError("expected --index, --task or --all, or $SLURM_ARRAY_TASK_ID as Slurm sets it");
  return *task;
}

/// One run, or those of a task.
int run_some(const SweepOptions& options, const Sweep& sweep) {
  std::size_t first = options.index.value_or(0);
  std::size_t last = first;
  if (options.index) {
    require_index(sweep, first);
  } else {
    const std::size_t chunk = options.chunk.value_or(1);
    first = (options.offset + (options.task ? *options.task : task_of_slurm())) * chunk;
    last = std::min(first + chunk, sweep.runs()) - 1;
  }
  WorstEnd worst;
  for (std::size_t run = first; run <= last && run < sweep.runs(); ++run) {
    const Attempt attempt = attempt_run(sweep, run);
    say(run, attempt);
    worst.add(attempt.end);
    if (attempt.end == AttemptEnd::stopped) break;
  }
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

/// Numbers in an array of this Slurm stay below it.
std::size_t max_array_size() {
  std::istringstream lines(output_of({"scontrol", "show", "config"}));
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("MaxArraySize")) {
      return std::strtoull(line.c_str() + line.find('=') + 1, nullptr, 10);
    }
  }
  throw InputError("'scontrol show config' does not say MaxArraySize");
}

std::string submitted(const std::vector<std::string>& command, bool is_dry_run) {
  if (is_dry_run) {
    fmt::print("{}\n", shell_line(command));
    return "JOB";
  }
  const std::string job = output_of(command);
  return job.substr(0, job.find_first_of(";\n"));
}

/// Writes a script, or prints it.
void hand_out(const std::filesystem::path& file, const std::string& text, bool is_dry_run) {
  if (is_dry_run) {
    fmt::print("# {}\n{}\n", file.string(), text);
    return;
  }
  prepare_folder_of(file);
  write_text_file(file, text);
}

int submit(const SweepOptions& options, const Sweep& sweep) {
  const FarmSettings settings = {options.chunk.value_or(usual_chunk(sweep.runs())), options.memory, options.sbatch};
  constexpr std::size_t usual_array_size = 1001;
  const SweepStatus status = status_of(sweep);
  if (status.missing.size() < sweep.runs() && !options.missing) {
    throw UsageError("{} of {} are there already; --missing submits the others", sweep.runs() - status.missing.size(),
                     counted(sweep.runs(), "run"));
  }
  const std::filesystem::path folder = std::filesystem::absolute(sweep.folder) / "slurm";
  hand_out(folder / "task.sh", slurm_script(sweep, settings), options.dry_run);
  hand_out(folder / "merge.sh", merge_script(sweep), options.dry_run);
  const std::size_t most = options.dry_run ? usual_array_size : max_array_size();
  std::string jobs;
  for (const ArrayJob& array : array_jobs(status.missing, settings.chunk, most)) {
    jobs += ':' + submitted({"sbatch", "--parsable", "--array=" + array.tasks, (folder / "task.sh").string(),
                             std::to_string(array.offset)},
                            options.dry_run);
  }
  if (jobs.empty()) {
    fmt::print("nothing is missing\n");
    return 0;
  }
  const std::string merge = submitted({"sbatch", "--parsable", "--dependency=afterany" + jobs,
                                       "--mem=" + settings.memory, (folder / "merge.sh").string()},
                                      options.dry_run);
  if (!options.dry_run) {
    fmt::print("submitted {} as jobs {}, and job {} that makes the table\n", counted(status.missing.size(), "run"),
               jobs.substr(1), merge);
  }
  return 0;
}

}  // namespace

int run(const SweepOptions& options) {
  if (options.action == SweepAction::plan) return plan(options);
  const Sweep sweep = read_sweep(options.folder);
  switch (options.action) {
    case SweepAction::run:
      require_planned_program(sweep);
      return options.all ? run_all(options, sweep) : run_some(options, sweep);
    case SweepAction::status:
      return status(options, sweep);
    case SweepAction::merge:
      return merge(sweep);
    case SweepAction::check:
      require_index(sweep, options.index.value_or(0));
      fmt::print("{} {} {}\n", host_name(), program_hash(), hash_of_run(sweep, options.index.value_or(0)));
      return 0;
    case SweepAction::show:
      require_index(sweep, *options.index);
      fmt::print("{}", scene_text(sweep.scene(*options.index), GarmentNaming::full_path));
      return 0;
    default:
      return submit(options, sweep);
  }
}

}  // namespace taut::app
