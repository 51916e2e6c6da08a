#pragma once

#include <deque>
#include <vector>

#include "app/viewer/session/session.hpp"

namespace taut::app {

/// Events that wait for a frame of the window. A user interface looks at the pointer, the buttons and the
/// keys once a frame; a click that comes and goes between two frames has to be spread over two.
class InputQueue {
 public:
  void add(SessionEvent event) { waiting_.push_back(std::move(event)); }
  bool empty() const { return waiting_.empty(); }

  /// As many events as one frame can tell apart; a run of moves becomes its last.
  std::vector<SessionEvent> take_frame();

 private:
  std::deque<SessionEvent> waiting_;
};

}  // namespace taut::app
