#pragma once

#include <filesystem>
#include <utility>
#include <vector>

#include "app/sweeps/sweep.hpp"

namespace taut::app {

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
