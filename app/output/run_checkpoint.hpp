#pragma once

#include <filesystem>
#include <string>

#include "app/output/frame_record.hpp"
#include "app/scene/scene.hpp"
#include "sim/simulation.hpp"

namespace taut::app {

/// A run at the end of a frame, as a file holds it: `--checkpoint` and the window write it, `--resume` and
/// start.checkpoint go on from it.
struct RunCheckpoint {
  std::string scene_name;
  std::string scene;  ///< as a scene file, with every key
  int frame = 0;
  RunSummary summary;      ///< of the frames up to this one
  std::string simulation;  ///< sim::encode
};

/// Leaves the file as it was, or writes all of it. Throws InputError.
void write_run_checkpoint(const std::filesystem::path& file, const RunCheckpoint& checkpoint);

/// Throws InputError, which says where, what was found and what was expected.
RunCheckpoint read_run_checkpoint(const std::filesystem::path& file);

/// Throws InputError with both names and the first key that differs, unless the texts say the same. The name
/// of the garment's file may differ: what it holds is checked by `restore`.
void require_same_scene(const std::filesystem::path& file, const RunCheckpoint& checkpoint,
                        const std::string& scene_name, const std::string& scene);

/// Throws InputError where it was saved of another garment or another solver; nothing has changed then.
void restore(const std::filesystem::path& file, const RunCheckpoint& checkpoint, sim::Simulation& simulation);

/// Puts the simulation where start.checkpoint of its scene says. Returns which frame that is; 0, and nothing
/// is done, where the scene begins with the garment as modelled. Throws InputError.
int go_to_start(const Scene& scene, sim::Simulation& simulation);

}  // namespace taut::app
