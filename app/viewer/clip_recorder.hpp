#pragma once

#include <exception>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>

#include "app/caches/frame_sink.hpp"
#include "app/frame_pipeline.hpp"
#include "app/viewer/simulation/simulation_host.hpp"
#include "app/viewer/state/viewer_state.hpp"

namespace taut::app {

/// Writes every frame that is simulated, once and in order, for other programs. It writes on a thread of its
/// own; frames that wait for it are those that the window can look back on anyway.
class ClipRecorder {
 public:
  /// Begins with the frame of `first`. The file has the name of the scene and is in a new folder, with the
  /// name of free_name(). Throws as require_export() and open_sink() do.
  ClipRecorder(const std::filesystem::path& folder, ClipFormat format, const SnapshotPtr& first);
  /// Leaves nothing that is not complete.
  ~ClipRecorder();
  ClipRecorder(const ClipRecorder&) = delete;
  ClipRecorder& operator=(const ClipRecorder&) = delete;

  /// Takes the frames that led to `newest`. Returns why the clip ends here, to be appended to what finish()
  /// returns; empty: it goes on. Throws InputError if a frame could not be written.
  std::string follow(const SnapshotPtr& newest, SimulationHost& simulation);
  /// Takes the frames that still wait and completes what was written. Returns what that is, for people.
  /// Throws InputError.
  std::string finish(SimulationHost& simulation);

  /// Where the newest frame goes.
  std::filesystem::path file() const;
  int frames() const { return newest_->record.frame - frames_.first + 1; }

 private:
  bool leads_on(const Snapshot& newest) const;
  bool take(SimulationHost& simulation, bool waits);
  void write();
  void rethrow();

  SnapshotPtr first_;
  SnapshotPtr newest_;  ///< of those that `first_` led to
  std::filesystem::path file_;
  FrameRange frames_;                ///< that it can hold
  int next_;                         ///< frame to be taken
  std::unique_ptr<FrameSink> sink_;  ///< of the thread until it has ended
  BoundedQueue<SnapshotPtr> queue_;
  std::exception_ptr failure_;  ///< of the thread
  std::thread thread_;
};

}  // namespace taut::app
