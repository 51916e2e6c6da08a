#pragma once

#include "app/drawing/drawn_scene.hpp"

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

}  // namespace taut::app
