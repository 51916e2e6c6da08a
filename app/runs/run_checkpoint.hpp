#pragma once

#include "app/garments/dressing/dressing.hpp"
#include "app/models/garment_loading.hpp"
#include "app/runs/frame_record.hpp"

namespace taut::app {

/// A run at the end of a frame, as stored in a file. The option --checkpoint and the window write it. The option
/// --resume and the key start.checkpoint continue from it.
struct RunCheckpoint {
  std::string scene_name;
  std::string scene;  ///< scene file with every key
  int frame = 0;
  RunSummary summary;      ///< summary of the frames up to this one
  std::string simulation;  ///< bytes from sim::encode
};

/// Writes the file completely or leaves it unchanged. Throws InputError.
void write_run_checkpoint(const std::filesystem::path& file, const RunCheckpoint& checkpoint);

/// Returns the bytes of the file.
std::string to_bytes(const RunCheckpoint& checkpoint);

/// Throw InputError that names the place, the value found and the value expected.
RunCheckpoint parse_run_checkpoint(std::string_view bytes, const std::filesystem::path& file);
RunCheckpoint read_run_checkpoint(const std::filesystem::path& file);

/// Throws InputError if the checkpoint belongs to another scene, with both names and the first key that differs. The
/// name of the garment's file may differ, because `restore` checks its content.
void require_same_scene(const std::filesystem::path& file, const RunCheckpoint& checkpoint,
                        const std::string& scene_name, const std::string& scene);

/// Restores the saved state. Throws InputError, and leaves the simulation unchanged, if the state belongs to another
/// garment or solver.
void restore(const std::filesystem::path& file, const RunCheckpoint& checkpoint, sim::Simulation& simulation);

/// Returns these forces without gravity, its path and the wind.
sim::ExternalForces without_gravity_and_wind(sim::ExternalForces forces);

/// Simulates the frames before 0 s in which the scene's bodies grow into the clothes (dressing.hpp), without gravity
/// and wind, and sets the clock to 0 s. Calls `begin` with each frame. Throws PromiseBroken if a frame cannot be made
/// without a crossing, or if several consecutive frames break a bound that the scene does not allow to exceed. Throws
/// Diverged, Interrupted.
void dress(const Scene& scene, sim::Simulation& simulation, const StageReport& begin = {});

/// Restores the scene's start.checkpoint and returns its frame. Without that key, dresses the scene's bodies and
/// returns 0. Throws InputError, also if the garment's girths are too small for a body (require_wearable()). Throws as
/// dress() does, and PromiseBroken if the dressed garment crosses a body that the solver keeps apart; the message says
/// where the garment is too small (app/garments/dressing/fit.hpp).
int go_to_start(const Scene& scene, const LoadedBodies& bodies, sim::Simulation& simulation,
                const StageReport& begin = {});

/// Returns the frame that go_to_start() would go to. Throws InputError if the checkpoint cannot be read.
int start_frame(const Scene& scene);

}  // namespace taut::app
