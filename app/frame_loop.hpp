#pragma once

#include <condition_variable>
#include <mutex>

#include "app/base/errors.hpp"
#include "app/runs/frame_record.hpp"
#include "renderer/page/png.hpp"

namespace taut::app {

/// A queue of limited length between two threads. A push into a full queue waits, so the faster thread never gets far
/// ahead.
template <class T> class BoundedQueue {
 public:
  explicit BoundedQueue(std::size_t capacity) : capacity_(capacity) {}

  /// Waits until there is space. Returns false if the queue is closed; the writer may then stop.
  bool push(T item) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return items_.size() < capacity_ || closed_; });
    if (closed_) return false;
    items_.push_back(std::move(item));
    changed_.notify_all();
    return true;
  }

  /// Waits for an item. Returns nothing once the queue is closed and all items were taken.
  std::optional<T> pop() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return !items_.empty() || closed_; });
    if (items_.empty()) return std::nullopt;
    std::optional<T> item(std::move(items_.front()));
    items_.pop_front();
    changed_.notify_all();
    return item;
  }

  /// Says that the writer has no more items, or that the reader takes no more.
  void close() {
    const std::scoped_lock lock(mutex_);
    closed_ = true;
    changed_.notify_all();
  }

 private:
  const std::size_t capacity_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<T> items_;
  bool closed_ = false;
};

/// A frame between two stages.
struct FrameInWork {
  FrameRecord record;
  std::vector<sim::Vec3> positions;  ///< metres, per vertex; empty if the frame is not drawn
  std::vector<sim::Vec3> shown_m;    ///< positions of the drawn vertices (FrameOutputs::show); empty: `positions`
  renderer::Image picture;
  std::string broken;  ///< message about the promise that the frame breaks; empty: none
};

/// The work on one frame, in this order.
struct FrameStages {
  std::function<std::optional<FrameInWork>()> simulate;  ///< returns the next frame; empty after the last
  std::function<void(FrameInWork&)> draw;
  std::function<void(FrameInWork&)> write;
};

/// Simulates all frames, passes them to `gathered`, then draws and writes them in order. If the simulation fails or is
/// interrupted, the frames before are drawn and written, then its exception is thrown; none is for ModelOverstretched.
/// Other stages throw as in run_overlapped.
void run_simulation_first(const FrameStages& stages, const std::function<void(std::span<const FrameInWork>)>& gathered);

/// Finishes all stages of a frame before it begins the next frame.
void run_in_turn(const FrameStages& stages);

/// Runs each stage on its own thread. Frames and their order are the same as in run_in_turn, but the run takes only as
/// long as its slowest stage. Drawing stays on the calling thread, which has the OpenGL context.
///
/// If a stage throws, no new frame begins. Frames that had passed this stage are still finished. Then the exception is
/// thrown from here; if several stages threw, the exception of the earliest frame.
void run_overlapped(const FrameStages& stages);

/// A frame cannot be made without a crossing (sim::ContactBlocked). The simulation stays at the frame before.
struct FrameBlocked : PromiseBroken {
  FrameBlocked(int blocked_frame, const sim::ContactBlocked& error);

  int frame;
  sim::BlockedContact blocked;
};

/// Receivers of the frames of a run. Every member may be left empty.
struct FrameOutputs {
  std::span<const int> pictures;  ///< numbers of the frames to draw, ascending
  int start_frame = 0;            ///< frame that the simulation is at
  bool with_start = false;        ///< also hands out the start frame, even if it is not drawn
  Measured measured = Measured::all;
  /// Called on the thread that called run_frames.
  std::function<renderer::Image(const FrameInWork&)> draw;
  /// Called in the order of frames, as is `report`, but not always on the caller's thread. The record lacks only
  /// `encode_ms`.
  std::function<void(const FrameRecord&, const renderer::Image&)> write_frame;
  /// Returns the positions of what is drawn and written in place of the simulated vertices, in m; empty: theirs. Called
  /// once for every frame that keeps its promises.
  std::function<std::vector<sim::Vec3>(std::span<const sim::Vec3> positions_m)> show;
  /// Called while the simulation waits.
  std::function<void(int frame, const sim::Simulation&, const std::vector<sim::Vec3>& shown_m)> write_shape;
  std::function<void(const FrameRecord&)> report;
  /// Called first, also for a start frame that is not handed out. Returns a message about the promise that the frame
  /// breaks; empty: none. A frame that breaks a promise is reported, but neither drawn nor written.
  std::function<std::string(const sim::Simulation&, FrameRecord&)> verify;
  /// If set, all frames are simulated before the first is drawn, then this is called with them on the caller's thread.
  /// Frames that are not drawn have no positions.
  std::function<void(std::span<const FrameInWork>)> before_drawing;
  /// Called on the simulating thread for every frame, before it is drawn.
  std::function<void(const FrameRecord&)> simulated;
  /// Simulates later frames while earlier ones are drawn and written. The outputs are the same.
  bool overlap = true;
};

/// Simulates the frames from the start frame to `last_frame`. Frame 0 is the cloth as modelled; frame n is n / frame
/// rate seconds later. Returns the measurements of these frames, and of the start frame if it is handed out. Throws
/// sim::Diverged, FrameBlocked, Interrupted and the exceptions of the outputs, and PromiseBroken after the report of a
/// frame that failed verification. The pictures written before are complete. An interrupted run without overlap has
/// handed out every frame that it simulated.
std::vector<FrameRecord> run_frames(sim::Simulation& simulation, int last_frame, const FrameOutputs& outputs);

}  // namespace taut::app
