#pragma once

#include "app/models/garment_loading.hpp"
#include "app/output/frame_record.hpp"

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

/// Simulates the frames before 0 s in which the scene's bodies grow into the clothes (dressing.hpp), without
/// gravity and wind, and ends with the clock at 0 s. Throws PromiseBroken if a frame cannot be made without a
/// crossing, or if several in a row break the bound where the scene does not accept that; Diverged;
/// Interrupted. `begin` is told each frame.
void dress(const Scene& scene, sim::Simulation& simulation, const StageReport& begin = {});

/// Puts the simulation into the state that start.checkpoint of its scene names. Returns the number of that
/// frame. Without start.checkpoint it dresses the scene's bodies and returns 0. Throws InputError, also for a
/// garment that is too small by its girths alone (require_wearable()), and as dress() does, and PromiseBroken
/// if the garment crosses a body then and the solver would keep them apart; the message says where the
/// garment is too small (app/bodies/fit.hpp).
int go_to_start(const Scene& scene, sim::Simulation& simulation, const StageReport& begin = {});

/// Returns that frame, and goes nowhere. Throws InputError where the checkpoint cannot be read.
int start_frame(const Scene& scene);

}  // namespace taut::app
