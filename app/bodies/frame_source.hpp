#pragma once

#include <filesystem>
#include <mutex>

#include "app/bodies/rig_pose.hpp"
#include "app/models/placement.hpp"
#include "sim/contact/bodies.hpp"
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

/// The furthest a vertex goes from one frame to the next, in m. Further, the frames are of something else.
inline constexpr double furthest_in_frame_m = 1.0;

/// How vertices of a file become those of a body.
struct FileVertexPlaces {
  std::vector<std::size_t> file_vertex;  ///< per vertex of the body, the vertex of the file that is meant
  Placement placement;
};

/// The frames of a motion as those of a body in the scene, in m. The last few are remembered, as a simulation
/// asks for the same two again and again. A frame that is remembered beside the one before it or after it was
/// compared with it, so that no two frames in a row are handed out between which a vertex jumps.
class PlacedFrames final : public sim::BodyFrames {
 public:
  /// `motion` is the file's name, for messages. Frames before `first` are left out: requires one that the
  /// source has, and a rate above 0.
  PlacedFrames(std::filesystem::path motion, std::unique_ptr<const FrameSource> source, FileVertexPlaces places,
               double rate_hz, std::size_t first);

  std::size_t count() const override { return source_->frames() - first_; }
  double rate_hz() const override { return rate_hz_; }
  /// Throws InputError that names the file, the frame of the file and the vertex of the file if a position is
  /// not a number or a vertex goes further than a metre from one frame to the next.
  void positions_in(std::size_t frame, std::span<sim::Vec3> positions_m) const override;

 private:
  using Positions = std::shared_ptr<const std::vector<sim::Vec3>>;
  struct Remembered {
    std::size_t frame = 0;
    Positions positions_m = {};
  };

  Positions placed(std::size_t frame) const;
  Positions remembered(std::size_t frame) const;
  Positions read(std::size_t frame) const;
  void require_near(std::size_t frame, const Positions& before_m, const Positions& after_m) const;
  [[noreturn]] void refuse(std::size_t frame, std::size_t vertex, const std::string& reason) const;

  std::filesystem::path motion_;
  std::unique_ptr<const FrameSource> source_;
  FileVertexPlaces places_;
  double rate_hz_;
  std::size_t first_;
  mutable std::mutex mutex_;
  mutable std::vector<Remembered> remembered_;  ///< the newest last
};

}  // namespace taut::app
