#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <vector>

#include "app/bodies/frame_source.hpp"
#include "app/models/placement.hpp"
#include "sim/contact/bodies.hpp"

namespace taut::app {

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
  PlacedFrames(std::filesystem::path motion, std::unique_ptr<const FrameSource> source,
               FileVertexPlaces places, double rate_hz, std::size_t first);

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
