#pragma once

#include "app/bodies/frame_source.hpp"
#include "app/library/taut.h"
#include "app/scene/scene.hpp"

namespace taut::library {

/// A body that goes from one shape to another within one frame of the run, each vertex in a straight line.
/// Its frames are counted from 0 s, as those of a file's motion are: the bits are the same.
class WayOfBody final : public sim::BodyFrames {
 public:
  WayOfBody(std::vector<sim::Vec3> from_m, std::vector<sim::Vec3> to_m, double from_s, double rate_hz)
      : from_m_(std::move(from_m)),
        to_m_(std::move(to_m)),
        frame_(static_cast<std::size_t>(std::max(std::round(from_s * rate_hz), 0.0))),
        rate_hz_(rate_hz) {
    // A state that was saved at another rate is between two frames.
    const double off = from_s * rate_hz - static_cast<double>(frame_);
    first_s_ = std::abs(off) > 1e-6 ? off / rate_hz : 0.0;
  }

  std::size_t count() const override { return frame_ + 2; }
  double rate_hz() const override { return rate_hz_; }
  double first_s() const override { return first_s_; }
  void positions_in(std::size_t frame, std::span<sim::Vec3> positions_m) const override {
    const std::vector<sim::Vec3>& shape_m = frame <= frame_ ? from_m_ : to_m_;
    std::ranges::copy(shape_m, positions_m.begin());
  }

 private:
  std::vector<sim::Vec3> from_m_, to_m_;
  std::size_t frame_;  ///< of the run, with which the way begins
  double rate_hz_;
  double first_s_ = 0.0;
};

/// A body that stays in a shape.
class StillBody final : public sim::BodyFrames {
 public:
  explicit StillBody(std::vector<sim::Vec3> shape_m) : shape_m_(std::move(shape_m)) {}

  std::size_t count() const override { return 1; }
  double rate_hz() const override { return 1.0; }
  void positions_in(std::size_t /*frame*/, std::span<sim::Vec3> positions_m) const override {
    std::ranges::copy(shape_m_, positions_m.begin());
  }

 private:
  std::vector<sim::Vec3> shape_m_;
};

/// A mesh of a caller that is a body.
struct LentBody {
  app::FileVertexPlaces places;
  std::size_t vertices = 0;                             ///< that the caller's mesh has
  std::optional<std::vector<sim::Vec3>> target_m = {};  ///< of the next frame, per vertex of the body
};

/// A body of a caller as a scene has it.
struct GivenBody {
  sim::Body body;
  app::BodySource source = {};
  std::shared_ptr<const app::Wearer> wearer = {};  ///< null: it is not dressed
  std::optional<LentBody> lent = {};               ///< empty: a plane
  std::vector<std::string> remarks = {};           ///< what was guessed and repaired
};

/// Takes a body, for a scene with these frames. Throws ArgumentError, and InputError on a mesh that is not
/// closed.
GivenBody take_body(const TautBody* body, const app::Scene& scene);

/// Adds it to the bodies of the scene and returns its number.
std::size_t put_in(const GivenBody& given, app::Scene& scene);

}  // namespace taut::library
