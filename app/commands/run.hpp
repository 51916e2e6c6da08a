#pragma once

#include "app/base/files.hpp"
#include "app/base/progress.hpp"
#include "app/caches/frame_sink.hpp"
#include "app/commands/options.hpp"
#include "app/frame_loop.hpp"
#include "app/output/frame_verifier.hpp"
#include "app/output/run_report.hpp"

namespace taut::app {

/// The run of a command, in this order: a scene, its outputs, its garment, its start, its frames.
struct SceneRun {
  /// Reads the bodies. Guesses and repairs go to `remarks`; null: nowhere. Throws as
  /// load_bodies().
  SceneRun(const RunOptions& options, DrawnScene asked, std::FILE* remarks);

  /// Requires, before anything is simulated, that all outputs can be written and none of them is an input: the statistics,
  /// what is exported and `others`, which the command writes itself. Other programs are kept from `claimed`, names or
  /// patterns of these. load() requires it again of what the garment's file names. Throws InputError, UsageError.
  void require_outputs(const ExportSettings& settings, std::vector<std::filesystem::path> others,
                       std::vector<std::filesystem::path> claimed);
  /// Reads the garment, puts it where it begins and makes the simulation; does `meanwhile` at the same time.
  void load(const std::function<void()>& meanwhile = {});
  /// Puts the simulation where the scene begins, which it verifies. Returns that frame.
  int begin();
  /// Begins the file of --stats, or goes on behind a frame.
  void open_statistics(const RunDescription& description, std::optional<int> last_kept);
  /// Simulates up to this frame. Of a run that ends early everything is kept. A frame that is blocked ends it
  /// as end_blocked() does.
  std::vector<FrameRecord> go(int last_frame, const std::string& pattern, OffscreenRenderer* offscreen);
  /// Says what was exported.
  std::string finish_shapes() { return shapes ? shapes->finish() + '\n' : ""; }

  const RunOptions& options;
  std::FILE* remarks;
  DrawnScene scene;
  Progress progress;
  LoadedGarment loaded;
  std::optional<sim::Simulation> simulation;
  FrameVerifier verifier;
  std::optional<StatisticsFile> statistics;
  std::unique_ptr<FrameSink> shapes;
  FrameOutputs outputs;
  std::vector<std::filesystem::path> files_written;  ///< from require_outputs()
  std::vector<OutputClaim> claims;
  bool is_told = true;           ///< says what it writes
  std::function<void()> keep{};  ///< called where it ends early
};

/// Ends a run with what blocked its last frame: writes a picture of the frame before to a file of a new name
/// and throws PromiseBroken, which names both. `pattern` is where the run's files go: the picture goes beside
/// them where each frame has its own, or else into the working folder. Without a picture the message says
/// why. Null: OpenGL is started for it.
[[noreturn]] void end_blocked(const FrameBlocked& error, const DrawnScene& scene, const sim::Simulation& simulation,
                              const std::string& pattern, OffscreenRenderer* offscreen = nullptr);

}  // namespace taut::app
