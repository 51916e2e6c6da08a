#pragma once

#include "app/base/files.hpp"
#include "app/base/progress.hpp"
#include "app/caches/frame_sink.hpp"
#include "app/commands/options.hpp"
#include "app/frame_loop.hpp"
#include "app/garments/dressing/dressing.hpp"
#include "app/models/mending/model_fitting.hpp"
#include "app/output/run_report.hpp"
#include "app/runs/frame_verifier.hpp"

namespace taut::app {

/// A command's run. Call its functions in order: they prepare the scene, outputs, garment, start and frames.
struct SceneRun {
  /// Reads the bodies. Writes guesses and repairs to `remarks`; null: nowhere. Throws as load_bodies().
  /// `why_not_model`: reason to show the simulated mesh, the message of ModelOverstretched with which an earlier run
  /// ended; empty: the model is shown.
  SceneRun(const RunOptions& options, DrawnScene asked, std::FILE* remarks, std::string why_not_model = "");

  /// Checks, before anything is simulated, that all outputs can be written and that none is an input: the statistics,
  /// the export and `others`, which the command writes itself. Claims the names or patterns `claimed`, so that other
  /// programs cannot write them. load() repeats the check with the files that the garment's file names. Throws
  /// InputError, UsageError.
  void require_outputs(const ExportSettings& settings, std::vector<std::filesystem::path> others,
                       std::vector<std::filesystem::path> claimed);
  /// Reads the garment, moves it to its start and makes the simulation. Calls `meanwhile` while the garment is read.
  void load(const std::function<void()>& meanwhile = {});
  /// Moves the simulation to the scene's start frame, verifies it and returns its number.
  int begin();
  /// Opens the file of --stats, or continues it after the frame `last_kept`.
  void open_statistics(const RunDescription& description, std::optional<int> last_kept);
  /// Simulates up to this frame. A run that ends early keeps its outputs. A blocked frame ends the run by
  /// end_blocked(). Throws ModelOverstretched if a model is shown or written that should not be.
  std::vector<FrameRecord> go(int last_frame, const std::string& pattern, OffscreenRenderer* offscreen);
  /// Returns a line for people about the model that follows or the mesh in its place; empty without such a model.
  std::string describe_shown() const;
  /// Completes the export and returns a message about it.
  std::string finish_shapes() { return shapes ? shapes->finish() + '\n' : ""; }

  const RunOptions& options;
  std::FILE* remarks;
  std::string why_not_model;  ///< reason to show the simulated mesh; empty: the model is shown
  DrawnScene scene;
  Progress progress;
  LoadedBodies bodies;
  LoadedGarment loaded;
  std::optional<sim::Simulation> simulation;
  FrameVerifier verifier;
  FollowingSummary following;
  std::optional<StatisticsFile> statistics;
  std::unique_ptr<FrameSink> shapes;
  FrameOutputs outputs;
  std::vector<std::filesystem::path> files_written;  ///< set by require_outputs()
  std::vector<OutputClaim> claims;
  bool prints_messages = true;           ///< prints messages about its outputs
  bool may_reject_model = true;          ///< lets go() throw ModelOverstretched
  std::function<void()> on_early_end{};  ///< called when the run ends early
};

/// Runs a command, and runs it again with the reason if the model cannot be shown (ModelOverstretched). Returns
/// its exit code.
int run_showing_what_fits(const std::function<int(const std::string& why_not_model)>& run);

/// Ends a run whose last frame was blocked: writes a picture of the frame before to a new file and throws PromiseBroken
/// that names both. The picture goes beside the files of `pattern` if each frame has its own file, otherwise into the
/// working folder. If there is no picture, the message says why. With a null `offscreen`, OpenGL is started.
[[noreturn]] void end_blocked(const FrameBlocked& error, const DrawnScene& scene, const sim::Simulation& simulation,
                              const std::string& pattern, OffscreenRenderer* offscreen = nullptr);

}  // namespace taut::app
