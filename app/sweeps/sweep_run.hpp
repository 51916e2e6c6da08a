#pragma once

#include "app/base/child_process.hpp"
#include "app/base/job_runner.hpp"
#include "app/drawing/drawn_scene.hpp"
#include "renderer/page/png.hpp"

namespace taut::app {

/// One key of the scene and the values that it takes.
struct SweepAxis {
  std::string key;
  std::vector<Json> values;        ///< files by their names in the sweep's folder
  std::vector<std::string> where;  ///< per value, its place for messages
};

/// All runs of a scene with every combination of values. Run i has the values that counting from 0 to i
/// ends with, where the last axis counts fastest. In its folder: sweep.json and scene.toml say what it is,
/// inputs/HASH/ holds the files that it names, manifest a line of JSON for each run, runs/ the results.
struct Sweep {
  std::filesystem::path folder;
  std::string scene_name;
  std::string scene_text;  ///< what all runs share, as a scene file; files as in the axes
  bool pictures = false;   ///< every run draws its last frame
  std::vector<SweepAxis> axes;
  std::string program;  ///< hash of the program that the runs are to be made by

  std::size_t runs() const;
  /// For each axis which of its values a run has.
  std::vector<std::size_t> choice(std::size_t run) const;
  const Json& value(std::size_t run, std::size_t axis) const { return axes[axis].values[choice(run)[axis]]; }
  /// An object: the keys and the values of a run.
  Json values(std::size_t run) const;
  /// The same as one line for people: "wind.speed = 10, garment.file = tshirt_1028".
  std::string describe(std::size_t run) const;
  /// A hash of all that the scene of a run says, its files' bytes included. It stays when the folder is
  /// moved.
  std::string scene_hash(std::size_t run) const;
  /// Throws InputError that names the value where the run's scene cannot be.
  DrawnScene scene(std::size_t run) const;

  /// The file of a run: "runs/012/012345.json" in the sweep's folder. No folder holds those of more runs
  /// than shard_runs.
  std::filesystem::path file(std::size_t run, const char* ending) const;
};

/// How many runs share a folder.
inline constexpr std::size_t shard_runs = 1000;
/// The most runs of a sweep.
inline constexpr std::size_t most_runs = 1000000;

/// Reads the sweep in a folder. Throws InputError.
Sweep read_sweep(const std::filesystem::path& folder);

/// The content of sweep.json, with `program` or without it.
std::string sweep_text(const Sweep& sweep, bool with_program = true);

/// A value for people: a file by its name without folder and ending.
std::string value_label(const Json& value);

/// The name of a folder, from the sweep's, that holds copies of files.
inline constexpr const char* inputs_folder = "inputs/";

/// The hash of this program's file. Throws InputError if it cannot be read.
std::string program_hash();

/// As sixteen digits.
std::string hash_text(std::uint64_t hash);

/// A sweep as a study asks for it, and the files that have to be copied into its folder.
struct PlannedSweep {
  Sweep sweep;
  /// From where, and to where in the sweep's folder.
  std::vector<std::pair<std::filesystem::path, std::filesystem::path>> copies;
};

/// Reads a study (TOML): `scene`, as the argument SCENE of other commands, or relative to the study;
/// optionally `frames` and `pictures`; and [axes], keys of scenes with lists of values. Checks the scene of
/// every run. Throws InputError that names file, line and key.
PlannedSweep plan_sweep(const std::filesystem::path& study, const std::filesystem::path& folder);

/// Writes the folder of a sweep, sweep.json last. Returns false if all was there already; a sweep that was
/// planned for another program then goes on with this one. Throws InputError if the folder holds another
/// sweep.
bool write_sweep(const PlannedSweep& planned);

/// How an attempt at a run ended. The first three are results that were written.
enum class AttemptEnd {
  done,
  broken,   ///< a promise was not kept
  failed,   ///< it could not be run
  stopped,  ///< by a signal; it goes on from its checkpoint
  busy,     ///< another process works on it
};

/// An attempt at a run.
struct Attempt {
  AttemptEnd end = AttemptEnd::done;
  std::string what;    ///< what was broken, what failed or who works on it
  bool is_new = true;  ///< false: the result was there already
};

/// Makes one run of a sweep and writes its result, unless that is there, going on from where an earlier
/// attempt stopped. Safe beside other processes that do the same. Throws InputError where a result cannot be
/// written, and what `report` throws.
Attempt attempt_run(const Sweep& sweep, std::size_t run, const ProgressCallback& report = {});

/// The exit code of the program for several attempts: 75 if one has to be tried again, else 1 if one failed,
/// else 3 if one is broken.
class WorstEnd {
 public:
  void add(AttemptEnd end);
  int exit_code() const { return code_; }

 private:
  int code_ = 0;
};

/// Throws InputError unless this is the program that the sweep was planned for.
void require_planned_program(const Sweep& sweep);

/// A file that says who works on a run and is locked meanwhile, so that others leave it alone. The lock ends with its
/// process, however that ends. It saves work and nothing depends on it: results are the same whoever makes them, and
/// are renamed into place.
class RunLock {
 public:
  /// Tries to take the lock. Throws InputError if the file cannot be written.
  explicit RunLock(std::filesystem::path file);
  ~RunLock();
  RunLock(const RunLock&) = delete;
  RunLock& operator=(const RunLock&) = delete;

  bool is_held() const { return is_held_; }
  /// Who has it: "HOST PROCESS".
  const std::string& owner() const { return owner_; }
  /// Whether a process holds the lock of this file.
  static bool is_anybodys(const std::filesystem::path& file);

 private:
  std::filesystem::path file_;
  Descriptor descriptor_;
  std::string owner_;
  bool is_held_ = false;
};

/// Returns the result of a run: the JSON object of its file. Empty if there is none, or one of another scene
/// or program than planned.
std::optional<Json> result_of(const Sweep& sweep, std::size_t run);

/// Whether a run came to an end that another attempt would come to as well: "done" or "broken".
bool is_final(const Json& result);

/// How the runs of a sweep stand.
struct SweepStatus {
  std::size_t done = 0;
  std::size_t broken = 0;            ///< a promise was not kept, which is a result
  std::size_t failed = 0;            ///< could not be run, such as for want of memory
  std::size_t working = 0;           ///< have a lock
  std::size_t stopped = 0;           ///< have a checkpoint to go on from, and no lock
  std::vector<std::size_t> missing;  ///< all without a result that is final, ascending
  std::string first_failure;         ///< empty: none
};
SweepStatus status_of(const Sweep& sweep);

/// Ascending numbers as ranges: "3,7-12".
std::string ranges_text(std::span<const std::size_t> numbers);

/// The results of a sweep as a table (CSV): a row for each run, those without a result too, and a column for
/// each axis and each measure.
std::string sweep_table(const Sweep& sweep);

/// The most pictures on a contact sheet.
inline constexpr std::size_t most_on_sheet = 120;

/// The pictures of the runs, small, under the values that differ; of many, some at equal distances. One
/// column for each value of the last axis that has several. Returns an image of no size if there are none.
renderer::Image sweep_sheet(const Sweep& sweep);

}  // namespace taut::app
