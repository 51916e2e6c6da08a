#include <fmt/core.h>

#include <cstdio>
#include <set>
#include <sstream>

#include "app/base/counted.hpp"
#include "app/base/errors.hpp"
#include "app/base/files.hpp"
#include "app/base/suggest.hpp"
#include "app/commands/options.hpp"
#include "app/output/picture_record.hpp"
#include "app/sweeps/farm.hpp"
#include "app/sweeps/sweep_results.hpp"
#include "app/sweeps/sweep_run.hpp"

namespace taut::app {
namespace {

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

int submit(const SweepOptions& options, const Sweep& sweep, const FarmSettings& settings) {
  constexpr std::size_t usual_array_size = 1001;
  const SweepStatus status = status_of(sweep);
  if (status.missing.size() < sweep.runs() && !options.missing) {
    throw UsageError(fmt::format("{} of {} are there already; --missing submits the others",
                                 sweep.runs() - status.missing.size(), counted(sweep.runs(), "run")));
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
    fmt::print("submitted {} as jobs {}, and job {} that makes the table\n",
               counted(status.missing.size(), "run"), jobs.substr(1), merge);
  }
  return 0;
}

int write_script(const SweepOptions& options, const Sweep& sweep, const FarmSettings& settings) {
  const std::string text = options.snakemake ? snakefile(sweep, settings) : parallel_script(sweep, settings);
  if (options.output.empty()) {
    fmt::print("{}", text);
    return 0;
  }
  prepare_folder_of(options.output);
  write_text_file(options.output, text);
  fmt::print("wrote {}\n", options.output.string());
  return 0;
}

/// Every node that can take work.
std::set<std::string> nodes_of_slurm() {
  std::set<std::string> nodes;
  std::istringstream lines(
      output_of({"sinfo", "--noheader", "--Node", "--states=idle,mixed,allocated", "--format=%N"}));
  for (std::string node; lines >> node;) {
    nodes.insert(node);
  }
  if (nodes.empty()) {
    throw InputError("no node of this Slurm takes work: see sinfo");
  }
  return nodes;
}

/// Answers of every node, or of this machine twice: lines "HOST PROGRAM HASH".
std::string said_by_all(const SweepOptions& options, const Sweep& sweep) {
  const std::string program = std::filesystem::read_symlink("/proc/self/exe").string();
  const std::vector<std::string> task = {program,   "sweep",
                                         "check",   std::filesystem::absolute(sweep.folder).string(),
                                         "--index", std::to_string(options.index.value_or(0)),
                                         "--here"};
  if (!options.slurm) {
    return output_of(task) + output_of(task);
  }
  const std::set<std::string> nodes = nodes_of_slurm();
  std::vector<std::string> command = {
      "srun", "--nodes=" + std::to_string(nodes.size()), "--ntasks-per-node=1",
      "--nodelist=" + joined(std::vector<std::string>(nodes.begin(), nodes.end()), ","),
      "--mem=" + options.memory};
  command.insert(command.end(), task.begin(), task.end());
  return output_of(command);
}

int check(const SweepOptions& options, const Sweep& sweep) {
  const std::size_t run = options.index.value_or(0);
  if (options.here) {
    fmt::print("{} {} {}\n", host_name(), program_hash(), hash_of_run(sweep, run));
    return 0;
  }
  std::istringstream lines(said_by_all(options, sweep));
  std::set<std::string> programs, hashes;
  std::size_t answers = 0;
  for (std::string host, program, hash; lines >> host >> program >> hash; ++answers) {
    fmt::print("{:<20} program {}  state {}\n", host, program, hash);
    programs.insert(program);
    hashes.insert(hash);
  }
  if (programs.size() != 1 || hashes.size() != 1) {
    throw InputError(fmt::format("run {} ends in {} and was made by {}, expected one of each on every node",
                                 run, counted(hashes.size(), "state"), counted(programs.size(), "program")));
  }
  fmt::print("the same bits {} times\n", answers);
  return 0;
}

}  // namespace

int run_on_farm(const SweepOptions& options) {
  const Sweep sweep = read_sweep(options.folder);
  const FarmSettings settings = {options.chunk.value_or(usual_chunk(sweep.runs())), options.memory,
                                 options.sbatch};
  switch (options.action) {
    case SweepAction::submit:
      return submit(options, sweep, settings);
    case SweepAction::write:
      return write_script(options, sweep, settings);
    default:
      return check(options, sweep);
  }
}

}  // namespace taut::app
