#pragma once

#include <condition_variable>
#include <mutex>

#include "app/base/errors.hpp"
#include "app/output/frame_record.hpp"
#include "renderer/page/png.hpp"

namespace taut::app {

/// A queue of limited length from one thread to another. A push into a full queue waits, so the faster thread
/// never gets far ahead.
template <class T> class BoundedQueue {
 public:
  explicit BoundedQueue(std::size_t capacity) : capacity_(capacity) {}

  /// Waits until there is room. Returns false if the reader has called `abandon`; then the writer may stop.
  bool push(T item) {
    std::unique_lock lock(mutex_);
    room_.wait(lock, [this] { return items_.size() < capacity_ || abandoned_; });
    if (abandoned_) return false;
    items_.push_back(std::move(item));
    filled_.notify_one();
    return true;
  }

  /// Waits for an item. Empty if the writer has called `close` and all items were taken.
  std::optional<T> pop() {
    std::unique_lock lock(mutex_);
    filled_.wait(lock, [this] { return !items_.empty() || closed_; });
    if (items_.empty()) return std::nullopt;
    std::optional<T> item(std::move(items_.front()));
    items_.pop_front();
    room_.notify_one();
    return item;
  }

  /// The writer has no more items.
  void close() {
    const std::scoped_lock lock(mutex_);
    closed_ = true;
    filled_.notify_all();
  }

  /// The reader takes no more items.
  void abandon() {
    const std::scoped_lock lock(mutex_);
    abandoned_ = true;
    room_.notify_all();
  }

 private:
  const std::size_t capacity_;
  std::mutex mutex_;
  std::condition_variable room_;
  std::condition_variable filled_;
  std::deque<T> items_;
  bool closed_ = false;
  bool abandoned_ = false;
};

/// A frame between two stages.
struct FrameInWork {
  FrameRecord record;
  std::vector<sim::Vec3> positions;  ///< in metres, per vertex; empty if the frame is not drawn
  renderer::Image picture;
  std::string broken;  ///< the promise that the frame does not keep; empty: none
};

/// The work on one frame, in this order.
struct FrameStages {
  std::function<std::optional<FrameInWork>()> simulate;  ///< returns the next frame; empty after the last
  std::function<void(FrameInWork&)> draw;
  std::function<void(FrameInWork&)> write;
};

/// Simulates all frames, hands them to `gathered`, and then draws and writes them in their order. Of a
/// simulation that fails or is interrupted the frames before are drawn and written, then its exception is thrown.
/// Errors of the other stages are as in run_overlapped.
void run_gathered(const FrameStages& stages, const std::function<void(std::span<const FrameInWork>)>& gathered);

/// Does all stages of a frame before it begins the next frame.
void run_in_turn(const FrameStages& stages);

/// Same frames in the same order, but each stage has its own thread. So the run takes as long as its slowest
/// stage, not as long as all stages together. Drawing stays on the calling thread, which has the OpenGL
/// context.
///
/// If a stage throws, no new frame begins. Frames that had passed this stage are still finished, as in
/// run_in_turn. Then the exception is thrown from here; of several, the one of the earliest frame.
void run_overlapped(const FrameStages& stages);

/// A frame could not be made without a crossing (sim::ContactBlocked). The simulation is where it was before.
struct FrameBlocked : PromiseBroken {
  FrameBlocked(int blocked_frame, const sim::ContactBlocked& error);

  int frame;
  sim::BlockedContact blocked;
};

/// Receivers of the frames of a run. Every member may be left empty.
struct FrameOutputs {
  std::span<const int> pictures;  ///< numbers of the frames to draw, ascending
  int start_frame = 0;            ///< frame the simulation is at
  bool with_start = false;        ///< also hands out the start frame, drawn or not
  Measured measured = Measured::all;
  /// Called on the thread that called run_frames.
  std::function<renderer::Image(const std::vector<sim::Vec3>& positions, double time_s)> draw_positions;
  /// This and report are called frame after frame, but not always on the caller's thread. The record lacks
  /// only `encode_ms`.
  std::function<void(const FrameRecord&, const renderer::Image&)> write_frame;
  std::function<void(int frame, const sim::Simulation&)> write_shape;  ///< called while the simulation waits
  std::function<void(const FrameRecord&)> report;
  /// Called first of all, for the start frame too, handed out or not. Returns what promise the frame breaks;
  /// empty: none. A frame that breaks one is reported, but neither drawn nor written.
  std::function<std::string(const sim::Simulation&, FrameRecord&)> verify;
  /// If set, all frames are simulated before the first is drawn, and handed to this in between; positions are
  /// empty of frames that are not drawn. Called on the caller's thread.
  std::function<void(std::span<const FrameInWork>)> before_drawing;
  /// Called on the simulating thread for every frame, before it is drawn.
  std::function<void(const FrameRecord&)> simulated;
  /// Later frames are simulated while earlier ones are drawn and written; never changes what comes out.
  bool overlap = true;
};

/// Simulates the frames after the start frame up to `last_frame`; frame n is the cloth n / frame rate seconds
/// after the clock started, frame 0 the cloth as it was modelled. Returns what was
/// measured of these, and of the start frame where that is drawn or asked for. Throws sim::Diverged,
/// FrameBlocked, PromiseBroken after the report of a frame that was not verified, Interrupted and what the
/// outputs throw; the pictures written before are complete. Without overlap, an interrupted run has handed
/// out every frame that it has simulated.
std::vector<FrameRecord> run_frames(sim::Simulation& simulation, int last_frame, const FrameOutputs& outputs);

}  // namespace taut::app
