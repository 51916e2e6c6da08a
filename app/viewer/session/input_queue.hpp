#pragma once

#include <deque>
#include <vector>

#include "app/viewer/session/session.hpp"

namespace taut::app {

/// Events that wait for the next frame of the window. The user interface reads pointer, buttons and keys once
/// per frame. So a click that begins and ends between two frames has to be split over two frames.
class InputQueue {
 public:
  void add(SessionEvent event) { waiting_.push_back(std::move(event)); }
  bool empty() const { return waiting_.empty(); }

  /// Removes and returns as many events as one frame can tell apart. Of several moves in a row only the last
  /// is kept.
  std::vector<SessionEvent> take_frame();

 private:
  std::deque<SessionEvent> waiting_;
};

}  // namespace taut::app
