#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "app/bodies/rig_pose.hpp"
#include "sim/mesh/types.hpp"

namespace taut::app {

/// Where the vertices of a model file are in each frame of a motion, in the model's unit and axes. Frames are
/// computed or read as they are asked for, so that memory does not grow with the length of the motion.
/// Several threads may ask at once, and the same question has the same answer.
class FrameSource {
 public:
  virtual ~FrameSource() = default;

  /// Returns how many frames there are, at least 1.
  virtual std::size_t frames() const = 0;
  /// Returns how many vertices each frame has.
  virtual std::size_t vertices() const = 0;
  /// Returns how many frames there are in a second; empty if the motion does not say.
  virtual std::optional<double> rate_hz() const = 0;
  /// Fills `positions` with where each vertex is in the frame. Requires a frame below frames() and a span
  /// with an entry for each vertex. Throws InputError that names the file if it cannot be read.
  virtual void read(std::size_t frame, std::span<sim::Vec3> positions) const = 0;
  /// Returns the joints in the frame; empty if the motion moves no joints but vertices.
  virtual std::optional<RigPose> pose(std::size_t /*frame*/) const { return std::nullopt; }
};

}  // namespace taut::app
