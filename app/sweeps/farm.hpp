#pragma once

#include "app/sweeps/sweep.hpp"

namespace taut::app {

/// How the runs of a sweep are cut into tasks, which start this program with --task.
struct FarmSettings {
  std::size_t chunk = 1;            ///< runs of a task
  std::string memory;               ///< of a task, as Slurm has it: "2G"
  std::vector<std::string> sbatch;  ///< more options of the array, such as --time=60
};

/// One array of Slurm.
struct ArrayJob {
  std::size_t offset = 0;  ///< what the script adds to the number of an array's task
  std::string tasks;       ///< ranges for --array
};

/// The tasks that have to be started so that all `missing` runs are made, in arrays whose numbers stay below
/// `max_array_size`.
std::vector<ArrayJob> array_jobs(std::span<const std::size_t> missing, std::size_t chunk, std::size_t max_array_size);

/// So few runs for a task that there are at most 10000 tasks, which is as many jobs as Slurm keeps unless it
/// is told otherwise.
std::size_t usual_chunk(std::size_t runs);

/// The script of an array, whose argument is its offset. Its log, which all of its tasks write to, is in
/// slurm/ of the sweep's folder.
std::string slurm_script(const Sweep& sweep, const FarmSettings& settings);

/// The script of the job that makes the table.
std::string merge_script(const Sweep& sweep);

/// Runs a program and returns what it prints. Throws InputError if there is no such program or it fails.
std::string output_of(const std::vector<std::string>& command);

}  // namespace taut::app
