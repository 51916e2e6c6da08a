#pragma once

#include <memory>
#include <string>

#include "sim/contact/bodies.hpp"

namespace taut::app {

/// Where a motion that repeats goes on after its last frame.
struct LoopBegin {
  std::size_t frame = 0;
  double furthest_m = 0.0;  ///< that a vertex is from where it is in the last frame
  bool meets = false;       ///< within 1 mm: the last frame is this one again
};

/// Returns the earliest frame at which every vertex is within 1 mm of where it is in the last one, so that
/// what leads into a motion is not repeated. It is looked for in the first half and the first two seconds; if
/// there is none, the first frame is returned. Throws what the motion throws.
LoopBegin find_loop_begin(const sim::BodyFrames& motion, std::size_t vertices);

/// How a motion that repeats goes on, for people.
std::string describe(const LoopBegin& begin);

/// Returns the motion from the frame `first` on, and again from `begin` on without end. Throws InputError if
/// a vertex goes further from the last frame to the begin than it may in a frame (PlacedFrames).
std::shared_ptr<const sim::BodyFrames> looped(std::shared_ptr<const sim::BodyFrames> motion,
                                              const LoopBegin& begin, std::size_t first);

}  // namespace taut::app
