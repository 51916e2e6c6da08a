#pragma once

#include "app/base/job_runner.hpp"
#include "app/scene/scene_key.hpp"

namespace taut::app {

/// A run of a sweep as it was planned.
struct PlannedRun {
  Json values;       ///< an object: the keys of the axes with the values of this run
  std::string hash;  ///< of its scene and of the content of the files that this names
};

/// All runs of a scene with every combination of some values. In its folder, sweep.json says what was planned; of run
/// 12 runs/000012.toml is the scene, 000012.json the result, and 000012.checkpoint the moment where it was stopped.
struct Sweep {
  std::filesystem::path folder;
  std::string program;  ///< hash of the program that makes the runs
  std::vector<PlannedRun> runs;

  std::filesystem::path file(std::size_t run, const char* ending) const;
};

/// The most runs of a sweep.
inline constexpr std::size_t most_runs = 100000;

/// Reads a study (TOML): `scene`, as the argument SCENE of other commands, or relative to the study; optionally
/// `frames`; and [axes], keys of scenes with lists of values, of which the last changes fastest from run to run. Checks
/// the scene of every run and writes the folder, sweep.json last. Planned again, runs whose program or scene has
/// changed count as not made. Throws InputError that names file, line and key, or if the folder holds a sweep of other
/// values.
Sweep plan_sweep(const std::filesystem::path& study, const std::filesystem::path& folder);

/// Reads the sweep in a folder. Throws InputError.
Sweep read_sweep(const std::filesystem::path& folder);

/// Throws InputError unless this is the program that the sweep was planned for.
void require_planned_program(const Sweep& sweep);

/// How an attempt at a run ended, the worse the later. The first three are results that were written.
enum class RunEnd {
  done,
  broken,  ///< a promise was not kept
  failed,  ///< it could not be run
  stopped  ///< by a signal; it goes on from its checkpoint
};

struct Attempt {
  RunEnd end = RunEnd::done;
  std::string reason = {};  ///< what is broken or failed
};

/// Makes a run and writes its result, going on from where an earlier attempt stopped. A result that is done or broken
/// is there already and returned. Throws InputError if the run's scene is not as it was planned or its result cannot be
/// written; what `report` throws.
Attempt attempt_run(const Sweep& sweep, std::size_t run, const ProgressCallback& report = {});

/// The result of a run, the JSON object of its file. Empty if there is none, or one of another scene or program.
std::optional<Json> result_of(const Sweep& sweep, std::size_t run);

/// How the runs of a sweep stand.
struct SweepStatus {
  std::array<std::size_t, 3> ended = {};  ///< runs that are done, broken, failed
  std::vector<std::size_t> missing;       ///< runs that are neither done nor broken, ascending
  std::string first_failure;              ///< empty: none
};
SweepStatus status_of(const Sweep& sweep);

/// Ascending numbers as ranges: "3,7-12".
std::string ranges_text(std::span<const std::size_t> numbers);

/// The results of a sweep as a table (CSV): a row for each run, those without a result too, and a column for each axis
/// and each measure.
std::string sweep_table(const Sweep& sweep);

}  // namespace taut::app
