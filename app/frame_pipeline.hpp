#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>

#include "app/output/frame_record.hpp"
#include "renderer/page/image.hpp"

namespace taut::app {

/// Hands things from one thread to another, in order, and makes the faster of them wait.
template <class T>
class BoundedQueue {
 public:
  explicit BoundedQueue(std::size_t capacity) : capacity_(capacity) {}

  /// Waits for room. False: nobody takes anything any more, the giver may stop.
  bool push(T item) {
    std::unique_lock lock(mutex_);
    room_.wait(lock, [this] { return items_.size() < capacity_ || abandoned_; });
    if (abandoned_) {
      return false;
    }
    items_.push_back(std::move(item));
    filled_.notify_one();
    return true;
  }

  /// Waits for something to take. Nothing: the giver closed and all was taken.
  std::optional<T> pop() {
    std::unique_lock lock(mutex_);
    filled_.wait(lock, [this] { return !items_.empty() || closed_; });
    if (items_.empty()) {
      return std::nullopt;
    }
    std::optional<T> item(std::move(items_.front()));
    items_.pop_front();
    room_.notify_one();
    return item;
  }

  /// The giver is done.
  void close() {
    const std::scoped_lock lock(mutex_);
    closed_ = true;
    filled_.notify_all();
  }

  /// The taker is done.
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

/// A frame on its way through the stages.
struct FrameInWork {
  FrameRecord record;
  std::vector<sim::Vec3> positions;  ///< empty where the frame is not drawn
  renderer::Image picture;
};

/// What happens to every frame, in this order.
struct FrameStages {
  std::function<std::optional<FrameInWork>()> simulate;  ///< the next frame; nothing: that was all
  std::function<void(FrameInWork&)> draw;
  std::function<void(FrameInWork&)> write;
};

/// Every frame passes all stages before the next one is begun.
void run_in_turn(const FrameStages& stages);

/// The same frames in the same order, but each stage has a thread, so that a sequence takes as long as its
/// slowest stage and not as all of them together. Drawing stays with the calling thread, where the OpenGL
/// context is. When a stage throws, the frames that were past it are still finished, as without overlap, no
/// new ones are begun, and the error comes out here; of several the one of the earliest frame.
void run_overlapped(const FrameStages& stages);

}  // namespace taut::app
