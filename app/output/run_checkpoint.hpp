#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "app/output/frame_record.hpp"
#include "app/scene/scene.hpp"
#include "sim/simulation.hpp"

namespace taut::app {

/// A run at the end of a frame, as stored in a file. The option --checkpoint and the window write it. The
/// option --resume and the key start.checkpoint continue from it.
struct RunCheckpoint {
  std::string scene_name;
  std::string scene;  ///< as a scene file, with every key
  int frame = 0;
  RunSummary summary;      ///< of the frames up to this one
  std::string simulation;  ///< bytes from sim::encode
};

/// Writes the file completely or leaves it as it was. Throws InputError.
void write_run_checkpoint(const std::filesystem::path& file, const RunCheckpoint& checkpoint);

/// The bytes of that file.
std::string bytes_of(const RunCheckpoint& checkpoint);

/// Throws InputError that names where, what was found and what was expected.
RunCheckpoint run_checkpoint_of(std::string_view bytes, const std::filesystem::path& file);
RunCheckpoint read_run_checkpoint(const std::filesystem::path& file);

/// Throws InputError if the checkpoint was saved of another scene, with both names and the first key that
/// differs. The name of the garment's file may differ, because `restore` checks its content.
void require_same_scene(const std::filesystem::path& file, const RunCheckpoint& checkpoint,
                        const std::string& scene_name, const std::string& scene);

/// Puts the simulation into the saved state. Throws InputError if that belongs to another garment or another
/// solver; the simulation is then unchanged.
void restore(const std::filesystem::path& file, const RunCheckpoint& checkpoint, sim::Simulation& simulation);

}  // namespace taut::app
