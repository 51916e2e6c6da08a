#include "app/viewer/clip_recorder.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "app/base/files.hpp"
#include "app/output/output_pattern.hpp"

namespace taut::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_waiting = 8;

fs::path file_in(const fs::path& folder, ClipFormat format, const std::string& scene) {
  constexpr std::array endings = {".pc2", ".mdd", ".glb", ".pvd", "_{frame:04}.obj"};
  return free_name(folder, scene, "-clip") / (scene + endings[static_cast<std::size_t>(format)]);
}

WrittenMoment moment_of(const Snapshot& snapshot) {
  return {*snapshot.garment, *snapshot.checkpoint};
}

// A simulation that goes back or starts again changes it; one that goes on does not.
std::int64_t frames_not_advanced(const Snapshot& snapshot) {
  const std::int64_t failed = snapshot.stopped ? 1 : 0;
  return static_cast<std::int64_t>(snapshot.advances) - snapshot.record.frame - failed;
}

}  // namespace

ClipRecorder::ClipRecorder(const fs::path& folder, ClipFormat format, const SnapshotPtr& first)
    : first_(first),
      newest_(first),
      file_(file_in(folder, format, first->loaded->scene.name)),
      next_(first->record.frame),
      queue_(most_waiting) {
  const DrawnScene& scene = first->loaded->scene;
  frames_ = {next_, next_ + most_frames(file_, *first->loaded) - 1};
  const ExportSettings settings = {file_, frames_, scene.simulation.frame_rate_hz};
  require_export(settings, scene.garment.file);
  sink_ = open_sink(settings, *first->loaded, moment_of(*first));
  thread_ = std::thread([this] { write(); });
}

ClipRecorder::~ClipRecorder() {
  queue_.close();
  if (thread_.joinable()) {
    thread_.join();
  }
}

fs::path ClipRecorder::file() const {
  return OutputPattern(file_, file_.extension()).path_of(newest_->record.frame);
}

bool ClipRecorder::leads_on(const Snapshot& newest) const {
  return newest.loaded == first_->loaded && frames_not_advanced(newest) == frames_not_advanced(*first_);
}

std::string ClipRecorder::follow(const SnapshotPtr& newest, SimulationHost& simulation) {
  const bool goes_on = leads_on(*newest);
  newest_ = goes_on ? newest : newest_;
  if (!take(simulation, false)) {
    return "; it ended as frames could not be written as fast as they were simulated";
  }
  return !goes_on                   ? "; it ended as the simulation began elsewhere"
         : newest->stopped          ? "; it ended as the simulation stopped"
         : !frames_.contains(next_) ? "; it ended as such a file holds no more"
                                    : "";
}

// Returns whether all frames are still there. One that `waits` takes them all.
bool ClipRecorder::take(SimulationHost& simulation, bool waits) {
  const int last = std::min(newest_->record.frame, frames_.last);
  for (; next_ <= last && (waits || queue_.has_room()); ++next_) {
    SnapshotPtr snapshot = simulation.past_frame(newest_, next_);
    if (snapshot->record.frame != next_) {
      return false;
    }
    if (!queue_.push(std::move(snapshot))) {
      rethrow();
    }
  }
  return true;
}

void ClipRecorder::write() {
  try {
    while (const std::optional<SnapshotPtr> snapshot = queue_.pop()) {
      sink_->write((*snapshot)->record.frame, moment_of(**snapshot));
    }
  } catch (...) {
    failure_ = std::current_exception();
    queue_.abandon();
  }
}

// Ends the thread first.
void ClipRecorder::rethrow() {
  queue_.close();
  thread_.join();
  if (failure_) {
    std::rethrow_exception(failure_);
  }
}

std::string ClipRecorder::finish(SimulationHost& simulation) {
  take(simulation, true);
  rethrow();
  return sink_->finish();
}

}  // namespace taut::app
